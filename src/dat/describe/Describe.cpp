#include "dat/Describe.h"

#include "dat/Iterations.h"
#include "dat/RecordTypes.h"
#include "dat/describe/Json.h"

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

namespace limen::dat {
namespace {

constexpr std::size_t kShownBytes = 64;

std::string describeOther(RecordKind kind, RecordId id, ByteView payload) {
    std::string bytes;
    for (const std::byte b : payload.first(std::min(payload.size(), kShownBytes)))
        bytes += fmt::format("{:02X} ", std::to_integer<unsigned>(b));
    if (!bytes.empty())
        bytes.pop_back();
    return pretty(
        {{"kind", nameOf(kind)}, {"id", hexId(id)}, {"size", payload.size()}, {"first_bytes", bytes}});
}

std::string describeIteration(RecordId id, ByteView payload) {
    Json words = Json::array();
    for (std::size_t i = 0; i + 4 <= payload.size(); i += 4) {
        std::int32_t word = 0;
        std::memcpy(&word, payload.data() + i, sizeof word);
        words.push_back(word);
    }
    Json record{{"kind", nameOf(RecordKind::Iteration)}, {"id", hexId(id)}, {"words", words}};
    if (const Result<Iterations> iterations = decodeIterations(payload)) {
        record["current"] = iterations->current;
        Json runs = Json::array();
        for (const IterationRun& run : iterations->runs)
            runs.push_back({{"first", run.first}, {"count", run.count}});
        record["runs"] = runs;
    }
    return pretty(record);
}

} // namespace

Result<std::string> describe(FileRole role, RecordId id, ByteView payload) {
    const RecordKind kind = kindOf(role, id);
    if (kind == RecordKind::Iteration)
        return describeIteration(id, payload);
    Result<std::string> text;
    const bool isKnown = visitKind(kind, [&]<class Record>(std::type_identity<Record>) {
        text = decode<Record>(id, payload).map([](const Record& record) { return describe(record); });
    });
    return isKnown ? text : describeOther(kind, id, payload);
}

} // namespace limen::dat
