// Opaque surfaces. Out: colour; the polygon's id. FLAT: the colour is the id's.
#include "surface.glsl"
#include "idcolour.glsl"

layout(location = kOutputColour) out vec4 outColour;
layout(location = kOutputId) out uint outId;

void main() {
    vec2 dx = dFdx(vUv);
    vec2 dy = dFdy(vUv);
    Instance instance = drawnInstance();
    Keep keep = keepOf(instance);
    if (!keep.kept) {
        discard;
    }
#ifdef FLAT
    outColour = colourOfId(vId);
#else
    Material material = materials[vSurface];
    vec3 albedo = materialColour(material, dx, dy).rgb;
    outColour = opaqueColour(albedo, material.luminosity, material.diffuse, instance, keep);
#endif
    outId = vId;
}
