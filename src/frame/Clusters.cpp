#include "frame/Clusters.h"

#include <algorithm>
#include <array>

namespace limen::frame {

namespace {

using world::InstanceIndex;
using Range = std::span<InstanceIndex>;

/// Share of the extent of a cluster's centres. Instances with a larger radius become a child of their own.
/// Otherwise the bounds of every child would be as large as theirs.
constexpr double kLargePart = 0.5;

/// Metres. Stands for all distances at which an instance is drawn: instances of one level come together, as if this were a
/// fourth coordinate. Endless ranges end at kMostDistance.
double meanDistance(const world::World& world, const world::Instance& instance) {
    constexpr double kMostDistance = 1000.0;
    const world::LevelRange range =
        instance.level == world::kNone ? world::LevelRange{} : world.levels[instance.level].range;
    const double upTo = static_cast<double>(range.upTo) / world::kRangeSteps;
    return 0.5 * (static_cast<double>(range.from) / world::kRangeSteps + std::min(upTo, kMostDistance));
}

/// The greatest difference between the distance that selects an instance's level and the distance to `centre`; for
/// a horizontal distance, at least as much below.
double slackOf(const world::World& world, const world::Instance& instance, const Vec3& centre) {
    constexpr double kRounding = 0.5; // metres: both ends are rounded down to 1/16 along each axis
    const world::Level& level = world.levels[instance.level];
    const auto metres = [](std::int32_t steps) { return static_cast<double>(steps) / world::kRangeSteps; };
    const Vec3 block = world.blocks[instance.block].origin();
    const Vec3 origin =
        block + Vec3(metres(level.origin[0]), metres(level.origin[1]), metres(level.origin[2]));
    const Vec2 middle = Vec2(block) + Vec2(metres(world::landcellMiddle(level.origin[0])),
                                           metres(world::landcellMiddle(level.origin[1])));
    const double toOrigin = glm::distance(origin, centre);
    return kRounding + (level.measure == world::LevelMeasure::Landcell
                            ? std::max(toOrigin, glm::distance(middle, Vec2(centre)))
                            : toOrigin);
}

class ClusterBuilder {
public:
    explicit ClusterBuilder(const world::World& world) : world_(world) {
        for (const world::Instance& instance : world.instances)
            distances_.push_back(meanDistance(world, instance));
    }

    Clusters build() {
        countLists();
        for (const world::Space& space : world_.spaces)
            addSpace(space);
        addShared();
        for (const InstanceIndex instance : out_.order)
            out_.bounds.push_back(world_.instances[instance].bounds);
        for (std::size_t i = out_.firstShared; i < out_.order.size(); ++i) {
            const world::Instance& instance = world_.instances[out_.order[i]];
            out_.sharedIsInOneZone.push_back(isInOneZone(world_, instance, world_.members) ? 1 : 0);
        }
        return std::move(out_);
    }

private:
    [[nodiscard]] std::span<const InstanceIndex> listOf(const world::Space& space) const {
        return std::span(world_.spaceInstances).subspan(space.firstInstance, space.instanceCount);
    }

    void countLists() {
        lists_.assign(world_.instances.size(), 0);
        for (const InstanceIndex instance : world_.spaceInstances)
            ++lists_[instance];
    }

    // An instance that is not shared is in one list, and so a member of one zone.
    [[nodiscard]] bool isShared(InstanceIndex instance) const {
        return lists_[instance] > 1 || world_.instances[instance].memberCount > 1;
    }

    void addSpace(const world::Space& space) {
        const auto first = static_cast<std::uint32_t>(out_.order.size());
        for (const InstanceIndex instance : listOf(space))
            if (!isShared(instance))
                out_.order.push_back(instance);
        const auto end = static_cast<std::uint32_t>(out_.order.size());
        out_.roots.push_back(first == end ? world::kNone : static_cast<std::uint32_t>(out_.clusters.size()));
        if (first != end) {
            out_.clusters.push_back({{}, first, end, 0, 0});
            divide(out_.roots.back());
        }
    }

