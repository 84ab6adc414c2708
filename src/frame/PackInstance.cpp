#include "frame/PackInstance.h"

#include "core/Assert.h"

#include <algorithm>
#include <bit>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace limen::frame {

static_assert(static_cast<std::uint32_t>(world::InstanceKind::Shell) == gpu::kKindShell &&
              static_cast<std::uint32_t>(world::InstanceKind::Exterior) == gpu::kKindExterior &&
              static_cast<std::uint32_t>(world::InstanceKind::Filling) == gpu::kKindFilling);
static_assert(world::kRangeSteps == static_cast<std::int32_t>(gpu::kRangeSteps) &&
              world::kMostRangeSteps == static_cast<std::int32_t>(gpu::kMostRangeSteps) &&
              world::kMostLocalSteps == static_cast<std::int32_t>(gpu::kMostLocalSteps) &&
              std::uint32_t{world::LevelRange::kEndless} == gpu::kEndlessRange &&
              world::kNone == gpu::kFromAnywhere &&
              static_cast<std::uint32_t>(world::LevelMeasure::Landcell) == gpu::kMeasureLandcell &&
              world::kLandcellBeyond * world::kRangeSteps == static_cast<std::int32_t>(gpu::kLandcellBeyond));

namespace {

/// Instances prefetched ahead of the one that is packed: the visible ones are scattered.
constexpr std::size_t kInstancesAhead = 16;

/// Bytes of records from which on they are written with stores that bypass the cache: half of a core's own
/// cache. For a hundred thousand dynamic instances that saves 50 of 700 microseconds; for fewer it makes no
/// difference.
constexpr std::size_t kBypassCache = std::size_t{1} << 20;

/// A dynamic instance's record has one member, the space that it is placed in; the planner adds others
/// (DynamicChange).
constexpr std::uint32_t kOneMember = 1;
constexpr std::uint32_t kNoHighlight = 0;

#ifdef __SSE2__
/// packInstance, four words at a time. A record that is assembled word by word and then copied in vectors
/// would stall.
template <class Store>
void packByVectors(const world::Instance& in, gpu::Instance& out, const Store& store) {
    static_assert(sizeof(gpu::Instance) == 5 * sizeof(__m128i));
    const auto word = [](std::uint32_t value) { return static_cast<int>(value); };
    const glm::mat3& m = in.linear;
    auto* const to = reinterpret_cast<__m128i*>(&out);
    store(to, _mm_loadu_si128(reinterpret_cast<const __m128i*>(&m[0].x)));
    store(to + 1, _mm_loadu_si128(reinterpret_cast<const __m128i*>(&m[1].y)));
    store(to + 2, _mm_castps_si128(_mm_set_ps(in.origin.z, in.origin.y, in.origin.x, m[2].z)));
    store(to + 3, _mm_set_epi32(word(in.placedIn), word(in.firstMaterial), word(in.idBase), word(in.block)));
    store(to + 4, _mm_set_epi32(std::bit_cast<int>(in.opacity), word(kNoHighlight), word(in.level),
                                word(membersAndKind(kOneMember, in.kind))));
}
#endif

/// `pack(instance, record)` for each of the numbers.
template <class Pack>
void packEach(const world::Instance* instances, std::span<const std::uint32_t> numbers,
              std::span<gpu::Instance> records, const Pack& pack) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (i + kInstancesAhead < numbers.size()) {
            const world::Instance& next = instances[numbers[i + kInstancesAhead]];
            __builtin_prefetch(&next);
            __builtin_prefetch(&next.origin.z);
        }
        pack(instances[numbers[i]], records[i]);
    }
}

void writeRecords(const void* first, std::span<const std::uint32_t> numbers,
                  std::span<gpu::Instance> records) {
    LIMEN_ASSERT(numbers.size() == records.size(), "one record for each instance");
    const auto* const instances = static_cast<const world::Instance*>(first);
#ifdef __SSE2__
    if (records.size_bytes() < kBypassCache) {
        packEach(instances, numbers, records, [](const world::Instance& in, gpu::Instance& out) {
            packByVectors(in, out, [](__m128i* to, __m128i value) { _mm_storeu_si128(to, value); });
        });
    } else {
        LIMEN_ASSERT(reinterpret_cast<std::uintptr_t>(records.data()) % sizeof(__m128i) == 0,
                     "an array of texels begins at a texel");
        packEach(instances, numbers, records, [](const world::Instance& in, gpu::Instance& out) {
            packByVectors(in, out, [](__m128i* to, __m128i value) { _mm_stream_si128(to, value); });
        });
        _mm_sfence(); // before the frame is drawn
    }
#else
    packEach(instances, numbers, records, [](const world::Instance& in, gpu::Instance& out) {
        out = packInstance(in, {in.placedIn, kOneMember});
    });
#endif
}

} // namespace

gpu::Level packLevel(const world::Level& level) {
    const auto measure = static_cast<std::int32_t>(level.measure);
    return {level.origin[0], level.origin[1],
            level.origin[2] * static_cast<std::int32_t>(gpu::kMeasures) + measure,
            level.range.from | std::uint32_t{level.range.upTo} << 16};
}

gpu::Instance packInstance(const world::Instance& in, const MemberRun& members) {
    const glm::mat3& m = in.linear;
    return {{m[0].x, m[0].y, m[0].z, m[1].x},
            {m[1].y, m[1].z, m[2].x, m[2].y},
            {m[2].z, in.origin.x, in.origin.y, in.origin.z},
            in.block,
            in.idBase,
            in.firstMaterial,
            members.first,
            membersAndKind(members.count, in.kind),
            in.level,
            kNoHighlight,
            in.opacity};
}

DynamicRecords recordsOf(std::span<const world::Instance> instances) {
    return {instances.data(), writeRecords};
}

std::vector<gpu::Member> membersOfSpaces(const world::World& world) {
    std::vector<gpu::Member> members;
    members.reserve(world.spaces.size());
    for (const world::Space& space : world.spaces)
        members.push_back({space.zone, space.lightSet});
    return members;
}

MemberRun packMembers(const world::World& world, std::span<const world::SpaceIndex> spaces,
                      const OwnMembers& own, std::uint32_t lightSet) {
    const bool isLitAlike = lightSet == world::kNone; // as other objects in its spaces
    if (isLitAlike && spaces.size() == 1)
        return {spaces.front(), 1};
    const std::size_t first = own.members.size();
    for (const world::SpaceIndex index : spaces) {
        const world::Space& space = world.spaces[index];
        const bool isKnown =
            std::any_of(own.members.begin() + static_cast<std::ptrdiff_t>(first), own.members.end(),
                        [&](const gpu::Member& member) { return member.zone == space.zone; });
        const bool takesOwn = !isLitAlike && space.zone != world::kOutsideZone;
        if (!isKnown)
            own.members.push_back({space.zone, takesOwn ? lightSet : space.lightSet});
    }
    const std::size_t count = own.members.size() - first;
    if (isLitAlike && count == 1) {
        own.members.pop_back();
        return {spaces.front(), 1};
    }
    return {own.first + static_cast<std::uint32_t>(first),
            static_cast<std::uint32_t>(std::min<std::size_t>(count, gpu::kMostMembers))};
}

} // namespace limen::frame
