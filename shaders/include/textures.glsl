// Textures by index, the same for both bindings of TextureStore: handles (BINDLESS) or array pages (PAGE_COUNT of them,
// one unit each; EACH_PAGE(x) expands to x(0) x(3) ... for the pages that the program samples). ShaderLibrary defines
// these macros. The texture differs from fragment to fragment within a draw. So callers take derivatives in uniform
// control flow, and pages are selected by constant index. Exception: PAGES_BY_INDEX, for drivers that shade the
// fragments of one triangle together. These sample one page, and with constant indices the driver would filter all
// pages, because it executes every case of a switch.
#include "buffers.glsl"
#include "AtlasLayout.h"

#ifndef BINDLESS
#if PAGE_COUNT > 0
layout(binding = kUnitFirstPage) uniform sampler2DArray pages[PAGE_COUNT];
#endif
#endif

ivec2 textureSizeOf(TextureRef ref) {
    return ivec2(ref.place.z & ~kTextureClamp, ref.place.w);
}

// Filtered texels at `uv`, with the given derivatives of uv. v runs downwards from the top row.
vec4 sampleTexture(uint index, vec2 uv, vec2 dx, vec2 dy) {
    TextureRef ref = textureRefAt(index);
#ifdef BINDLESS
    return textureGrad(sampler2DArray(ref.place.xy), vec3(uv, 0.0), dx, dy);
#else
    vec3 at = vec3(uv, float(ref.place.x));
#ifdef PAGES_BY_INDEX
    return textureGrad(pages[ref.place.y], at, dx, dy);
#endif
    switch (int(ref.place.y)) {
#define SAMPLE_PAGE(i) case i: return textureGrad(pages[i], at, dx, dy);
        EACH_PAGE(SAMPLE_PAGE)
    }
    return vec4(1.0);
#endif
}

#ifdef ATLAS
// Place in the atlas that src/gpu/texture/Atlas.h lays out: column and row in texels, and layer, of the nearest mip level.
// `place`: of TextureRef. dx, dy: derivatives of uv.
vec3 inAtlas(uvec2 place, vec2 uv, vec2 dx, vec2 dy) {
    ivec2 size = ivec2(place.y & kAtlasTexels, place.y >> kAtlasHeight & kAtlasTexels);
    dx *= vec2(size);
    dy *= vec2(size);
    float stretch = max(dot(dx, dx), dot(dy, dy));
    int last = int(place.y >> kAtlasLastLevel & kAtlasLevels);
    int level = clamp((floatBitsToInt(stretch) >> 23) - 126 >> 1, 0, last); // log2 of the root, rounded
    int above = max(level - 1, 0);
    ivec2 corner = ivec2(min(level, 1) * (size.x + 2), size.y - (size.y >> above) + 3 * above);
    vec2 within = (place.y & kAtlasClamp) != 0u ? clamp(uv, 0.0, 1.0) : fract(uv);
    ivec2 first = ivec2(place.x & kAtlasTexels, place.x >> kAtlasY & kAtlasTexels) + corner + 1;
    return vec3(vec2(first) + within * vec2(max(size >> level, 1)), float(place.x >> kAtlasLayer));
}

// Texels of a wall's grain, unfiltered, because it is stored enlarged, of the nearest mip level. `row`: of its first texel in the
// atlas. `texels`: of a side for each repeat of uv; 0 with kNoGrainRow: black and transparent.
vec4 wallGrain(int row, float texels, vec2 uv) {
    vec2 dx = dFdx(uv);
    vec2 dy = dFdy(uv);
    float stretch = max(dot(dx, dx), dot(dy, dy)) * (texels * texels);
    int level = clamp((floatBitsToInt(stretch) >> 23) - 126 >> 1, 0, int(kGrainLevels) - 1); // as in inAtlas
    int above = max(level - 1, 0);
    int side = int(kGrainSide);
    ivec2 corner = ivec2(1 + min(level, 1) * (side + 2), row + side - (side >> above) + 3 * above);
    ivec2 texel = (ivec2(floor(uv * texels)) & (side - 1)) >> level;
    return texelFetch(pages[ATLAS], ivec3(corner + texel, 0), 0);
}
#endif

#ifdef FAST
// Filtered texels of the texture at a place (TextureRef) that is constant over a triangle. Fragments that are
// differentiated together are of one triangle, so they agree on the page. Handle 0: white, because a driver may crash
// when a shader samples it.
vec4 texelsAt(uvec2 place, vec2 uv) {
#ifdef ATLAS
    vec3 at = inAtlas(place, uv, dFdx(uv), dFdy(uv));
    return textureLod(pages[ATLAS], vec3(at.xy * ATLAS_TEXEL, at.z), 0.0);
#elif defined(BINDLESS)
    return place == uvec2(0u) ? vec4(1.0) : texture(sampler2DArray(place), vec3(uv, 0.0));
#elif PAGE_COUNT == 0
    return vec4(1.0);
#else
    vec3 at = vec3(uv, float(place.x));
#ifdef PAGES_BY_INDEX
    return texture(pages[place.y], at);
#else
    vec2 dx = dFdx(uv);
    vec2 dy = dFdy(uv);
    switch (int(place.y)) {
#define SAMPLE_FAST(i) case i: return textureGrad(pages[i], at, dx, dy);
        EACH_PAGE(SAMPLE_FAST)
    }
    return vec4(1.0);
#endif
#endif
}
#endif

// The texel of mip level 0 that contains `uv`, unfiltered, independent of the driver. For ids and depth of cut-outs.
vec4 nearestTexel(uint index, vec2 uv) {
    TextureRef ref = textureRefAt(index);
    ivec2 size = textureSizeOf(ref);
    bool isClamped = (ref.place.z & kTextureClamp) != 0u;
    vec2 within = isClamped ? clamp(uv, 0.0, 1.0) : uv - floor(uv);
    ivec2 texel = min(ivec2(within * vec2(size)), size - 1);
#ifdef ATLAS
    ivec2 first = ivec2(ref.place.x & kAtlasTexels, ref.place.x >> kAtlasY & kAtlasTexels) + 1;
    return texelFetch(pages[ATLAS], ivec3(first + texel, int(ref.place.x >> kAtlasLayer)), 0);
#elif defined(BINDLESS)
    return texelFetch(sampler2DArray(ref.place.xy), ivec3(texel, 0), 0);
#else
    ivec3 at = ivec3(texel, int(ref.place.x));
#ifdef PAGES_BY_INDEX
    return texelFetch(pages[ref.place.y], at, 0);
#endif
    switch (int(ref.place.y)) {
#define FETCH_PAGE(i) case i: return texelFetch(pages[i], at, 0);
        EACH_PAGE(FETCH_PAGE)
    }
    return vec4(1.0);
#endif
}
