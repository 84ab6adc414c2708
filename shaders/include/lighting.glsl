// Fog and highlight of a fragment.
#include "incident.glsl"
#include "gate.glsl"

// Blends the instance's highlight over a lit colour; its alpha is the strength.
vec3 highlighted(vec3 colour, uint highlight) {
    vec4 over = unpackUnorm4x8(highlight);
    return mix(colour, over.rgb, over.a);
}
