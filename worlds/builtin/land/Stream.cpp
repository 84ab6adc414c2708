#include "worlds/builtin/land/Stream.h"

#include "worlds/pictures/Noise.h"

#include <algorithm>
#include <cmath>

namespace limen::worlds {

namespace {

constexpr double kSource = 30.0, kMouth = 21.5; ///< metres: height of the bed at the path's ends
constexpr double kBank = 0.7;                   ///< height above the bed, one vertex beside it; metres
constexpr double kLevel = 1.5;                  ///< vertices: up to here the ground is as low as the banks
constexpr double kReach = 4.2;                  ///< vertices: from here on the ground is natural

struct Nearest {
    double distance = 1e9, bed = 0.0;
};

Nearest nearestTo(double vx, double vy) {
    const auto& path = streamPath();
    Nearest out;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const double distance = std::hypot(path[i].first - vx, path[i].second - vy);
        if (distance < out.distance) {
            const double t = static_cast<double>(i) / static_cast<double>(path.size() - 1);
            out = {distance, kSource + (kMouth - kSource) * t};
        }
    }
    return out;
}

/// Extends the path along edges to a vertex: first along x, then along y.
void extend(std::vector<std::pair<int, int>>& path, int vx, int vy) {
    while (path.back() != std::pair{vx, vy}) {
        auto [x, y] = path.back();
        if (x != vx)
            x += vx > x ? 1 : -1;
        else
            y += vy > y ? 1 : -1;
        path.emplace_back(x, y);
    }
}

} // namespace

const std::vector<std::pair<int, int>>& streamPath() {
    static const std::vector<std::pair<int, int>> path = [] {
        const std::vector<std::pair<int, int>> bends{{-8, 10}, {-5, 9}, {-1, 10}, {2, 9},
                                                     {6, 8},   {9, 7},  {13, 6},  {15, 5},
                                                     {15, 4},  {16, 1}, {15, -4}, {16, -8}};
        std::vector<std::pair<int, int>> out{bends.front()};
        for (const auto& [vx, vy] : bends)
            extend(out, vx, vy);
        return out;
    }();
    return path;
}

double distanceToStream(double vx, double vy) {
    return nearestTo(vx, vy).distance;
}

double cutByStream(double height, double vx, double vy) {
    const Nearest stream = nearestTo(vx, vy);
    const double bank = stream.bed + kBank * smoothStep(0.0, 1.0, stream.distance);
    return bank + (height - bank) * smoothStep(kLevel, kReach, stream.distance);
}

} // namespace limen::worlds
