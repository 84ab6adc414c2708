// The ownership test (docs/ray-rule.md). A pixel's leaf visit has a chain of visits up to the root. A fragment is kept
// if, for some visit of the chain, its instance is a member of the visit's zone, and the fragment is beyond the visit's
// entry plane but not beyond the entry plane of the next visit.
#include "Tolerances.h"
#include "samples.glsl"

#ifdef MULTISAMPLED
layout(binding = kUnitOwnership) uniform usampler2DMS ownership;
#else
layout(binding = kUnitOwnership) uniform usampler2D ownership;
#endif

// Pixels between a fragment's position and its ray. On a surface seen edge-on (a doorway's ceiling at eye level) this
// shifts the fragment by far more than a millimetre, out of its own cell. A larger value would keep a strip of roof
// seen edge-on that is metres beyond the opening by which its ray has left.
#ifdef EXACT
// Depth is taken up to kInward from the ray (onpolygon.glsl). Directions are floats, with an error of 0.00025 pixel in
// a picture 4,000 pixels wide.
const float kSnap = 1.0 / 2048.0;
#else
// Corners are snapped by up to 1/256 pixel in each axis, so a fragment stands for a point up to twice that from the
// pixel's centre, while its position is extrapolated to the centre along the triangle's plane.
const float kSnap = kSnapTolerance;
#endif

// The visit's number, and kOwnedOutside.
uint ownerHere() {
#ifdef MULTISAMPLED
    return texelFetch(ownership, ivec2(gl_FragCoord.xy), gl_SampleID).r;
#else
    return texelFetch(ownership, ivec2(gl_FragCoord.xy), 0).r;
#endif
}

uint leafVisit() {
    return ownerHere() & ~kOwnedOutside;
}

// Whether the pixel's ray ended outside.
bool keepOutside() {
#ifdef CLIPPED
    return true; // the clip planes decide
#endif
    return (ownerHere() & kOwnedOutside) != 0u;
}

// Whether an instance belongs to a visit's zone.
#if defined(FAST) && !defined(MEMBER_LISTS)
// Its record has a bit for each visit (DrawRecord.members).
bool isMember(Instance instance, uint visitIndex, uint zone) {
    uint bits = visitIndex < 32u ? instance.firstMember : instance.membersAndKind;
    return (bits >> (visitIndex & 31u) & 1u) != 0u;
}
#else
// A fast draw of one zone has it in place of the first member, and counts no members. The condition of the loop stands at
// its end: see walkChain.
bool isMember(Instance instance, uint visitIndex, uint zone) {
    uint count = memberCountOf(instance);
    bool isFound = false;
    uint i = 0u;
    do {
        isFound = memberAt(count > 0u ? instance.firstMember + i : 0u).zone == zone && count > 0u;
        ++i;
    } while (!isFound && i < count);
#ifdef FAST
    isFound = isFound || ((instance.membersAndKind & kOneMember) != 0u && instance.firstMember == zone);
#endif
    return isFound;
}
#endif

// A fragment's position, eye-relative, and its change from pixel to pixel.
struct SurfacePoint {
    vec3 at;
    vec3 dx;
    vec3 dy;
};

// Tolerance in metres for `point` on the wrong side of a plane with this normal.
float toleranceFor(vec3 normal, SurfacePoint point) {
#ifdef LIMEN_WITHOUT_GATE_TOLERANCE // tests show the effect of leaving this out (docs/proof.md)
    return 0.0;
#endif
    float slope = abs(dot(normal, point.dx)) + abs(dot(normal, point.dy));
    return kInPlaneTolerance + kEntryPlaneToleranceSlope * length(point.at) + kSnap * slope;
}

// Tolerance in metres beyond the plane by which the rays leave a visit. `shutBy`: of the next visit.
float leavingTolerance(Instance instance, vec3 normal, uint shutBy, SurfacePoint point) {
#ifndef LIMEN_WITHOUT_FILLING_FIRST // tests show the effect of leaving this out (docs/proof.md)
    if (shutBy != 0u && shutBy != instance.idBase) {
        return -kInPlaneTolerance; // a surface in the plane of a shut opening is met after the filling
    }
#endif
    return toleranceFor(normal, point);
}

// The two halves of the test at one point.
bool isBeyondEntry(vec4 entryPlane, vec3 at, float tolerance) {
#ifdef LIMEN_WITHOUT_ENTRY_TEST // tests show the effect of leaving this out (docs/proof.md)
    return true;
#else
    return dot(entryPlane, vec4(at, 1.0)) >= -tolerance;
#endif
}

bool isBeforeNext(vec4 next, vec3 at, float tolerance) {
#ifdef LIMEN_WITHOUT_EXIT_TEST
    return true;
#else
    return dot(next, vec4(at, 1.0)) <= tolerance;
#endif
}

// Whether a surface of the root is before the opening by which the pixel's ray leaves the root; true if it leaves none. Of a
// shut opening a surface in its plane is not: the filling is met first.
bool isBeforeExit(vec3 at) {
    uint visitIndex = leafVisit();
    vec4 next = vec4(0.0);
    uint shutBy = 0u;
    do {
        Visit visit = visitAt(visitIndex);
        bool isRoot = visit.parent >= frame.visitCount;
        next = isRoot ? next : visit.entryPlane;
        shutBy = isRoot ? shutBy : visit.shutBy;
        visitIndex = visit.parent;
    } while (visitIndex < frame.visitCount);
    SurfacePoint point = SurfacePoint(at, vec3(0.0), vec3(0.0)); // beside an edge, depths of adjacent pixels tell no slope
    return isBeforeNext(next, at, shutBy != 0u ? -kInPlaneTolerance : toleranceFor(next.xyz, point));
}

const vec4 kNothingBeyond = vec4(0.0, 0.0, 0.0, -1.0); // the leaf has no next visit

// Follows the chain from the pixel's leaf visit to the root; parents come before children, so it ends. Without `walks`
// it looks at the root alone, in vain. The condition stands at the end of the loop, because software drivers execute the
// body once more than it has turns if the condition stands before it. `afterFilling`: the fragment is not kept, but would be
// if the filling in whose plane it lies were not there.
bool walkChain(Instance instance, SurfacePoint point, bool walks, out bool afterFilling) {
    vec4 next = kNothingBeyond;
    uint shutBy = 0u;
    uint visitIndex = walks ? leafVisit() : 0u;
    bool isKept = false;
    afterFilling = false;
    do {
        Visit visit = visitAt(visitIndex);
        bool beyondEntry = isBeyondEntry(visit.entryPlane, point.at, toleranceFor(visit.entryPlane.xyz, point));
        bool beforeNext = isBeforeNext(next, point.at, toleranceFor(next.xyz, point));
        bool isMet = walks && beyondEntry && beforeNext && isMember(instance, visitIndex, visit.zone);
        isKept = isMet && isBeforeNext(next, point.at, leavingTolerance(instance, next.xyz, shutBy, point));
        afterFilling = afterFilling || (isMet && !isKept);
        next = visit.entryPlane;
        shutBy = visit.shutBy;
        visitIndex = visit.parent;
    } while (!isKept && visitIndex < frame.visitCount);
    return isKept;
}
