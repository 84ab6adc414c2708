#include "frames/FrameTimes.h"

#include "DrawnPart.h"
#include "PictureFile.h"
#include "Stopwatch.h"

#include "core/Hash.h"
#include "engine/CheckView.h"
#include "motion/DynamicStateBuilder.h"

#include <algorithm>
#include <fmt/format.h>

namespace limen::bench {

namespace {

using Ways = std::vector<std::unique_ptr<FrameWay>>;

FramePlace placeIn(std::shared_ptr<const engine::LoadedPart> part, const world::Place& place,
                   const FrameEffort& effort) {
    FramePlace out;
    out.view = viewFrom(*part, place, effort.width, effort.height);
    motion::DynamicStateBuilder(part->world).build(dynamicsFor(out.view), out.dynamics);
    out.part = std::move(part);
    return out;
}

/// The options of `limen shot` for a place.
std::string sceneOf(const FramePlace& place, const world::Place& from) {
    check::View view;
    view.eye = from.eye;
    view.yaw = from.yaw;
    view.pitch = from.pitch;
    view.fov = kFieldOfView;
    view.width = place.view.width;
    view.height = place.view.height;
    view.root = engine::cellOf(place.part->world, place.view.view.root);
    return check::shotOptions(view);
}

Result<FrameTime> timeOnce(FrameWay& way) {
    if (Result<void> entered = way.enter(); !entered)
        return Failure(entered.error());
    Result<void> drawn;
    const double processor = processSeconds();
    const double wall = secondsOf([&] { drawn = way.draw(); });
    const FrameTime time{wall * 1e3, (processSeconds() - processor) * 1e3};
    return drawn.map([&] { return time; });
}

double medianOf(const std::vector<FrameTime>& repeats, double FrameTime::*part) {
    Samples samples;
    for (const FrameTime& time : repeats)
        samples.seconds.push_back(time.*part);
    return samples.quantile(0.5);
}

Result<void> showEverywhere(const Ways& ways, const FramePlace& place) {
    for (const std::unique_ptr<FrameWay>& way : ways) {
        Result<void> shown = way->enter().and_then([&] { return way->show(place); });
        if (!shown)
            return shown;
    }
    return {};
}

Result<std::vector<FrameTime>> timePlace(const Ways& ways, const FramePlace& place, int repeats) {
    if (Result<void> shown = showEverywhere(ways, place); !shown)
        return Failure(shown.error());
    std::vector<std::vector<FrameTime>> times(ways.size());
    for (int repeat = 0; repeat < 1 + repeats; ++repeat) { // one to warm up
        for (std::size_t i = 0; i < ways.size(); ++i) {
            const Result<FrameTime> time = timeOnce(*ways[i]);
            if (!time)
                return Failure(time.error());
            if (repeat > 0)
                times[i].push_back(*time);
        }
    }
    std::vector<FrameTime> medians;
    medians.reserve(times.size());
    for (const std::vector<FrameTime>& way : times)
        medians.push_back({medianOf(way, &FrameTime::wall), medianOf(way, &FrameTime::processor)});
    return medians;
}

/// "03-cell-peer.png", "11-outside-exact-without-visibility.png".
std::string pictureName(std::size_t number, bool isInCell, std::string way) {
    std::replace(way.begin(), way.end(), ' ', '-');
    return fmt::format("{:02}-{}-{}.png", number, isInCell ? "cell" : "outside", way);
}

/// Draws a frame again, because ways can share images. Adds the first way's to the hash; writes all if there
/// is a directory for them.
Result<void> keepPictures(const Ways& ways, const std::filesystem::path& directory, std::size_t number,
                          bool isInCell, Hash& hash) {
    for (const std::unique_ptr<FrameWay>& way : ways) {
        if (way != ways.front() && directory.empty())
            continue;
        if (Result<void> drawn = way->enter().and_then([&] { return way->draw(); }); !drawn)
            return drawn;
        const FramePicture picture = way->read();
        if (way == ways.front())
            hash.addWords(std::as_bytes(std::span(picture.rgba)));
        if (directory.empty())
            continue;
        const std::filesystem::path file = directory / pictureName(number, isInCell, way->name());
        if (Result<void> written = writePicture(file, picture); !written)
            return written;
    }
    return {};
}

/// The part of the world for the next place: the one at hand, if it has the place.
Result<std::shared_ptr<const engine::LoadedPart>> partFor(const dat::Archive& archive,
                                                          const world::WorldFile& file,
                                                          const world::Place& place,
                                                          const FramePlace* atHand) {
    if (atHand != nullptr && holds(*atHand->part, place))
        return atHand->part;
    return loadAround(archive, file, place);
}

} // namespace

Result<FrameTimes> timeFrames(const dat::Archive& archive, const world::WorldFile& file,
                              const std::vector<world::Place>& places, const Ways& ways,
                              const FrameEffort& effort) {
    FrameTimes out;
    for (const std::unique_ptr<FrameWay>& way : ways)
        out.ways.push_back(way->name());
    Hash hash;
    std::unique_ptr<FramePlace> there; // ways keep a reference to it
    for (const world::Place& place : places) {
        Result<std::shared_ptr<const engine::LoadedPart>> part = partFor(archive, file, place, there.get());
        if (!part)
            return Failure(part.error());
        auto next = std::make_unique<FramePlace>(placeIn(std::move(*part), place, effort));
        Result<std::vector<FrameTime>> times = timePlace(ways, *next, effort.repeats);
        if (!times)
            return Failure(times.error());
        const bool isInCell = next->view.view.root != world::kOutside;
        if (Result<void> kept = keepPictures(ways, effort.pictures, out.places.size(), isInCell, hash); !kept)
            return Failure(kept.error());
        out.places.push_back({sceneOf(*next, place), isInCell, std::move(*times)});
        there = std::move(next);
    }
    out.hash = hash.value();
    return out;
}

} // namespace limen::bench
