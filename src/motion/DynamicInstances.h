#pragma once

#include "motion/PartPoses.h"
#include "world/DynamicState.h"
#include "world/Membership.h"
#include "world/World.h"

#include <span>
#include <vector>

namespace limen::motion {

/// Where a body is: global space from the body's own space.
struct BodyPose {
    Mat3 linear{1.0};
    Vec3 origin{0.0};

    /// A sphere of the body's own space; its radius stays as it is.
    [[nodiscard]] Sphere placed(const Sphere& sphere) const {
        return {origin + linear * sphere.centre, sphere.radius};
    }
};

/// Appends instances to a dynamic state, finds the spaces that they belong to, and hands out the ids of
/// sprites. Keeps its memory between states. The world must outlive it.
class DynamicInstances {
public:
    explicit DynamicInstances(const world::World& world);

    /// Begins a state: empties its instances and members. Every later call writes to `out`, whose `closed`
    /// must already be as it will be. `eye`: global; it selects levels of detail by `levels`, and billboards turn to it.
    void begin(const Vec3& eye, const world::LevelShare& levels, BetweenFrames between,
               world::DynamicState& out);

    [[nodiscard]] const world::World& world() const { return world_; }
    [[nodiscard]] world::DynamicState& state() const { return *out_; }
    [[nodiscard]] std::size_t count() const { return out_->instances.size(); }

    /// Appends the parts of a body that are in range of the eye, at a point of one of its cycles; a default
    /// CyclePoint is the resting pose. All of them get `placedIn`. Returns the first part's index.
    std::size_t addBody(const world::MovingBody& body, const BodyPose& pose, const CyclePoint& point,
                        world::SpaceIndex placedIn);
    /// Appends parts that are block-local and stay where they are. Returns the first one's index.
    std::size_t addInPlace(const world::MovingBody& body);
    /// Appends copies of those of the world's own instances, parts of an object with this origin, that are in
    /// range of the eye. Returns the first one's index.
    std::size_t addCopies(std::span<const world::Instance> instances, const Vec3& objectOrigin);
    /// Appends one instance. Returns its index.
    std::size_t add(const world::Instance& instance) {
        out_->instances.push_back(instance);
        return count() - 1;
    }

    /// Of sprites and particles at most world::kMostSprites polygons are drawn in one state.
    [[nodiscard]] bool hasSpriteIds(std::uint32_t count) const {
        return spriteIds_ + count <= world::kMostSprites;
    }
    /// The first of `count` ids that no other sprite of this state has. Requires hasSpriteIds(count).
    [[nodiscard]] std::uint32_t takeSpriteIds(std::uint32_t count);

    /// The block with the nearest middle: instances at `position` are stored relative to its origin.
    [[nodiscard]] std::uint32_t blockFor(const Vec3& position) const;

    // Spaces of an instance, the one it is placed in first. Each call overwrites the result of the one
    // before.
    using Spaces = std::span<const world::SpaceIndex>;
    [[nodiscard]] Spaces only(world::SpaceIndex space);
    /// The spaces that a global sphere reaches from `space` through open portals.
    [[nodiscard]] Spaces reachedFrom(world::SpaceIndex space, const Sphere& sphere);
    /// The spaces on both sides of a portal, shut or not.
    [[nodiscard]] Spaces sidesOf(const world::Portal& portal);
    /// The same, and the spaces that a global sphere reaches from them through open portals.
    [[nodiscard]] Spaces reachedFromSidesOf(const world::Portal& portal, const Sphere& sphere);

    /// Makes all instances from `first` on members of `spaces`, which must not be empty.
    void setSpaces(std::size_t first, Spaces spaces);

private:
    void fillSidesOf(const world::Portal& portal);

    const world::World& world_;
    world::Membership membership_;
    std::vector<world::SpaceIndex> spaces_;
    Vec3 eye_{0.0};
    world::LevelShare levels_;
    BetweenFrames between_ = BetweenFrames::Interpolated;
    world::DynamicState* out_ = nullptr;
    std::uint32_t spriteIds_ = 0;
};

} // namespace limen::motion
