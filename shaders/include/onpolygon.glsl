// Where a fragment lies on its polygon. The rasteriser extends depth and position from the snapped triangle's plane to the
// pixel's centre. Here both are taken from the ray through the centre and the triangle's own plane, and whether the ray
// passes over the polygon at all from its own outline (outline.glsl), so that what a pixel shows is told to the last bits
// of a float.
#include "Tolerances.h"
#include "transform.glsl"

#ifdef EXACT

// Share of the near plane's distance by which a depth may round. What is so little before the plane is met rather than lost.
const float kNearRounding = 1.0e-5;
// Metres: twice the distance at which the rule takes an eye for one in an opening's plane.
const float kEyeInPlane = 2.0 * kInPlaneTolerance;
// Sine of the angle between ray and plane below which rounding (1e-7) makes more of the depth than a thousandth.
const float kGrazing = 1.0e-4;
// Share of its distance by which a place on a plane is off, seen straight on: eight roundings, of the corners, the plane's
// normal and height, and of the ray.
const float kPlaneRounding = 4.8e-7;
// Pixels that a triangle's fringe is wide, and depth is taken inwards at most.
const float kInward = 1.0e-4;
// The same as an angle. Depths tie within some three steps of a float (3.6e-7 of a depth), which two planes that part at 45 degrees
// do within as many radians. What is seen flat changes its depth by much within it: by more than a metre, for a leaf half a
// kilometre away, in 1e-4 of a pixel of a coarse picture. So it is no more than a pixel of a fine one gives: 640 x 360, 90 degrees high.
const float kInwardRadians = 5.56e-7;
// Share of its depth by which what is seen flat may be off, from which on it is taken for as far as it may be: see behindRounding.
const float kFlat = 2.0e-4;
// Share of its depth by which it still is before where the ray leaves it: some ten roundings of that.
const float kBeforeEnd = 2.0e-6;
const float kBehindAll = uintBitsToFloat((127u - kFringeExponent) << 23); // 2^-kFringeExponent
// Share of its products by which a corner's share may round: six roundings.
const float kShareRounding = 3.6e-7;

vec3 cornerOnScreen(uint i) {
    return vOutline[i];
}
#include "ray.glsl"
#include "outline.glsl"

// The depths between which the ray with this direction (depth 1) passes within so many pixels of the polygon; empty (x > y) if
// it does not. In the polygon's plane the ray is a line; each outline edge that comes within a band around it bounds the
// stretch. It is seldom asked for: of no edge, then, and drivers that run every branch for all fragments have a single turn of
// the loop to do.
vec2 stretchOver(bool isAsked, float pixels, vec3 normal, vec3 direction) {
    vec3 along = direction - normal * dot(normal, direction);
    along /= dot(along, along);
    vec3 across = normalize(cross(normal, direction));
    float beside = pixels * frame.pixel;
    vec2 stretch = vec2(3.0e38, -3.0e38);
    vec3 from = vCorners[2];
    vec3 to = vCorners[0];
    vec3 next = vCorners[1];
    uint edges = isAsked ? 3u : 0u;
    for (uint i = 0u; i < edges; ++i) {
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
        vec3 before = from;
        from = to;
        to = next;
        next = before;
    }
    return stretch;
}

