#pragma once

#include "picture/PictureWorld.h"

#include <gtest/gtest.h>

#include <algorithm>

// Shared by the tests of hard cases (docs/cases.md).
namespace limen::test {

/// Every case is run with cells merged into zones and with every cell as a zone.
struct ZoneCases : ::testing::TestWithParam<bool> {
    [[nodiscard]] PictureOptions options(world::MovingEntries moving = {}, int radius = 1) const {
        return {.mergeZones = GetParam(), .radius = radius, .moving = std::move(moving)};
    }
};

// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): GoogleTest offers no other way.
#define LIMEN_BOTH_ZONINGS(suite)                                                                            \
    INSTANTIATE_TEST_SUITE_P(Zones, suite, ::testing::Bool(),                                                \
                             [](const auto& zones) { return zones.param ? "merged" : "apart"; })

/// The instance, static or part of a dynamic object, that shows as `id`; null for void and sky.
[[nodiscard]] inline const world::Instance* shownAs(const world::World& world, std::uint32_t id) {
    for (const auto* instances : {&world.instances, &world.movingParts}) {
        for (const world::Instance& in : *instances)
            if (id >= in.idBase && id - in.idBase < world.meshes[in.mesh].polygonCount)
                return &in;
    }
    return nullptr;
}

/// Pixels that show a surface whose instance comes from `record`.
[[nodiscard]] inline std::size_t pixelsOfRecord(const PictureWorld& pictures, const Picture& picture,
                                                dat::RecordId record) {
    return static_cast<std::size_t>(
        std::count_if(picture.ids.begin(), picture.ids.end(), [&](std::uint32_t id) {
            const world::Instance* in = shownAs(pictures.world(), id);
            return in != nullptr && in->record == record;
        }));
}

[[nodiscard]] inline std::size_t skyPixels(const Picture& picture) {
    return static_cast<std::size_t>(std::count(picture.ids.begin(), picture.ids.end(), 1u));
}

[[nodiscard]] inline bool visitsSpace(const Picture& picture, world::SpaceIndex space) {
    return std::any_of(picture.visible.visits.begin(), picture.visible.visits.end(),
                       [&](const visibility::Visit& v) { return v.space == space; });
}

[[nodiscard]] inline bool seesSpace(const Picture& picture, world::SpaceIndex space) {
    return std::any_of(picture.visible.seen.begin(), picture.visible.seen.end(),
                       [&](const visibility::SeenSpace& s) { return s.space == space; });
}

/// The dynamic state in which `frame` is drawn.
[[nodiscard]] inline motion::DynamicStateInput dynamicsFor(const frame::FrameView& frame, double seconds,
                                                           std::optional<double> doors, bool rain = false) {
    motion::DynamicStateInput input;
    input.seconds = seconds;
    input.allDoors = doors;
    input.rain = rain;
    input.eye = frame.view.eye;
    input.right = frame.view.right;
    input.up = frame.view.up;
    input.forward = frame.view.forward;
    return input;
}

} // namespace limen::test
