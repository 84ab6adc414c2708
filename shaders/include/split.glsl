// Textures with alpha of all strengths (foliage, banners) are drawn in two parts. Nearly opaque texels are drawn with
// the solid surfaces and write depth. The others are blended back to front; nearly transparent ones are skipped.
// Surfaces that intersect or are sorted wrongly then look right except at their seams. Only in colour-only frames:
// these surfaces have no id and no depth at any alpha.
const float kSolidAlpha = 0.95;
const float kLeastAlpha = 0.05;
// The two parts overlap a little: two programs do not compute identical bits, and the nearly opaque part hides its own
// surplus.
const float kSplitOverlap = 1.0 / 512.0;
const float kAnyAlpha = 1.0e9; // beyond every alpha
const vec2 kAllAlpha = vec2(-kAnyAlpha, kAnyAlpha);
