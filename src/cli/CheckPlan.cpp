#include "cli/CheckPlan.h"

#include "cli/Choices.h"
#include "cli/Parse.h"
#include "cli/PathArguments.h"
#include "engine/CheckView.h"
#include "engine/DayGroup.h"
#include "gpu/device/NullDevice.h"
#include "play/FrameSource.h"

#include <algorithm>
#include <fmt/format.h>
#include <thread>

namespace limen::cli {
namespace {

Result<std::vector<check::ViewKind>> kindsOf(const std::string& list) {
    const std::vector<std::string> names(check::kKindNames.begin(), check::kKindNames.end());
    std::vector<check::ViewKind> kinds;
    for (std::size_t begin = 0; begin <= list.size() && !list.empty();) {
        const std::size_t end = std::min(list.find(',', begin), list.size());
        const std::string_view name = trimmed(std::string_view(list).substr(begin, end - begin));
        const std::optional<check::ViewKind> kind = check::kindNamed(name);
        if (!kind)
            return fail(ErrorCode::BadArgument, "--kinds",
                        fmt::format("unknown kind of view '{}'{}", name, suggestion(name, names)));
        kinds.push_back(*kind);
        begin = end + 1;
    }
    if (kinds.empty())
        for (std::size_t i = 0; i < check::kUsualKinds; ++i)
            kinds.push_back(static_cast<check::ViewKind>(i));
    return kinds;
}

/// Keeps only the selected block.
Result<void> restrictTo(const std::string& text, std::vector<check::BlockSummary>& blocks) {
    if (text.empty())
        return {};
    const Result<dat::RecordId> word = parseRecordId("--block", text);
    if (!word)
        return Failure(word.error());
    if (*word > 0xFFFFu)
        return fail(ErrorCode::BadArgument, "--block",
                    fmt::format("'{}' is not a landblock of four hexadecimal digits, such as A9B4", text));
    std::erase_if(blocks,
                  [&](const check::BlockSummary& b) { return dat::blockWord(b.block) != *word << 16; });
    if (blocks.empty())
        return fail(
            ErrorCode::NotFound, "--block",
            fmt::format("landblock {:04X} has no cells and no buildings in this world; choose another block",
                        *word));
    return {};
}

/// Replays a walk without drawing and adds a view for each of its frames.
Result<check::RunRequest> addWalk(const CheckOptions& options,
                                  const std::shared_ptr<const engine::WorldSource>& source,
                                  const Console& console, check::RunRequest request) {
    Result<play::WalkRecord> record = play::readWalk(options.walk);
    if (!record)
        return Failure(record.error());
    const Result<engine::ViewRequest> start = walkStart(*record);
    if (!start)
        return Failure(start.error());
    gpu::NullDevice device;
    engine::Session session(source, options.session, device);
    const Result<std::unique_ptr<play::ReplayedFrames>> frames =
        play::ReplayedFrames::open(session, std::move(*record), *start);
    if (!frames)
        return Failure(frames.error());
    std::vector<check::View> views;
    for (std::size_t i = 0; i < (*frames)->count(); ++i) {
        const Result<const engine::FrameRequest*> next = (*frames)->next();
        if (!next)
            return Failure(next.error());
        if (Result<void> drawn = session.draw(**next, {}); !drawn)
            return Failure(drawn.error());
        views.push_back(engine::viewOf(**next, session.part().world));
        views.back().kind = check::ViewKind::Path;
        views.back().width = request.width;
        views.back().height = request.height;
        views.back().about = fmt::format("frame {} of the walk", i);
    }
    if (const std::string difference = play::differenceLine(**frames); !difference.empty())
        console.note(difference);
    request.tasks = check::tasksOf(views);
    return request;
}

} // namespace

Result<check::RunRequest> planCheck(const CheckOptions& options,
                                    const std::shared_ptr<const engine::WorldSource>& source,
                                    const Console& console) {
    const Result<std::vector<check::ViewKind>> kinds = kindsOf(options.kinds);
    if (!kinds)
        return Failure(kinds.error());
    check::RunRequest request;
    request.seed = options.seed;
    request.tour = source->file.tour;
    const Result<std::optional<double>> doors = parseDoors("--doors", options.doors);
    if (!doors)
        return Failure(doors.error());
    request.doors = *doors;
    const Result<engine::Weather> weather = parseWeather("--weather", options.weather);
    if (!weather)
        return Failure(weather.error());
    request.rain = *weather == engine::Weather::Rain;
    const Result<engine::Look> look = parseLook("--look", options.look);
    if (!look)
        return Failure(look.error());
    request.look = *look;
    const Result<dat::Region> region = source->archive.load<dat::Region>(dat::kRegionId);
    const Result<std::uint32_t> day =
        region ? engine::dayGroupOf(region->sky, region->gameTime, {options.day, {}})
               : engine::dayGroupOf({}, {}, {options.day, {}});
    if (!day)
        return Failure(day.error());
    request.dayGroup = *day;
    request.threads = std::max(1u, std::thread::hardware_concurrency());
    request.anySize = options.size == "any";
    if (!options.size.empty() && !request.anySize) {
        const Result<engine::PixelSize> size = parseSize("--size", options.size);
        if (!size)
            return Failure(size.error());
        request.width = request.sweepWidth = size->width;
        request.height = request.sweepHeight = size->height;
    }
    if (!options.walk.empty())
        return addWalk(options, source, console, request);
    Result<std::vector<check::BlockSummary>> blocks = check::blocksOf(source->archive);
    if (!blocks)
        return Failure(blocks.error());
    if (Result<void> left = restrictTo(options.block, *blocks); !left)
        return Failure(left.error());
    const std::vector<check::ViewKind> placed = check::kindsWithPlaces(*kinds, *blocks);
    request.tasks =
        check::planTasks(*blocks, source->file.tour, check::shareAmongKinds(options.views, placed));
    if (request.tasks.empty())
        return fail(ErrorCode::NotFound, "check",
                    "this world has no content for these kinds of view; choose other --kinds");
    return request;
}

} // namespace limen::cli
