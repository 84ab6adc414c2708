// Light and fog. Both are properties of the zone that kept a fragment, never of the frame: a cell has its lamps,
// ambient and share of the sun; outside has sun, sky and fog. Lambert per fragment.
#include "transform.glsl"
#include "gate.glsl"

// 1 at the lamp, 0 with zero slope at its range.
float falloff(float distance, float range) {
    float x = clamp(distance / range, 0.0, 1.0);
    float remaining = 1.0 - x * x;
    return remaining * remaining;
}

vec3 lampLight(Light lamp, vec3 eyeRelative, vec3 normal) {
    vec3 towards = eyeFromBlock(lamp.position.xyz, vec3(0.0), floatBitsToUint(lamp.colour.w)) - eyeRelative;
    float distance = length(towards);
    if (distance >= lamp.position.w) {
        return vec3(0.0);
    }
    // Within a tenth of a millimetre of the lamp the direction means nothing.
    float facing = max(0.0, dot(normal, towards / max(distance, 1.0e-4)));
    return lamp.colour.rgb * facing * falloff(distance, lamp.position.w);
}

// Light that arrives at a surface; `normal` has unit length.
vec3 lightAt(LightSet set, vec3 eyeRelative, vec3 normal) {
    vec3 light = set.ambient.rgb + frame.skyAmbient.rgb * set.ambient.w;
    light += frame.sunColour.rgb * (set.sun * max(0.0, dot(normal, frame.sunDirection.xyz)));
    uint count = min(set.lightCount, kMaxLights);
    for (uint i = 0u; i < count; ++i) {
        light += lampLight(lights[set.firstLight + i], eyeRelative, normal);
    }
    return light;
}

// Share of fog, 0..1, linear between near and far; outside only.
float fogShare(Keep keep, vec3 eyeRelative) {
    if (keep.zone != kOutside) {
        return 0.0;
    }
    float range = max(frame.fogRange.y - frame.fogRange.x, 1.0e-3);
    return clamp((length(eyeRelative) - frame.fogRange.x) / range, 0.0, 1.0);
}

// Albedo lit in the zone that kept the fragment; luminosity is the least light. No fog.
vec3 lit(vec3 albedo, float luminosity, float diffuse, Keep keep, vec3 eyeRelative, vec3 normal) {
    vec3 light = lightAt(lightSets[keep.lightSet], eyeRelative, normalize(normal)) * diffuse;
    return albedo * max(light, vec3(luminosity));
}

// The instance's highlight colour over a lit one; strength in its alpha.
vec3 highlighted(vec3 colour, uint highlight) {
    vec4 over = unpackUnorm4x8(highlight);
    return mix(colour, over.rgb, over.a);
}
