#include "engine/map/Footprints.h"

#include <algorithm>
#include <cmath>

namespace limen::engine {
namespace {

constexpr double kMostMetres = 400.0; ///< larger models are damaged or no buildings

Vec3 placed(const dat::Frame& frame, const Vec3& point) {
    const dat::Frame& f = frame;
    return Quat(static_cast<double>(f.orientation.w), static_cast<double>(f.orientation.x),
                static_cast<double>(f.orientation.y), static_cast<double>(f.orientation.z)) *
               point +
           Vec3(f.origin);
}

const dat::AnimationFrame* placementOf(const dat::Setup& setup) {
    for (const std::uint32_t wanted : {dat::Setup::kPlacementResting, dat::Setup::kPlacementDefault})
        for (const auto& [kind, frame] : setup.placementFrames)
            if (kind == wanted)
                return &frame;
    return nullptr;
}

} // namespace

void Footprints::Extent::add(const Vec3& point) {
    const Vec2 at(point);
    if (!(std::abs(at.x) < kMostMetres && std::abs(at.y) < kMostMetres))
        return;
    least = isEmpty ? at : glm::min(least, at);
    most = isEmpty ? at : glm::max(most, at);
    isEmpty = false;
}

void Footprints::addMesh(dat::RecordId gfxObj, const dat::Frame& frame, const Vec3& scale, Extent& extent) {
    if (const dat::GfxObj* mesh = records_.gfxObj(gfxObj))
        for (const auto& [key, vertex] : mesh->vertexArray.vertices)
            extent.add(placed(frame, Vec3(vertex.position) * scale));
}

Footprints::Extent Footprints::extentOf(dat::RecordId model) {
    Extent extent;
    if (world::isGfxObj(model))
        addMesh(model, {}, Vec3(1.0), extent);
    const dat::Setup* setup = world::isSetup(model) ? records_.setup(model) : nullptr;
    const dat::AnimationFrame* placement = setup != nullptr ? placementOf(*setup) : nullptr;
    for (std::size_t i = 0; setup != nullptr && i < setup->parts.size(); ++i)
        addMesh(setup->parts[i],
                placement != nullptr && i < placement->parts.size() ? placement->parts[i] : dat::Frame{},
                i < setup->scales.size() ? Vec3(setup->scales[i]) : Vec3(1.0), extent);
    return extent;
}

std::optional<Footprint> Footprints::of(const dat::Building& building) {
    auto found = extents_.find(building.model);
    if (found == extents_.end())
        found = extents_.emplace(building.model, extentOf(building.model)).first;
    const Extent& extent = found->second;
    if (extent.isEmpty)
        return std::nullopt;
    const auto corner = [&](double x, double y) { return Vec2(placed(building.frame, {x, y, 0.0})); };
    return Footprint{corner(extent.least.x, extent.least.y), corner(extent.most.x, extent.least.y),
                     corner(extent.most.x, extent.most.y), corner(extent.least.x, extent.most.y)};
}

} // namespace limen::engine
