// Colour, texture and alpha of a material, for vertices of the fast way of drawing. After fastlook.glsl.
#include "split.glsl"

// Colour = texel * times + plus.
struct Look {
    vec3 times;
    vec3 plus;
};

// A material without a texture is its colour alone.
void setTexture(Material material, Look look) {
    bool hasTexture = material.texture != kNoTexture;
    vTexture = hasTexture ? textureRefAt(material.texture).place.xy : uvec2(0u);
    vTimes = hasTexture ? look.times : vec3(0.0);
    vPlus = hasTexture ? look.plus : look.plus + look.times;
}

#if defined(CUTOUT) || defined(BLENDED)
// Alpha = texel.a * x + y, kept from z to below w.
vec4 alphaOf(Material material, float whole, bool isInverse, vec2 kept) {
    vec2 factors = isInverse ? vec2(-whole, whole) : vec2(whole, 0.0);
    return vec4(material.texture != kNoTexture ? factors : vec2(0.0, factors.x + factors.y), kept);
}
#endif

#ifdef CUTOUT
float largerSide(TextureRef ref) {
    return float(max(ref.place.z & ~kTextureClamp, ref.place.w));
}
#endif

#ifdef BLENDED
vec4 blendedAlpha(Material material, float opacity, vec2 kept) {
    if (isAddedWhole(material.flags)) {
        return vec4(0.0, material.colour.a * opacity, kept);
    }
    return alphaOf(material, material.colour.a * opacity, (material.flags & kMaterialInvAlpha) != 0u, kept);
}
#endif
