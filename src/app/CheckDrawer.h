#pragma once

#include "app/Session.h"
#include "check/Run.h"

#include <future>

namespace limen::app {

/// A check's view as the eye of a frame.
[[nodiscard]] FrameEye eyeOf(const check::View& view, world::SpaceIndex root);

/// Draws the views of a check through the path of every other verb. The session must outlive it.
class CheckDrawer final : public check::Drawer {
public:
    /// `outlines`: keep the regions of visits, for pictures of findings.
    CheckDrawer(Session& session, bool outlines) : session_(session), outlines_(outlines) {}

    Result<std::shared_ptr<const world::World>> load(dat::BlockCoord block) override;
    void expect(dat::BlockCoord block) override;
    reference::Camera cameraOf(const check::View& view, world::SpaceIndex root) override;
    Result<check::DrawnImages> draw(const check::View& view, world::SpaceIndex root, bool colour) override;
    const world::Moment& moment() const override { return session_.moment(); }

private:
    using Reading = std::future<Result<std::shared_ptr<LoadedWorld>>>;

    Session& session_;
    bool outlines_;
    dat::BlockCoord expected_; ///< what coming_ reads
    Reading coming_;
};

} // namespace limen::app
