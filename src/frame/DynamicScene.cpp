#include "frame/DynamicScene.h"

#include "frame/PackInstance.h"

namespace limen::frame {

namespace {

const world::DynamicState& stateWithoutInstances() {
    static const world::DynamicState kEmpty;
    return kEmpty;
}

} // namespace

DynamicScene::DynamicScene() : state_(&stateWithoutInstances()) {}

void DynamicScene::pack(const StaticScene& scene, const world::DynamicState& state) {
    state_ = &state;
    members_.clear();
    records_.resize(state.instances.size());
    const OwnMembers own{members_, static_cast<std::uint32_t>(scene.members().size())};
    for (std::size_t i = 0; i < records_.size(); ++i)
        records_[i] = packInstance(scene.world(), state.instances[i], state.members, own);
}

} // namespace limen::frame
