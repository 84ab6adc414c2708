#pragma once

#include "dat/records/Models.h"
#include "support/TestShapes.h"

#include <functional>

namespace limen::test {

/// Collects flat polygons as a record stores them. Every corner gets a vertex of its own, with its polygon's
/// normal and texture coordinates of one repeat per metre.
struct MeshRecords {
    dat::VertexArray vertices;
    dat::PolygonList polygons;

    /// Yields the id, an index into `polygons`. A `surface` of -1 draws nothing.
    std::uint16_t add(std::span<const Vec3> points, std::int16_t surface, bool twoSided);
};

/// A tree without planes: one leaf.
[[nodiscard]] dat::BspTree leafTree();

/// The cell tree of a convex cell: a chain of planes, all seen from inside.
[[nodiscard]] dat::BspTree chainTree(std::span<const Plane> planes);

/// Assigns each surface name a slot; `idOf` resolves names.
class SurfaceSlots {
public:
    explicit SurfaceSlots(std::function<std::uint32_t(const std::string&)> idOf) : idOf_(std::move(idOf)) {}
    [[nodiscard]] std::int16_t slot(const std::string& name); ///< -1 for ""
    [[nodiscard]] const std::vector<std::uint32_t>& ids() const { return ids_; }

private:
    std::function<std::uint32_t(const std::string&)> idOf_;
    std::vector<std::uint32_t> ids_;
};

} // namespace limen::test
