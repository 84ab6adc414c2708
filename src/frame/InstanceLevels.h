#pragma once

#include "frame/Clusters.h"
#include "world/LevelRange.h"

#include <vector>

namespace limen::frame {

/// The levels of detail of the static instances, by position in Clusters::order: 20 bytes each, so that testing successive positions
/// reads memory in order. A property of the world.
class InstanceLevels {
public:
    InstanceLevels(const world::World& world, const Clusters& clusters);

    struct Entry {
        std::array<std::int32_t, 3> origin{}; ///< as world::Level
        world::LevelRange range;
        std::uint32_t block : 24 = 0;
        std::uint32_t measure : 8 = kAnywhere; ///< world::LevelMeasure, or kAnywhere
    };
    static constexpr std::uint32_t kAnywhere = 0xFF; ///< drawn at every distance
    [[nodiscard]] const Entry& at(std::uint32_t position) const { return entries_[position]; }

private:
    std::vector<Entry> entries_;
};

/// Tests which static instances an eye is in range of: the same as world::isInLevelRange and cull.comp. Reuse it: steady frames
/// allocate nothing.
class LevelTests {
public:
    /// Both must outlive the tests.
    LevelTests(const world::World& world, const InstanceLevels& levels) : world_(world), levels_(levels) {}
    /// `eye`: global, metres.
    void prepare(const Vec3& eye, world::LevelShare share);
    [[nodiscard]] bool isInRange(std::uint32_t position) const {
        const InstanceLevels::Entry& entry = levels_.at(position);
        return entry.measure == InstanceLevels::kAnywhere || contains(entry);
    }

private:
    [[nodiscard]] bool contains(const InstanceLevels::Entry& entry) const;

    const world::World& world_;
    const InstanceLevels& levels_;
    world::LevelShare share_;
    std::vector<world::RangeSteps> eyes_; ///< by block: relative to its south-west corner
};

} // namespace limen::frame
