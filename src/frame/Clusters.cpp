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

class ClusterBuilder {
public:
    explicit ClusterBuilder(const world::World& world) : world_(world) {}

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

    // Half of the range goes to each side of a plane across its longest axis. Instance numbers break ties, so
    // that every standard library gives the same partition.
    void halve(Range range) const {
        const Vec3 size = sizeOf(range);
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const auto middle = range.begin() + static_cast<std::ptrdiff_t>(range.size() / 2);
        std::nth_element(range.begin(), middle, range.end(), [&](InstanceIndex a, InstanceIndex b) {
            const double left = boundsOf(a).centre[axis], right = boundsOf(b).centre[axis];
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
}

std::uint32_t ClusterBatches::add(const Clusters& clusters, std::uint32_t first, std::uint32_t count) {
    const auto index = static_cast<std::uint32_t>(batches.size());
    batches.emplace_back().count = count;
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
    }
    return index;
}

} // namespace limen::frame
