#include "world/mesh/Weld.h"

#include "geometry/TwoFloats.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

namespace limen::world {
namespace {

/// Positions in one cube of this side (metres) count as equal before distances are measured. This bounds the
/// number of distinct points within reach of one, also in hostile files.
constexpr double kMicro = 0.00001;
/// Metres. The points of two cubes may be nearer to each other than their representatives by both cubes'
/// diagonals.
constexpr double kReach = kWeldTolerance + 2.0 * 1.7320508 * kMicro;
/// Side of the search grid's cells, metres. It is much larger than kReach, so most points search one cell.
constexpr double kGrid = 0.004;

/// 2^33. A double has 53 bits, so 20 remain for whole metres.
constexpr double kStepsPerMetre = 8589934592.0;

struct Key {
    std::int64_t x, y, z;
    friend bool operator==(const Key&, const Key&) = default;
};

struct KeyHash {
    std::size_t operator()(const Key& k) const {
        std::uint64_t h = static_cast<std::uint64_t>(k.x) * 0x9E3779B97F4A7C15ull;
        h = (h ^ (h >> 29)) + static_cast<std::uint64_t>(k.y) * 0xBF58476D1CE4E5B9ull;
        h = (h ^ (h >> 31)) + static_cast<std::uint64_t>(k.z) * 0x94D049BB133111EBull;
        return static_cast<std::size_t>(h ^ (h >> 32));
    }
};

Key keyOf(const Vec3& p, double side) {
    return {static_cast<std::int64_t>(std::floor(p.x / side)),
            static_cast<std::int64_t>(std::floor(p.y / side)),
            static_cast<std::int64_t>(std::floor(p.z / side))};
}

/// Clusters of representatives. The root of a cluster is its smallest index.
class Clusters {
public:
    explicit Clusters(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }
    std::uint32_t root(std::uint32_t i) {
        while (parent_[i] != i)
            i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void unite(std::uint32_t a, std::uint32_t b) {
        a = root(a);
        b = root(b);
        if (a != b)
            parent_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::uint32_t> parent_;
};

/// Unites every two points within reach of each other.
void uniteNeighbours(const std::vector<Vec3>& points, Clusters& clusters) {
    std::unordered_map<Key, std::uint32_t, KeyHash> heads;
    heads.reserve(points.size());
    std::vector<std::uint32_t> next(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        const Key low = keyOf(points[i] - kReach, kGrid), high = keyOf(points[i] + kReach, kGrid);
        for (std::int64_t x = low.x; x <= high.x; ++x) {
            for (std::int64_t y = low.y; y <= high.y; ++y) {
                for (std::int64_t z = low.z; z <= high.z; ++z) {
                    const auto cell = heads.find(Key{x, y, z});
                    for (std::uint32_t j = cell == heads.end() ? i : cell->second; j != i; j = next[j]) {
                        const Vec3 d = points[j] - points[i];
                        if (glm::dot(d, d) <= kReach * kReach)
                            clusters.unite(i, j);
                        if (next[j] == j)
                            break;
                    }
                }
            }
        }
        const auto [head, fresh] = heads.try_emplace(keyOf(points[i], kGrid), i);
        next[i] = fresh ? i : head->second;
        head->second = i;
    }
}

} // namespace

Vec3 canonicalPosition(const Vec3& position) {
    const Vec3 steps = position * kStepsPerMetre;
    const Vec3 stepped(std::round(steps.x), std::round(steps.y), std::round(steps.z));
    return inTwoFloats(stepped / kStepsPerMetre).sum();
}

std::uint32_t Welder::add(const Vec3& position) {
    LIMEN_ASSERT(std::max({std::abs(position.x), std::abs(position.y), std::abs(position.z)}) <= 1e6,
                 "the position fits the grid's keys");
    added_.push_back(position);
    return static_cast<std::uint32_t>(added_.size() - 1);
}

void Welder::weld() {
    std::unordered_map<Key, std::uint32_t, KeyHash> micro;
    micro.reserve(added_.size());
    std::vector<Vec3> points;
    vertexOf_.resize(added_.size());
    for (std::size_t i = 0; i < added_.size(); ++i) {
        const auto [at, fresh] =
            micro.try_emplace(keyOf(added_[i], kMicro), static_cast<std::uint32_t>(points.size()));
        if (fresh)
            points.push_back(added_[i]);
        vertexOf_[i] = at->second;
    }
    Clusters clusters(points.size());
    uniteNeighbours(points, clusters);
    std::vector<std::uint32_t> vertexOfPoint(points.size());
    positions_.clear();
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        const std::uint32_t root = clusters.root(i);
        LIMEN_ASSERT(root <= i, "the root is the smallest index, so its vertex is known");
        if (root == i) {
            vertexOfPoint[i] = static_cast<std::uint32_t>(positions_.size());
            positions_.push_back(canonicalPosition(points[i]));
        } else {
            vertexOfPoint[i] = vertexOfPoint[root];
        }
    }
    for (std::uint32_t& v : vertexOf_)
        v = vertexOfPoint[v];
}

} // namespace limen::world
