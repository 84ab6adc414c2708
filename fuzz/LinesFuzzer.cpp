#include "Check.h"

#include "cli/ShotRequest.h"
#include "play/WalkRecord.h"

// Input: a byte that selects a parser (recorded walk, line of a views file), then text. Every refusal has a
// reason.
namespace {

using namespace limen;

void checkWalk(const std::string& text) {
    const Result<play::WalkRecord> walk = play::parseWalk(text, "walk");
    fuzz::expectReason(walk);
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
    if (data[0] % 2 == 0)
        checkWalk(text);
    else
        fuzz::expectReason(cli::parseView(text, "views:1"));
    return 0;
}
