// Fast frames are drawn into a viewport of twice the picture's width and height around the picture (kFrameWide, kFrameHigh). Software drivers
// clip triangles at the viewport, and the corners that clipping adds near the eye are off by a part of the picture.
#include "buffers.glsl"

// Applied last: clip distances need the picture's own places.
vec4 widened(vec4 clip) {
    vec2 share = vec2((device.flags & kFrameWide) != 0u ? 0.5 : 1.0, (device.flags & kFrameHigh) != 0u ? 0.5 : 1.0);
    return vec4(clip.xy * share, clip.zw);
}
