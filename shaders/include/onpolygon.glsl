// Position and depth of a fragment on its polygon. The rasteriser extrapolates both from the snapped triangle's plane
// to the pixel's centre. Here both come from the ray through the pixel and the triangle's own plane, and the outline
// decides whether the ray passes over the polygon (outline.glsl). A pixel's content is then exact to the last bits of a
// float.
#include "Tolerances.h"
#include "transform.glsl"

#ifdef EXACT

// Relative rounding error of a depth at the near plane. A fragment nearer by no more than this is kept.
const float kNearRounding = 1.0e-5;
// Metres. Twice the rule's tolerance for an eye in an opening's plane.
const float kEyeInPlane = 2.0 * kInPlaneTolerance;
// Sine of the angle between ray and plane. Below it, rounding (1e-7) changes the depth by more than a thousandth.
const float kGrazing = 1.0e-4;
// Relative error of a position on a plane seen frontally: eight roundings, of the corners, the plane's normal and
// height, and the ray.
const float kPlaneRounding = 4.8e-7;
// Pixels. Width of a triangle's fringe, and the limit by which the depth sample moves inwards.
const float kInward = 1.0e-4;
// Radians. The same limit as an angle. Depths tie within about three steps of a float (3.6e-7 of the depth); two planes
// that meet at 45 degrees differ by that within as many radians. A surface seen nearly edge-on changes depth quickly: a
// door leaf half a kilometre away by more than a metre within 1e-4 pixel of a coarse picture. So this is one kInward of
// a fine picture: 640 x 360 pixels at 90 degrees high.
const float kInwardRadians = 5.56e-7;
// Relative depth error of a surface seen nearly edge-on, from which it is placed as far as possible: see
// behindRounding.
const float kFlat = 2.0e-4;
// Relative distance that such a fragment keeps before the point where the ray leaves its polygon: about ten roundings.
const float kBeforeEnd = 2.0e-6;
const float kBehindAll = uintBitsToFloat((127u - kFringeExponent) << 23); // 2^-kFringeExponent
// Relative rounding error of a corner's share, of the products it is a difference of: six roundings.
const float kShareRounding = 3.6e-7;

vec3 cornerOnScreen(uint i) {
    return vOutline[i];
}
#include "ray.glsl"
#include "outline.glsl"
#include "close.glsl"
#include "closehit.glsl"

// Depth interval in which the ray with this direction (view depth 1) passes within `pixels` of the polygon; empty (x >
// y) if it does not. In the polygon's plane the ray is a line, and each outline edge within a band around it bounds the
// interval. Rarely needed: otherwise it looks at no edge, so that drivers that execute every branch for all fragments
// run one turn of the loop.
vec2 stretchOver(bool isAsked, float pixels, vec3 normal, vec3 direction) {
    vec3 along = direction - normal * dot(normal, direction);
    along /= dot(along, along);
    vec3 across = normalize(cross(normal, direction));
    float beside = pixels * device.pixel;
    vec2 stretch = vec2(3.0e38, -3.0e38);
    vec3 from = vCorners[2];
    vec3 to = vCorners[0];
    vec3 next = vCorners[1];
    uint edges = isAsked ? 3u : 0u;
    for (uint i = 0u; i < edges; ++i) {
        vec2 depths = vec2(dot(along, from), dot(along, to));
        vec2 sides = vec2(dot(across, from), dot(across, to));
        // The part of the edge with |side| <= beside * |depth|: edges behind the eye also bound the interval.
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
        vec3 before = from;
        from = to;
        to = next;
        next = before;
    }
    return stretch;
}

// Barycentric shares (unnormalised) of the corners at the ray's intersection, and their change per pixel of the window.
// All three are positive where the ray passes over the front of the triangle. Their sum may be 0 for a triangle seen
// edge-on.
struct Shares {
    vec3 corner;
    vec2 change[3];
    vec3 products; // magnitudes of the products whose differences are the shares
};

vec2 changeAcross(vec3 from, vec3 to) {
    return vec2(from.y * to.z - to.y * from.z, to.x * from.z - from.x * to.z);
}

Shares sharesAt(vec2 window) {
    vec3 a = vec3(acrossRay(cornerOnScreen(0u), window), cornerOnScreen(0u).z);
    vec3 b = vec3(acrossRay(cornerOnScreen(1u), window), cornerOnScreen(1u).z);
    vec3 c = vec3(acrossRay(cornerOnScreen(2u), window), cornerOnScreen(2u).z);
    vec3 one = vec3(b.x * c.y, c.x * a.y, a.x * b.y);
    vec3 other = vec3(c.x * b.y, a.x * c.y, b.x * a.y);
    return Shares(one - other, vec2[3](changeAcross(b, c), changeAcross(c, a), changeAcross(a, b)),
                  abs(one) + abs(other));
}

// Shift of the depth sample on the window, in pixels.
struct InwardStep {
    vec2 by;
    bool isSmall; // the ray passes over the triangle or its fringe
};

float inwardRadians() {
    return min(kInward * device.pixel, kInwardRadians);
}

