// The ownership test of a fast fragment (gate.glsl). GATED programs draw only what needs it, and the planner's other
// draws are wholly inside one visit.
#include "gate.glsl"
#include "place.glsl"

#ifdef GATED

bool isMember(uvec4 members, uint zone) {
    if (members.x == zone) {
        return true;
    }
    bool found = false;
    uint count = members.x == kNoVisit ? members.z : 0u;
    for (uint i = 0u; i < count; ++i) {
        found = found || memberAt(members.y + i).zone == zone;
    }
    return found;
}

// The chain of visits as in walkChain, without light sets. `members`: see fastlook.glsl.
bool isSeen(uvec4 members) {
    vec3 at = placeHere();
    vec3 dx = dFdx(at);
    vec3 dy = dFdy(at);
    float near = kEntryPlaneTolerance + kEntryPlaneToleranceSlope * length(at);
    float beyondNext = -1.0; // metres beyond the next visit's entry plane
    float nextTolerance = 0.0;
    bool seen = members.z == kNoVisit;
    uint index = leafVisit();
    while (!seen && index < frame.visitCount) {
        Visit visit = visitAt(index);
        float beyond = dot(visit.entryPlane, vec4(at, 1.0));
        float tolerance = near + kSnap * (abs(dot(visit.entryPlane.xyz, dx)) + abs(dot(visit.entryPlane.xyz, dy)));
        seen = beyond >= -tolerance && beyondNext <= nextTolerance && isMember(members, visit.zone);
        beyondNext = beyond;
        nextTolerance = visit.shutBy != 0u && visit.shutBy != members.w ? -kInPlaneTolerance : tolerance;
        index = visit.parent;
    }
    return seen;
}
#endif
