#include "dat/codec/Mesh.h"

namespace limen::dat {
namespace {

constexpr std::size_t kMinCellStructBytes = 12 + 8 + 8 + 32 + 4; // counts, vertices, two leaves, drawing flag

/// Polygons behind a packed count.
void packedPolygons(ByteReader& io, PolygonList& out) {
    polygons(io, out, io.packedCount());
}
void packedPolygons(ByteWriter& io, const PolygonList& in) {
    io.packedCount(in.size());
    polygons(io, in, in.size());
}

void surfaceIds(ByteReader& io, std::vector<std::uint32_t>& out) {
    io.array(out, io.packedCount());
}
void surfaceIds(ByteWriter& io, const std::vector<std::uint32_t>& in) {
    io.packedCount(in.size());
    io.array(in, in.size());
}

template <class IO, class G>
void gfxObj(IO& io, RecordId key, G& g) {
    ownId(io, key, g.id);
    io.value(g.flags);
    surfaceIds(io, g.surfaces);
    vertexArray(io, g.vertexArray);
    if (g.flags & GfxObj::kPhysics) {
        packedPolygons(io, g.physicsPolygons);
        bsp(io, g.physicsBsp, BspKind::Physics);
    }
    io.value(g.sortCenter);
    if (g.flags & GfxObj::kDrawing) {
        packedPolygons(io, g.polygons);
        bsp(io, g.drawingBsp, BspKind::Drawing);
    }
    if (g.flags & GfxObj::kHasDegrade)
        io.value(g.degradeId);
}

struct CellStructCounts {
    std::size_t polygons = 0, physicsPolygons = 0, portals = 0;
};

CellStructCounts cellCounts(ByteReader& io, CellStruct&) {
    CellStructCounts n;
    n.polygons = io.count<std::uint32_t>("polygons");
    n.physicsPolygons = io.count<std::uint32_t>("physics polygons");
    n.portals = io.count<std::uint32_t>("portals");
    return n;
}
CellStructCounts cellCounts(ByteWriter& io, const CellStruct& cell) {
    io.count<std::uint32_t>(cell.polygons.size());
    io.count<std::uint32_t>(cell.physicsPolygons.size());
    io.count<std::uint32_t>(cell.portalPolygons.size());
    return {cell.polygons.size(), cell.physicsPolygons.size(), cell.portalPolygons.size()};
}

void optionalDrawingBsp(ByteReader& io, std::optional<BspTree>& tree) {
    const std::size_t start = io.offset();
    const auto present = io.get<std::uint32_t>();
    if (present > 1)
        io.failAt(start, fmt::format("the flag for a drawing BSP is {}; 0 or 1 was expected", present));
    if (present == 1)
        bsp(io, tree.emplace(), BspKind::Drawing);
}
void optionalDrawingBsp(ByteWriter& io, const std::optional<BspTree>& tree) {
    io.value(std::uint32_t{tree ? 1u : 0u});
    if (tree)
        bsp(io, *tree, BspKind::Drawing);
}

template <class IO, class C>
void cellStruct(IO& io, C& cell) {
    const CellStructCounts n = cellCounts(io, cell);
    vertexArray(io, cell.vertexArray);
    polygons(io, cell.polygons, n.polygons);
    io.array(cell.portalPolygons, n.portals);
    io.align(cell.portalPadding);
    bsp(io, cell.cellBsp, BspKind::Cell);
    polygons(io, cell.physicsPolygons, n.physicsPolygons);
    bsp(io, cell.physicsBsp, BspKind::Physics);
    optionalDrawingBsp(io, cell.drawingBsp);
    io.align(cell.padding);
}

template <class IO, class E>
void environment(IO& io, RecordId key, E& e) {
    ownId(io, key, e.id);
    io.template list<std::uint32_t>(e.cells, 4 + kMinCellStructBytes, "cell shapes", [&](auto& keyed) {
        io.value(keyed.first);
        cellStruct(io, keyed.second);
    });
}

constexpr std::size_t kDegradeLevelBytes = 20;

template <class IO, class D>
void degradeInfo(IO& io, RecordId key, D& d) {
    ownId(io, key, d.id);
    io.template list<std::uint32_t>(d.levels, kDegradeLevelBytes, "levels of detail", [&](auto& level) {
        io.value(level.gfxObj);
        io.value(level.mode);
        io.value(level.minDistance);
        io.value(level.idealDistance);
        io.value(level.maxDistance);
    });
}

} // namespace

template <>
Result<GfxObj> decode<GfxObj>(RecordId id, ByteView payload) {
    return decodeWith<GfxObj>(id, payload, [&](ByteReader& io, GfxObj& g) { gfxObj(io, id, g); });
}
template <>
Result<Bytes> encode<GfxObj>(const GfxObj& g) {
    ByteWriter io;
    io.require((g.flags & GfxObj::kPhysics) || (g.physicsPolygons.empty() && g.physicsBsp.nodes.empty()),
               "physics content needs kPhysics");
    io.require((g.flags & GfxObj::kDrawing) || (g.polygons.empty() && g.drawingBsp.nodes.empty()),
               "drawing content needs kDrawing");
    gfxObj(io, g.id, g);
    return io.take(g.id);
}

template <>
Result<Environment> decode<Environment>(RecordId id, ByteView payload) {
    return decodeWith<Environment>(id, payload,
                                   [&](ByteReader& io, Environment& e) { environment(io, id, e); });
}
template <>
Result<Bytes> encode<Environment>(const Environment& e) {
    ByteWriter io;
    environment(io, e.id, e);
    return io.take(e.id);
}

template <>
Result<DegradeInfo> decode<DegradeInfo>(RecordId id, ByteView payload) {
    return decodeWith<DegradeInfo>(id, payload,
                                   [&](ByteReader& io, DegradeInfo& d) { degradeInfo(io, id, d); });
}
template <>
Result<Bytes> encode<DegradeInfo>(const DegradeInfo& d) {
    ByteWriter io;
    degradeInfo(io, d.id, d);
    return io.take(d.id);
}

} // namespace limen::dat
