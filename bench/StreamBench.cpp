#include "StreamBench.h"

#include "ChildProcess.h"
#include "FullWorld.h"
#include "HeadlessDriver.h"
#include "Stopwatch.h"
#include "TemporaryDirectory.h"

#include "engine/HeapTuning.h"
#include "engine/stream/StreamedResidency.h"
#include "gpu/device/NullDevice.h"
#include "world/Nearby.h"
#include "worlds/Demo.h"
#include "worlds/Generated.h"

#include <fmt/format.h>
#include <fstream>
#include <limits>
#include <thread>
#include <unistd.h>

namespace limen::bench {

namespace {

constexpr double kSpeed = 50.0; // metres a second
constexpr double kFrame = 1.0 / 60.0;
constexpr double kAbove = 30.0; // metres above the ground
constexpr int kNear = 4, kFar = 12;
/// The eye can be one block away from the loaded centre. Blocks up to this distance must always be loaded.
constexpr int kAlwaysNear = kNear - 1;
constexpr std::uint32_t kMapCells = 60'000;
constexpr double kMebibyte = 1 << 20;

double residentMiB() {
    std::ifstream in("/proc/self/statm");
    double all = 0.0, resident = 0.0;
    in >> all >> resident;
    return resident * static_cast<double>(::sysconf(_SC_PAGESIZE)) / kMebibyte;
}

/// Blocks with landscape, and the path over them from the south-western to the north-eastern end.
struct Land {
    std::vector<dat::BlockCoord> blocks;
    Vec3 from{0.0}, to{0.0};

    explicit Land(const engine::WorldSource& source) {
        for (int x = 0; x < world::kMapSize; ++x) {
            for (int y = 0; y < world::kMapSize; ++y) {
                const dat::BlockCoord block{x, y};
                if (source.archive.contains<dat::LandBlock>(dat::landBlockId(block)) &&
                    !world::isDungeon(source.archive, block))
                    blocks.push_back(block);
            }
        }
        const auto isBefore = [](dat::BlockCoord a, dat::BlockCoord b) { return a.x + a.y < b.x + b.y; };
        const auto placeIn = [](dat::BlockCoord block) {
            return Vec3(block.x + 0.5, block.y + 0.45, 0.0) * world::kBlockSize;
        };
        if (!blocks.empty()) {
            from = placeIn(*std::min_element(blocks.begin(), blocks.end(), isBefore));
            to = placeIn(*std::max_element(blocks.begin(), blocks.end(), isBefore));
        }
    }

