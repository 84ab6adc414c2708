// The ray's intersection with a close triangle (close.glsl), in double.
//
// Before this is included: outline.glsl and close.glsl.
// Metres. Edges nearer than this are computed in double. Both triangles at such an edge are close (isClose). The triangle
// beyond a farther edge may be computed in floats, so both evaluate that edge as isOverOutline does: no ray passes between.
const double kNearEdge = 0.9 * kNearestPlace;

bool isNearEdge(dvec3 from, dvec3 to) {
    dvec3 along = to - from;
    double share = clamp(-dot(from, along) / max(dot(along, along), 1.0e-30LF), 0.0LF, 1.0LF);
    dvec3 nearest = from + along * share;
    return dot(nearest, nearest) < kNearEdge * kNearEdge;
}

// As isOverOutline, but the side of near edges is found in double.
bool isOverClose(CloseTriangle t, dvec3 ray, vec2 window) {
    bool inside = false;
    vec2 from = acrossRay(cornerOnScreen(2u), window);
    dvec3 fromEye = t.c;
    for (uint i = 0u; i < 3u; ++i) {
        vec2 to = acrossRay(cornerOnScreen(i), window);
        dvec3 toEye = i == 0u ? t.a : (i == 1u ? t.b : t.c);
        if ((from.y < 0.0) != (to.y < 0.0)) {
            bool rises = from.y < 0.0;
            vec2 below = rises ? from : to;
            vec2 above = rises ? to : from;
            precise float side = below.x * above.y - above.x * below.y;
            dvec3 lower = rises ? fromEye : toEye;
            dvec3 upper = rises ? toEye : fromEye;
            precise double exactSide = -dot(cross(lower, upper), ray);
            inside = inside != (isNearEdge(lower, upper) ? exactSide > 0.0LF : side > 0.0);
        }
        from = to;
        fromEye = toEye;
    }
    return inside;
}

// Depth at which the ray meets the triangle's front; negative if it does not.
float exactDepth(CloseTriangle t, vec3 direction, vec2 window) {
    dvec3 ray = dvec3(direction);
    dvec3 normal = cross(t.b - t.a, t.c - t.a);
    double height = dot(normal, t.a);
    double facing = dot(normal, ray);
    bool isMet = facing < 0.0LF && height < 0.0LF && isOverClose(t, ray, window);
    return isMet ? float(height / facing) : -1.0;
}
