// Light and fog, per fragment, Lambert. Both belong to the zone that kept a fragment, not to the frame: a cell has
// lamps, ambient light and a share of the sun; the outside has sun, sky and fog.
#include "transform.glsl"
#include "gate.glsl"

// 1 at the lamp; 0 with zero slope at its range.
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
    // Within 0.1 mm of the lamp the direction is undefined.
    float facing = max(0.0, dot(normal, towards / max(distance, 1.0e-4)));
    return lamp.colour.rgb * facing * falloff(distance, lamp.position.w);
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

// Share of fog, 0..1, linear between near and far. Outside only.
float fogShare(GateResult keep, vec3 eyeRelative) {
    if (keep.zone != kOutside) {
        return 0.0;
    }
    float range = max(frame.fogRange.y - frame.fogRange.x, 1.0e-3);
    return clamp((length(eyeRelative) - frame.fogRange.x) / range, 0.0, 1.0);
}

// Albedo lit in the zone that kept the fragment. `luminosity` is the lower bound of the light. Without fog.
vec3 lit(vec3 albedo, float luminosity, float diffuse, GateResult keep, vec3 eyeRelative, vec3 normal) {
    vec3 light = lightAt(lightSets[keep.lightSet], eyeRelative, normalize(normal)) * diffuse;
    return albedo * max(light, vec3(luminosity));
}

// Blends the instance's highlight over a lit colour; its alpha is the strength.
vec3 highlighted(vec3 colour, uint highlight) {
    vec4 over = unpackUnorm4x8(highlight);
    return mix(colour, over.rgb, over.a);
}
