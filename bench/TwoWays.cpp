#include "TwoWays.h"

#include "frame/SceneBuilder.h"

namespace limen::bench {

Result<std::unique_ptr<TwoWays>> TwoWays::create(gpu::Device& device, const ObjectField& field,
                                                 std::uint32_t width, std::uint32_t height) {
    Result<gpu::RenderTarget> target = gpu::RenderTarget::create(device, width, height);
    if (!target)
        return Failure(target.error());
    std::unique_ptr<TwoWays> ways(new TwoWays(device, field, std::move(*target)));
    if (Result<void> uploaded = ways->renderer_.upload(frame::buildScene(ways->scene_)); !uploaded)
        return Failure(uploaded.error());
    Result<std::unique_ptr<ClassicPath>> classic = ClassicPath::create(device, field.world, field.dynamics);
    if (!classic)
        return Failure(classic.error());
    ways->classic_ = std::move(*classic);
    return ways;
}

Result<void> TwoWays::drawReal(const FieldView& view) {
    planner_.plan(view.frame, field_.dynamics, view.visible, plan_);
    return renderer_.render(plan_, target_);
}

Result<void> TwoWays::drawClassic(const FieldView& view) {
    return classic_->render(view.frame, field_.dynamics, view.visible, target_);
}

} // namespace limen::bench