// Two triangles that share an edge may both appear on the same side of it, one behind the other. Closer to the edge
// than floats can separate their depths, either could show. So depth is sampled no closer to an edge than kInward or
// kInwardRadians: both triangles are sampled at the same point, where their depths differ. Edges of a near and a far
// triangle may also appear collinear, if the eye is in the plane of the surface that joins them. Each edge is computed
// from different corners, and a ray can pass between the two. So triangles have a fringe that fills uncovered pixels:
// kInward wide, plus the rounding error.
InwardStep stepInwards(Shares shares) {
    InwardStep inwards = InwardStep(vec2(0.0), true);
    float most = inwardRadians() / device.pixel;
#ifdef LIMEN_WITHOUT_DEPTH_INWARDS // tests show the effect of leaving this out (docs/proof.md)
    inwards.isSmall = false;
    return inwards;
#endif
    for (uint i = 0u; i < 3u; ++i) {
        float perPixel = max(length(shares.change[i]), 1.0e-30);
        float within = shares.corner[i] / perPixel;
        float fringe = kInward + kShareRounding * shares.products[i] / perPixel;
        inwards.by += shares.change[i] * (clamp(most - within, 0.0, most + fringe) / perPixel);
        inwards.isSmall = inwards.isSmall && within >= -fringe;
    }
#ifdef LIMEN_WITHOUT_FRINGE // tests show the effect of leaving this out (docs/proof.md)
    inwards.isSmall = false;
#endif
    return inwards;
}

// View depth of the ray's intersection with the triangle's plane, clamped to the interval in which the ray passes over
// it.
float depthOnPlane(vec3 direction, float facing) {
    float onPlane = -vFacet.w / facing;
    bool grazes = !(facing > kGrazing * length(direction));
    vec2 stretch = stretchOver(grazes, kSnapTolerance, vFacet.xyz, direction);
    return stretch.x <= stretch.y ? clamp(onPlane, stretch.x, stretch.y) : onPlane;
}

// Intersection of a ray with a triangle.
struct Intersection {
    float depth;
    bool isAhead; // in front of the eye, not on the backward half of the ray's line, as far as rounding can tell
    bool isOnFringe; // the ray passes over the triangle or its fringe, and the triangle is wider than its fringe
    bool isExact; // `isAhead` says whether the ray meets the triangle
};

// The depth from the plane has an error that grows as the plane is seen more edge-on. Within that error the depth
// interpolated from the corners is used. Near a shared edge it is the same for both triangles.
Intersection intersectPolygon(vec3 direction) {
    Shares shares = sharesAt(windowPosition());
    InwardStep inwards = stepInwards(shares);
    vec3 nearby = direction + device.rayRight.xyz * inwards.by.x + device.rayUp.xyz * inwards.by.y;
    float facing = -dot(vFacet.xyz, nearby);
    float depth = depthOnPlane(nearby, facing);
    float off = kPlaneRounding * depth / max(facing, kGrazing);
    vec3 corner = shares.corner + vec3(dot(shares.change[0], inwards.by), dot(shares.change[1], inwards.by),
                                       dot(shares.change[2], inwards.by));
    float sum = corner.x + corner.y + corner.z;
    float first = cornerOnScreen(0u).z;
    float byCorners = first + (corner.y * (cornerOnScreen(1u).z - first) + corner.z * (cornerOnScreen(2u).z - first)) / sum;
    bool isThere = inwards.isSmall && min(min(corner.x, corner.y), corner.z) > 0.0;
    float whole = shares.corner.x + shares.corner.y + shares.corner.z;
    bool isAhead = whole > -kShareRounding * (shares.products.x + shares.products.y + shares.products.z);
    return Intersection(sum > 0.0 ? clamp(byCorners, depth - off, depth + off) : depth, isAhead, isThere, false);
}

// Texture coordinate at the ray's intersection. The rasteriser's value belongs to a point up to 1/256 pixel away, which
// may be in another texel.
vec2 uvOnPolygon() {
    vec3 shares = sharesAt(windowPosition()).corner;
    float sum = shares.x + shares.y + shares.z;
    if (sum == 0.0) {
        // a triangle without area. Flat programs do not read vUv here, so that it need not be interpolated.
        return uvAt(vTriangle);
    }
    return (uvAt(vTriangle) * shares.x + uvAt(vTriangle + 1u) * shares.y + uvAt(vTriangle + 2u) * shares.z) / sum;
}

