// The ownership test (docs: "every pixel has an owner"). A pixel's leaf visit names a chain of visits up to the root;
// a fragment stays when some visit of the chain is in a zone its instance belongs to, and the fragment lies beyond that
// visit's entry plane and not beyond the entry plane of the next visit of the chain.
#include "Tolerances.h"
#include "samples.glsl"

#ifdef MULTISAMPLED
layout(binding = kUnitOwnership) uniform usampler2DMS ownership;
#else
layout(binding = kUnitOwnership) uniform usampler2D ownership;
#endif

// Pixels that a fragment's place may be beside its ray. On a surface seen edge-on (the ceiling of a doorway at eye level) that
// moves it by far more than a millimetre, out of its own cell; too much of it, and a strip of roof seen edge-on is kept though it
// lies metres beyond the opening by which its ray has left.
#ifdef EXACT
// Depth is taken up to kInward from the ray (onpolygon.glsl), and directions are floats, of which a picture 4,000 pixels wide
// makes 0.00025 of a pixel.
const float kSnap = 1.0 / 2048.0;
#else
// Corners are snapped to 1/256 of a pixel each way, so a fragment stands for a point up to twice that from the pixel's centre,
// while its position is extended to the centre along the triangle's plane.
const float kSnap = kSnapTolerance;
#endif

// Where a fragment was kept, and by which light set it is lit there.
struct Keep {
    bool kept;
    uint zone;
    uint lightSet;
};

uint leafVisit() {
#ifdef MULTISAMPLED
    return texelFetch(ownership, ivec2(gl_FragCoord.xy), gl_SampleID).r;
#else
    return texelFetch(ownership, ivec2(gl_FragCoord.xy), 0).r;
#endif
}

// Whether the ray got outside.
bool keepOutside() {
    return visitAt(leafVisit()).zone == kOutside;
}

bool findMember(Instance instance, uint zone, out uint lightSet) {
    lightSet = 0u;
    for (uint i = 0u; i < memberCountOf(instance); ++i) {
        Member member = memberAt(instance.firstMember + i);
        if (member.zone == zone) {
            lightSet = member.lightSet;
            return true;
        }
    }
    return false;
}

// A fragment's position, eye-relative, and how it changes from pixel to pixel.
struct Place {
    vec3 at;
    vec3 dx;
    vec3 dy;
};

// How far a fragment at `place` may lie on the wrong side of a plane with this normal.
float toleranceFor(vec3 normal, Place place) {
#ifdef LIMEN_WITHOUT_GATE_TOLERANCE // tests show that it is needed (docs/proof.md)
    return 0.0;
#endif
    float slope = abs(dot(normal, place.dx)) + abs(dot(normal, place.dy));
    return kEntryPlaneTolerance + kEntryPlaneToleranceSlope * length(place.at) + kSnap * slope;
}

// How far a fragment may lie beyond the plane by which its rays leave, at most. `shutBy`: of the visit beyond.
float leavingTolerance(Instance instance, vec3 normal, uint shutBy, Place place) {
#ifndef LIMEN_WITHOUT_FILLING_FIRST // tests show that it is needed (docs/proof.md)
    if (shutBy != 0u && shutBy != instance.idBase) {
        return -kInPlaneTolerance; // a surface in the plane of a shut opening is met after the filling
    }
#endif
    return toleranceFor(normal, place);
}

// The two halves of the test, for one point.
bool isBeyondEntry(vec4 entryPlane, vec3 at, float tolerance) {
#ifdef LIMEN_WITHOUT_ENTRY_TEST // tests show that it is needed (docs/proof.md)
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

const vec4 kNothingBeyond = vec4(0.0, 0.0, 0.0, -1.0); // the leaf has no next visit

// Walks the chain from the pixel's leaf visit to the root. Parents come before children, so it ends. Without `walks` it has none to
// look at: a loop, for drivers that run every branch for all fragments still end one with its last turn.
Keep walkChain(Instance instance, Place place, bool walks) {
    vec4 next = kNothingBeyond;
    uint shutBy = 0u;
    uint visitIndex = walks ? leafVisit() : kNoVisit;
    while (visitIndex < frame.visitCount) {
        Visit visit = visitAt(visitIndex);
        uint lightSet;
        bool beyondEntry = isBeyondEntry(visit.entryPlane, place.at, toleranceFor(visit.entryPlane.xyz, place));
        bool beforeNext = isBeforeNext(next, place.at, leavingTolerance(instance, next.xyz, shutBy, place));
        if (beyondEntry && beforeNext && findMember(instance, visit.zone, lightSet)) {
            return Keep(true, visit.zone, lightSet);
        }
        next = visit.entryPlane;
        shutBy = visit.shutBy;
        visitIndex = visit.parent;
    }
    return Keep(false, 0u, 0u);
}

// Of a frame with several visits. What the planner drew without the test lies wholly in one of them; only which of several zones
// lights it is open.
Keep keepWhereVisited(Instance instance, Place place, bool isGated) {
    Keep keep = walkChain(instance, place, isGated || memberCountOf(instance) > 1u);
    if (!keep.kept && !isGated) {
        Member first = memberAt(instance.firstMember);
        return Keep(true, first.zone, first.lightSet);
    }
    return keep;
}

// Of a frame with one visit: all that is drawn is seen from there.
Keep keepInRoot(Instance instance) {
    uint lightSet;
    if (memberCountOf(instance) > 1u && findMember(instance, frame.rootZone, lightSet)) {
        return Keep(true, frame.rootZone, lightSet);
    }
    Member first = memberAt(instance.firstMember);
    return Keep(true, first.zone, first.lightSet);
}
