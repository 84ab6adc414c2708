// Place of a fragment of the fast way of drawing, eye-relative.
#include "samples.glsl"
#include "ray.glsl"

// The rasteriser's depth is near plane / view depth, so the fragment is that far along its pixel's ray.
vec3 placeHere() {
    return rayThrough(pixelOfPicture()) * (frame.nearPlane / gl_FragCoord.z);
}
