// Triangles close to the eye, in double. A float corner a few metres away is a few ten-millionths of a metre off. Seen
// from a tenth of a millimetre beside an edge, that is several pixels. Only triangles that isClose() selects are
// computed so, in loops that have no turn for others: drivers that execute every branch execute their bodies once.
//
#include "Tolerances.h"
#include "buffers.glsl"

// Metres from the eye to a triangle's plane. As kNearOpening of openings.
const float kCloseTriangle = 0.05;

// `height`: of the eye over the plane. `nearest`: least view depth of the corners, which are behind the eye or near it.
bool isClose(float height, float nearest) {
    return abs(height) < kCloseTriangle && nearest < kNearestPlace;
}

// A vertex, eye-relative. The block's origin, the eye's two parts and the vertex's two are exact.
dvec3 exactFromVertex(uint vertex, Instance instance) {
    dvec3 model = dvec3(cornerAt(vertex)) + dvec3(cornerRestAt(vertex));
    mat3 rows = rowsOf(instance);
    dvec3 turned = dvec3(dot(dvec3(rows[0]), model), dot(dvec3(rows[1]), model), dot(dvec3(rows[2]), model));
    dvec3 fromEye = (dvec3(blockOrigin(instance.block)) - dvec3(frame.eyeHigh.xyz)) - dvec3(frame.eyeLow.xyz);
    return (turned + dvec3(originOf(instance))) + fromEye;
}

struct CloseTriangle {
    dvec3 a;
    dvec3 b;
    dvec3 c;
};

CloseTriangle exactTriangle(uint first, Instance instance) {
    return CloseTriangle(exactFromVertex(first, instance), exactFromVertex(first + 1u, instance),
                         exactFromVertex(first + 2u, instance));
}

// Height of the eye over the triangle's plane, negated: as vFacet.w.
float exactFacetHeight(CloseTriangle t) {
    dvec3 normal = cross(t.b - t.a, t.c - t.a);
    double size = length(normal);
    return size > 0.0LF ? float(dot(normal, t.a) / size) : 0.0;
}
