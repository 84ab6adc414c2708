// Whether the ray through a point of the window passes an opening that the rasteriser has covered (FAST): within the clip
// set alone. The planes before the last pass through the eye. Needs ray.glsl.
layout(location = kVaryingVisit) flat in uint vVisit;
layout(location = kVaryingPlane) flat in vec4 vPlane;
layout(location = kVaryingClip) flat in uvec3 vClip; // the set; edges in use; those and the last plane if it is in use

bool isPassed(vec2 window) {
    vec3 direction = rayThrough(window);
    float depth = vPlane.w / dot(vPlane.xyz, direction);
    bool isWithin = true;
    uint turn = 0u;
    do {
        bool isEdge = turn < vClip.y;
        vec4 plane = clipSets[vClip.x].planes[isEdge ? turn : kLastClipPlane];
        isWithin = isWithin && dot(plane.xyz, direction) * (isEdge ? 1.0 : depth) + plane.w >= 0.0;
        ++turn;
    } while (turn < vClip.z); // at the end: see walkChain in gate.glsl
    return isWithin;
}
