// Sky objects of the fast way of drawing. GATED: where the pixel's ray ended outside. Out: premultiplied colour.
#define BLENDED
#define SKY
#include "textures.glsl"
#include "gate.glsl"
#define LOOK in
#include "fastlook.glsl"

layout(location = kOutputBlended) out vec4 outColour;

void main() {
    vec4 texel = texelsAt(vTexture, vUv);
#ifdef GATED
    if (!keepOutside()) {
        discard;
    }
#endif
    float alpha = texel.a * vAlpha.x + vAlpha.y;
    outColour = vec4((texel.rgb * vTimes + vPlus) * alpha, alpha * vCover);
}
