#include "dat/codec/Mesh.h"

namespace limen::dat {
namespace {

constexpr std::size_t kMinVertexBytes = 2 + 2 + 24;      // key, number of uvs, position, normal
constexpr std::size_t kMinPolygonBytes = 2 + 10 + 3 * 2; // id, fields, three vertex ids

void vertex(ByteReader& io, Vertex& v) {
    const std::size_t uvCount = io.get<std::uint16_t>();
    io.value(v.position);
    io.value(v.normal);
    io.array(v.uvs, uvCount);
}

bool hasPosUv(const Polygon& p) {
    return (p.stippling & kNoPositiveUv) == 0;
}
bool hasNegUv(const Polygon& p) {
    return p.sides == static_cast<std::int32_t>(Sides::Both) && (p.stippling & kNoNegativeUv) == 0;
}

void polygon(ByteReader& io, Polygon& p) {
    const std::size_t start = io.offset();
    const std::size_t n = io.get<std::uint8_t>();
    if (n < 3) {
        if (!io.failed())
            io.failAt(start, fmt::format("a polygon has {} vertices; it needs three", n));
        return;
    }
    io.value(p.stippling);
    io.value(p.sides);
    io.value(p.posSurface);
    io.value(p.negSurface);
    io.array(p.vertexKeys, n);
    if (hasPosUv(p))
        io.array(p.posUv, n);
    if (hasNegUv(p))
        io.array(p.negUv, n);
}

void polygon(ByteWriter& io, const Polygon& p) {
    const std::size_t n = p.vertexKeys.size();
    io.require(n >= 3 && n <= 255, "a polygon has 3 to 255 vertices");
    io.require(hasPosUv(p) || p.posUv.empty(), "kNoPositiveUv says that there are no positive uvs");
    io.require(hasNegUv(p) || p.negUv.empty(), "only a polygon with two surfaces has negative uvs");
    io.value(static_cast<std::uint8_t>(n));
    io.value(p.stippling);
    io.value(p.sides);
    io.value(p.posSurface);
    io.value(p.negSurface);
    io.array(p.vertexKeys, n);
    if (hasPosUv(p))
        io.array(p.posUv, n);
    if (hasNegUv(p))
        io.array(p.negUv, n);
}

} // namespace

void vertexArray(ByteReader& io, VertexArray& out) {
    const std::size_t start = io.offset();
    io.value(out.type);
    if (out.type != 1 && !io.failed()) {
        io.failAt(start, fmt::format("the vertex type is {}; only type 1 is known", out.type),
                  ErrorCode::Unsupported);
    }
    io.list<std::uint32_t>(out.vertices, kMinVertexBytes, "vertices", [&](auto& keyed) {
        io.value(keyed.first);
        vertex(io, keyed.second);
    });
}

void vertexArray(ByteWriter& io, const VertexArray& in) {
    io.require(in.type == 1, "only vertex type 1 is known");
    io.value(in.type);
    io.list<std::uint32_t>(in.vertices, kMinVertexBytes, "vertices", [&](const auto& keyed) {
        const Vertex& v = keyed.second;
        io.value(keyed.first);
        io.count<std::uint16_t>(v.uvs.size());
        io.value(v.position);
        io.value(v.normal);
        io.array(v.uvs, v.uvs.size());
    });
}

void polygons(ByteReader& io, PolygonList& out, std::size_t count) {
    io.items(out, count, kMinPolygonBytes, "polygons", [&](auto& keyed) {
        io.value(keyed.first);
        polygon(io, keyed.second);
    });
}

void polygons(ByteWriter& io, const PolygonList& in, std::size_t count) {
    io.items(in, count, kMinPolygonBytes, "polygons", [&](const auto& keyed) {
        io.value(keyed.first);
        polygon(io, keyed.second);
    });
}

} // namespace limen::dat
