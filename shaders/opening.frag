// Depth of openings, for the gate that orders by depth (docs/gates.md). Out: depth alone.
// AT_FAR: the far plane, so that all later surfaces are nearer. Else the opening itself, kBehindFence metres farther: a
// surface in the opening's plane is still met.
#include "Tolerances.h"
#include "passage.glsl"

const float kBehindFence = kInPlaneTolerance;
const float kLeastApproach = 1.0e-6; // metres towards the plane per metre of view depth: the ray is in the plane

void main() {
    opening = vOpening;
    Passage passage = passageAt(windowPosition());
    if (!passage.isOver) {
        discard;
    }
#ifdef AT_FAR
    gl_FragDepth = 0.0;
#else
    // Without an outline the eye is in the opening's plane: nothing of the eye's cell is beside it.
    float approach = max(abs(dot(vPlane.xyz, rayThrough(windowPosition()))), kLeastApproach);
    float behind = (kBehindFence + kEntryPlaneToleranceSlope * passage.depth) / approach;
    float depth = opening.y > 0u ? passage.depth + behind : frame.nearPlane;
    gl_FragDepth = min(frame.nearPlane / depth, 1.0);
#endif
}
