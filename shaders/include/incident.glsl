// Light and fog at a point, Lambert, for vertices and fragments. Light belongs to a zone, not to the frame: a cell has
// lamps, ambient light and a share of the sun; the outside has sun, sky and fog.
#include "transform.glsl"

// 1 at the lamp; 0 with zero slope at its range.
float falloff(float distance, float range) {
    float x = clamp(distance / range, 0.0, 1.0);
    float remaining = 1.0 - x * x;
    return remaining * remaining;
}

// Share of a lamp's colour that reaches a surface. `towards`: from there to the lamp.
float lampShare(vec3 towards, float range, vec3 normal) {
    float distance = length(towards);
    // Within 0.1 mm of the lamp the direction is undefined.
    float facing = max(0.0, dot(normal, towards / max(distance, 1.0e-4)));
    return facing * falloff(distance, range);
}

vec3 lampLight(Light lamp, vec3 eyeRelative, vec3 normal) {
    vec3 towards = eyeFromBlock(lamp.position.xyz, vec3(0.0), floatBitsToUint(lamp.colour.w)) - eyeRelative;
    if (length(towards) >= lamp.position.w) {
        return vec3(0.0);
    }
    return lamp.colour.rgb * lampShare(towards, lamp.position.w, normal);
}

// Incident light; `normal` has unit length.
vec3 lightAt(LightSet set, vec3 eyeRelative, vec3 normal) {
    vec3 light = set.ambient.rgb + frame.skyAmbient.rgb * set.ambient.w;
    light += frame.sunColour.rgb * (set.sun * max(0.0, dot(normal, frame.sunDirection.xyz)));
    uint count = min(set.lightCount, kMaxLights);
    for (uint i = 0u; i < count; ++i) {
        light += lampLight(lights[set.firstLight + i], eyeRelative, normal);
    }
    return light;
}

// Share of fog outside, 0..1, linear between near and far.
float fogOutside(vec3 eyeRelative) {
    float range = max(frame.fogRange.y - frame.fogRange.x, 1.0e-3);
    return clamp((length(eyeRelative) - frame.fogRange.x) / range, 0.0, 1.0);
}
