// Place of a fragment of the fast way of drawing, eye-relative.
#include "samples.glsl"
#include "ray.glsl"

// The place with this depth in the fragment's pixel. Depth is near plane / view depth, so it is that far along the ray.
vec3 placeAt(float depth) {
    return rayThrough(pixelOfPicture()) * (frame.nearPlane / depth);
}

// The fragment's depth without vBeforePlane. BLENDED: after fastlook.glsl.
float storedDepth() {
#ifdef BLENDED
    return gl_FragCoord.z / vBeforePlane;
#else
    return gl_FragCoord.z;
#endif
}

vec3 placeHere() {
    return placeAt(storedDepth());
}
