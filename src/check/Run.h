#pragma once

#include "check/Drawer.h"
#include "check/Plan.h"
#include "check/Report.h"
#include "check/Traced.h"

#include <functional>
#include <optional>

// The run itself, with any drawer.
namespace limen::check {

/// Pixels. Sizes of views of any size; one side is at most four times the other.
inline constexpr std::uint32_t kLeastSide = 16, kMostWidth = 2000, kMostHeight = 1200;

struct RunRequest {
    std::vector<BlockTask> tasks;
    std::uint64_t seed = 1;
    std::uint32_t width = 640, height = 360;          ///< pixels
    std::uint32_t sweepWidth = 160, sweepHeight = 90; ///< pixels
    bool anySize =
        false; ///< instead: each view has a size of its own, kLeastSide to kMostWidth x kMostHeight
    std::span<const world::Place> tour;
    std::optional<double> doors; ///< openness of all doors; none: that of the world file
    std::uint32_t dayGroup = 0;
    bool rain = false;
    world::Look look = world::Look::Retail;
    double longest = 600.0; ///< views are taken at times from 0 to this, seconds
    unsigned threads = 2;   ///< for tracing
};

/// A judged view, for pictures of it. Valid during the call only.
struct FindingPicture {
    const View& view;
    std::uint64_t number;
    const DrawnImages& drawn;
    const reference::Picture& traced;
    const Comparison& comparison;
};

/// Callbacks of a run; each may be empty. `picture` is called from the tracing thread, one call at a time.
struct RunEvents {
    std::function<void(std::size_t done)> step; ///< views judged or left out, of viewsAsked
    std::function<Result<void>(const Progress&)>
        saved; ///< the state to save; every few seconds and at the end
    std::function<Result<void>(const FindingPicture&)> picture;
    std::function<bool()> stopped; ///< true: draw no further view; runCheck then returns an error
    std::function<Result<void>(const FindingPicture&)> right;   ///< as picture, for views without findings
    std::function<void(dat::BlockCoord, const Error&)> leftOut; ///< a block that could not be loaded
};

/// The number of views in a plan.
[[nodiscard]] std::size_t viewsAsked(const RunRequest& request);

/// The views of one task, in order; equal in every call.
[[nodiscard]] std::vector<View> viewsOf(const RunRequest& request, const BlockTask& task,
                                        const world::World& world, const reference::Scene& scene);

/// Draws and judges all views from `progress` on, and updates it. Drawing runs ahead of tracing, across
/// blocks, too. The drawer's helper, if there is one, shares the drawing. Errors: the drawer's and the
/// events', and `stopped`; `progress` then has all views judged so far.
[[nodiscard]] Result<void> runCheck(const RunRequest& request, Drawer& drawer, const RunEvents& events,
                                    Progress& progress);

} // namespace limen::check
