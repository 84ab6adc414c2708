// The ownership test of a fast fragment (gate.glsl).
#include "gate.glsl"
#include "place.glsl"

#ifdef GATED
// `members`: see fastlook.glsl.
bool isSeen(uvec3 members) {
    Instance instance;
    instance.firstMember = members.x;
    instance.membersAndKind = members.y;
    instance.idBase = members.z;
    vec3 at = placeHere();
    bool takesTest = members.y > 0u;
    bool afterFilling;
    return walkChain(instance, SurfacePoint(at, dFdx(at), dFdy(at)), takesTest, afterFilling) || !takesTest;
}
#endif
