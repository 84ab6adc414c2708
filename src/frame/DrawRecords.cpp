#include "frame/DrawRecords.h"

#include "core/Assert.h"
#include "world/World.h"

#include <algorithm>
#include <bit>

namespace limen::frame {
namespace {

constexpr auto kTerrainKind = static_cast<std::uint32_t>(world::InstanceKind::Terrain);

std::uint32_t fillingFlagOf(std::uint32_t kind) {
    return kind == gpu::kKindFilling ? gpu::kRecordFilling : 0u;
}

/// As details.glsl; the ground has programs of its own.
std::uint32_t detailOf(std::uint32_t kind) {
    return kind == gpu::kKindShell      ? gpu::kDetailOfShells
           : kind == gpu::kKindExterior ? gpu::kDetailOfExteriors
           : kind == kTerrainKind       ? gpu::kDetailOfLand
                                        : gpu::kNoDetail;
}

} // namespace

RecordTables tablesOf(const SceneUpload& scene) {
    return {scene.pieces, scene.instances, scene.members, scene.levels, scene.lightSets};
}

bool DrawRecords::isInRange(std::uint32_t instance) const {
    const gpu::Instance& drawn = at(instance);
    if (drawn.level == gpu::kFromAnywhere)
        return true;
    const gpu::Level& level = tables_.levels[drawn.level];
    const gpu::vec4& block = plan_.blocks[drawn.block & gpu::kBlockMask];
    const auto stepsOf = [](float eye, float origin) {
        return static_cast<std::int64_t>(eye) -
               static_cast<std::int64_t>(origin * static_cast<float>(gpu::kRangeSteps));
    };
    const gpu::vec4& steps = plan_.constants.eyeSteps;
    const world::RangeSteps eye{stepsOf(steps.x, block.x), stepsOf(steps.y, block.y),
                                stepsOf(steps.z, block.z)};
    const auto measure =
        static_cast<world::LevelMeasure>(static_cast<std::uint32_t>(level.originZ) % gpu::kMeasures);
    constexpr int kMeasureBits = std::bit_width(gpu::kMeasures) - 1;
    const std::uint32_t squared =
        world::levelDistance(measure, {level.originX, level.originY, level.originZ >> kMeasureBits}, eye)
            .squared;
    return world::LevelRange{static_cast<std::uint16_t>(level.range),
                             static_cast<std::uint16_t>(level.range >> 16)}
        .contains(world::LevelShare{plan_.levelSixteenths}.seen(squared));
}

std::uint32_t DrawRecords::replaced(std::uint32_t instance) const {
    for (const gpu::Replacement& replacement : plan_.replacements)
        if (replacement.instance == instance)
            return replacement.by;
    return instance;
}

bool DrawRecords::hasLamps(std::uint32_t instance) const {
    const gpu::LightSet& set = tables_.lightSets[memberThatLights(at(replaced(instance))).lightSet];
    return set.lampCount > 0 || (set.kind != gpu::kLitOutdoors && plan_.constants.viewerLight.w > 0.0f);
}

Vec3 DrawRecords::offsetOf(std::uint32_t block, const Vec3f& local) const {
    const gpu::vec4& origin = plan_.blocks[block];
    const gpu::vec4 &high = plan_.constants.eyeHigh, &low = plan_.constants.eyeLow;
    return Vec3(origin.x, origin.y, origin.z) + Vec3(local) - Vec3(high.x, high.y, high.z) -
           Vec3(low.x, low.y, low.z);
}

gpu::DrawRecord DrawRecords::of(std::uint32_t instance) const {
    gpu::DrawRecord record;
    place(at(replaced(instance)), record);
    light(instance, record);
    return record;
}

std::uint64_t DrawRecords::visitsTo(std::uint32_t instance, const VisitBits& visits) const {
    const gpu::Instance& drawn = at(replaced(instance));
    std::uint64_t bits = 0;
    for (std::uint32_t i = 0; i < gpu::memberCountOf(drawn); ++i)
        bits |= visits.of(member(drawn.firstMember + i).zone);
    return bits;
}

void DrawRecords::place(const gpu::Instance& instance, gpu::DrawRecord& record) const {
    const gpu::vec4 &a = instance.pose0, &b = instance.pose1, &c = instance.pose2;
    // The offset from the eye in two floats. Near the eye, the sum of the first with a coordinate is exact.
    const Vec3 offset = offsetOf(instance.block & gpu::kBlockMask, {c.y, c.z, c.w});
    const Vec3f first(offset);
    record.row0 = {a.x, a.w, b.z, first.x};
    record.row1 = {a.y, b.x, b.w, first.y};
    record.row2 = {a.z, b.y, c.x, first.z};
    record.rest = {Vec3f(offset - Vec3(first)), static_cast<float>(instance.block >> gpu::kClipSetShift)};
}

gpu::Member DrawRecords::memberThatLights(const gpu::Instance& instance) const {
    const std::uint32_t count = gpu::memberCountOf(instance);
    for (std::uint32_t i = 0; count > 1 && i < count; ++i)
        if (const gpu::Member& each = member(instance.firstMember + i); each.zone == plan_.constants.rootZone)
            return each;
    return member(instance.firstMember);
}

void DrawRecords::light(std::uint32_t number, gpu::DrawRecord& record) const {
    const gpu::Instance& instance = at(replaced(number));
    const gpu::LightSet& set = tables_.lightSets[memberThatLights(instance).lightSet];
    const gpu::ViewConstants& view = plan_.constants;
    const bool isOutdoors = set.kind == gpu::kLitOutdoors;
    const gpu::vec4& ambient = set.sealed != 0                         ? view.sealedAmbient
                               : gpu::kindOf(instance) == kTerrainKind ? view.landAmbient
                                                                       : view.skyAmbient;
    record.ambient = {gpu::vec3(ambient), instance.opacity};
    record.sun = isOutdoors ? gpu::vec4(gpu::vec3(view.sunColour), 0.0f) : gpu::vec4(0.0f);
    record.look = {instance.firstMaterial, instance.highlight, set.firstLamp, set.lampCount};
    const std::uint32_t count = gpu::memberCountOf(instance);
    const bool isOne = count == 1;
    record.members = {isOne ? member(instance.firstMember).zone : instance.firstMember,
                      isOne ? gpu::kOneMember : count, instance.idBase,
                      set.kind | fillingFlagOf(gpu::kindOf(instance)) |
                          detailOf(gpu::kindOf(instance)) << gpu::kRecordDetail};
}

} // namespace limen::frame
