// The ray's intersection with a close triangle (close.glsl), in double.
//
// Before this is included: outline.glsl and close.glsl, vCorners and vRests.
// Metres. Edges nearer than this are computed in double. Both triangles at such an edge are close (isClose). The triangle
// beyond a farther edge may be computed in floats, so both evaluate that edge as isOverOutline does: no ray passes between.
const double kNearEdge = 0.9 * kNearestPlace;

// Perpendicular to the eye and an edge; the other way round exactly the negative.
dvec3 facetToEdge(dvec3 from, dvec3 to) {
    precise dvec3 facet = dvec3(from.y * to.z - from.z * to.y, from.z * to.x - from.x * to.z, from.x * to.y - from.y * to.x);
    return facet;
}

bool isNearEdge(dvec3 from, dvec3 to, dvec3 facet) {
    dvec3 along = to - from;
    double most = kNearEdge * kNearEdge;
    bool isBeside = dot(from, along) < 0.0LF && dot(to, along) > 0.0LF && dot(facet, facet) < most * dot(along, along);
    return isBeside || dot(from, from) < most || dot(to, to) < most;
}

// Whether an edge crosses the ray's height to the right of the ray. `byFloats`: the answer for far edges.
bool isRightOfRay(dvec3 from, dvec3 to, dvec3 ray, bool rises, bool byFloats) {
    dvec3 facet = facetToEdge(from, to);
    precise double side = ray.x * facet.x + ray.y * facet.y + ray.z * facet.z;
    return isNearEdge(from, to, facet) ? (rises ? side < 0.0LF : side > 0.0LF) : byFloats;
}

// A corner in two floats.
struct CloseCorner {
    vec3 at;
    vec3 rest;
};

dvec3 exactFromCorner(CloseCorner corner) {
    return dvec3(corner.at) + dvec3(corner.rest);
}

// Metres along the view direction to the front of a close triangle; negative if the ray does not meet it. `edges`: by
// floats. The loop has one turn for each edge, and none if the result is not `wanted` (it is 0 then): a short loop without a
// turn costs little where drivers execute every branch.
float exactDepth(bool wanted, vec3 direction, TriangleEdges edges) {
    dvec3 ray = dvec3(direction);
    CloseCorner from = CloseCorner(vCorners[1], vRests[1]);
    CloseCorner to = CloseCorner(vCorners[2], vRests[2]);
    CloseCorner next = CloseCorner(vCorners[0], vRests[0]);
    bool inside = false;
    float depth = 0.0;
    uint turns = wanted ? 3u : 0u;
    for (uint turn = 0u; turn < turns; ++turn) {
        dvec3 first = exactFromCorner(from);
        dvec3 second = exactFromCorner(to);
        uint edge = turn == 0u ? 2u : turn - 1u; // it ends at `second`
        inside = inside != (edges.crosses[edge] && isRightOfRay(first, second, ray, edges.rises[edge], edges.isRight[edge]));
        dvec3 normal = cross(second - first, exactFromCorner(next) - first);
        double facing = dot(normal, ray);
        double height = dot(normal, first);
        depth = inside && facing < 0.0LF && height < 0.0LF ? float(height / facing) : -1.0;
        CloseCorner before = from;
        from = to;
        to = next;
        next = before;
    }
    return depth;
}
