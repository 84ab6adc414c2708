#pragma once

#include "frame/StaticScene.h"
#include "world/DynamicState.h"

namespace limen::frame {

/// One dynamic state with the device records of its instances. Packed once per state; any number of views can
/// then be planned from it. A plan refers to the records, and drawing copies those of the visible instances.
///
/// Reuse it: steady frames allocate nothing.
class DynamicScene {
public:
    /// A state without dynamic instances.
    DynamicScene();

    /// Packs the records of all instances of `state`, a state of the scene's world. The state must outlive
    /// the next call and stay unchanged until then; the records change with that call.
    void pack(const StaticScene& scene, const world::DynamicState& state);

    [[nodiscard]] const world::DynamicState& state() const { return *state_; }
    /// By DynamicState::instances, without highlights.
    [[nodiscard]] std::span<const gpu::Instance> records() const { return records_; }
    /// Member records of instances in several zones, numbered from the scene's members on.
    [[nodiscard]] std::span<const gpu::Member> members() const { return members_; }

private:
    const world::DynamicState* state_; ///< never null
    std::vector<gpu::Instance> records_;
    std::vector<gpu::Member> members_;
};

} // namespace limen::frame
