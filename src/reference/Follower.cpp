#include "reference/Follower.h"

#include "core/Assert.h"

#include <algorithm>
#include <cmath>

namespace limen::reference {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Metres along the ray. Nearer meetings with one polygon are one: with a triangle in the spaces on both sides of an
/// opening, or with two triangles on their common edge.
constexpr double kSameMeeting = 1e-6;

} // namespace

Follower::Follower(const SceneData& scene, const Ray& ray)
    : scene_(scene), ray_(ray.eye - scene.origin, ray.direction), eye_(world::rangeStepsOf(ray.eye)),
      candidates_(scene, ray_, eye_), nearPlane_(ray.nearPlane) {}

Follower::Follower(const SceneData& scene, const Ray& ray, TileCandidates& tile, std::uint32_t pixel)
    : scene_(scene), ray_(ray.eye - scene.origin, ray.direction), eye_(world::rangeStepsOf(ray.eye)),
      candidates_(scene, ray_, eye_, tile, pixel), nearPlane_(ray.nearPlane) {}

Leaving Follower::leavingFrom(const Visit& visit) const {
    return {visit.space, visit.after, visit.cameBy, nearPlane_, scene_.shut, notAgain_};
}

void Follower::meetSurfaces(const Visit& visit, double most) {
    const Stretch stretch{visit.surfacesAfter, nearPlane_, most};
    double farthest = std::min(most, nearest_.t);
    candidates_.forSolids(visit.space, stretch.after, farthest,
                          [&](const TriangleSet& set, const Triangle& triangle) {
                              Meeting at;
                              if (meetsFront(ray_, triangle, at) && stretch.holds(at.t) && at.t <= farthest &&
                                  !set.isHole(scene_.world, triangle, at)) {
                                  nearest_.take(at.t, triangle.id);
                                  farthest = std::min(farthest, nearest_.t);
                              }
                          });
    candidates_.forBlended(visit.space, stretch.after, most, nearest_.t,
                           [&](const Triangle& triangle, bool isFilling) {
                               Meeting at;
                               if (meetsFront(ray_, triangle, at) && stretch.holds(at.t))
                                   meetLayer(triangle, isFilling, at.t);
                           });
}

/// Of all surfaces in a portal's plane the filling is met first, so a pane counts as the tolerance nearer
/// than it is. A ray can meet two triangles of a polygon that is not flat: they are two layers.
void Follower::meetLayer(const Triangle& triangle, bool isFilling, double t) {
    if (isFilling) {
        const Vec3 normal = glm::cross(triangle.b - triangle.a, triangle.c - triangle.a);
        t -= kInPlaneTolerance * glm::length(normal) / std::abs(glm::dot(normal, ray_.direction));
    }
    if (t > nearest_.t)
        return;
    const double same = kSameMeeting / glm::length(ray_.direction);
    const auto known = std::find_if(layers_.begin(), layers_.end(), [&](const Layer& layer) {
        return layer.id == triangle.id && std::abs(layer.t - t) <= same;
    });
    if (known == layers_.end())
        layers_.push_back({triangle.id, t});
    else
        known->t = std::min(known->t, t);
}

/// A closed filling makes its whole portal a surface. The pixel shows the filling's triangle that the ray
/// meets, or else the triangle that faces the ray most.
void Follower::meetFilling(const Exit& exit) {
    nearest_ = {exit.t, 0};
    end_ = exit.before; // the filling is the first surface in its plane
    const world::InstanceIndex filling =
        scene_.fillings.empty() ? world::kNone : scene_.fillings[exit.portal];
    if (filling == world::kNone)
        return;
    double most = -kInfinity; // a triangle that faces away still represents the object
    bool met = false;
    const auto offer = [&](const Triangle& triangle) {
        Meeting at;
        const bool meets = meetsFront(ray_, triangle, at);
        const double facing =
            -glm::dot(glm::cross(triangle.b - triangle.a, triangle.c - triangle.a), ray_.direction);
        if (met && !meets)
            return;
        if ((meets && !met) || facing > most || (facing == most && triangle.id < nearest_.id)) {
            most = facing;
            nearest_.id = triangle.id;
        }
        met = met || meets;
    };
    const Surfaces& surfaces = scene_.moving.surfacesOf(filling);
    for (const TriangleSet* set : {&surfaces.solid, &surfaces.blended})
        std::for_each(set->triangles().begin(), set->triangles().end(), offer);
}

