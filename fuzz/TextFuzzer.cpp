#include "Check.h"

#include "cli/ShotRequest.h"
#include "play/WalkRecord.h"
#include "world/Places.h"

// Input: a byte that selects a parser (world file, recorded walk, line of a views file), then text. Every
// refusal has a reason.
namespace {

using namespace limen;

template <class T>
void expectReason(const Result<T>& read) {
    FUZZ_CHECK(read.has_value() || !read.error().what.empty());
}

void checkWalk(const std::string& text) {
    const Result<play::WalkRecord> walk = play::parseWalk(text, "walk");
    expectReason(walk);
    if (!walk)
        return;
    std::string again = play::beginningLine(walk->start);
    for (const play::RecordedFrame& frame : walk->frames)
        again += play::frameLine(frame);
    const Result<play::WalkRecord> same = play::parseWalk(again, "walk");
    FUZZ_CHECK(same.has_value() && same->start == walk->start && same->frames.size() == walk->frames.size());
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0)
        return 0;
    const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
    switch (data[0] % 3) {
    case 0:
        expectReason(world::parseWorldFile(text, "world.json"));
        break;
    case 1:
        checkWalk(text);
        break;
    default:
        expectReason(cli::parseView(text, "views:1"));
    }
    return 0;
}
