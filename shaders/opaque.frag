// Opaque surfaces. Out: colour; the polygon's id. FLAT: colour of the id.
#define SOLID
#include "surface.glsl"
#include "idcolour.glsl"
#ifdef DETAILS
#include "details.glsl"
#endif

layout(location = kOutputColour) out vec4 outColour;
layout(location = kOutputId) out uint outId;

void main() {
    Painted painted = paintedHere();
    vec2 dx = dFdx(painted.uv);
    vec2 dy = dFdy(painted.uv);
    Instance instance = drawnInstance();
    bool keep = isKept(instance);
    if (!keep) {
        discard;
    }
#ifdef FLAT
    outColour = colourOfId(vId);
#else
    Material material = materialAt(vSurface);
    vec3 albedo = materialColour(material, painted.uv, dx, dy).rgb;
#ifdef DETAILS
    uint detail = detailOf(kindOf(instance));
    if (frame.detailTiling[detail] > 0.0) {
        albedo = grained(albedo, grainTexels(detail, painted.uv, dx, dy));
    }
#endif
    outColour = opaqueColour(albedo, painted, instance);
#endif
    outId = vId;
}
