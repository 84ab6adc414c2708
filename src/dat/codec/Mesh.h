#pragma once

#include "dat/codec/Layout.h"

// Vertex arrays, polygons and BSP trees, the parts that GfxObj and Environment share (docs/formats/geometry.md).
namespace limen::dat {

void vertexArray(ByteReader& io, VertexArray& out);
void vertexArray(ByteWriter& io, const VertexArray& in);

/// Reads `count` polygons, each behind its id.
void polygons(ByteReader& io, PolygonList& out, std::size_t count);
void polygons(ByteWriter& io, const PolygonList& in, std::size_t count);

/// Nodes deeper than this are refused.
inline constexpr int kMaxBspDepth = 512;

void bsp(ByteReader& io, BspTree& out, BspKind kind);
void bsp(ByteWriter& io, const BspTree& in, BspKind kind);

} // namespace limen::dat