// Adjacent cells of a zone overlap by the error of their recorded corners. Near a triangle's edge, a shell fragment
// reached through the back of the wall beyond that edge belongs to a cell that the ray is not in. It is moved behind
// that wall, so that the ray's own cell shows instead. Yields the added distance along the ray. The width of the zone
// affected follows from the flatness of the cell's polygons (world::MeshVertex): 1 / length of the stored wall vector.
// Shells are placed untransformed, so facets need no turning. Shells only: programs without shells leave it out (NO_SHELLS).
float behindNeighbours(bool isShell, vec3 at, vec3 direction) {
    float farther = 0.0;
#ifndef NO_SHELLS
    uint edges = isShell ? 3u : 1u;
    uint i = 0u;
    do {
        vec3 wall = neighbourAt(vTriangle + i);
        float perMetre = length(wall);
        // distance of the eye behind the wall; in its plane the eye may be in an opening
        float height = dot(wall, vCorners[i]);
        float before = dot(wall, at) - height;
        // At an edge that juts into the cell the triangle is behind the wall, as a reveal is: it hides nothing.
        bool isInCorner = dot(wall, vCorners[(i + 2u) % 3u]) > height;
        if (isShell && isInCorner && height > kEyeInPlane * perMetre && abs(before) < 1.0) {
            farther = max(farther, 2.0 / max(dot(wall, direction), 0.1 * perMetre));
        }
        ++i;
    } while (i < edges); // at the end: see walkChain in gate.glsl
#endif
    return farther;
}

// Of the surfaces in an opening's plane, a pane comes first (docs/ray-rule.md#spaces-portals-fillings). Blended surfaces write no
// depth, so a pane may be tested at a depth before the plane. Yields the reduction.
float beforePlane(uint kind, vec3 direction) {
#ifdef TRANSLUCENT
    return kind == kKindFilling ? kInPlaneTolerance / max(-dot(vFacet.xyz, direction), kGrazing) : 0.0;
#else
    return 0.0;
#endif
}

// Floats cannot resolve the depth of a plane seen nearly edge-on: a door leaf half a kilometre away at an angle of
// 0.0005 not to a metre, where it is 1/10,000 pixel wide. Such a fragment is moved as far as its error allows. A
// surface behind it by less then shows, which neighbouring pixels show, too; a surface that it would wrongly hide is
// not hidden. Yields the added distance, a millionth of the distance measured along the normal. For SOLID surfaces it
// ends where the ray leaves the polygon, because beyond that a wall may begin that no ray meets, between two planks for
// example (door leaves have no inside). Shells are not moved: directly behind a cell's wall there may be another cell
// of the zone that no ray reaches through the wall.
float behindRounding(uint kind, vec3 direction, float depth) {
#ifdef TRANSLUCENT // writes no depth, hides nothing
    return 0.0;
#endif
    float facing = max(-dot(vFacet.xyz, direction), kGrazing * 1.0e-1);
    float share = (kPlaneRounding + inwardRadians()) / facing;
    float farther = kind == kKindShell ? 0.0 : depth * max(share - kFlat, 0.0);
#ifdef SOLID
    vec2 stretch = stretchOver(farther > 0.0, 0.0, vFacet.xyz, direction);
    farther = stretch.x <= stretch.y ? min(farther, max(stretch.y * (1.0 - kBeforeEnd) - depth, 0.0)) : farther;
#endif
    return farther;
}

// The same of a close triangle, whose edges and depth are exact.
Intersection intersectClose(Intersection found, TriangleEdges edges, vec3 direction) {
    bool close = isClose(vFacet.w, min(min(vOutline[0].z, vOutline[1].z), vOutline[2].z));
    float depth = exactDepth(close, direction, edges);
    return Intersection(close ? depth : found.depth, close ? depth > 0.0 : found.isAhead, found.isOnFringe && !close, close);
}

// A stored depth behind all others; one that is there already stays.
float behindAll(float stored) {
    return stored > kVoidDepth ? stored * kBehindAll : stored;
}

// Position eye-relative; sets the fragment's depth. False: the pixel's ray does not meet the triangle's front.
bool findOnPolygon(Instance instance, out SurfacePoint point) {
    uint kind = kindOf(instance);
    vec3 direction = rayThrough(windowPosition());
    TriangleEdges edges = triangleEdges(windowPosition());
    Intersection met = intersectClose(intersectPolygon(direction), edges, direction);
    float facing = max(-dot(vFacet.xyz, direction), kGrazing * length(direction));
    // Derivatives along the plane: the rasteriser's may be infinite beside a thin triangle.
    point = SurfacePoint(direction * met.depth, met.depth * (device.rayRight.xyz + direction * (dot(vFacet.xyz, device.rayRight.xyz) / facing)),
                  met.depth * (device.rayUp.xyz + direction * (dot(vFacet.xyz, device.rayUp.xyz) / facing)));
    float tested = met.depth + behindNeighbours(kind == kKindShell, point.at, direction) - beforePlane(kind, direction) +
                   behindRounding(kind, direction, met.depth);
    bool isOver = met.isAhead && (met.isExact || isOverTriangle(edges));
    float stored = min(frame.nearPlane / max(tested, frame.nearPlane), 1.0);
    gl_FragDepth = isOver ? stored : behindAll(stored);
#ifndef TRANSLUCENT // layers count once where two polygons share an edge, so they have no fringe
    isOver = isOver || met.isOnFringe;
#endif
    return isOver && met.depth >= frame.nearPlane * (1.0 - kNearRounding);
}

#else

vec2 uvOnPolygon() {
    return vUv.xy;
}

bool findOnPolygon(Instance instance, out SurfacePoint point) {
    point = SurfacePoint(vEyeRelative, dFdx(vEyeRelative), dFdy(vEyeRelative));
    return true;
}

#endif
