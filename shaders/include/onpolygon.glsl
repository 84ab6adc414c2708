// Where a fragment lies on its polygon. The rasteriser snaps corners to 1/256 of a pixel, decides by them which pixels a
// polygon covers, and extends depth and position from the triangle's plane to the pixel's centre. On a polygon seen
// edge-on that leads far off the polygon: metres before its near edge, in front of what hides it, or out of its own cell.
// Here such a fragment is moved back, along its ray, to the stretch in which the ray passes over the polygon.
#include "transform.glsl"

// Not for MULTISAMPLED: one depth for all samples of a pixel would flatten every edge.
#if defined(EXACT_DEPTH) && !defined(MULTISAMPLED)

// Pixels, either side: corners are snapped by up to half of 1/256 of a pixel each way. The same as kSnap of the gate.
const float kBesideRay = 1.0 / 128.0;
// Share of the depth that snapping may have cost before it is worth looking: a hundred times what floats lose.
const float kDepthDoubt = 1.0e-5;
// A fragment whose ray only passes beside its polygon lies on the outline, at equal depth with the polygon beyond the edge,
// if there is one. That one is the one to be seen.
// Translucent surfaces count beside each other, at equal depth too.
#ifdef TRANSLUCENT
const float kBehindNeighbour = 0.0;
#else
const float kBehindNeighbour = 1.0e-5;
#endif

vec3 loopCorner(Instance instance, uint index) {
    return eyeFromBlock(blockFromModel(cornerAt(index), instance.row0, instance.row1, instance.row2), instance.block);
}

// Newell's normal about the first corner, so that nothing large cancels.
vec3 loopNormal(Instance instance) {
    vec3 origin = loopCorner(instance, vLoop.x);
    vec3 sum = vec3(0.0);
    vec3 before = loopCorner(instance, vLoop.x + 1u) - origin;
    for (uint i = 2u; i < vLoop.y; ++i) {
        vec3 next = loopCorner(instance, vLoop.x + i) - origin;
        sum += cross(before, next);
        before = next;
    }
    return normalize(sum);
}

// The depths between which the ray with this direction (depth 1) passes over the polygon (zw), or within kBesideRay of it
// (xy); empty (x > y, z > w) if it does not. In the polygon's plane the ray is a line; each outline edge that crosses it,
// or comes within a band around it, bounds the stretch.
vec4 stretchOver(Instance instance, vec3 direction) {
    vec3 normal = loopNormal(instance);
    vec3 along = direction - normal * dot(normal, direction);
    along /= dot(along, along);
    vec3 across = normalize(cross(normal, direction));
    float beside = kBesideRay * frame.pixel;
    vec2 stretch = vec2(3.0e38, -3.0e38);
    vec2 crossed = stretch;
    vec3 from = loopCorner(instance, vLoop.x + vLoop.y - 1u);
    for (uint i = 0u; i < vLoop.y; ++i) {
        vec3 to = loopCorner(instance, vLoop.x + i);
        vec2 depths = vec2(dot(along, from), dot(along, to));
        vec2 sides = vec2(dot(across, from), dot(across, to));
        // Part of the edge with |side| <= beside * |depth|: edges behind the eye bound the stretch as well.
        vec2 left = abs(depths) * beside - sides;
        vec2 right = abs(depths) * beside + sides;
        float first = 0.0;
        float last = 1.0;
        first = left.x < 0.0 ? (left.y < 0.0 ? 2.0 : left.x / (left.x - left.y)) : first;
        last = left.y < 0.0 ? (left.x < 0.0 ? last : left.x / (left.x - left.y)) : last;
        first = right.x < 0.0 ? (right.y < 0.0 ? 2.0 : max(first, right.x / (right.x - right.y))) : first;
        last = right.y < 0.0 ? (right.x < 0.0 ? last : min(last, right.x / (right.x - right.y))) : last;
        if (first <= last) {
            vec2 ends = vec2(mix(depths.x, depths.y, first), mix(depths.x, depths.y, last));
            stretch = vec2(min(stretch.x, min(ends.x, ends.y)), max(stretch.y, max(ends.x, ends.y)));
        }
        if ((sides.x < 0.0) != (sides.y < 0.0)) {
            float at = mix(depths.x, depths.y, sides.x / (sides.x - sides.y));
            crossed = vec2(min(crossed.x, at), max(crossed.y, at));
        }
        from = to;
    }
    return vec4(stretch, crossed);
}

// The fragment's eye-relative position; sets its depth.
vec3 onPolygon(Instance instance) {
    float depth = 1.0 / gl_FragCoord.w;
    bool doubtful = fwidth(depth) * kBesideRay > kDepthDoubt * depth;
    gl_FragDepth = gl_FragCoord.z;
    if (!doubtful || vLoop.y < 3u) {
        return vEyeRelative;
    }
    vec3 direction = vEyeRelative / depth;
    vec4 stretch = stretchOver(instance, direction);
    float moved = stretch.x <= stretch.y ? clamp(depth, stretch.x, stretch.y) : depth;
    bool isBeside = stretch.z > stretch.w || moved < stretch.z || moved > stretch.w;
    if (!(moved > 0.0) || !isBeside) {
        return vEyeRelative;
    }
    gl_FragDepth = min(frame.nearPlane / (moved * (1.0 + kBehindNeighbour)), 1.0);
    return direction * moved;
}

#else

vec3 onPolygon(Instance instance) {
    return vEyeRelative;
}

#endif
