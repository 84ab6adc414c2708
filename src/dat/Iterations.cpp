#include "dat/Iterations.h"

#include <cstring>
#include <limits>

namespace limen::dat {
namespace {

Failure damaged(std::string reason) {
    return fail(ErrorCode::Malformed, "the iteration record", std::move(reason));
}

void put(Bytes& out, std::int32_t word) {
    const std::size_t at = out.size();
    out.resize(at + sizeof word);
    std::memcpy(out.data() + at, &word, sizeof word);
}

} // namespace

Result<Iterations> decodeIterations(ByteView payload) {
    if (payload.empty() || payload.size() % 4 != 0)
        return damaged("its size is not that of whole words");
    std::vector<std::int32_t> words(payload.size() / 4);
    std::memcpy(words.data(), payload.data(), payload.size());
    Iterations out{words[0], {}};
    for (std::size_t i = 1; i < words.size(); ++i) {
        const std::int32_t word = words[i];
        if (word >= 0) {
            out.runs.push_back({word, 1});
            continue;
        }
        if (i + 1 == words.size() || word == std::numeric_limits<std::int32_t>::min())
            return damaged("it ends within a run");
        out.runs.push_back({words[++i], -word});
    }
    return out;
}

Result<Bytes> encodeIterations(const Iterations& iterations) {
    Bytes out;
    put(out, iterations.current);
    for (const IterationRun& run : iterations.runs) {
        if (run.count <= 0)
            return fail(ErrorCode::BadArgument, "iterations",
                        "a run has " + std::to_string(run.count) + " iterations; it needs one or more");
        put(out, -run.count);
        put(out, run.first);
    }
    return out;
}

} // namespace limen::dat
