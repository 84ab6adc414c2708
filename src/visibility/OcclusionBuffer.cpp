#include "visibility/OcclusionBuffer.h"

#include "core/Assert.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace limen::visibility {

namespace {

/// The share by which occluders must be nearer than a sphere: some times the rounding of depths.
constexpr double kNearer = 1e-5;
constexpr double kLeastClip =
    0.1; ///< metres: nearer corners would be so far from the picture that doubles are too coarse
constexpr double kMargin = 2.0; ///< pixels around a sphere

/// Eight pixels. Vectors of this width are part of every x86-64 processor.
using Lanes = std::int16_t __attribute__((vector_size(16)));
constexpr std::int32_t kLanes = 8;

Lanes load(const std::int16_t* from) {
    Lanes lanes;
    std::memcpy(&lanes, from, sizeof lanes);
    return lanes;
}

/// All bits of the first `count` lanes.
Lanes firstLanes(std::int32_t count) {
    constexpr std::array<std::int16_t, 2 * kLanes> kMasks{-1, -1, -1, -1, -1, -1, -1, -1,
                                                          0,  0,  0,  0,  0,  0,  0,  0};
    return load(&kMasks[static_cast<std::size_t>(kLanes - count)]);
}

void raise(std::int16_t* pixels, Lanes to) {
    const Lanes before = load(pixels), isMore = to > before;
    const Lanes after = (to & isMore) | (before & ~isMore);
    std::memcpy(pixels, &after, sizeof after);
}

/// Raises `count` pixels to a value at least. Reads up to a vector beyond them.
void raise(std::int16_t* pixels, std::int32_t count, std::int16_t value) {
    const Lanes all = Lanes{} + value;
    for (; count >= kLanes; pixels += kLanes, count -= kLanes)
        raise(pixels, all);
    if (count > 0)
        raise(pixels, all & firstLanes(count));
}

constexpr std::int32_t kTile = 16; ///< side, pixels

/// Whether `count` pixels are more than a value. Reads up to a vector beyond them.
bool areMore(const std::int16_t* pixels, std::int32_t count, std::int16_t value) {
    const Lanes all = Lanes{} + value;
    const auto isAny = [](Lanes lanes) {
        std::array<std::uint64_t, 2> words;
        std::memcpy(&words, &lanes, sizeof words);
        return (words[0] | words[1]) != 0;
    };
    for (; count >= kLanes; pixels += kLanes, count -= kLanes)
        if (isAny(load(pixels) <= all))
            return false;
    return count == 0 || !isAny((load(pixels) <= all) & firstLanes(count));
}

Lanes least(Lanes a, Lanes b) {
    const Lanes isLess = a < b;
    return (a & isLess) | (b & ~isLess);
}

std::int16_t leastOf(Lanes lanes) {
    std::int16_t found = lanes[0];
    for (std::int32_t i = 1; i < kLanes; ++i)
        found = std::min<std::int16_t>(found, lanes[i]);
    return found;
}

/// The first of the pixels whose centres are at `at` or beyond it, from 0 to `end`.
std::int32_t firstCentreFrom(double at, std::int32_t end) {
    if (!(at > 0.5)) // also NaN
        return 0;
    const double clamped = std::min(at - 0.5, static_cast<double>(end));
    const auto whole = static_cast<std::int32_t>(clamped);
    return whole + (static_cast<double>(whole) < clamped ? 1 : 0);
}

/// Ratios of a coordinate across the view to the one along it.
struct Ratios {
    double least = 0.0, most = 0.0;
};

/// Of the points of a sphere. `along` > radius.
Ratios ratiosOf(double across, double along, double radius) {
    const double square = along * along - radius * radius;
    const double root = radius * std::sqrt(across * across + square);
    return {(across * along - root) / square, (across * along + root) / square};
}

} // namespace

void OcclusionBuffer::begin(const View& view, std::uint32_t width, std::uint32_t height, double nearPlane) {
    LIMEN_ASSERT(width > 0 && height > 0 && nearPlane > 0.0, "a picture has pixels, and a near plane");
    screenFromEye_ = view.screenFromEye();
    tanHalfX_ = view.tanHalfX;
    tanHalfY_ = view.tanHalfY;
    width_ = static_cast<std::int32_t>(width);
    height_ = static_cast<std::int32_t>(height);
    halfWidth_ = 0.5 * width;
    halfHeight_ = 0.5 * height;
    clipPlane_ = std::max(nearPlane, kLeastClip);
    stride_ = (width + 2 * kLanes - 1) / kLanes * std::size_t{kLanes};
    pixels_.assign(stride_ * height, 0);
    firsts_.resize(height);
    ends_.resize(height);
}

OcclusionBuffer::Corner OcclusionBuffer::cornerAt(const Vec3& onScreen) const {
    const double inverse = 1.0 / onScreen.z;
    return {(onScreen.x * inverse + 1.0) * halfWidth_, (onScreen.y * inverse + 1.0) * halfHeight_, inverse};
}

