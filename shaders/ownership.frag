// Stage 1: writes the number of the visit that owns the pixel. A later polygon is a nearer one. The clip set is tested
// here, not by gl_ClipDistance: clipping creates vertices, and edges through new vertices no longer coincide exactly
// with the edges of adjacent walls.
// FAST: the rasteriser's coverage decides the outline.
#define OWNERSHIP
#include "transform.glsl"
#include "ray.glsl"
#include "samples.glsl"
#ifdef FAST
#include "coverage.glsl"
#else
#include "passage.glsl"
#endif

layout(location = kOutputVisit) out uint outVisit;

void main() {
#ifdef FAST
    bool isOver = isPassed(windowPosition());
#else
    opening = vOpening;
    bool isOver = passageAt(windowPosition()).isOver;
#endif
    if (!isOver) {
        discard;
    }
    outVisit = vVisit;
}
