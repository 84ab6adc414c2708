#include "check/Traced.h"

#include "check/LonePolygon.h"

namespace limen::check {

TracedWorld::TracedWorld(const world::World& world) : world_(world), scene_(world) {}

void TracedWorld::setDynamics(const world::DynamicState& dynamics) {
    dynamics_ = dynamics;
    scene_.setDynamics(dynamics_);
    byZoneIsOld_ = true;
}

const reference::Scene& TracedWorld::sceneByZone() {
    if (!byZone_)
        byZone_.emplace(world_, reference::RuleOptions{.objectsByZone = true});
    if (byZoneIsOld_)
        byZone_->setDynamics(dynamics_);
    byZoneIsOld_ = false;
    return *byZone_;
}

const PolygonTable& TracedWorld::polygons() {
    if (!polygons_)
        polygons_.emplace(world_, dynamics_);
    return *polygons_;
}

reference::Answer ViewRetracer::exact(double x, double y) {
    return traced_.scene().trace(camera_.root, rayThrough(camera_, x, y));
}

reference::Answer ViewRetracer::byZone(double x, double y) {
    return traced_.sceneByZone().trace(camera_.root, rayThrough(camera_, x, y));
}

bool ViewRetracer::leadsIntoTheRoot(double x, double y) {
    if (!contact_)
        contact_.emplace(traced_.world(), traced_.polygons(),
                         traced_.scene().spaceOfEye(camera_.root, camera_.eye), camera_.eye);
    return contact_->touchesNothing() || contact_->leadsIntoTheRoot(rayThrough(camera_, x, y).direction);
}

bool ViewRetracer::isEdgeOn(double x, double y, std::uint32_t id, double shown) {
    return coversEdgeOn(trianglesOf(id), camera_, x, y, shown);
}

double ViewRetracer::outlineRounding(double x, double y, std::uint32_t id) {
    return check::outlineRounding(trianglesOf(id), camera_, x, y);
}

void ViewRetracer::polygonsAlong(double x, double y, std::vector<std::uint32_t>& ids) {
    const reference::Ray ray = rayThrough(camera_, x, y);
    traced_.polygons().polygonsAlong(ray.eye, ray.direction, ids);
}

bool ViewRetracer::mayHaveDepth(int x, int y, std::uint32_t id, double drawn) {
    return check::mayHaveDepth(trianglesOf(id), camera_, x, y, drawn);
}

const std::vector<Triangle>& ViewRetracer::trianglesOf(std::uint32_t id) {
    if (trianglesId_ != id) {
        traced_.polygons().trianglesOf(id, triangles_);
        trianglesId_ = id;
    }
    return triangles_;
}

} // namespace limen::check
