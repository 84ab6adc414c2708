#include "frame/gates/ScreenPlanes.h"

#include "geometry/Tolerances.h"
#include "visibility/Region.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace limen::frame {

namespace {

/// Pixels by which merging two edges may move the outline.
constexpr double kMostMerged = 1.0;

/// Share of w within which a vertex is on the picture's border. Regions are clipped to it in double.
constexpr double kOnBorder = 1e-9;

/// Whether both ends of an edge are on one side of the picture's border.
bool isOnBorder(const Vec3& a, const Vec3& b) {
    for (const int axis : {0, 1}) {
        for (const double side : {-1.0, 1.0}) {
            const auto isThere = [&](const Vec3& v) {
                return std::abs(v[axis] - side * v.z) <= kOnBorder * std::max(v.z, kOnBorder);
            };
            if (isThere(a) && isThere(b))
                return true;
        }
    }
    return false;
}

class EdgeMerger {
public:
    EdgeMerger(std::span<const Vec3> region, ScreenSize size) : size_(size) {
        for (std::size_t i = 0; i < region.size(); ++i) {
            const Vec3& a = region[i];
            const Vec3& b = region[(i + 1) % region.size()];
            const Vec3 edge = glm::cross(a, b);
            const double length = std::sqrt(glm::dot(edge, edge));
            if (length > 0.0 && !isOnBorder(a, b))
                edges_.push_back(edge / length);
        }
        for (std::size_t i = 0; i < edges_.size(); ++i)
            kept_.push_back(i);
    }

    /// Removes edges until at most `most` are left. False if that moves the outline too far.
    bool reduceTo(std::size_t most) {
        while (kept_.size() > most) {
            std::size_t best = kept_.size();
            double least = kMostMerged;
            for (std::size_t k = 0; k < kept_.size(); ++k) {
                const std::optional<double> moved = movedBy(k);
                if (moved && *moved <= least) {
                    least = *moved;
                    best = k;
                }
            }
            if (best == kept_.size())
                return false;
            kept_.erase(kept_.begin() + static_cast<std::ptrdiff_t>(best));
        }
        return true;
    }

    [[nodiscard]] std::size_t count() const { return kept_.size(); }
    [[nodiscard]] const Vec3& line(std::size_t k) const { return edges_[kept_[k]]; }

private:
    /// Pixels between the edge that is removed and the corner that its neighbours make, the largest over the
    /// edges removed before. None if the neighbours do not meet beyond them.
    [[nodiscard]] std::optional<double> movedBy(std::size_t k) const {
        const std::size_t before = kept_[(k + kept_.size() - 1) % kept_.size()];
        const std::size_t after = kept_[(k + 1) % kept_.size()];
        const Vec3 corner = glm::cross(edges_[before], edges_[after]);
        if (corner.z <= 0.0)
            return std::nullopt;
        double most = 0.0;
        for (std::size_t i = (before + 1) % edges_.size(); i != after; i = (i + 1) % edges_.size()) {
            const Vec3& edge = edges_[i];
            const double perPixel = std::hypot(edge.x * 2.0 / size_.width, edge.y * 2.0 / size_.height);
            most = std::max(most, -glm::dot(edge, corner) / (corner.z * std::max(perPixel, 1e-300)));
        }
        return most;
    }

    ScreenSize size_;
    std::vector<Vec3> edges_;
    std::vector<std::size_t> kept_; ///< ascending
};

Vec3 movedOutwards(Vec3 line, ScreenSize size) {
    line.z += kSnapTolerance * (std::abs(line.x) * 2.0 / size.width + std::abs(line.y) * 2.0 / size.height);
    return line / std::sqrt(glm::dot(line, line));
}

ScreenPlanes rectangleAround(std::span<const Vec3> region, ScreenSize size) {
    const visibility::Rect rect = visibility::boundsOf(region);
    ScreenPlanes planes;
    planes.isRectangle = true;
    const auto add = [&](bool isInside, const Vec3& line) {
        if (isInside)
            planes.lines[planes.count++] = movedOutwards(line, size);
    };
    add(rect.minX > -1.0, {1.0, 0.0, -rect.minX});
    add(rect.maxX < 1.0, {-1.0, 0.0, rect.maxX});
    add(rect.minY > -1.0, {0.0, 1.0, -rect.minY});
    add(rect.maxY < 1.0, {0.0, -1.0, rect.maxY});
    return planes;
}

} // namespace

ScreenPlanes screenPlanes(std::span<const Vec3> region, ScreenSize size) {
    EdgeMerger merger(region, size);
    if (!merger.reduceTo(ScreenPlanes::kMost))
        return rectangleAround(region, size);
    ScreenPlanes planes;
    for (std::size_t k = 0; k < merger.count(); ++k)
        planes.lines[planes.count++] = movedOutwards(merger.line(k), size);
    return planes;
}

} // namespace limen::frame