    // Adds the shared instances, in the order of the first list that each is in.
    void addShared() {
        out_.firstShared = static_cast<std::uint32_t>(out_.order.size());
        std::vector<std::uint32_t> position(world_.instances.size(), world::kNone);
        for (const world::Space& space : world_.spaces) {
            out_.sharedStart.push_back(static_cast<std::uint32_t>(out_.sharedOf.size()));
            for (const InstanceIndex instance : listOf(space)) {
                if (!isShared(instance))
                    continue;
                if (position[instance] == world::kNone) {
                    position[instance] = static_cast<std::uint32_t>(out_.order.size());
                    out_.order.push_back(instance);
                }
                out_.sharedOf.push_back(position[instance]);
            }
        }
        out_.sharedStart.push_back(static_cast<std::uint32_t>(out_.sharedOf.size()));
    }

    [[nodiscard]] Range rangeOf(const Cluster& cluster) {
        return Range(out_.order).subspan(cluster.first, cluster.end - cluster.first);
    }
    [[nodiscard]] const Sphere& boundsOf(InstanceIndex instance) const {
        return world_.instances[instance].bounds;
    }
    // Of the box around its instances' centres.
    [[nodiscard]] Vec3 sizeOf(Range range) const {
        Aabb box;
        for (const InstanceIndex instance : range)
            box.include(boundsOf(instance).centre);
        return box.max - box.min;
    }

    [[nodiscard]] Sphere sphereAround(Range range) const {
        Aabb box;
        for (const InstanceIndex instance : range) {
            const Sphere& sphere = boundsOf(instance);
            box.include(sphere.centre - Vec3(sphere.radius));
            box.include(sphere.centre + Vec3(sphere.radius));
        }
        Sphere around{box.centre(), 0.0};
        for (const InstanceIndex instance : range) {
            const Sphere& sphere = boundsOf(instance);
            around.radius =
                std::max(around.radius, glm::distance(sphere.centre, around.centre) + sphere.radius);
        }
        return around;
    }

    // Requires: sphereAround made `bounds`.
    [[nodiscard]] DetailRange detailOf(Range range, const Sphere& bounds) const {
        DetailRange detail{DetailRange::kEvery, 0.0, 0.0, DetailRange::kEvery, 0.0};
        for (const InstanceIndex index : range) {
            const world::Instance& instance = world_.instances[index];
            if (instance.level == world::kNone) {
                detail.leastFrom = 0.0;
                detail.mostUpTo = DetailRange::kEvery;
                continue;
            }
            const world::LevelRange& level = world_.levels[instance.level].range;
            const double from = static_cast<double>(level.from) / world::kRangeSteps;
            const double upTo = level.upTo == world::LevelRange::kEndless
                                    ? DetailRange::kEvery
                                    : static_cast<double>(level.upTo) / world::kRangeSteps;
            detail.leastFrom = std::min(detail.leastFrom, from);
            detail.mostUpTo = std::max(detail.mostUpTo, upTo);
            detail.mostFrom = std::max(detail.mostFrom, from);
            detail.leastUpTo = std::min(detail.leastUpTo, upTo);
            detail.slack = std::max(detail.slack, slackOf(world_, instance, bounds.centre));
        }
        return detail;
    }

    [[nodiscard]] double spreadOfDistances(Range range) const {
        double least = DetailRange::kEvery, most = 0.0;
        for (const InstanceIndex instance : range) {
            least = std::min(least, distances_[instance]);
            most = std::max(most, distances_[instance]);
        }
        return most - least;
    }

    // Half of the range goes to each side of a plane across its longest axis; one axis is that of the levels' distances.
    // Instance numbers break ties, so that every standard library gives the same partition.
    void halve(Range range) const {
        constexpr int kDistance = 3;
        const Vec3 size = sizeOf(range);
        const double longest = std::max({size.x, size.y, size.z});
        const int axis = spreadOfDistances(range) > longest ? kDistance
                         : size.x == longest                ? 0
                         : size.y == longest                ? 1
                                                            : 2;
        const auto key = [&](InstanceIndex i) {
            return axis == kDistance ? distances_[i] : boundsOf(i).centre[axis];
        };
        const auto middle = range.begin() + static_cast<std::ptrdiff_t>(range.size() / 2);
        std::nth_element(range.begin(), middle, range.end(), [&](InstanceIndex a, InstanceIndex b) {
            const double left = key(a), right = key(b);
            return left != right ? left < right : a < b;
        });
    }

