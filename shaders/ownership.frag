// Stage 1: writes the number of the visit that owns the pixel. A later polygon is a nearer one. The clip set is tested
// here, not by gl_ClipDistance: clipping creates vertices, and edges through new vertices no longer coincide exactly
// with the edges of adjacent walls.
#include "passage.glsl"

layout(location = kOutputVisit) out uint outVisit;

void main() {
    opening = vOpening;
    if (!passageAt(windowPosition()).isOver) {
        discard;
    }
    outVisit = vVisit;
}