    /// Shortens the path to a few blocks, from the last place outside of dungeons towards the middle.
    void keepPart(const std::vector<world::Place>& places) {
        constexpr double kLength = 12.0 * world::kBlockSize;   // metres
        const auto isOnLand = [&](const world::Place& place) { // a dungeon's cells can have any coordinates
            const dat::BlockCoord block =
                place.cell == 0 ? world::blockAt(place.eye) : dat::blockOf(place.cell);
            return std::find(blocks.begin(), blocks.end(), block) != blocks.end();
        };
        const auto town = std::find_if(places.rbegin(), places.rend(), isOnLand);
        if (town != places.rend()) {
            const double inwards = town->eye.x < 0.5 * (from.x + to.x) ? 1.0 : -1.0;
            from = town->eye;
            to = from + Vec3(inwards * kLength, 0.1 * kLength, 0.0);
        }
    }
};

struct Flight {
    std::vector<double> cpu, wall; ///< seconds of streaming, by frame
    std::size_t missing = 0;       ///< frames with blocks missing in the near tier
    std::size_t shown = 0;         ///< parts of the world that were shown
    double mostMiB = 0.0;
};

double quantile(std::vector<double> values, double q) {
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(q * static_cast<double>(values.size() - 1) + 0.5)];
}

bool isAllThere(const world::World& world, const Land& land, dat::BlockCoord eye) {
    return std::all_of(land.blocks.begin(), land.blocks.end(), [&](dat::BlockCoord block) {
        if (std::max(std::abs(block.x - eye.x), std::abs(block.y - eye.y)) > kAlwaysNear)
            return true;
        const world::Block* there = world::findBlock(world, block);
        return there != nullptr && !there->isFar;
    });
}

/// A frame's streaming, with no body that has to be prepared.
bool follow(const engine::Session& session, engine::StreamedResidency& stream, const Vec3& at,
            engine::FrameRequest& eye) {
    const dat::RecordId cell = engine::cellOf(session.part().world, eye.root);
    if (!stream.follow(at, eye.root) || !stream.show())
        return false;
    eye.root = engine::rootIn(session.part(), cell, at);
    return true;
}

Result<Flight> fly(const std::shared_ptr<const engine::WorldSource>& source, const Land& land,
                   gpu::Device& device) {
    engine::giveBackFreeMemory(); // of earlier flights
    engine::SessionOptions options;
    options.givesMemoryBack = true; // as in the viewer
    options.load.radius = kNear;
    options.load.farRadius = kFar;
    engine::Session session(source, options, device);
    if (Result<void> loaded = session.load(world::blockAt(land.from)); !loaded)
        return Failure(loaded.error());
    engine::StreamedResidency stream(session);
    engine::FrameRequest eye;
    eye.size = {64, 36};
    const Vec3 way = land.to - land.from;
    eye.camera.heading.yaw = glm::degrees(std::atan2(way.x, way.y));
    const auto frames = static_cast<std::size_t>(glm::length(way) / kSpeed / kFrame);
    Flight flight;
    auto due = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < frames; ++i) {
        Vec3 at = land.from + way * (static_cast<double>(i) / static_cast<double>(frames));
        const double ground = world::terrainHeight(session.part().world, at.x, at.y);
        at.z = std::isfinite(ground) ? ground + kAbove : kAbove;
        eye.camera.eye = eye.scene.player = at;
        eye.scene.seconds = static_cast<double>(i) * kFrame;
        const double cpu = threadSeconds();
        flight.wall.push_back(secondsOf([&] { flight.shown += follow(session, stream, at, eye) ? 1 : 0; }));
        flight.cpu.push_back(threadSeconds() - cpu);
        if (const std::string fault = stream.takeFault(); !fault.empty())
            return fail(ErrorCode::NotFound, "stream", fault);
        flight.missing += isAllThere(session.part().world, land, world::blockAt(at)) ? 0 : 1;
        if (Result<void> drawn = session.draw(eye, {}); !drawn)
            return Failure(drawn.error());
        flight.mostMiB = std::max(flight.mostMiB, i % 20 == 0 ? residentMiB() : 0.0);
        due = std::max(
            due + std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(kFrame)),
            std::chrono::steady_clock::now());
        std::this_thread::sleep_until(due);
    }
    return flight;
}

BenchRow rowOf(const char* name, std::string scene, double value, const char* unit, double target) {
    BenchRow row{name, std::move(scene), value, value, unit};
    row.target = target;
    row.hasTarget = true;
    return row;
}

void addRows(const std::string& scene, const Result<Flight>& flight, std::vector<BenchRow>& rows) {
    if (!flight) {
        rows.push_back(rowOf("stream", scene + ": " + flight.error().message(), kNotMeasured, "ms", 0.5));
        return;
    }
    const std::string times =
        fmt::format("{}, {} frames, {} parts; by the clock median {:.3f}, p99 {:.3f}, most {:.2f} ms", scene,
                    flight->cpu.size(), flight->shown, quantile(flight->wall, 0.5) * 1e3,
                    quantile(flight->wall, 0.99) * 1e3, quantile(flight->wall, 1.0) * 1e3);
    BenchRow main = rowOf("stream/main", times, quantile(flight->cpu, 0.99) * 1e3, "ms", 0.5);
    main.p95 = quantile(flight->cpu, 0.95) * 1e3;
    rows.push_back(main);
    rows.push_back(rowOf("stream/missing", scene, static_cast<double>(flight->missing), "frames", 2.0));
    rows.push_back(rowOf("stream/memory", scene, flight->mostMiB, "MiB", 512.0));
}

} // namespace

