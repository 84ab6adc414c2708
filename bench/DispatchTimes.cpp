#include "DispatchTimes.h"

#include "Stopwatch.h"

#include "core/Hash.h"
#include "gpu/device/NullDevice.h"

#include <epoxy/gl.h>

namespace limen::bench {

namespace {

constexpr int kWarmUps = 2;
constexpr double kMicroseconds = 1e6;

using DrawWay = Result<void> (TwoWays::*)(const FieldView&);
constexpr DrawWay kReal = &TwoWays::drawReal, kClassic = &TwoWays::drawClassic;

/// One repeat of one path, in microseconds a frame.
struct Round {
    double thread = 0.0, wall = 0.0;
    std::uint64_t allocations = 0;
};

Result<Round> roundOnNull(TwoWays& ways, DrawWay draw, ObjectField& field, std::span<const FieldView> views,
                          AllocationCounter counter) {
    Round round;
    for (std::uint32_t i = 0; i < views.size(); ++i) {
        field.moveTo(i);
        const std::uint64_t before = counter ? counter() : 0;
        const double start = threadSeconds();
        Result<void> drawn = (ways.*draw)(views[i]);
        round.thread += threadSeconds() - start;
        round.allocations += counter ? counter() - before : 0;
        if (!drawn)
            return Failure(drawn.error());
    }
    round.thread *= kMicroseconds / static_cast<double>(views.size());
    return round;
}

Result<Round> roundOnDriver(TwoWays& ways, DrawWay draw, ObjectField& field,
                            std::span<const FieldView> views) {
    Round round;
    for (std::uint32_t i = 0; i < views.size(); ++i) {
        field.moveTo(i);
        glFinish();
        Result<void> drawn;
        const double start = threadSeconds();
        round.wall += secondsOf([&] {
            drawn = (ways.*draw)(views[i]);
            round.thread += threadSeconds() - start;
            glFinish();
        });
        if (!drawn)
            return Failure(drawn.error());
    }
    round.thread *= kMicroseconds / static_cast<double>(views.size());
    round.wall *= kMicroseconds / static_cast<double>(views.size());
    return round;
}

Result<void> compareIds(TwoWays& ways, ObjectField& field, std::span<const FieldView> views, DriverRun& run) {
    Hash hash;
    for (std::uint32_t i = 0; i < views.size(); ++i) {
        field.moveTo(i);
        if (Result<void> drawn = ways.drawReal(views[i]); !drawn)
            return drawn;
        const std::vector<std::uint32_t> ids = ways.target().readIds();
        if (Result<void> drawn = ways.drawClassic(views[i]); !drawn)
            return drawn;
        run.same = run.same && ids == ways.target().readIds();
        for (const std::uint32_t id : ids)
            hash.add(id);
    }
    run.hash = hash.value();
    return {};
}

} // namespace

Result<WayTimes> timeOnNullDevice(ObjectField& field, std::span<const FieldView> views, int repeats,
                                  AllocationCounter counter) {
    gpu::NullDevice device;
    const frame::FrameView& frame = views.front().frame;
    const Result<std::unique_ptr<TwoWays>> ways = TwoWays::create(device, field, frame.width, frame.height);
    if (!ways)
        return Failure(ways.error());
    WayTimes times;
    for (int i = 0; i < kWarmUps + repeats; ++i) {
        const Result<Round> real = roundOnNull(**ways, kReal, field, views, counter);
        const Result<Round> classic = roundOnNull(**ways, kClassic, field, views, nullptr);
        if (!real || !classic)
            return Failure((real ? classic : real).error());
        if (i >= kWarmUps) {
            times.real.push_back(real->thread);
            times.classic.push_back(classic->thread);
            times.allocations = real->allocations;
        }
    }
    return times;
}

Result<DriverRun> runOnDriver(gpu::Device& device, ObjectField& field, std::span<const FieldView> views,
                              int repeats) {
    const frame::FrameView& frame = views.front().frame;
    const Result<std::unique_ptr<TwoWays>> ways = TwoWays::create(device, field, frame.width, frame.height);
    if (!ways)
        return Failure(ways.error());
    DriverRun run;
    if (Result<void> compared = compareIds(**ways, field, views, run); !compared) // this also warms up
        return Failure(compared.error());
    for (int i = 0; i < repeats; ++i) {
        const Result<Round> real = roundOnDriver(**ways, kReal, field, views);
        const Result<Round> classic = roundOnDriver(**ways, kClassic, field, views);
        if (!real || !classic)
            return Failure((real ? classic : real).error());
        run.calls.real.push_back(real->thread);
        run.calls.classic.push_back(classic->thread);
        run.finished.real.push_back(real->wall);
        run.finished.classic.push_back(classic->wall);
    }
    return run;
}

} // namespace limen::bench
