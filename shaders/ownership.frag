// Stage 1: writes the number of the visit that owns the pixel. A later polygon is a nearer one.
// The clip set is tested here and not by gl_ClipDistance: clipping makes new vertices, and edges through new vertices
// are no longer exactly the edges of the walls beside them. Discarding leaves the polygon's own edges untouched.
#include "SharedLayout.h"

layout(location = 0) flat in uint vVisit;
layout(location = 1) in vec4 vClipLow;
layout(location = 2) in vec4 vClipHigh;
layout(location = 0) out uint outVisit;

void main() {
    if (any(lessThan(vClipLow, vec4(0.0))) || any(lessThan(vClipHigh, vec4(0.0)))) {
        discard;
    }
    outVisit = vVisit;
}