std::vector<BenchRow> benchStream(AllocationCounter) {
    engine::tuneHeapForHours(); // as in the viewer
    const TemporaryDirectory builtIn("stream-built-in"), generated("stream-generated");
    std::vector<BenchRow> rows;
    const auto measure = [&](const std::string& scene, const TemporaryDirectory& directory, bool whole,
                             const Result<void>& written, gpu::Device& device) {
        Result<engine::WorldSource> source = engine::openWorldSource(directory.path().string());
        if (!written || !source) {
            addRows(scene, Failure(written ? source.error() : written.error()), rows);
            return;
        }
        Land land(*source);
        if (!whole)
            land.keepPart(source->file.places);
        addRows(scene, fly(std::make_shared<const engine::WorldSource>(std::move(*source)), land, device),
                rows);
    };
    // Child processes write the worlds, so that the writers' memory does not count.
    const Result<void> world = inChildProcess([&] { return worlds::writeBuiltInWorld(builtIn.path()); });
    const Result<void> map = inChildProcess([&] {
        return worlds::writeGeneratedWorld({worlds::GeneratedKind::Map, kMapCells}, generated.path());
    });
    measure("built-in world, null device", builtIn, true, world, *std::make_unique<gpu::NullDevice>());
    measure("whole map, null device", generated, false, map, *std::make_unique<gpu::NullDevice>());
    if (const std::optional<HeadlessDriver> driver = openDriver()) {
        measure("whole map, " + driver->device->capabilities().renderer, generated, false, map,
                *driver->device);
    }
    return rows;
}

std::vector<BenchRow> benchStreamOver(const std::string& dat) {
    engine::tuneHeapForHours();
    std::vector<BenchRow> rows;
    const auto measure = [&](const std::string& scene, gpu::Device& device) {
        Result<engine::WorldSource> source = engine::openWorldSource(dat);
        if (!source) {
            addRows(scene, Failure(source.error()), rows);
            return;
        }
        const Land land(*source);
        addRows(scene, fly(std::make_shared<const engine::WorldSource>(std::move(*source)), land, device),
                rows);
    };
    measure(dat + ", null device", *std::make_unique<gpu::NullDevice>());
    if (const std::optional<HeadlessDriver> driver = openDriver())
        measure(dat + ", " + driver->device->capabilities().renderer, *driver->device);
    return rows;
}

std::vector<BenchRow> benchPlaced(AllocationCounter) {
    engine::tuneHeapForHours();
    const TemporaryDirectory directory("placed");
    const Result<void> written = inChildProcess([&]() -> Result<void> {
        return worlds::writeGeneratedWorld({worlds::GeneratedKind::Map, kMapCells}, directory.path())
            .and_then([&] { return writeFullWorld(directory.path()); });
    });
    std::vector<BenchRow> rows;
    const auto measure = [&](const std::string& scene, gpu::Device& device) {
        Result<engine::WorldSource> source =
            written ? engine::openWorldSource(directory.path().string()) : Failure(written.error());
        if (!source) {
            addRows(scene, Failure(source.error()), rows);
            return;
        }
        Land land(*source);
        land.keepPart(source->file.places);
        addRows(scene, fly(std::make_shared<const engine::WorldSource>(std::move(*source)), land, device),
                rows);
    };
    measure("365,183 placed objects, null device", *std::make_unique<gpu::NullDevice>());
    if (const std::optional<HeadlessDriver> driver = openDriver())
        measure("365,183 placed objects, " + driver->device->capabilities().renderer, *driver->device);
    return rows;
}

std::vector<BenchRow> benchPlacedOver(const std::string& dat) {
    if (!std::filesystem::exists(std::filesystem::path(dat) / placements::kWorldDbName))
        if (Result<void> written = inChildProcess([&] { return writeFullWorld(dat); }); !written) {
            std::vector<BenchRow> rows;
            addRows(dat, Failure(written.error()), rows);
            return rows;
        }
    return benchStreamOver(dat);
}

} // namespace limen::bench
