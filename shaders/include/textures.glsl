// Textures by index, the same for both bindings of TextureStore: handles (BINDLESS) or array pages (PAGE_COUNT of them,
// one unit each; EACH_PAGE(x) expands to x(0) x(3) ... for the pages that the program samples). ShaderLibrary defines
// these macros. The texture differs from fragment to fragment within a draw. So callers take derivatives in uniform
// control flow, and pages are selected by constant index. Exception: PAGES_BY_INDEX, for drivers that shade the
// fragments of one triangle together. These sample one page, and with constant indices the driver would filter all
// pages, because it executes every case of a switch.
#include "buffers.glsl"

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

#ifdef FAST
// Filtered texels of the texture at a place (TextureRef) that is constant over a triangle. Fragments that are
// differentiated together are of one triangle, so they agree on the page. Handle 0: white, because a driver may crash
// when a shader samples it.
vec4 texelsAt(uvec2 place, vec2 uv) {
#ifdef BINDLESS
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
#ifdef BINDLESS
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
