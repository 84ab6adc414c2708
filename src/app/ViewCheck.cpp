#include "app/ViewCheck.h"

#include "app/CheckDrawer.h"
#include "app/TracedFrame.h"

#include <chrono>

namespace limen::app {

Result<ViewVerdict> ViewCheck::check(Session& session, const FrameEye& eye) {
    const auto start = std::chrono::steady_clock::now();
    if (world_ != session.shareLoaded()) {
        traced_.reset(); // refers to the world that goes
        world_ = session.shareLoaded();
        traced_.emplace(world_->world);
    }
    const Result<check::DrawnImages> drawn = drawImages(session, eye, false);
    if (!drawn)
        return tl::unexpected(drawn.error());
    traced_->setDynamics(session.dynamics());
    const TracedFrame traced = traceFrame(traced_->scene(), eye);
    check::ViewRetracer retracer(*traced_, traced.camera);
    ViewVerdict verdict;
    check::compare(*drawn, traced.picture, retracer, verdict.comparison);
    verdict.picture = pictureOfVerdicts(eye.size.width, eye.size.height, verdict.comparison);
    verdict.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return verdict;
}

} // namespace limen::app
