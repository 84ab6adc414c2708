// Landscape, blended per landcell (terrainblend.glsl). In: uv is the position within the landcell, (0,0) at its
// south-west corner. Out: colour; the landcell triangle's id. FLAT: colour of the id.
#include "surface.glsl"
#include "terrainblend.glsl"
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
    CellUv uv = CellUv(vec2(painted.uv.x, 1.0 - painted.uv.y), vec2(dx.x, -dx.y), vec2(dy.x, -dy.y));
    vec3 albedo = blendedTerrain(vSurface, uv);
#ifdef DETAILS
    float viewDepth = (frame.clipFromEye * vec4(painted.at, 1.0)).w;
    vec4 grain = grainTexels(kDetailOfLand, uv.at, uv.dx, uv.dy);
#ifdef GRAIN_UNLIT
    outColour = coveredColour(grainedGround(albedo * lightHere(painted, instance), grain, viewDepth), painted, instance);
#else
    outColour = opaqueColour(grainedGround(albedo, grain, viewDepth), painted, instance);
#endif
#else
    outColour = opaqueColour(albedo, painted, instance);
#endif
#endif
    outId = vId;
}
