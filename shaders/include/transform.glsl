// From a model's vertex to the screen. Baked walls and the portal polygons between them use the same expressions,
// marked precise, so that equal inputs give equal bits in every program. That makes openings watertight.
#include "buffers.glsl"

// Block-local metres from model space. A baked mesh has the identity pose, for which products and sums are exact.
vec3 blockFromModel(vec3 model, vec4 row0, vec4 row1, vec4 row2) {
    precise vec3 result = vec3(row0.x * model.x + row0.y * model.y + row0.z * model.z + row0.w,
                               row1.x * model.x + row1.y * model.y + row1.z * model.z + row1.w,
                               row2.x * model.x + row2.y * model.y + row2.z * model.z + row2.w);
    return result;
}

// Eye-relative metres from block-local ones in two floats. The eye has two floats as well: subtracting its rounded part
// from a nearby coordinate is exact (Sterbenz), and the remainders are summed separately. `lost`, the rounding error of
// the sum with the block's origin, is exact if the origin is zero or has no smaller exponent, which holds for
// everything in its block.
// Ref: Dekker, "A floating-point technique for extending the available precision" (1971), for `lost`.
vec3 eyeFromBlock(vec3 local, vec3 rest, uint block) {
    vec3 origin = blockOrigin(block);
    precise vec3 offset = origin + local;
    precise vec3 lost = local - (offset - origin);
    precise vec3 high = offset - frame.eyeHigh.xyz;
    precise vec3 low = (lost + rest) - frame.eyeLow.xyz;
    precise vec3 result = high + low;
    return result;
}

// Clip space from eye-relative.
vec4 clipFromEye(vec3 p) {
    precise vec4 result = frame.clipFromEye[0] * p.x + frame.clipFromEye[1] * p.y + frame.clipFromEye[2] * p.z +
                          frame.clipFromEye[3];
    return result;
}

// Screen position of an eye-relative point: pixels from the middle times depth, and depth.
vec3 screenFromEye(vec3 p) {
    vec4 clip = clipFromEye(p);
    precise vec3 result = vec3(clip.xy * (device.viewport.xy * 0.5), clip.w);
    return result;
}
