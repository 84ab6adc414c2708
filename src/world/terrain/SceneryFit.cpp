#include "world/terrain/SceneryFit.h"

#include "world/World.h"

#include <algorithm>

namespace limen::world {
namespace {

/// A circle clears all four edges. A radius that is not a number does not count.
bool clearsEdges(const Vec3& at, double radius) {
    const double r = std::isfinite(radius) ? std::max(radius, 0.0) : 0.0;
    return at.x >= r && at.y >= r && at.x < kBlockSize - r && at.y < kBlockSize - r;
}

bool clearsEdges(const dat::SphereF& sphere, const Vec3& origin, const Quat& orientation) {
    return clearsEdges(origin + orientation * Vec3(sphere.centre), static_cast<double>(sphere.radius));
}

bool isSetupWithin(const dat::Setup& setup, const Vec3& origin, const Quat& orientation) {
    if ((setup.flags & dat::Setup::kPhysicsBsp) != 0)
        return clearsEdges(setup.sortingSphere, origin, orientation);
    if (!setup.cylSpheres.empty())
        return std::all_of(setup.cylSpheres.begin(), setup.cylSpheres.end(), [&](const dat::CylSphere& c) {
            return clearsEdges(origin + orientation * Vec3(c.low), static_cast<double>(c.radius));
        });
    if (!setup.spheres.empty())
        return clearsEdges(setup.sortingSphere, origin, orientation);
    return clearsEdges(origin, 0.0);
}

} // namespace

bool isWithinBlock(dat::RecordId model, const Vec3& origin, const Quat& orientation, Records& records) {
    if (isSetup(model)) {
        const dat::Setup* setup = records.setup(model);
        return setup == nullptr || isSetupWithin(*setup, origin, orientation);
    }
    const dat::GfxObj* mesh = isGfxObj(model) ? records.gfxObj(model) : nullptr;
    const bool isSolid = mesh != nullptr && (mesh->flags & dat::GfxObj::kPhysics) != 0;
    if (isSolid && !mesh->physicsBsp.nodes.empty())
        return clearsEdges(mesh->physicsBsp.nodes.front().sphere, origin, orientation);
    return clearsEdges(origin, 0.0);
}

} // namespace limen::world
