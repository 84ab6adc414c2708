// Exact outlines. The rasteriser snaps corners to 1/256 of a pixel and decides by the snapped ones which centres a polygon
// covers. Where three polygons meet in a line without sharing corners, each is snapped its own way, and a centre near the
// line may be covered by none of the two that are seen there, so that a hidden third one shows. Here polygons are drawn a
// little larger than they are (grow.glsl), and each fragment near an edge decides for itself whether the ray through its
// centre passes over the polygon.
//
// Before this is included: `vec3 outlineCorner(uint i)`, eye-relative, i below the number of corners, and ray.glsl.
// Ref: Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection" (2013): in coordinates in which the ray is the z axis an
// edge has the very same sign, reversed, for the two polygons that share it.

// Pixels: nearer to an edge as drawn than this, a fragment is tested. More than growth and snapping together.
const float kNearOutline = 1.0 / 32.0;

// Across the ray through a point of the window, in pixels times depth.
vec2 acrossRay(vec3 p, vec2 window) {
    vec4 clip = clipFromEye(p);
    vec2 centre = window - frame.viewport.xy * 0.5;
    precise vec2 across = clip.xy * (frame.viewport.xy * 0.5) - centre * clip.w;
    return across;
}

// Whether the line of the ray passes over the outline, by the edges it lies to the left of.
bool isOverOutline(uint count, vec2 window) {
    bool inside = false;
    vec2 from = acrossRay(outlineCorner(count - 1u), window);
    for (uint i = 0u; i < count; ++i) {
        vec2 to = acrossRay(outlineCorner(i), window);
        if ((from.y < 0.0) != (to.y < 0.0)) {
            precise float side = from.x * to.y - to.x * from.y;
            inside = inside != ((side > 0.0) == (to.y > from.y));
        }
        from = to;
    }
    return inside;
}
