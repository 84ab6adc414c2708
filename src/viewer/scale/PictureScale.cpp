#include "viewer/scale/PictureScale.h"

#include "engine/Quality.h"

#include <chrono>
#include <cmath>
#include <utility>

namespace limen::viewer {
namespace {

// Timers of a graphics card report frames that were drawn up to three frames ago.
constexpr std::uint32_t kSoftwareSettling = 1, kCardSettling = 4;

ScaleBounds boundsOf(std::optional<std::size_t> quality) {
    if (!quality)
        return {kLeastScale, kFullScale};
    return {engine::kQualities[*quality].leastScale, engine::kQualities[*quality].mostScale};
}

} // namespace

std::uint32_t PictureScale::choose(const ScaleInput& input) {
    const std::optional<double> sceneMs = std::exchange(lastMs_, std::nullopt);
    facts_.wish = input.wish;
    facts_.automaticRate = input.isSoftware ? kSoftwareRate : input.displayRate;
    facts_.frameRate = input.wish.frameRate > 0.0 ? input.wish.frameRate : facts_.automaticRate;
    if (input.wish.percent > 0) {
        if (scale_.percent() != input.wish.percent)
            scale_.set(input.wish.percent);
    } else if (!input.isHeld && sceneMs && std::isfinite(*sceneMs)) {
        // A graphics card works beside the processor, and a display makes it wait: only its own time counts.
        const double other = input.isSoftware ? std::max(input.frameMs - *sceneMs, 0.0) : 0.0;
        static_cast<void>(
            scale_.next({*sceneMs, other}, {1e3 / facts_.frameRate, boundsOf(input.quality),
                                            input.isSoftware ? kSoftwareSettling : kCardSettling}));
    }
    if (input.wish.percent == 0)
        scale_.confine(boundsOf(input.quality));
    facts_.percent = scale_.percent();
    return facts_.percent;
}

void PictureScale::note(double sceneMs) {
    lastMs_ = sceneMs;
    facts_.sceneMs = sceneMs;
}

Result<double> drawTimed(engine::Session& session, const engine::FrameRequest& request,
                         const engine::DrawOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    if (Result<void> drawn = session.draw(request, options); !drawn)
        return Failure(drawn.error());
    if (!session.capabilities().software)
        return session.figures().gpuMs;
    session.finish();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

} // namespace limen::viewer
