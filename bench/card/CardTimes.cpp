#include "card/CardTimes.h"

#include "Stopwatch.h"

#include "core/Hash.h"
#include "gpu/device/GlObjects.h"

#include <epoxy/gl.h>

namespace limen::bench {

namespace {

/// A frame's timestamps.
struct Stamps {
    gpu::Query begin = gpu::Query::createTimestamp("frame begin");
    gpu::Query end = gpu::Query::createTimestamp("frame end");

    /// Requires that the device is idle.
    [[nodiscard]] double milliseconds() const {
        return static_cast<double>(end.poll().value_or(0) - begin.poll().value_or(0)) * 1e-6;
    }
};

/// Submits the planned frame some times. Errors: the renderer's.
Result<void> submitOften(DrawnPart& part, std::span<const Stamps> stamps) {
    for (const Stamps& frame : stamps) {
        frame.begin.stamp();
        if (Result<void> drawn = part.submit({.wantIds = false}); !drawn)
            return drawn;
        frame.end.stamp();
    }
    return {};
}

/// Medians of the stages' times. Each frame is waited for, because the stages' timers skip frames in flight.
Result<void> addStages(DrawnPart& part, int repeats, CardTime& time) {
    std::array<Samples, frame::kStageCount> samples;
    for (int i = 0; i < repeats; ++i) {
        if (Result<void> drawn = part.submit({.wantIds = false}); !drawn)
            return drawn;
        glFinish();
        const gpu::FrameReport report = part.renderer().report();
        for (std::size_t stage = 0; stage < samples.size(); ++stage)
            samples[stage].seconds.push_back(report.stages[stage].gpuMs.value_or(0.0));
    }
    for (std::size_t stage = 0; stage < samples.size(); ++stage)
        time.stages[stage] = samples[stage].quantile(0.5);
    return {};
}

Result<CardTime> timePlace(DrawnPart& part, const world::Place& place, const CardEffort& effort) {
    const frame::FrameView view = part.viewFrom(place);
    part.move(view);
    part.flood(view);
    part.plan(view);
    const std::vector<Stamps> stamps(static_cast<std::size_t>(effort.warmUps + effort.repeats));
    if (Result<void> drawn = submitOften(part, stamps); !drawn)
        return Failure(drawn.error());
    glFinish();
    Samples frames;
    for (auto i = static_cast<std::size_t>(effort.warmUps); i < stamps.size(); ++i)
        frames.seconds.push_back(stamps[i].milliseconds());
    CardTime time;
    time.frame = frames.quantile(0.5);
    return addStages(part, effort.repeats, time).map([&] { return time; });
}

/// Times the places [first, last), which one part holds.
Result<void> timeRun(DrawnPart& part, const std::vector<world::Place>& places, std::size_t first,
                     std::size_t last, const CardEffort& effort, CardTimes& times) {
    Hash hash;
    hash.add(times.hash);
    for (std::size_t i = first; i < last; ++i) {
        const Result<CardTime> time = timePlace(part, places[i], effort);
        if (!time)
            return Failure(time.error());
        times.places.push_back(*time);
        hash.add(part.plan().counts.instancesDrawn);
        hash.add(part.plan().visits.size());
    }
    times.hash = hash.value();
    return {};
}

} // namespace

Result<std::vector<CardTimes>> timeOnCard(gpu::Device& device, const dat::Archive& archive,
                                          const world::WorldFile& file,
                                          const std::vector<world::Place>& places,
                                          const std::vector<CardWay>& ways,
                                          const std::vector<PictureSize>& sizes, const CardEffort& effort) {
    std::vector<CardTimes> all;
    for (const CardWay& way : ways)
        for (const PictureSize& size : sizes)
            all.push_back({size.width, size.height, way.name, {}, 0});
    for (std::size_t first = 0, last = 0; first < places.size(); first = last) {
        const Result<std::shared_ptr<const engine::LoadedPart>> loaded =
            loadAround(archive, file, places[first]);
        if (!loaded)
            return Failure(loaded.error());
        for (last = first; last < places.size() && holds(**loaded, places[last]);)
            ++last;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const CardWay& way = ways[i / sizes.size()];
            const Result<std::unique_ptr<DrawnPart>> drawn =
                DrawnPart::of(*loaded, device, all[i].width, all[i].height, way.options);
            if (!drawn)
                return Failure(drawn.error());
            if (Result<void> timed = timeRun(**drawn, places, first, last, effort, all[i]); !timed)
                return Failure(timed.error());
        }
    }
    return all;
}

} // namespace limen::bench