// How the corners share in where a ray meets the triangle, and how their shares change along the window, by pixels. Shares are
// positive on the triangle's front, all three where the ray passes over it; their sum may be 0 where it is seen edge-on.
struct Shares {
    vec3 corner;
    vec2 change[3];
    vec3 products; // their sizes: of what the shares are the differences
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

// A step on the window, in pixels.
struct Step {
    vec2 by;
    bool isSmall; // of a ray that passes over the triangle, or beside it by no more than the fringe
};

float inwardRadians() {
    return min(kInward * frame.pixel, kInwardRadians);
}

// Two triangles that share an edge may both lie on one side of it as seen, one behind the other. Closer to the edge than
// floats tell their depths apart, either could show. So depth is taken no closer to an edge than kInward, or kInwardRadians: there
// both are asked at the same place, and they differ.
// Two edges may also be in line as seen, of a near triangle and of a far one, where the eye is in the plane of what joins
// them. Each is computed from corners of its own, and a ray can slip through between them. So triangles have a fringe, by which
// they fill what nothing covers: kInward wide, and as much as rounding may make of more.
Step stepInwards(Shares shares) {
    Step inwards = Step(vec2(0.0), true);
    float most = inwardRadians() / frame.pixel;
#ifdef LIMEN_WITHOUT_DEPTH_INWARDS // tests show that it is needed (docs/proof.md)
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
#ifdef LIMEN_WITHOUT_FRINGE // likewise
    inwards.isSmall = false;
#endif
    return inwards;
}

// View depth where a ray meets the triangle's plane, but no farther off it than the ray passes over it.
float depthOnPlane(vec3 direction, float facing) {
    float onPlane = -vFacet.w / facing;
    bool grazes = !(facing > kGrazing * length(direction));
    vec2 stretch = stretchOver(grazes, kSnapTolerance, vFacet.xyz, direction);
    return stretch.x <= stretch.y ? clamp(onPlane, stretch.x, stretch.y) : onPlane;
}

// Where a ray meets a triangle, or does not.
struct Meeting {
    float depth;     // view depth
    bool isAhead;    // and not behind the eye, as far as rounding can tell: the ray's line has two ends
    bool isOnFringe; // the ray passes over the triangle or its fringe, and the triangle is wider than that
};

// From the plane the depth is off by the more the flatter the plane is seen; within that, what the corners' depths say
// counts, which is the same for all triangles that share an edge, close to that.
Meeting meetPolygon(vec3 direction) {
    Shares shares = sharesAt(windowPlace());
    Step inwards = stepInwards(shares);
    vec3 nearby = direction + frame.rayRight.xyz * inwards.by.x + frame.rayUp.xyz * inwards.by.y;
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
    return Meeting(sum > 0.0 ? clamp(byCorners, depth - off, depth + off) : depth, isAhead, isThere);
}

// The texture coordinate where the ray meets the triangle. What the rasteriser interpolates is that of a place up to 1/256 of
// a pixel away: it may be another texel's.
vec2 uvOnPolygon() {
    vec3 shares = sharesAt(windowPlace()).corner;
    float sum = shares.x + shares.y + shares.z;
    if (sum == 0.0) {
        return uvAt(vTriangle); // an area of nothing; and what is not read here, flat programs need not interpolate
    }
    return (uvAt(vTriangle) * shares.x + uvAt(vTriangle + 1u) * shares.y + uvAt(vTriangle + 2u) * shares.z) / sum;
}

// Cells of a zone that touch reach into each other by what their records' corners are off. Within so much of an edge of its
// triangle, a fragment of a shell that is reached through the back of the wall beyond the edge belongs to a cell that the ray
// is not in: it is to lie behind that wall, and whatever of the ray's own cell is there shows instead. Yields how much farther.
// How much that is follows from how flat the cell's polygons are (world::MeshVertex): a wall's length is one over it.
// Shells are placed as they are: a facet needs no turning. Only of shells: see stretchOver for the loop.
float behindNeighbours(bool isShell, vec3 at, vec3 direction) {
    float farther = 0.0;
    uint edges = isShell ? 3u : 0u;
    for (uint i = 0u; i < edges; ++i) {
        vec3 wall = neighbourAt(vTriangle + i);
        float perMetre = length(wall);
        float height = dot(wall, vCorners[i]); // how far the eye is behind the wall; in its plane it may be in an opening
        float before = dot(wall, at) - height;
        if (height > kEyeInPlane * perMetre && abs(before) < 1.0) {
            farther = max(farther, 2.0 / max(dot(wall, direction), 0.1 * perMetre));
        }
    }
    return farther;
}

// Of what lies in an opening's plane a pane is met first (docs: "Fillings"). What is blended writes no depth, so that it may
// be tested with that of a place before the pane. Yields how much nearer.
float beforePlane(uint kind, vec3 direction) {
#ifdef TRANSLUCENT
    return kind == kKindFilling ? kInPlaneTolerance / max(-dot(vFacet.xyz, direction), kGrazing) : 0.0;
#else
    return 0.0;
#endif
}

// Of a plane seen flat enough floats do not tell the depth: of a leaf half a kilometre away seen at an angle of 0.0005, not to a
// metre, where it is a ten-thousandth of a pixel wide. Then it is put as far as it may be. What is behind it by less and shows
// instead is what pixels around it show; what it would hide by being put too near is not. Yields how much farther; that is
// a millionth of its distance, square to it. But no farther than the ray passes over it: where it ends a wall may begin that no ray
// meets, between two planks for one (of what is SOLID: leaves have no inside). Not so for shells: right behind a cell's wall may be another cell of its zone, that no
// ray reaches through it.
float behindRounding(uint kind, vec3 direction, float depth) {
#ifdef TRANSLUCENT // writes no depth: it hides nothing
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

// Eye-relative. Sets the fragment's depth. False: the ray through the pixel does not meet the triangle's front.
bool findOnPolygon(uint kind, out Place place) {
    vec3 direction = rayThrough(windowPlace());
    Meeting met = meetPolygon(direction);
    float facing = max(-dot(vFacet.xyz, direction), kGrazing * length(direction));
    // Along the plane: what the rasteriser interpolates may be infinite beside a thin triangle.
    place = Place(direction * met.depth, met.depth * (frame.rayRight.xyz + direction * (dot(vFacet.xyz, frame.rayRight.xyz) / facing)),
                  met.depth * (frame.rayUp.xyz + direction * (dot(vFacet.xyz, frame.rayUp.xyz) / facing)));
    float tested = met.depth + behindNeighbours(kind == kKindShell, place.at, direction) - beforePlane(kind, direction) +
                   behindRounding(kind, direction, met.depth);
    bool isOver = met.isAhead && isOverOutline(3u, windowPlace());
    gl_FragDepth = min(frame.nearPlane / max(tested, frame.nearPlane), 1.0) * (isOver ? 1.0 : kBehindAll);
#ifndef TRANSLUCENT // of two that share an edge, a layer is counted once
    isOver = isOver || met.isOnFringe;
#endif
    return isOver && met.depth >= frame.nearPlane * (1.0 - kNearRounding);
}

#else

vec2 uvOnPolygon() {
    return vUv.xy;
}

bool findOnPolygon(uint kind, out Place place) {
    place = Place(vEyeRelative, dFdx(vEyeRelative), dFdy(vEyeRelative));
    return true;
}

#endif