OcclusionBuffer::Place OcclusionBuffer::placeOf(const Vec3& corner) const {
    const Vec3 onScreen = screenFromEye_ * corner;
    if (!(onScreen.z >= clipPlane_))
        return {onScreen, {}, true};
    return {onScreen, cornerAt(onScreen), false};
}

void OcclusionBuffer::cover(std::span<const Vec3> corners, std::span<const std::uint32_t> triangles) {
    places_.clear();
    for (const Vec3& corner : corners)
        places_.push_back(placeOf(corner));
    for (std::size_t i = 0; i + 2 < triangles.size(); i += 3)
        cover(places_[triangles[i]], places_[triangles[i + 1]], places_[triangles[i + 2]]);
}

// The plane is that of the whole triangle, because corners on the clip plane are far from the picture.
void OcclusionBuffer::cover(const Place& a, const Place& b, const Place& c) {
    if (a.isBefore && b.isBefore && c.isBefore)
        return;
    const Vec3 normal = glm::cross(b.onScreen - a.onScreen, c.onScreen - a.onScreen);
    const double towards = glm::dot(normal, a.onScreen);
    if (!(towards > 0.0)) // faces away, or is edge-on
        return;
    const Vec3 plane = normal / towards;
    const Slope slope{plane.z - plane.x - plane.y, plane.x / halfWidth_, plane.y / halfHeight_};
    if (!a.isBefore && !b.isBefore && !c.isBefore) {
        cover(std::array{a.corner, b.corner, c.corner}, slope);
        return;
    }
    std::array<Corner, 4> clipped;
    std::size_t count = 0;
    for (const auto& [from, to] : {std::pair(&a, &b), std::pair(&b, &c), std::pair(&c, &a)}) {
        if (!from->isBefore)
            clipped[count++] = from->corner;
        if (from->isBefore != to->isBefore) {
            const Vec3 along = to->onScreen - from->onScreen;
            Vec3 cut = from->onScreen + along * ((clipPlane_ - from->onScreen.z) / along.z);
            cut.z = clipPlane_;
            clipped[count++] = cornerAt(cut);
        }
    }
    cover(std::span(clipped).first(count), slope);
}

// Adjacent polygons get the same numbers for a common edge, so that no pixel is between them.
void OcclusionBuffer::spanEdge(const Corner& from, const Corner& to) {
    const bool isRising = from.y < to.y; // then the polygon is to the left of the edge
    const Corner &low = isRising ? from : to, &high = isRising ? to : from;
    const std::int32_t first = firstCentreFrom(low.y, height_), end = firstCentreFrom(high.y, height_);
    if (first >= end)
        return;
    const double slope = (high.x - low.x) / (high.y - low.y);
    const double start = low.x + (first + 0.5 - low.y) * slope, stop = start + slope * (end - 1 - first);
    std::int32_t* const out = (isRising ? ends_ : firsts_).data();
    if (end - first == 1 || !(std::min(start, stop) > 0.0 && std::max(start, stop) < width_)) {
        for (std::int32_t row = first; row < end; ++row)
            out[row] = firstCentreFrom(start + slope * (row - first), width_);
        return;
    }
    // The same in fixed point.
    constexpr double kFixed = 4294967296.0;
    const auto step = static_cast<std::int64_t>(slope * kFixed);
    auto at = static_cast<std::int64_t>((start + 0.5) * kFixed) - 1;
    for (std::int32_t row = first; row < end; ++row, at += step)
        out[row] = static_cast<std::int32_t>(at >> 32);
}

// Distances are rounded up: to the farther end of each stretch of pixels, never beyond the farthest corner.
void OcclusionBuffer::coverRow(std::int32_t row, const Slope& slope) {
    constexpr std::int32_t kStretch = 64; // pixels
    const Run run{firsts_[static_cast<std::size_t>(row)], ends_[static_cast<std::size_t>(row)]};
    const double atRow = slope.atOrigin + slope.byY * (row + 0.5);
    for (std::int32_t first = run.first; first < run.end; first += kStretch) {
        const std::int32_t end = std::min(first + kStretch, run.end);
        const double farther = atRow + slope.byX * (slope.byX < 0.0 ? end : first);
        const double inverse = std::min(std::max(farther, slope.least) * kNearest, 1.0);
        raise(rowAt(row) + first, end - first, static_cast<Inverse>(inverse * kOne));
    }
}

