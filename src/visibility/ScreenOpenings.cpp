#include "visibility/ScreenOpenings.h"

#include "geometry/ConvexPolygon.h"
#include "geometry/Tolerances.h"
#include "visibility/Outline.h"

#include <algorithm>

namespace limen::visibility {

namespace {

/// Metres. An eye this near to a portal between two cells of a zone can be in either cell, and sees through
/// all of the portal.
constexpr double kNear = 0.01;

/// Metres. A point nearer to the eye plane is not projected: it is within kNear of the eye or off the screen.
constexpr double kMinW = 1e-6;

constexpr Rect kWholePlane{-1e300, -1e300, 1e300, 1e300};

Rect widened(const Rect& rect) {
    return {rect.minX - kRectMargin, rect.minY - kRectMargin, rect.maxX + kRectMargin,
            rect.maxY + kRectMargin};
}

} // namespace

void ScreenOpenings::begin(const Input& input) {
    in_ = input;
    inner_.clear();
    exits_.clear();
    relative_.clear();
    onScreen_.clear();
    spaces_.resize(input.graph->spaces().size());
    ++stamp_;
    if (stamp_ == 0) { // wrapped around: forget all
        std::fill(spaces_.begin(), spaces_.end(), Space{});
        stamp_ = 1;
    }
}

void ScreenOpenings::project(std::uint32_t index, Space& space) {
    const Graph::Space& desc = in_.graph->spaces()[index];
    space = {stamp_, static_cast<std::uint32_t>(inner_.size()), 0,
             0,      static_cast<std::uint32_t>(exits_.size()), 0,
             false};
    for (std::uint32_t p = desc.firstPortal; p < desc.firstPortal + desc.portalCount; ++p) {
        const Graph::Portal& portal = in_.graph->portals()[p];
        const double side = portal.plane.signedDistance(in_.eye);
        if (!portal.withinZone || (!in_.closed.empty() && in_.closed[p] != 0)) {
            const bool isExit = side >= -kInPlaneTolerance && portal.plane.n != Vec3(0.0);
            space.hasExits |= isExit;
            if (isExit && desc.root == kNone)
                addExit(p, portal);
            continue;
        }
        if (side >= -kNear)
            ++space.tested;
        if (side >= -kNear || in_.isTraced)
            addInner(p, portal, side);
    }
    space.exitCount = static_cast<std::uint32_t>(exits_.size()) - space.firstExit;
    space.innerCount = static_cast<std::uint32_t>(inner_.size()) - space.firstInner;
}

void ScreenOpenings::addInner(std::uint32_t index, const Graph::Portal& portal, double side) {
    Inner inner{{}, index, portal.destination, PortalFate::OutsideRegion};
    if (side < -kNear)
        inner.refusal = PortalFate::WrongSide;
    else if (side <= kNear && containsProjection(in_.graph->polygon(portal), portal.plane.n, in_.eye, kNear))
        inner.rect = kWholePlane;
    else if (side <= 0.0)
        inner.refusal = PortalFate::EdgeOn;
    else if (!screenRect(in_.graph->polygon(portal), inner.rect))
        inner.refusal = PortalFate::BehindEye;
    if (in_.isTraced || !inner.rect.empty())
        inner_.push_back(inner);
}

void ScreenOpenings::addExit(std::uint32_t index, const Graph::Portal& portal) {
    const auto first = static_cast<std::uint32_t>(relative_.size());
    if (portal.outlineCount > 0) {
        hullSeenFrom(in_.eye, in_.graph->outline(portal), portal.plane.n, hull_, swap_);
        relative_.insert(relative_.end(), hull_.begin(), hull_.end());
    } else {
        for (const Vec3& v : in_.graph->polygon(portal))
            relative_.push_back(v - in_.eye);
    }
    Exit exit{{}, index, first, static_cast<std::uint32_t>(relative_.size()) - first};
    bool ahead = false, behind = false;
    for (std::size_t i = first; i < relative_.size(); ++i) {
        const Vec3 p = in_.screenFromEye * relative_[i];
        onScreen_.push_back(p);
        ahead |= p.z > -kMinW;
        behind |= p.z < kMinW;
        exit.rect.include(p.x / p.z, p.y / p.z);
    }
    if (behind)
        exit.rect = ahead ? kWholePlane : Rect{};
    exit.rect = widened(exit.rect);
    exits_.push_back(exit);
}

bool ScreenOpenings::screenRect(std::span<const Vec3> polygon, Rect& rect) {
    Rect found;
    bool cut = false;
    for (const Vec3& vertex : polygon) {
        const Vec3 p = in_.screenFromEye * (vertex - in_.eye);
        if (p.z < kMinW) {
            cut = true;
            break;
        }
        const double inverse = 1.0 / p.z;
        found.include(p.x * inverse, p.y * inverse);
    }
    if (cut) {
        found = {};
        swap_.clear();
        for (const Vec3& vertex : polygon)
            swap_.push_back(in_.screenFromEye * (vertex - in_.eye));
        clipPolygon(swap_, Plane{Vec3(0, 0, 1), -kMinW}, 0.0, clipped_);
        for (const Vec3& p : clipped_)
            found.include(p.x / p.z, p.y / p.z);
    }
    rect = widened(found);
    return !rect.empty();
}

} // namespace limen::visibility
