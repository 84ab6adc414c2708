#include "reference/Pyramid.h"

#include <algorithm>
#include <cmath>

namespace limen::reference {
namespace {

constexpr std::size_t kAxis = 4; ///< index of the axis among the planes of the box test
/// A point less ahead than this share of its distance has no sufficiently exact place in the tile.
constexpr double kAhead = 1e-3;
constexpr double kLast = Tile::kSide - 1;

double sumOf(const Vec3& v) {
    return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

} // namespace

Pyramid::Pyramid(const Tile& tile, const Vec3& origin)
    : eye_(tile.camera.eye - origin), forward_(tile.camera.forward) {
    const Camera& camera = tile.camera;
    const double stepX = 2.0 * camera.tanHalfX / camera.width, stepY = 2.0 * camera.tanHalfY / camera.height;
    const double firstX = (tile.left + camera.place.x + 0.5) * stepX - camera.tanHalfX;
    const double firstY = (tile.top + camera.place.y + 0.5) * stepY - camera.tanHalfY; // downwards
    column_ = (camera.right - camera.forward * firstX) / stepX;
    row_ = (-camera.up - camera.forward * firstY) / stepY;
    hand_ = glm::dot(glm::cross(camera.right, camera.forward), camera.up) < 0.0 ? -1.0 : 1.0;
    // A corner carries about four roundings of 2^-53, times at most this factor. An edge's value at a pixel
    // is a sum of six products of two corners' numbers, times at most 7. RayFrame's own roundings are fewer.
    // 2^-42 is sixteen times the sum.
    const double factor = std::max({sumOf(column_), sumOf(row_), 1.0});
    // The roundings of a corner and of the ray's direction, divided by the depth, which is at least kAhead of
    // the reach.
    blur_ = 0x1p-48 * factor / kAhead;
    rounding_ = 0x1p-42 * factor * factor;

    const double lastX = firstX + kLast * stepX, lastY = firstY + kLast * stepY;
    const double mostX = std::max(std::abs(firstX), std::abs(lastX)),
                 mostY = std::max(std::abs(firstY), std::abs(lastY));
    // Float arithmetic is off by about 2^-22 of the summands of a plane's product. Where the summands cancel,
    // they are at most the length of the plane's normal times the distance of the point in the box that a ray
    // meets. Both are at most sqrt(1 + x² + y²), times 1 and times that point's depth. All planes are moved
    // out by sixteen times that.
    slack_ = 0x1p-18 * (1.0 + mostX * mostX + mostY * mostY);
    sides_ = {camera.right - camera.forward * (firstX - slack_),
              camera.forward * (lastX + slack_) - camera.right,
              -camera.up - camera.forward * (firstY - slack_), camera.forward * (lastY + slack_) + camera.up};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int i = static_cast<int>(axis);
        for (std::size_t side = 0; side < sides_.size(); ++side)
            planes_[side][axis] = static_cast<float>(sides_[side][i]);
        planes_[kAxis][axis] = static_cast<float>(forward_[i]);
        // As in BoxRay: the rounding of the eye, and a micrometre.
        const double off = std::abs(eye_[i]) * 0x1p-22 + 1e-6;
        below_[axis] = static_cast<float>(eye_[i] - off);
        above_[axis] = static_cast<float>(eye_[i] + off);
    }
}

int Pyramid::meetsBoxes(const float (&sides)[2][3][4], float (&least)[4]) const {
    __m128 low[3], high[3]; // relative to the eye, slightly too low and too high
    for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = _mm_sub_ps(_mm_load_ps(sides[0][axis]), _mm_set1_ps(above_[axis]));
        high[axis] = _mm_sub_ps(_mm_load_ps(sides[1][axis]), _mm_set1_ps(below_[axis]));
    }
    // The greatest or least product of a normal with a point of the box.
    const auto extreme = [&](const std::array<float, 3>& normal, bool greatest) {
        __m128 sum = _mm_setzero_ps();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const __m128 side = (normal[axis] > 0.0f) == greatest ? high[axis] : low[axis];
            sum = _mm_add_ps(sum, _mm_mul_ps(_mm_set1_ps(normal[axis]), side));
        }
        return sum;
    };
    __m128 inmost = extreme(planes_[0], true);
    for (std::size_t side = 1; side < kAxis; ++side)
        inmost = _mm_min_ps(inmost, extreme(planes_[side], true));
    inmost = _mm_min_ps(inmost, extreme(planes_[kAxis], true)); // some of the box is not behind the eye
    _mm_storeu_ps(least, _mm_mul_ps(extreme(planes_[kAxis], false),
                                    _mm_set1_ps(static_cast<float>(std::max(1.0 - slack_, 0.0)))));
    return _mm_movemask_ps(_mm_cmpge_ps(inmost, _mm_setzero_ps()));
}

