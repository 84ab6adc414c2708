// Exact outlines. The rasteriser snaps corners to 1/256 of a pixel and decides by the snapped ones which centres a polygon
// covers. Where three polygons meet in a line without sharing corners, each is snapped its own way, and a centre near the
// line may be covered by none of the two that are seen there, so that a hidden third one shows. Here polygons are drawn a
// little larger than they are (grow.glsl), and each fragment decides for itself whether the ray through its centre passes
// over the polygon.
//
// Before this is included: `vec3 cornerOnScreen(uint i)`, of screenFromEye, i below the number of corners.
// Ref: Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection" (2013), for the coordinates in which the ray is the z axis.

// Across the ray through a point of the window, in pixels times depth.
vec2 acrossRay(vec3 onScreen, vec2 window) {
    vec2 centre = window - device.viewport.xy * 0.5;
    precise vec2 across = onScreen.xy - centre * onScreen.z;
    return across;
}

// Whether the line of the ray passes over the outline: how many edges cross the half-line to its right. Two polygons that
// share an edge compute the very same for it, for its ends are taken in the same order, so that no ray slips between them.
bool isOverOutline(uint count, vec2 window) {
    bool inside = false;
    vec2 from = acrossRay(cornerOnScreen(count - 1u), window);
    for (uint i = 0u; i < count; ++i) {
        vec2 to = acrossRay(cornerOnScreen(i), window);
        if ((from.y < 0.0) != (to.y < 0.0)) {
            vec2 below = from.y < 0.0 ? from : to;
            vec2 above = from.y < 0.0 ? to : from;
            precise float side = below.x * above.y - above.x * below.y;
            inside = inside != (side > 0.0);
        }
        from = to;
    }
    return inside;
}
