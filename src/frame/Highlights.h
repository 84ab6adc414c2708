#pragma once

#include "frame/FramePlan.h"
#include "frame/FrameView.h"
#include "world/World.h"

namespace limen::frame {

/// What an object's highlight is, 0 if it has none; of several, the last.
[[nodiscard]] std::uint32_t colourOf(std::span<const Highlight> highlights, std::uint64_t object);

/// Highlights what stands still. Its records are on the device and stay as they are: a frame brings records of its own, and
/// the device draws by those.
class Highlights {
public:
    explicit Highlights(const world::World& world);

    /// Adds the records, and whom they replace. Allocates nothing once a plan has held as many. Objects that the world does
    /// not know are passed over. Requires the plan's constants and movers.
    void replace(std::span<const Highlight> highlights, FramePlan& plan) const;

private:
    void replaceObject(std::uint64_t object, std::uint32_t colour, FramePlan& plan) const;

    const world::World& world_;
    std::vector<world::InstanceIndex> byObject_; ///< ascending by object
};

} // namespace limen::frame