    /// Ends of up to four parts.
    struct Parts {
        std::array<std::size_t, 4> ends{};
        std::uint32_t count = 0;
        void add(std::size_t end) { ends[count++] = end; }
    };

    // The large instances and the others; no parts if one of the two is empty.
    [[nodiscard]] Parts partBySize(Range range) const {
        const Vec3 size = sizeOf(range);
        const double large = kLargePart * std::max({size.x, size.y, size.z});
        const auto middle = std::stable_partition(range.begin(), range.end(), [&](InstanceIndex instance) {
            return boundsOf(instance).radius > large;
        });
        Parts parts;
        if (middle != range.begin() && middle != range.end()) {
            parts.add(static_cast<std::size_t>(middle - range.begin()));
            parts.add(range.size());
        }
        return parts;
    }

    [[nodiscard]] Parts partByPlace(Range range) const {
        Parts parts;
        const std::size_t half = range.size() / 2;
        halve(range);
        for (const Range side : {range.first(half), range.subspan(half)}) {
            const std::size_t begin = parts.count > 0 ? half : 0;
            halve(side);
            parts.add(begin + side.size() / 2);
            parts.add(begin + side.size());
        }
        return parts;
    }

    // Divides a cluster, and its parts in turn. Its positions take the order of the parts.
    void divide(std::uint32_t index) {
        const Cluster whole = out_.clusters[index];
        const Range range = rangeOf(whole);
        out_.clusters[index].bounds = sphereAround(range);
        out_.clusters[index].detail = detailOf(range, out_.clusters[index].bounds);
        if (range.size() <= kLeafInstances) {
            std::sort(range.begin(), range.end());
            return;
        }
        Parts parts = partBySize(range);
        if (parts.count == 0)
            parts = partByPlace(range);
        const auto child = static_cast<std::uint32_t>(out_.clusters.size());
        out_.clusters[index].firstChild = child;
        out_.clusters[index].childCount = parts.count;
        std::uint32_t first = whole.first;
        for (std::uint32_t i = 0; i < parts.count; ++i) {
            const auto end = whole.first + static_cast<std::uint32_t>(parts.ends[i]);
            out_.clusters.push_back({{}, first, end, 0, 0});
            first = end;
        }
        for (std::uint32_t i = 0; i < parts.count; ++i)
            divide(child + i);
    }

    const world::World& world_;
    std::vector<double> distances_;    ///< by instance: meanDistance
    std::vector<std::uint32_t> lists_; ///< by instance: number of spaces that list it
    Clusters out_;
};

} // namespace

Clusters buildClusters(const world::World& world) {
    return ClusterBuilder(world).build();
}

bool isInOneZone(const world::World& world, const world::Instance& instance,
                 std::span<const world::SpaceIndex> members) {
    const auto own = members.subspan(instance.firstMember, instance.memberCount);
    return std::all_of(own.begin(), own.end(), [&](world::SpaceIndex space) {
        return world.spaces[space].zone == world.spaces[own.front()].zone;
    });
}

ClusterBatches::ClusterBatches(const Clusters& clusters) {
    for (const std::uint32_t root : clusters.roots)
        roots.push_back(root == world::kNone ? root : add(clusters, root, 1));
    const bool areEndless = std::all_of(clusters.clusters.begin(), clusters.clusters.end(),
                                        [](const Cluster& c) { return c.detail.isEndless(); });
    if (areEndless)
        details.clear();
}

std::uint32_t ClusterBatches::add(const Clusters& clusters, std::uint32_t first, std::uint32_t count) {
    const auto index = static_cast<std::uint32_t>(batches.size());
    batches.emplace_back().count = count;
    details.emplace_back();
    for (std::uint32_t i = 0; i < count; ++i) {
        const Cluster& cluster = clusters.clusters[first + i];
        const std::uint32_t children =
            cluster.childCount > 0 ? add(clusters, cluster.firstChild, cluster.childCount) : world::kNone;
        Batch& batch = batches[index];
        batch.x[i] = cluster.bounds.centre.x;
        batch.y[i] = cluster.bounds.centre.y;
        batch.z[i] = cluster.bounds.centre.z;
        batch.radius[i] = cluster.bounds.radius;
        batch.positions[i] = {cluster.first, cluster.end};
        batch.children[i] = children;
        details[index][i] = cluster.detail;
    }
    return index;
}

} // namespace limen::frame
