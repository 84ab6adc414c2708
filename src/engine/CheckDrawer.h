#pragma once

#include "check/Run.h"
#include "engine/Session.h"
#include "frame/IdColour.h"

#include <future>

namespace limen::engine {

/// Draws the images that a check compares with the traced frame: ids, depth, and the counts of transparent
/// layers. With `colour`, it draws the colours instead of the layers. One sample a pixel. Errors: those of
/// drawing.
[[nodiscard]] Result<check::DrawnImages> drawImages(Session& session, const FrameRequest& request,
                                                    bool colour);

/// Draws the views of a check. It uses a Session as all verbs do, so that a check tests the same code. The
/// session must outlive it.
class CheckDrawer final : public check::Drawer {
public:
    /// `outlines`: keep the regions of visits, for pictures of findings. `multisampled`: draw each polygon in
    /// the flat colour of its id, with the session's number of samples.
    CheckDrawer(Session& session, bool outlines, bool multisampled)
        : session_(session), outlines_(outlines), multisampled_(multisampled) {}

    Result<std::shared_ptr<const world::World>> load(dat::BlockCoord block) override;
    void expect(dat::BlockCoord block) override;
    reference::Camera cameraOf(const check::View& view, world::SpaceIndex root) override;
    Result<check::DrawnImages> draw(const check::View& view, world::SpaceIndex root, bool colour) override;
    check::IdColour idColour() const override { return &frame::colourOfId; }
    const world::DynamicState& dynamics() const override { return session_.dynamics(); }
    Result<std::unique_ptr<check::Drawer>> makeHelper() override;

private:
    using Reading = std::future<Result<std::unique_ptr<PartPlanner>>>;

    [[nodiscard]] Result<check::DrawnImages> drawSamples(const FrameRequest& request);

    Session& session_;
    bool outlines_, multisampled_;
    dat::BlockCoord expected_; ///< the block that coming_ reads
    Reading coming_;
};

} // namespace limen::engine
