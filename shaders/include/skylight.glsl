// Light of the meshes of the sky: as of objects outdoors. The material's luminosity replaces the object's.
#include "incident.glsl"

vec3 skyLight(SkyInstance object, Material material, vec3 normal) {
    vec3 turned = vec3(dot(object.row0.xyz, normal), dot(object.row1.xyz, normal), dot(object.row2.xyz, normal));
    float emission = material.luminosity > 0.0 ? material.luminosity : object.luminosity;
    float facing = max(0.0, dot(unitOrZero(turned), frame.sunDirection.xyz));
    return clamp(emission + frame.skyAmbient.rgb + frame.sunColour.rgb * (object.diffuse * facing), 0.0, 1.0);
}

// Depth behind everything, or before it. Behind everything it equals the plain sky's to the bit: objects are drawn over
// it and over one another.
float skyDepth(SkyInstance object) {
    return object.overLand != 0u ? 0.999 : kSkyDepth;
}

vec4 skyPosition(SkyInstance object, vec3 position) {
    vec4 clip = clipFromEye(blockFromModel(position, object.row0, object.row1, object.row2));
    return vec4(clip.xy, skyDepth(object) * clip.w, clip.w);
}
