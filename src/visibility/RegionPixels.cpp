#include "visibility/RegionPixels.h"

#include "visibility/Region.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limen::visibility {

namespace {

/// Share of a pixel by which an edge that rounding has moved touches a pixel that it does not. Samples are on a grid of
/// 1/256 of a pixel.
constexpr double kTouch = 1e-6;

/// NDC of the centre of pixel `i` of `count`.
double centreOf(std::uint32_t i, std::uint32_t count) {
    return (2.0 * i + 1.0) / count - 1.0;
}

/// The edges of a region as lines on the screen: positive inside.
std::vector<Vec3> edgesOf(std::span<const Vec3> region) {
    std::vector<Vec3> edges;
    edges.reserve(region.size());
    for (std::size_t i = 0; i < region.size(); ++i)
        edges.push_back(glm::cross(region[i], region[i + 1 == region.size() ? 0 : i + 1]));
    return edges;
}

/// One row of a region. The ends are computed by a division and then corrected by the test that counts: whether the
/// centre is on the inner side of each edge.
class Row {
public:
    Row(std::span<const Vec3> edges, double y, std::uint32_t width) : edges_(edges), y_(y), width_(width) {}

    /// False if no centre of the row is inside.
    [[nodiscard]] bool find(PixelRun& run) const {
        double low = -1.0, high = 1.0;
        for (const Vec3& edge : edges_) {
            const double rest = edge.y * y_ + edge.z;
            if (edge.x > 0.0)
                low = std::max(low, -rest / edge.x);
            else if (edge.x < 0.0)
                high = std::min(high, -rest / edge.x);
            else if (rest < 0.0)
                return false;
        }
        if (!(low <= high + 2.0 / width_))
            return false;
        std::int64_t first = columnFrom(low), last = columnFrom(high);
        first = std::max<std::int64_t>(first - 1, 0);
        last = std::min<std::int64_t>(last + 1, width_ - 1);
        while (first <= last && !isInside(first))
            ++first;
        while (last >= first && !isInside(last))
            --last;
        run.firstX = static_cast<std::uint32_t>(first);
        run.lastX = static_cast<std::uint32_t>(last);
        return first <= last;
    }

private:
    [[nodiscard]] std::int64_t columnFrom(double x) const {
        return static_cast<std::int64_t>(std::floor((std::clamp(x, -1.0, 1.0) + 1.0) * 0.5 * width_));
    }
    [[nodiscard]] bool isInside(std::int64_t column) const {
        const Vec3 centre(centreOf(static_cast<std::uint32_t>(column), width_), y_, 1.0);
        return std::all_of(edges_.begin(), edges_.end(),
                           [&](const Vec3& edge) { return glm::dot(edge, centre) >= 0.0; });
    }

    std::span<const Vec3> edges_;
    double y_;
    std::uint32_t width_;
};

} // namespace

void pixelsOf(std::span<const Vec3> region, std::uint32_t width, std::uint32_t height,
              std::vector<PixelRun>& out) {
    out.clear();
    const PixelRect touched = scissorOf(region, width, height);
    const std::vector<Vec3> edges = edgesOf(region);
    for (std::uint32_t y = touched.y; y < touched.y + touched.height; ++y) {
        PixelRun run;
        run.y = y;
        if (Row(edges, centreOf(y, height), width).find(run))
            out.push_back(run);
    }
}

void visitOfPixels(const VisibleSet& set, std::uint32_t width, std::uint32_t height,
                   std::vector<std::uint32_t>& out) {
    out.assign(std::size_t{width} * height, std::numeric_limits<std::uint32_t>::max());
    std::vector<PixelRun> runs;
    for (std::uint32_t i = 0; i < set.visits.size(); ++i) {
        pixelsOf(set.region(set.visits[i]), width, height, runs);
        for (const PixelRun& run : runs) {
            const auto row = out.begin() + static_cast<std::ptrdiff_t>(std::size_t{run.y} * width);
            std::fill(row + run.firstX, row + run.lastX + 1, i);
        }
    }
}

PixelRect scissorOf(std::span<const Vec3> region, std::uint32_t width, std::uint32_t height) {
    return region.size() < 3 ? PixelRect{} : scissorOf(boundsOf(region), width, height);
}

PixelRect scissorOf(const Rect& rect, std::uint32_t width, std::uint32_t height) {
    const double minX = std::max(rect.minX, -1.0), maxX = std::min(rect.maxX, 1.0);
    const double minY = std::max(rect.minY, -1.0), maxY = std::min(rect.maxY, 1.0);
    if (!(minX <= maxX && minY <= maxY) || width == 0 || height == 0)
        return {};
    const auto low = [](double ndc, std::uint32_t count) {
        const double pixel = std::floor((ndc + 1.0) * 0.5 * count + kTouch);
        return static_cast<std::uint32_t>(std::clamp(pixel, 0.0, count - 1.0));
    };
    const auto high = [](double ndc, std::uint32_t count) { // one beyond the last
        return static_cast<std::uint32_t>(
            std::clamp(std::ceil((ndc + 1.0) * 0.5 * count - kTouch), 1.0, static_cast<double>(count)));
    };
    const std::uint32_t x = low(minX, width), y = low(minY, height);
    return {x, y, std::max(high(maxX, width), x + 1) - x, std::max(high(maxY, height), y + 1) - y};
}

} // namespace limen::visibility
