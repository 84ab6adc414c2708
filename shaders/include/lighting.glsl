// Light and fog of a fragment, in the zone that kept it.
#include "incident.glsl"
#include "gate.glsl"

// Share of fog, 0..1. Outside only.
float fogShare(GateResult keep, vec3 eyeRelative) {
    return keep.zone == kOutside ? fogOutside(eyeRelative) : 0.0;
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