PixelMask Pyramid::pixelsOf(const Box& box) const {
    double left = kLast, right = 0.0, top = kLast, bottom = 0.0;
    for (std::size_t corner = 0; corner < 8; ++corner) {
        const auto side = [&](std::size_t axis) {
            return corner >> axis & 1 ? box.max[axis] : box.min[axis];
        };
        const Corner at = cornerOf(Vec3(side(0), side(1), side(2)));
        if (at.z <= kAhead * at.reach)
            return ~PixelMask{0}; // some of the box is not ahead
        left = std::min(left, at.x / at.z);
        right = std::max(right, at.x / at.z);
        top = std::min(top, at.y / at.z);
        bottom = std::max(bottom, at.y / at.z);
    }
    const auto first = [&](double least) { return std::max(std::ceil(least - blur_), 0.0); };
    const auto last = [&](double most) { return std::min(std::floor(most + blur_), kLast); };
    PixelMask pixels = 0;
    const double begin = first(left), end = last(right);
    if (begin > end)
        return 0;
    const auto row = ((PixelMask{2} << static_cast<unsigned>(end)) - 1) >>
                     static_cast<unsigned>(begin) << static_cast<unsigned>(begin);
    for (double y = first(top); y <= last(bottom); ++y)
        pixels |= row << (Tile::kSide * static_cast<unsigned>(y));
    return pixels;
}

bool Pyramid::mayMeet(std::span<const Vec3> points, double margin) const {
    return std::all_of(sides_.begin(), sides_.end(), [&](const Vec3& side) {
        const double least = -margin * glm::length(side);
        return std::any_of(points.begin(), points.end(),
                           [&](const Vec3& p) { return glm::dot(side, p - eye_) >= least; });
    });
}

Pyramid::Corner Pyramid::cornerOf(const Vec3& p) const {
    const Vec3 from = p - eye_;
    return {glm::dot(column_, from), glm::dot(row_, from), glm::dot(forward_, from), sumOf(from)};
}

Pyramid::Edge Pyramid::edgeOf(const Corner& a, const Corner& b) const {
    // The volume spanned by both corners and the ray's direction (column, row, 1). It has the sign of
    // edgeSide().
    const double across = hand_ * (b.y * a.z - b.z * a.y), down = hand_ * (b.z * a.x - b.x * a.z),
                 first = hand_ * (b.x * a.y - b.y * a.x);
    // The error of double arithmetic, and that of a pixel's float sums: up to ten roundings of 2^-24.
    const double slack = rounding_ * a.reach * b.reach +
                         0x1p-20 * (std::abs(first) + Tile::kSide * (std::abs(across) + std::abs(down)));
    return {static_cast<float>(first + slack), static_cast<float>(across), static_cast<float>(down)};
}

Pyramid::Cover Pyramid::coverOf(const Triangle& triangle) const {
    const Corner a = cornerOf(triangle.a), b = cornerOf(triangle.b), c = cornerOf(triangle.c);
    Edge edges[3];
    std::size_t crossing = 0; // edges that divide the tile
    const auto isOutside = [&](const Corner& from, const Corner& to) {
        const Edge edge = edgeOf(from, to);
        constexpr auto last = static_cast<float>(kLast);
        if (edge.atFirst + last * (std::max(edge.across, 0.0f) + std::max(edge.down, 0.0f)) < 0.0f)
            return true;
        if (edge.atFirst + last * (std::min(edge.across, 0.0f) + std::min(edge.down, 0.0f)) < 0.0f)
            edges[crossing++] = edge;
        return false;
    };
    if (isOutside(b, c) || isOutside(c, a) || isOutside(a, b))
        return {};
    Cover cover{~PixelMask{0}, std::min({a.z, b.z, c.z}), std::max({a.z, b.z, c.z})};
    // A parameter is a mean of the corners' depths, up to rounding.
    const double off = 1e-9 * (a.reach + b.reach + c.reach);
    cover.least -= off;
    cover.most += off;
    for (std::size_t i = 0; i < crossing; ++i) {
        const __m128 columns = _mm_set_ps(3.0f, 2.0f, 1.0f, 0.0f), four = _mm_set1_ps(4.0f * edges[i].across);
        const __m128 down = _mm_set1_ps(edges[i].down);
        __m128 left =
            _mm_add_ps(_mm_set1_ps(edges[i].atFirst), _mm_mul_ps(columns, _mm_set1_ps(edges[i].across)));
        PixelMask pixels = 0;
        for (std::uint32_t row = 0; row < Tile::kSide; ++row) {
            const __m128 right = _mm_add_ps(left, four);
            const int outside = _mm_movemask_ps(left) | _mm_movemask_ps(right) << 4; // the signs
            pixels |= static_cast<PixelMask>(~outside & 0xFF) << (row * Tile::kSide);
            left = _mm_add_ps(left, down);
        }
        cover.pixels &= pixels;
    }
    return cover;
}

} // namespace limen::reference
