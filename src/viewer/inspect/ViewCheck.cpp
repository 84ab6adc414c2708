#include "viewer/inspect/ViewCheck.h"

#include "engine/CheckDrawer.h"
#include "output/TracedFrame.h"

#include <chrono>

namespace limen::viewer {

Result<ViewVerdict> ViewCheck::check(engine::Session& session, const engine::FrameRequest& request) {
    const auto start = std::chrono::steady_clock::now();
    if (world_ != session.sharePart()) {
        traced_.reset(); // it refers to the old world
        world_ = session.sharePart();
        traced_.emplace(world_->world);
    }
    const Result<check::DrawnImages> drawn = engine::drawImages(session, request, false);
    if (!drawn)
        return Failure(drawn.error());
    traced_->setDynamics(session.dynamics());
    const output::TracedFrame traced = output::traceFrame(traced_->scene(), request);
    check::ViewRetracer retracer(*traced_, traced.camera);
    ViewVerdict verdict;
    check::compare(*drawn, traced.picture, retracer, verdict.comparison);
    verdict.picture = output::pictureOfVerdicts(request.size.width, request.size.height, verdict.comparison);
    verdict.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return verdict;
}

} // namespace limen::viewer