void OcclusionBuffer::cover(std::span<const Corner> polygon, Slope slope) {
    double low = polygon[0].y, high = low, left = polygon[0].x, right = left,
           sum = slope.atOrigin + slope.byX + slope.byY;
    slope.least = polygon[0].inverse;
    for (const Corner& corner : polygon) {
        sum += corner.x + corner.y + corner.inverse;
        low = std::min(low, corner.y);
        high = std::max(high, corner.y);
        left = std::min(left, corner.x);
        right = std::max(right, corner.x);
        slope.least = std::min(slope.least, corner.inverse);
    }
    const Run rows{firstCentreFrom(low, height_), firstCentreFrom(high, height_)};
    if (!std::isfinite(sum) || rows.first >= rows.end ||
        firstCentreFrom(left, width_) >= firstCentreFrom(right, width_))
        return;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        spanEdge(polygon[i], polygon[(i + 1) % polygon.size()]);
    for (std::int32_t row = rows.first; row < rows.end; ++row)
        coverRow(row, slope);
}

void OcclusionBuffer::finish() {
    const std::int32_t tileRows = (height_ + kTile - 1) / kTile;
    tileColumns_ = (width_ + kTile - 1) / kTile;
    tiles_.assign(static_cast<std::size_t>(tileColumns_ * tileRows), std::numeric_limits<Inverse>::max());
    for (std::int32_t row = 0; row < height_; ++row) {
        const Inverse* const pixels = rowAt(row);
        Inverse* const tiles = &tiles_[static_cast<std::size_t>(row / kTile * tileColumns_)];
        const std::int32_t whole = width_ / kTile;
        for (std::int32_t i = 0; i < whole; ++i)
            tiles[i] = std::min(tiles[i],
                                leastOf(least(load(pixels + i * kTile), load(pixels + i * kTile + kLanes))));
        for (std::int32_t x = whole * kTile; x < width_; ++x)
            tiles[whole] = std::min(tiles[whole], pixels[x]);
    }
}

bool OcclusionBuffer::hides(const Sphere& sphere) const {
    const Vec3 on = screenFromEye_ * sphere.centre;
    const double radius = sphere.radius;
    if (!(on.z - radius > kNearest))
        return false;
    const Ratios x = ratiosOf(on.x * tanHalfX_, on.z, radius), y = ratiosOf(on.y * tanHalfY_, on.z, radius);
    return hides(
        {x.least / tanHalfX_, x.most / tanHalfX_, y.least / tanHalfY_, y.most / tanHalfY_, on.z - radius});
}

bool OcclusionBuffer::hidesBox(const Vec3& centre, const Vec3& half) const {
    const Vec3 middle = screenFromEye_ * centre;
    const Vec3 x = screenFromEye_[0] * half.x, y = screenFromEye_[1] * half.y, z = screenFromEye_[2] * half.z;
    const double nearest = middle.z - std::abs(x.z) - std::abs(y.z) - std::abs(z.z);
    if (!(nearest > kNearest))
        return false;
    Extent extent{1e300, -1e300, 1e300, -1e300, nearest};
    for (const Vec3& a : {middle - x, middle + x})
        for (const Vec3& b : {a - y, a + y})
            for (const Vec3& c : {b - z, b + z}) {
                const double inverse = 1.0 / c.z, across = c.x * inverse, upwards = c.y * inverse;
                extent.left = std::min(extent.left, across);
                extent.right = std::max(extent.right, across);
                extent.low = std::min(extent.low, upwards);
                extent.high = std::max(extent.high, upwards);
            }
    return hides(extent);
}

bool OcclusionBuffer::hides(const Extent& extent) const {
    const Run columns{firstCentreFrom((extent.left + 1.0) * halfWidth_ - kMargin, width_),
                      firstCentreFrom((extent.right + 1.0) * halfWidth_ + kMargin, width_)};
    const Run rows{firstCentreFrom((extent.low + 1.0) * halfHeight_ - kMargin, height_),
                   firstCentreFrom((extent.high + 1.0) * halfHeight_ + kMargin, height_)};
    if (columns.first >= columns.end || rows.first >= rows.end)
        return true;
    const auto least = static_cast<Inverse>((1.0 + kNearer) * kNearest / extent.nearest * kOne);
    // The sky is above: a thing that is seen is usually seen at its top.
    for (std::int32_t row = (rows.end - 1) / kTile; row >= rows.first / kTile; --row) {
        const Run within{std::max(rows.first, row * kTile), std::min(rows.end, (row + 1) * kTile)};
        const Inverse* const tiles = &tiles_[static_cast<std::size_t>(row * tileColumns_)];
        for (std::int32_t column = columns.first / kTile; column * kTile < columns.end; ++column)
            if (tiles[column] <= least && !hidesIn({std::max(columns.first, column * kTile),
                                                    std::min(columns.end, (column + 1) * kTile)},
                                                   within, least))
                return false;
    }
    return true;
}

bool OcclusionBuffer::hidesIn(const Run& columns, const Run& rows, Inverse least) const {
    if (columns.end - columns.first == kTile && rows.end - rows.first == kTile)
        return false; // the tile has such a pixel
    for (std::int32_t row = rows.end; row-- > rows.first;)
        if (!areMore(pixels_.data() + static_cast<std::size_t>(row) * stride_ + columns.first,
                     columns.end - columns.first, least))
            return false;
    return true;
}

} // namespace limen::visibility
