// Counts the surfaces of the transparent stage instead of painting them: each polygon once wherever it would be
// blended, at any alpha, in any order. Same vertices, gate and depth test as blended.frag. With a source alpha of
// 0 the blend function (one, one minus source alpha) adds. Out: number of layers, sum of their hashes.
#define TRANSLUCENT
#include "surface.glsl"
#include "layers.glsl"

layout(location = kOutputBlended) out vec4 outLayers;

void main() {
    if (!isKept(drawnInstance())) {
        discard;
    }
    outLayers = vec4(1.0, layerHash(vId), 0.0, 0.0);
}
