#include "world/records/PolygonSource.h"

#include "core/Assert.h"
#include "world/records/Records.h"

#include <algorithm>
#include <unordered_map>

namespace limen::world {
namespace {

/// Metres from the origin. Vertices of intact records are nearer; a farther one means damage.
constexpr double kFarthestPoint = 100000.0;

/// Finds vertices by key. In most lists the key is the position, which needs no map.
class VertexLookup {
public:
    explicit VertexLookup(const dat::VertexArray& array) : array_(&array) {
        for (std::size_t i = 0; i < array.vertices.size() && inOrder_; ++i)
            inOrder_ = array.vertices[i].first == i;
        if (inOrder_)
            return;
        for (const auto& [key, vertex] : array.vertices)
            byKey_[key] = &vertex;
    }
    [[nodiscard]] const dat::Vertex* find(std::uint16_t key) const {
        if (inOrder_)
            return key < array_->vertices.size() ? &array_->vertices[key].second : nullptr;
        const auto found = byKey_.find(key);
        return found == byKey_.end() ? nullptr : found->second;
    }

private:
    const dat::VertexArray* array_;
    bool inOrder_ = true;
    std::unordered_map<std::uint16_t, const dat::Vertex*> byKey_;
};

Vec2f uvOf(const dat::Vertex& vertex, std::span<const std::uint8_t> indices, std::size_t corner) {
    if (vertex.uvs.empty())
        return Vec2f(0.0f);
    const std::size_t index = corner < indices.size() ? indices[corner] : 0;
    const Vec2f uv = vertex.uvs[index < vertex.uvs.size() ? index : 0];
    return std::isfinite(uv.x) && std::isfinite(uv.y) ? uv : Vec2f(0.0f);
}

bool isSane(const Vec3& p) {
    return isFinite(p) && std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) < kFarthestPoint;
}

std::int32_t slot(std::int16_t surface, const std::vector<bool>& drawn) {
    const auto index = static_cast<std::size_t>(surface);
    return surface >= 0 && index < drawn.size() && drawn[index] ? surface : -1;
}

void readSides(const dat::Polygon& polygon, const std::vector<bool>& drawn, SourcePolygon& out) {
    out.frontSlot = slot(polygon.posSurface, drawn);
    out.frontRepeats = (polygon.stippling & dat::kRepeatPositive) != 0;
    if (polygon.sides == static_cast<std::int32_t>(dat::Sides::Double)) {
        out.backSlot = out.frontSlot;
        out.backRepeats = out.frontRepeats;
        out.backIsLitAsFront = true;
    } else if (polygon.sides == static_cast<std::int32_t>(dat::Sides::Both)) {
        out.backSlot = slot(polygon.negSurface, drawn);
        out.backRepeats = (polygon.stippling & dat::kRepeatNegative) != 0;
    }
}

bool readCorners(const VertexLookup& lookup, const dat::Polygon& polygon, SourcePolygon& out) {
    const bool both = polygon.sides == static_cast<std::int32_t>(dat::Sides::Both);
    const std::span<const std::uint8_t> front(polygon.posUv.data(), polygon.posUv.size());
    const std::span<const std::uint8_t> negative(polygon.negUv.data(), polygon.negUv.size());
    for (std::size_t i = 0; i < polygon.vertexKeys.size(); ++i) {
        const dat::Vertex* vertex = lookup.find(polygon.vertexKeys[i]);
        if (vertex == nullptr || !isSane(Vec3(vertex->position)))
            return false;
        const Vec3 normal(vertex->normal);
        out.corners.push_back({Vec3(vertex->position), isFinite(normal) ? normal : Vec3(0.0),
                               uvOf(*vertex, front, i), uvOf(*vertex, both ? negative : front, i)});
    }
    return out.corners.size() >= 3;
}

} // namespace

std::vector<bool> drawnSlots(std::span<const dat::RecordId> surfaces, MeshOwner owner, Records& records) {
    std::vector<bool> drawn;
    for (const dat::RecordId id : surfaces) {
        const dat::Surface* surface = records.surface(id);
        drawn.push_back(owner == MeshOwner::Thing || surface == nullptr || surface->hasImage());
    }
    return drawn;
}

std::vector<SourcePolygon> readPolygons(const dat::VertexArray& vertices, const dat::PolygonList& polygons,
                                        const std::vector<bool>& drawn,
                                        const std::set<std::uint16_t>& portals, dat::RecordId record,
                                        std::vector<Finding>& findings) {
    const VertexLookup lookup(vertices);
    std::vector<SourcePolygon> out;
    out.reserve(polygons.size());
    std::size_t damaged = 0;
    for (const auto& [id, polygon] : polygons) {
        SourcePolygon source;
        source.id = id;
        source.isPortal = portals.contains(id);
        readSides(polygon, drawn, source);
        if (!source.isPortal && !source.isDrawn())
            continue;
        LIMEN_ASSERT(source.frontSlot < std::ssize(drawn) && source.backSlot < std::ssize(drawn),
                     "slots are those of the record");
        if (readCorners(lookup, polygon, source) && out.size() < 0xFFFF)
            out.push_back(std::move(source));
        else
            ++damaged;
    }
    if (damaged > 0)
        note(findings, record,
             std::to_string(damaged) + " polygons name vertices that do not exist or cannot be");
    return out;
}

std::vector<std::vector<Vec3>> readOutlines(const dat::VertexArray& vertices,
                                            const dat::PolygonList& polygons) {
    const VertexLookup lookup(vertices);
    std::vector<std::vector<Vec3>> outlines;
    for (const auto& [id, polygon] : polygons) {
        SourcePolygon source;
        if (!readCorners(lookup, polygon, source))
            continue;
        outlines.emplace_back();
        for (const SourcePolygon::Corner& corner : source.corners)
            outlines.back().push_back(corner.position);
    }
    return outlines;
}

std::vector<PortalPolygonRef> portalRefs(const dat::GfxObj& model, std::size_t portalCount) {
    std::set<std::uint16_t> polygons;
    for (const auto& [id, polygon] : model.polygons)
        polygons.insert(id);
    std::vector<PortalPolygonRef> refs;
    for (const dat::BspNode& node : model.drawingBsp.nodes)
        if (node.tag == dat::BspTag::Port)
            for (const dat::PortalRef& ref : node.portals)
                refs.push_back({ref.polygonId, ref.portalIndex});
    std::erase_if(refs, [&](const PortalPolygonRef& ref) {
        return !polygons.contains(ref.polygonId) || ref.portalIndex >= portalCount;
    });
    return refs;
}

} // namespace limen::world
