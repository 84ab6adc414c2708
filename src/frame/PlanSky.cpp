#include "frame/PlanSky.h"

#include "frame/PlanBatches.h"
#include "frame/ZoneScreenRects.h"
#include "world/Ground.h"
#include "world/SkyCover.h"

#include <cmath>

namespace limen::frame {

namespace {

/// The origin of sun, moon and domes, global.
Vec3 originOfSky(const world::World& world, const Vec3& eye, world::SpaceIndex space) {
    const auto corner = [&eye](double side) {
        return Vec3(std::floor(eye.x / side) * side, std::floor(eye.y / side) * side, 0.0);
    };
    switch (world.readings.skyPlace) {
    case world::SkyPlace::Block:
        return corner(world::kBlockSize);
    case world::SkyPlace::Cell:
        return space != world::kOutside ? world.spaces[space].origin : corner(world::kLandcellSize);
    case world::SkyPlace::Eye:
        break;
    }
    return eye;
}

constexpr double kSkyMargin = 0.01; ///< NDC

} // namespace

void placeSky(const world::World& world, const FrameView& frame, world::SpaceIndex space,
              std::vector<world::SkyPlacement>& placements) {
    world::skyPlacements(world.sky,
                         {frame.dayGroup, world::timeOfSky(world.sky, frame.timeOfDay), frame.seconds,
                          frame.view.eye.z, space == world::kOutside,
                          originOfSky(world, frame.view.eye, space) - frame.view.eye},
                         placements);
    world::leaveOutCovered(world.sky, placements);
}

// In a direction d of the picture, d.z / |d| is the sine of its elevation, and |d| is at least the distance of the plane of all
// directions. So d is above an elevation below the horizon if d.z is above a constant. It is linear on the screen.
RectRun plainSkyBelow(double sine, FramePlan& plan) {
    if (!(sine < 0.0) || plan.rects.size() > kMaxFirstRect)
        return {};
    const glm::dmat4 eyeFromClip = glm::inverse(glm::dmat4(plan.constants.clipFromEye));
    const auto directionAt = [&](double x, double y) {
        const glm::dvec4 at = eyeFromClip * glm::dvec4(x, y, 1.0, 1.0);
        return Vec3(at) / at.w;
    };
    const Vec3 middle = directionAt(0.0, 0.0);
    const Vec3 across = directionAt(1.0, 0.0) - middle, up = directionAt(0.0, 1.0) - middle;
    const double distance = std::abs(glm::dot(glm::normalize(glm::cross(across, up)), middle));
    if (!(up.z > 0.0))
        return {};
    const double highest = (sine * distance - middle.z + std::abs(across.z)) / up.z + kSkyMargin;
    if (!(highest < 1.0))
        return {};
    plan.rects.emplace_back(-1.0f, -1.0f, 1.0f, static_cast<float>(std::max(highest, -1.0)));
    return {static_cast<std::uint16_t>(plan.rects.size() - 1), 1};
}

void addSkyObjects(const world::World& world, std::span<const world::SkyPlacement> placements,
                   const SkyShare& share, FramePlan& plan) {
    const std::size_t firstPiece = plan.pieces.size();
    for (const world::SkyPlacement& p : placements) {
        if (p.isOverLand != share.overLand)
            continue;
        const world::SkyPart& part = world.sky.parts[p.part];
        const auto instance = static_cast<std::uint32_t>(plan.skyInstances.size());
        gpu::SkyInstance out;
        out.row0 = {p.rotation[0][0], p.rotation[1][0], p.rotation[2][0], p.offset.x};
        out.row1 = {p.rotation[0][1], p.rotation[1][1], p.rotation[2][1], p.offset.y};
        out.row2 = {p.rotation[0][2], p.rotation[1][2], p.rotation[2][2], p.offset.z};
        out.firstMaterial = part.firstMaterial;
        out.opacity = 1.0f - p.transparent;
        out.luminosity = p.luminosity;
        out.diffuse = p.diffuse;
        out.overLand = share.overLand ? 1u : 0u;
        out.uvOffsetX = p.uvOffset.x;
        out.uvOffsetY = p.uvOffset.y;
        out.clipSet = share.clipSet;
        plan.skyInstances.push_back(out);
        for (const world::Mesh::Range& range : world.meshes[part.mesh].ranges)
            addRun(addOwnPieces(range, instance, plan), plan);
    }
    for (std::size_t i = firstPiece; i < plan.pieces.size(); ++i)
        plan.pieces[i].triangles |= gpu::kNeverCulled;
}

} // namespace limen::frame
