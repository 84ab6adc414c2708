#pragma once

#include "check/EyeContact.h"
#include "check/PolygonTable.h"
#include "check/Retracer.h"
#include "reference/Picture.h"

#include <optional>

namespace limen::check {

/// A loaded world, prepared for tracing. Parts are made on demand, so it serves one thread at a time. The
/// world must outlive it.
class TracedWorld {
public:
    /// Until setDynamics() is called nothing moves and all openings are open.
    explicit TracedWorld(const world::World& world);
    TracedWorld(const TracedWorld&) = delete;
    TracedWorld& operator=(const TracedWorld&) = delete;
    void setDynamics(const world::DynamicState& dynamics);

    [[nodiscard]] const world::World& world() const { return world_; }
    [[nodiscard]] const reference::Scene& scene() const { return scene_; }
    [[nodiscard]] const reference::Scene& sceneByZone();
    [[nodiscard]] const PolygonTable& polygons();

private:
    const world::World& world_;
    world::DynamicState dynamics_;
    reference::Scene scene_;
    std::optional<reference::Scene> byZone_;
    bool byZoneIsOld_ = true; ///< byZone_ has an older dynamic state
    std::optional<PolygonTable> polygons_;
};

/// The second looks at one view of a traced world.
class ViewRetracer final : public Retracer {
public:
    ViewRetracer(TracedWorld& traced, const reference::Camera& camera) : traced_(traced), camera_(camera) {}

    reference::Answer exact(double x, double y) override;
    reference::Answer byZone(double x, double y) override;
    bool leadsIntoTheRoot(double x, double y) override;
    bool isEdgeOn(double x, double y, std::uint32_t id, double shown) override;
    double outlineRounding(double x, double y, std::uint32_t id) override;
    void polygonsAlong(double x, double y, std::vector<std::uint32_t>& ids) override;
    bool mayHaveDepth(int x, int y, std::uint32_t id, double drawn) override;

private:
    const std::vector<Triangle>& trianglesOf(std::uint32_t id);

    TracedWorld& traced_;
    reference::Camera camera_;
    std::optional<EyeContact> contact_;
    std::uint32_t trianglesId_ = 0; ///< the id of triangles_
    std::vector<Triangle> triangles_;
};

} // namespace limen::check
