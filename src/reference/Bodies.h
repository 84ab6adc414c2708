#pragma once

#include "reference/TriangleSet.h"

#include <atomic>
#include <memory>
#include <mutex>

namespace limen::reference {

/// The triangles of one instance.
struct Surfaces {
    TriangleSet solid;   ///< opaque and cut-out
    TriangleSet blended; ///< translucent
};

/// The instances of a world, or of a dynamic state. The triangles of an instance are placed when the first
/// ray comes near it: rays come near few of all instances.
class Bodies {
public:
    /// `origin` is the scene's. The world must outlive it.
    Bodies(const world::World& world, const Vec3& origin);

    /// Replaces all instances. `instances` must stay unchanged until the next call. Keeps its capacity.
    void assign(std::span<const world::Instance> instances);

    /// The box of a body's vertices.
    [[nodiscard]] Box boxOf(std::uint32_t body) const;
    [[nodiscard]] bool hasSolid(std::uint32_t body) const;
    [[nodiscard]] bool hasBlended(std::uint32_t body) const;
    [[nodiscard]] bool isFilling(std::uint32_t body) const {
        return instances_[body].kind == world::InstanceKind::Filling;
    }

    /// Whether the instance is drawn for an eye at that position: it is one level of detail of several.
    [[nodiscard]] bool isInLevelRange(std::uint32_t body, const world::RangeSteps& eye) const {
        return world::isInLevelRange(world_, instances_[body], eye);
    }

    /// Safe to call from any thread. The first call for a body places its triangles.
    [[nodiscard]] const Surfaces& surfacesOf(std::uint32_t body) const {
        Slot& slot = slots_[body];
        if (!slot.isPlaced.load(std::memory_order_acquire))
            place(body, slot);
        return slot.surfaces;
    }

private:
    struct Slot {
        std::atomic<bool> isPlaced{false};
        Surfaces surfaces;
    };
    struct MeshGroupings {
        TriangleSet::Grouping solid, blended;
    };
    void place(std::uint32_t body, Slot& slot) const;
    [[nodiscard]] const world::Mesh* meshOf(std::uint32_t body) const;

    const world::World& world_;
    const Vec3 origin_;
    std::span<const world::Instance> instances_;
    std::size_t capacity_ = 0;
    std::unique_ptr<Slot[]> slots_;                ///< by body
    mutable std::mutex placing_;                   ///< one thread places at a time
    mutable std::vector<MeshGroupings> groupings_; ///< by mesh, made when first needed; under placing_
    mutable TriangleSet::Scratch scratch_;         ///< under placing_
};

/// The bodies that a ray can meet in each space (or zone), as hierarchies over their boxes.
class BodyLists {
public:
    struct List {
        std::vector<std::uint32_t> bodies;
        Hierarchy tree;
        [[nodiscard]] bool empty() const { return bodies.empty(); }
        /// Calls visit(body) as Hierarchy::walk calls its leaf.
        template <class Visit>
        void walk(const BoxRay& ray, double nearest, const double& farthest, Visit&& visit) const {
            tree.walk(ray, nearest, farthest, [&](std::uint32_t first, std::uint32_t count) {
                for (std::uint32_t i = first; i < first + count; ++i)
                    visit(bodies[i]);
            });
        }
    };
    /// The bodies of one space or zone. A body with both kinds of surface is in both lists.
    struct ListPair {
        List solid, blended;
    };

    /// `count`: of spaces or zones.
    void resize(std::size_t count) { pairs_.resize(count); }
    void clear();
    /// `index`: a space or zone.
    void add(const Bodies& bodies, std::uint32_t index, std::uint32_t body);
    /// Builds the hierarchies; walks find no body that was added since.
    void build(const Bodies& bodies);
    [[nodiscard]] const ListPair& at(std::uint32_t index) const { return pairs_[index]; }
    [[nodiscard]] bool empty() const { return used_.empty(); }

private:
    void build(const Bodies& bodies, List& list);

    std::vector<ListPair> pairs_;     ///< by space or zone
    std::vector<std::uint32_t> used_; ///< spaces or zones with at least one body
    std::vector<Box> boxes_;          ///< scratch of build()
    std::vector<std::uint32_t> order_, sorted_;
};

} // namespace limen::reference
