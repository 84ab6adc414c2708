// Draws an outline slightly larger, so that every pixel whose centre it covers gets a fragment however corners are
// snapped. Fragments outside the true outline are discarded (outline.glsl).
//
// Before this is included: `vec3 outlineCorner(uint i)`, eye-relative.

#include "Tolerances.h"

// Pixels by which edges move outwards. Snapping moves them by up to 1/256.
const float kGrow = kSnapTolerance;
// Pixels. An outline whose visible part is thinner is drawn as one triangle around it.
const float kThin = 2.0 * kGrow;
// Sine of the turn at a corner. Below it a corner moves perpendicular to the edge instead of along both edges; at a
// sharp corner the limit is kSharp.
const float kStraight = 0.02;
const float kSharp = 1.0e-6;
// Limit of a corner's movement, in lengths of its edges.
const float kLongest = 4.0;

// Movement of a corner: outwards along both its edges, by these shares of their lengths, which keeps it in its plane
// and its texture coordinates consistent; or a shift on the screen, in pixels.
struct Growth {
    float before;
    float after;
    vec2 shift;
    bool fails; // the corner would move beyond its plane's horizon, or nearly
};

// `before`, `here`, `after`: clip positions of three consecutive corners; `front`: the outline is seen
// counter-clockwise. An edge L moved by d pixels is the line L + (0, 0, d |L.xy|) in homogeneous pixels; the corner
// moves to the intersection of two. All coordinates are relative to the corner, so that no large terms cancel.
Growth growthAt(vec4 before, vec4 here, vec4 after, bool front) {
    Growth none = Growth(0.0, 0.0, vec2(0.0), true);
    if (abs(here.w) < 1.0e-6) {
        return none;
    }
    vec2 pixels = device.viewport.xy * 0.5;
    vec2 centre = here.xy * pixels / here.w;
    vec2 p = before.xy * pixels - centre * before.w;
    vec2 n = after.xy * pixels - centre * after.w;
    float lengthP = max(length(p), 1.0e-30);
    float lengthN = max(length(n), 1.0e-30);
    vec2 toBefore = p * (sign(here.w) / lengthP);
    vec2 toAfter = n * (sign(here.w) / lengthN);
    float sine = toBefore.y * toAfter.x - toBefore.x * toAfter.y; // positive if the outline turns left here
    if (abs(sine) < (dot(p, n) > 0.0 ? kSharp : kStraight)) {
        vec2 along = toAfter - toBefore;
        float size = max(length(along), 1.0e-30);
        vec2 outwards = (front ? 1.0 : -1.0) * vec2(along.y, -along.x) / size;
        return Growth(0.0, 0.0, kGrow * outwards, false);
    }
    float outwards = front == (sine > 0.0) ? kGrow / abs(sine) : -kGrow / abs(sine);
    vec2 perLength = outwards * sign(here.w) / vec2(lengthP, lengthN);
    float left = 1.0 - perLength.x * (here.w - before.w) - perLength.y * (here.w - after.w);
    vec2 shares = perLength * here.w / left;
    return Growth(shares.x, shares.y, vec2(0.0), left < 0.5 || max(abs(shares.x), abs(shares.y)) > kLongest);
}

// A cheap conservative test for Growth.fails at any corner: possible only if depths differ greatly or the outline may
// be thin.
bool mayFail(vec4 before, vec4 here, vec4 after) {
    float nearest = min(min(before.w, here.w), after.w);
    return nearest < kNearestPlace || max(max(before.w, here.w), after.w) > 1.5 * nearest;
}

// A triangle around the rectangle from `low` to `high`, in pixels from the middle of the screen.
vec2 aroundBox(vec2 low, vec2 high, uint corner, bool front) {
    vec2 size = 2.0 * (high - low + 4.0);
    vec2 origin = low - 2.0;
    bool isRight = corner == (front ? 1u : 2u);
    bool isTop = corner == (front ? 2u : 1u);
    return origin + vec2(isRight ? size.x : 0.0, isTop ? size.y : 0.0);
}

// False only if the triangle of three corners is thicker than kThin by itself.
bool mayBeThin(vec4 before, vec4 here, vec4 after) {
    if (min(min(before.w, here.w), after.w) < kNearestPlace) {
        return true;
    }
    vec2 pixels = device.viewport.xy * 0.5;
    vec2 p = (before.xy / before.w - here.xy / here.w) * pixels;
    vec2 n = (after.xy / after.w - here.xy / here.w) * pixels;
    vec2 opposite = p - n;
    float longest = sqrt(max(max(dot(p, p), dot(n, n)), dot(opposite, opposite)));
    return !(abs(p.x * n.y - p.y * n.x) > kThin * longest);
}

// Triangle around an outline that appears thinner than kThin. Its plane then appears as a line (its horizon), and the
// triangle is placed along that line. Corners 0 and 1 become one end, all other corners the other end.
struct Thin {
    bool is;
    vec2 at; // of the requested corner, in pixels from the middle of the screen
};

// Parts nearer than `closest` metres are ignored.
Thin thinAt(uint count, uint corner, float closest) {
    vec3 origin = outlineCorner(0u);
    vec3 sum = vec3(0.0);
    vec3 last = vec3(0.0);
    float nearest = 3.0e38;
    float farthest = 0.0;
    for (uint i = 0u; i < count; ++i) {
        vec3 next = outlineCorner(i) - origin;
        sum += cross(last, next);
        last = next;
        float w = max(clipFromEye(next + origin).w, closest);
        nearest = min(nearest, w);
        farthest = max(farthest, w);
    }
    float size = length(sum);
    vec3 normal = size > 0.0 ? sum / size : vec3(0.0);
    float height = dot(normal, origin); // positive: seen from behind
    vec2 middle = device.viewport.xy * 0.5;
    vec2 steps = vec2(dot(normal, device.rayRight.xyz), dot(normal, device.rayUp.xyz));
    float steepness = length(steps);
    float thickness = abs(height) * (1.0 / nearest - 1.0 / farthest) / max(steepness, 1.0e-30);
    if (!(thickness < kThin) || steepness < 1.0e-3 * device.pixel) {
        return Thin(false, vec2(0.0));
    }
    vec2 across = steps / steepness;
    vec2 along = vec2(across.y, -across.x);
    float horizon = -(dot(normal, device.rayCorner.xyz) + dot(steps, middle)) / steepness;
    vec2 low = vec2(3.0e38);
    vec2 high = vec2(-3.0e38);
    for (uint i = 0u; i < count; ++i) {
        vec3 p = outlineCorner(i);
        vec4 clip = clipFromEye(p);
        float reach = device.viewport.x + device.viewport.y;
        bool ahead = clip.w >= closest;
        float place = clamp(dot(along, clip.xy * middle) / clip.w, -reach, reach); // in a long line floats lose the pixel
        float side = horizon + dot(normal, p) / (max(clip.w, closest) * steepness);
        low = min(low, vec2(ahead ? place : -reach, side));
        high = max(high, vec2(ahead ? place : reach, side));
    }
    float half_ = (high.y - low.y) * 0.5 + 2.0 * kGrow;
    float begin = low.x - 2.0 * kGrow;
    float end = 2.0 * (high.x + 2.0 * kGrow) - begin;
    float centre = (low.y + high.y) * 0.5;
    float up = (corner == 0u) == (height < 0.0) ? 2.0 * half_ : -2.0 * half_;
    vec2 place = corner < 2u ? vec2(begin, centre + up) : vec2(end, centre);
    return Thin(true, along * place.x + across * place.y);
}