/// Whether the gap has another side: a solid triangle or a portal of the space.
bool Follower::isGap(world::SpaceIndex space, const BoxRay& wide, const Gap& gap) const {
    bool found = gap.isRounding();
    scene_.openings.forCorners(space,
                               [&](std::span<const Vec3> corners) { found = found || gap.hasSide(corners); });
    const double farthest = kInfinity;
    scene_.forLists(space, [&](const Bodies& bodies, const BodyLists::ListPair& lists) {
        lists.solid.walk(wide, 0.0, farthest, [&](std::uint32_t body) {
            if (!found && bodies.isInLevelRange(body, eye_))
                bodies.surfacesOf(body).solid.walk(wide, 0.0, farthest, [&](const Triangle& triangle) {
                    const Vec3 corners[] = {triangle.a, triangle.b, triangle.c};
                    found = found || gap.hasSide(corners);
                });
        });
    });
    return found;
}

/// A ray in a cell that meets nothing may have slipped through a gap narrower than the data's own rounding.
/// Then the nearer neighbour of the gap counts: a triangle, which becomes `nearest_`, or a portal, which
/// becomes `exit`. True if a portal.
bool Follower::closeGap(const Visit& visit, Exit& exit) {
    const BoxRay wide(ray_.eye, ray_.direction, kGapTolerance);
    const BoxRay widest(ray_.eye, ray_.direction, 3.0 * kGapTolerance); // both sides of a gap, and its width
    const GapTest isNarrow = [&](const Vec3& passes, std::span<const Vec3> corners) {
        return isGap(visit.space, widest, Gap(passes, corners));
    };
    exit = scene_.openings.nearestGrown(ray_, wide, leavingFrom(visit), isNarrow);
    const Stretch stretch{visit.surfacesAfter, nearPlane_, exit.found() ? exit.t : kInfinity};
    double farthest = stretch.most;
    scene_.forLists(visit.space, [&](const Bodies& bodies, const BodyLists::ListPair& lists) {
        lists.solid.walk(wide, stretch.after, farthest, [&](std::uint32_t body) {
            if (!bodies.isInLevelRange(body, eye_))
                return;
            const TriangleSet& solid = bodies.surfacesOf(body).solid;
            solid.findNearestGrown(scene_.world, ray_, wide, stretch, kGapTolerance, isNarrow, nearest_);
            farthest = std::min(farthest, nearest_.t);
        });
    });
    if (nearest_.id != 0)
        exit = {};
    return exit.found();
}

Layers Follower::layersBefore(double end) const {
    Layers result;
    for (const Layer& layer : layers_) {
        if (layer.t <= end) {
            ++result.count;
            result.hash += layerHash(layer.id);
        }
    }
    return result;
}

Answer Follower::follow(world::SpaceIndex root) {
    const world::World& world = scene_.world;
    LIMEN_ASSERT(root < world.spaces.size(), "a ray begins in a space of the world");
    Answer answer;
    Visit visit{root, 0.0, 0.0, world::kNone};
    bool hole = false;
    // A ray leaves by a portal once where it crosses the plane, and once more at most by way of notAgain_.
    const std::size_t limit = 4 * world.portals.size() + 16;
    for (;;) {
        LIMEN_ASSERT(answer.spacesVisited < limit, "a straight ray crosses every portal's plane once");
        ++answer.spacesVisited;
        answer.reachedOutside = answer.reachedOutside || visit.space == world::kOutside;
        Exit exit = candidates_.exitOf(leavingFrom(visit));
        meetSurfaces(visit, exit.found() ? exit.beyond : kInfinity);
        bool slipped = false;
        if (!exit.found() && nearest_.id == 0 && visit.space != world::kOutside)
            slipped = closeGap(visit, exit);
        // Surfaces within the tolerance of the portal's plane are met from both sides. So the ray continues
        // even if it has met one there, and the nearest counts.
        if (!exit.found() || nearest_.t < exit.before)
            break;
        if (isShut(exit.portal)) {
            meetFilling(exit);
            hole = nearest_.id == 0;
            break;
        }
        if (nearest_.t > exit.beyond)
            nearest_ = {};
        if (world.portals[exit.portal].destination == world::kNone ||
            !scene_.openings.passesPair(exit.portal, ray_, visit.after)) {
            hole = true;
            break;
        }
        if (slipped || exit.t <= 0.0)
            notAgain_.push_back(exit.portal);
        visit = {world.portals[exit.portal].destination, std::max(exit.t, visit.after),
                 std::max(exit.before, 0.0), exit.portal};
    }
    answer.space = visit.space;
    answer.id = nearest_.id;
    answer.t = nearest_.t;
    if (nearest_.id == 0) {
        const bool sky = visit.space == world::kOutside && !hole;
        answer.id = sky ? 1 : 0;
        answer.t = sky ? kInfinity : std::numeric_limits<double>::quiet_NaN();
    }
    answer.layers = layersBefore(std::min(end_, nearest_.t));
    return answer;
}

} // namespace limen::reference
