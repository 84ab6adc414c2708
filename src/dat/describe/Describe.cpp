#include "dat/Describe.h"

#include "dat/describe/Json.h"

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

namespace limen::dat {
namespace {

constexpr std::size_t kShownBytes = 64;

template <class Record>
Result<std::string> describeAs(RecordId id, ByteView payload) {
    return decode<Record>(id, payload).map([](const Record& record) { return describe(record); });
}

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
    return pretty({{"kind", nameOf(RecordKind::Iteration)}, {"id", hexId(id)}, {"words", words}});
}

} // namespace

Result<std::string> describe(FileRole role, RecordId id, ByteView payload) {
    const RecordKind kind = kindOf(role, id);
    switch (kind) {
    case RecordKind::GfxObj:
        return describeAs<GfxObj>(id, payload);
    case RecordKind::Setup:
        return describeAs<Setup>(id, payload);
    case RecordKind::Palette:
        return describeAs<Palette>(id, payload);
    case RecordKind::SurfaceTexture:
        return describeAs<SurfaceTexture>(id, payload);
    case RecordKind::RenderSurface:
        return describeAs<RenderSurface>(id, payload);
    case RecordKind::Surface:
        return describeAs<Surface>(id, payload);
    case RecordKind::Environment:
        return describeAs<Environment>(id, payload);
    case RecordKind::Scene:
        return describeAs<Scene>(id, payload);
    case RecordKind::Region:
        return describeAs<Region>(id, payload);
    case RecordKind::LandBlock:
        return describeAs<LandBlock>(id, payload);
    case RecordKind::LandBlockInfo:
        return describeAs<LandBlockInfo>(id, payload);
    case RecordKind::EnvCell:
        return describeAs<EnvCell>(id, payload);
    case RecordKind::Iteration:
        return describeIteration(id, payload);
    case RecordKind::Other:
        break;
    }
    return describeOther(kind, id, payload);
}

} // namespace limen::dat
