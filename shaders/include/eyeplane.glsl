// Whether a fragment's surface and the eye are in one plane (docs/ray-rule.md#tolerances). Then no ray meets the surface,
// but its triangles can cover any part of the picture, as their corners are rounded. After fastlook.glsl.
#include "place.glsl"

// Micrometres, so that products of places this near the eye are within a float's range.
const float kMicrometres = 1.0e6;

// Metres of view depth. Rays of surfaces further away leave such a plane by less than a pixel.
const float kFarFromPlane = 0.01;

bool isInEyesPlane() {
    vec3 at = placeHere() * kMicrometres;
    vec3 normal = cross(dFdx(at), dFdy(at));
    float height = dot(at, normal);
    float most = kEyeInPlaneTolerance * kMicrometres;
    return storedDepth() > frame.nearPlane / kFarFromPlane && height * height <= most * most * dot(normal, normal);
}
