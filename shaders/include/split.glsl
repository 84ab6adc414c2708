// Textures with alpha of all strengths (foliage, banners) are drawn in two parts. Nearly opaque texels are drawn with
// the solid surfaces and write depth. The others are blended back to front; nearly transparent ones are skipped.
// Surfaces that intersect or are sorted wrongly then look right except at their seams. Only in colour-only frames:
// these surfaces have no id and no depth at any alpha.
#include "Tolerances.h"

const float kSolidAlpha = 0.95;
const float kLeastAlpha = 0.05;
// The two parts overlap a little: two programs do not compute identical bits, and the nearly opaque part hides its own
// surplus.
const float kSplitOverlap = 1.0 / 512.0;
// Additive surfaces are added whole, whatever the alpha of their texels, unless the Alpha bit is set, too.
bool isAddedWhole(uint flags) {
    return (flags & (kMaterialAdditive | kMaterialAlpha | kMaterialInvAlpha)) == kMaterialAdditive;
}
// The least alpha of a cut-out (Tolerances.h), by the flags of its material.
float leastAlpha(uint flags) {
    return (flags & kMaterialIndexed) != 0u ? kCutOutAlphaIndexed : kCutOutAlpha;
}
// Means of several texels count from one half on, so that distant foliage is as dense as near one.
const float kFarCutOutAlpha = 0.5;
// 0 where a texel is as large as a pixel or larger; 1 from half a pixel on. `size`: of the picture, in texels.
float farShare(vec2 size, vec2 dx, vec2 dy) {
    return clamp(max(length(dx * size), length(dy * size)) - 1.0, 0.0, 1.0);
}
const float kAnyAlpha = 1.0e9; // beyond every alpha
const vec2 kAllAlpha = vec2(-kAnyAlpha, kAnyAlpha);
