// Exact outlines. The rasteriser snaps corners to 1/256 pixel and computes coverage from the snapped corners. Where
// three polygons meet in a line without shared corners, each is snapped differently. Neither of the two visible ones
// may then cover a centre near the line, and the hidden third one shows. Here polygons are drawn slightly larger
// (grow.glsl), and each fragment tests whether the ray through its pixel passes over the polygon.
//
// Before this is included: `vec3 cornerOnScreen(uint i)`, from screenFromEye, i below the number of corners.
// Ref: Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection" (2013), for the coordinates in which the ray is the
// z axis.

// Coordinates perpendicular to the ray through a point of the window, in pixels times depth.
vec2 acrossRay(vec3 onScreen, vec2 window) {
    vec2 centre = window - device.viewport.xy * 0.5;
    precise vec2 across = onScreen.xy - centre * onScreen.z;
    return across;
}

// An edge and the half-line to the right of the ray, at the ray's height.
struct EdgeSide {
    bool rises;   // from below the ray to above it
    bool crosses; // the ray's height
    bool isRight; // where it crosses, it is to the right of the ray
};

// Ends by acrossRay(). The lower end comes first in the product, whichever way the edge runs.
EdgeSide edgeSide(vec2 from, vec2 to) {
    bool rises = from.y < 0.0;
    vec2 below = rises ? from : to;
    vec2 above = rises ? to : from;
    precise float side = below.x * above.y - above.x * below.y;
    return EdgeSide(rises, rises != (to.y < 0.0), side > 0.0);
}

// Whether the ray's line passes over the outline: parity of the edges that cross the half-line to its right. Two
// polygons with a common edge evaluate the same expression for it, with its ends in the same order, so no ray passes
// between them. `count`: at least 1.
bool isOverOutline(uint count, vec2 window) {
    bool inside = false;
    vec2 from = acrossRay(cornerOnScreen(count - 1u), window);
    uint i = 0u;
    do {
        vec2 to = acrossRay(cornerOnScreen(i), window);
        EdgeSide edge = edgeSide(from, to);
        inside = inside != (edge.crosses && edge.isRight);
        from = to;
        ++i;
    } while (i < count); // at the end: see walkChain in gate.glsl
    return inside;
}

// The edges of a triangle; edge i ends at corner i.
struct TriangleEdges {
    bvec3 rises;
    bvec3 crosses;
    bvec3 isRight;
};

TriangleEdges triangleEdges(vec2 window) {
    TriangleEdges edges = TriangleEdges(bvec3(false), bvec3(false), bvec3(false));
    vec2 from = acrossRay(cornerOnScreen(2u), window);
    for (uint i = 0u; i < 3u; ++i) {
        vec2 to = acrossRay(cornerOnScreen(i), window);
        EdgeSide edge = edgeSide(from, to);
        edges.rises[i] = edge.rises;
        edges.crosses[i] = edge.crosses;
        edges.isRight[i] = edge.isRight;
        from = to;
    }
    return edges;
}

// As isOverOutline().
bool isOverTriangle(TriangleEdges edges) {
    bvec3 counts = bvec3(edges.crosses.x && edges.isRight.x, edges.crosses.y && edges.isRight.y, edges.crosses.z && edges.isRight.z);
    return counts.x != (counts.y != counts.z);
}
