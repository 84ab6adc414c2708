// CLIPPED: the clip planes of a region on the screen (docs/gates.md). Needs buffers.glsl, in a vertex stage.
// The planes are lines in clip space, so they also hold for triangles that are drawn larger or around the window.
#ifdef CLIPPED
out float gl_ClipDistance[8];

// After gl_Position is set. Set 0 clips nothing.
void clipBy(uint set) {
    vec3 onScreen = gl_Position.xyw;
    for (int i = 0; i < 8; ++i) {
        vec4 plane = clipSets[set].planes[i];
        gl_ClipDistance[i] = dot(plane.xyz, onScreen) + plane.w;
    }
}

// Of an instance; only records of the plan's own have a clip set.
uint clipSetOf(uint index) {
    if (index < frame.staticInstances) {
        return 0u;
    }
    return ringTexel(device.firstInstance + (index - frame.staticInstances) * kInstanceTexels + 3u).x >> kClipSetShift;
}
#else
void clipBy(uint set) {
}

uint clipSetOf(uint index) {
    return 0u;
}
#endif
