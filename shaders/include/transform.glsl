// From a model's vertex to the screen. Baked walls and the portal polygons between them go through the same
// expressions, marked precise, so that equal inputs give equal bits in every program: that is what makes openings
// watertight.
#include "buffers.glsl"

// Block-local metres from model space. A baked mesh has the identity, whose products and sums are exact.
vec3 blockFromModel(vec3 model, vec4 row0, vec4 row1, vec4 row2) {
    precise vec3 result = vec3(row0.x * model.x + row0.y * model.y + row0.z * model.z + row0.w,
                               row1.x * model.x + row1.y * model.y + row1.z * model.z + row1.w,
                               row2.x * model.x + row2.y * model.y + row2.z * model.z + row2.w);
    return result;
}

// Eye-relative metres from block-local ones in two floats. The eye comes in two as well: subtracting the rounded part from
// something near it is exact (Sterbenz), and what the roundings left is put together apart. What is lost of the sum with the
// block's origin is exact as long as the origin is zero or has no smaller exponent, as for all that lies in its block.
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

// Where something eye-relative is on the screen: pixels from the middle times depth, and depth.
vec3 screenFromEye(vec3 p) {
    vec4 clip = clipFromEye(p);
    precise vec3 result = vec3(clip.xy * (device.viewport.xy * 0.5), clip.w);
    return result;
}
