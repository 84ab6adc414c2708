#include "CrowdBench.h"

#include "BuiltInFiles.h"
#include "DrawnPart.h"
#include "Stopwatch.h"

#include "core/Assert.h"
#include "core/Hash.h"
#include "geometry/Compass.h"
#include "visibility/Flood.h"

#include <algorithm>
#include <fmt/format.h>

namespace limen::bench {
namespace {

constexpr std::size_t kPeople = 200;
constexpr int kCrowdFrames = 400;
constexpr double kMostPlanning = 1.0; ///< milliseconds

BenchRow failedCrowd(const Error& error) {
    return failedRow("crowd/planning", error.message(), "ms");
}

/// People in rows before an eye, in the clothes and with the body of a villager.
std::vector<world::PlacedEntry> crowdBefore(const world::Place& place, const world::VillagerEntry& villager) {
    const Mat3 turn = turnedTo(place.yaw);
    std::vector<world::PlacedEntry> people;
    for (std::size_t i = 0; i < kPeople; ++i) {
        world::PlacedEntry person;
        person.id = i + 1;
        person.name = fmt::format("person {}", i);
        person.model = villager.model;
        person.clothing = villager.clothing;
        person.basePalette = villager.basePalette;
        const double row = static_cast<double>(i / 20), column = static_cast<double>(i % 20) - 9.5;
        person.position = place.eye + turn * Vec3(column * (0.8 + 0.1 * row), 12.0 + 2.0 * row, -1.6);
        person.block = world::blockAt(person.position);
        person.isOnGround = true;
        people.push_back(person);
    }
    return people;
}

/// Milliseconds of processor time of a frame's steps.
struct CrowdTimes {
    double state = 0.0, planning = 0.0;
    std::size_t instances = 0;
    std::uint64_t hash = 0;
};

CrowdTimes crowdTimesOf(engine::PartPlanner& planner, const world::Place& place) {
    const engine::LoadedPart& part = *planner.part;
    Samples state, planning;
    world::DynamicState dynamics;
    visibility::VisibleSet visible;
    frame::FramePlan plan;
    visibility::FloodScratch scratch;
    Hash hash;
    for (int i = 0; i < kCrowdFrames; ++i) {
        const frame::FrameView view = viewFrom(part, place, 1920, 1080, 0.05 * i);
        motion::DynamicStateInput input = dynamicsFor(view);
        input.seconds = i / 60.0;
        const double begin = threadSeconds();
        planner.dynamics.build(input, dynamics);
        const double built = threadSeconds();
        const Result<void> flooded =
            visibility::flood(part.graph, dynamics.closed, view.view, {}, scratch, visible);
        LIMEN_ASSERT(flooded.has_value(), "the views of a benchmark are valid");
        planner.planner.plan(view, dynamics, visible, plan);
        planning.seconds.push_back(threadSeconds() - built);
        state.seconds.push_back(built - begin);
        hash.add(visible.visits.size());
        hash.add(plan.batches.size());
    }
    return {state.quantile(0.5) * 1e3, planning.quantile(0.5) * 1e3, dynamics.instances.size(), hash.value()};
}

} // namespace

std::vector<BenchRow> benchCrowd(AllocationCounter) {
    BuiltInFiles files;
    if (const Result<void> opened = files.open(); !opened)
        return {failedCrowd(opened.error())};
    const auto place = std::find_if(files.world.places.begin(), files.world.places.end(),
                                    [](const world::Place& p) { return p.name == "lane"; });
    if (place == files.world.places.end() || files.world.moving.villagers.empty())
        return {failedCrowd({ErrorCode::NotFound, "lane", "the built-in world lacks this place, or people"})};
    std::vector<CrowdTimes> times; // without the crowd, and with it
    for (const bool isCrowded : {false, true}) {
        if (isCrowded)
            files.world.moving.placed = crowdBefore(*place, files.world.moving.villagers.front());
        Result<std::shared_ptr<const engine::LoadedPart>> loaded =
            loadAround(*files.archive, files.world, *place, {.radius = 1});
        if (!loaded)
            return {failedCrowd(loaded.error())};
        engine::PartPlanner planner(std::move(*loaded));
        times.push_back(crowdTimesOf(planner, *place));
    }
    const std::string scene =
        fmt::format("{} people, {} instances", kPeople, times[1].instances - times[0].instances);
    BenchRow planning{"crowd/planning", scene, times[1].planning - times[0].planning, times[1].planning,
                      "ms"};
    planning.target = kMostPlanning;
    planning.hasTarget = true;
    planning.hash = times[1].hash;
    const BenchRow state{"crowd/state", scene, times[1].state - times[0].state, times[1].state, "ms"};
    return {planning, state};
}

} // namespace limen::bench
