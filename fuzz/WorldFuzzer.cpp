#include "Check.h"

#include "dat/Writer.h"
#include "frame/Planner.h"
#include "frame/SceneBuilder.h"
#include "frame/WorldGraph.h"
#include "motion/DoorSwing.h"
#include "motion/DynamicStateBuilder.h"
#include "reference/Scene.h"
#include "support/MovingHut.h"
#include "visibility/Flood.h"
#include "world/Solids.h"

#include <cstring>

// Input: a list of changes to the records of a small world. Loading may refuse the world or report findings.
// A world that loads is flooded, planned, traced and walked through; none of this may fail.
namespace {

using namespace limen;

struct Stored {
    dat::RecordId id = 0;
    dat::Bytes payload;
};

/// The hut's records in the portal file and in the cell file.
struct Base {
    test::MovingHut hut;
    std::vector<Stored> portal, cell;

    Base() {
        const test::TempDir directory;
        FUZZ_CHECK(hut.source.write(directory.path()).has_value());
        const auto archive = dat::Archive::open(directory.path());
        FUZZ_CHECK(archive.has_value());
        portal = recordsOf(archive->portal());
        cell = recordsOf(archive->cell());
    }

private:
    static std::vector<Stored> recordsOf(const dat::File& file) {
        std::vector<Stored> records;
        dat::Bytes scratch;
        const auto walked = file.forEach([&](const dat::Entry& entry) {
            const auto payload = file.read(entry, scratch);
            FUZZ_CHECK(payload.has_value());
            records.push_back({entry.id, dat::Bytes(payload->begin(), payload->end())});
            return true;
        });
        FUZZ_CHECK(walked.has_value());
        return records;
    }
};

/// One change, with the layout of the input.
struct Change {
    std::uint8_t record = 0, how = 0;
    std::uint16_t where = 0;
    std::uint8_t value = 0;
};
constexpr std::size_t kChangeBytes = 5;

/// Words that often break arithmetic: ends of ranges, NaN and infinity.
constexpr std::uint32_t kWords[] = {0,          1,          0x7F,       0xFF,       0xFFFF,     0x10000,
                                    0x7FFFFFFF, 0x80000000, 0xFFFFFFFF, 0x7F800000, 0xFF800000, 0x7FC00000,
                                    0x7F7FFFFF, 0x00000001, 0x49742400, 0xC9742400};

void alter(const Change& change, std::vector<Stored>& records) {
    if (records.empty())
        return;
    const std::size_t index = change.record % records.size();
    dat::Bytes& bytes = records[index].payload;
    const std::size_t at = bytes.empty() ? 0 : change.where % bytes.size();
    switch (change.how % 8) {
    case 0:
        records.erase(records.begin() + static_cast<std::ptrdiff_t>(index));
        return;
    case 1:
        bytes.resize(at);
        return;
    case 2:
    case 3:
    case 4: {
        const std::uint32_t word = kWords[change.value % std::size(kWords)];
        std::memcpy(bytes.data() + at, &word, std::min(sizeof word, bytes.size() - at));
        return;
    }
    default:
        if (!bytes.empty())
            bytes[at] = change.how % 2 != 0 ? static_cast<std::byte>(change.value)
                                            : bytes[at] ^ static_cast<std::byte>(change.value);
    }
}

dat::File fileOf(const std::vector<Stored>& records, const dat::FileTraits& traits, const char* name) {
    dat::Writer writer(traits);
    for (const Stored& record : records)
        writer.add(record.id, record.payload);
    auto file = dat::File::fromBytes(*writer.build(), name);
    FUZZ_CHECK(file.has_value());
    return std::move(*file);
}

/// Floods, plans, traces and locates from a viewpoint.
void look(const world::World& world, const visibility::Graph& graph, frame::Planner& planner,
          const reference::Scene& scene, const world::DynamicState& dynamics, const Vec3& eye,
          world::SpaceIndex root) {
    if (!std::isfinite(eye.x + eye.y + eye.z))
        return;
    visibility::FloodScratch scratch;
    visibility::VisibleSet set;
    frame::FramePlan plan;
    for (const double yaw : {0.0, 100.0, 230.0}) {
        const frame::FrameView view = frame::makeView(eye, yaw, -10.0, 80.0, 64, 48, root);
        FUZZ_CHECK(visibility::flood(graph, dynamics.closed, view.view, {}, scratch, set).has_value());
        FUZZ_CHECK(!set.visits.empty());
        planner.plan(view, dynamics, set, plan);
        FUZZ_CHECK(plan.visits.size() == set.visits.size());
        for (const Vec3& aside : {Vec3(0.0), 0.3 * view.view.right, -0.2 * view.view.up})
            static_cast<void>(scene.trace(root, {eye, glm::normalize(view.view.forward + aside), 0.02}));
    }
    FUZZ_CHECK(root < world.spaces.size());
}

/// Moves a body while all doors open and close.
void walk(const dat::Archive& archive, const world::World& world, const Vec3& from) {
    auto solids = world::loadSolids(archive, world, world::blockAt(from), 1);
    if (!solids)
        return;
    const motion::Collisions around(world, std::move(*solids));
    motion::BodyState body = motion::bodyAt({from, world::kOutside});
    std::vector<double> doors;
    double openness = 0.0;
    for (int step = 0; step < 20; ++step) {
        openness = motion::swingAll(openness, step % 8 < 4 ? 1.0 : 0.0, body, around, doors);
        body = motion::moved(body, {1.0, 0.0, 40.0 * step, true, step % 7 == 0}, 0.05, around, doors);
    }
    FUZZ_CHECK(openness >= 0.0 && openness <= 1.0);
    FUZZ_CHECK(std::isfinite(body.standing.feet.x + body.standing.feet.y + body.standing.feet.z));
}

void check(const dat::Archive& archive, const test::MovingHut& hut) {
    world::LoadOptions options;
    options.radius = 1;
    const auto world = world::loadWorld(archive, hut.source.home(), options, hut.moving);
    if (!world) {
        FUZZ_CHECK(!world.error().what.empty());
        return;
    }
    const auto graph = frame::visibilityGraph(*world);
    if (!graph)
        return;
    motion::DynamicStateBuilder dynamicsBuilder(*world);
    world::DynamicState dynamics;
    motion::DynamicStateInput input;
    input.seconds = 12.5;
    input.eye = hut.at({12, 12, 3.5});
    input.rain = true;
    if (!world->sky.weather.empty())
        input.weather = world::SkyHour{world->sky.weather.front().dayGroup, 0.5};
    dynamicsBuilder.build(input, dynamics);
    const frame::StaticScene staticScene(*world);
    static_cast<void>(frame::buildScene(staticScene));
    frame::Planner planner(staticScene);
    reference::Scene scene(*world);
    scene.setDynamics(dynamics);
    look(*world, *graph, planner, scene, dynamics, hut.at({5, 11.5, 3.5}), world::kOutside);
    for (world::SpaceIndex space = 1; space < world->spaces.size(); ++space)
        look(*world, *graph, planner, scene, dynamics, world->spaces[space].bounds.centre(), space);
    walk(archive, *world, hut.at({5, 11.5, 3.0}));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const Base base;
    std::vector<Stored> portal = base.portal, cell = base.cell;
    for (std::size_t at = 0; at + kChangeBytes <= size; at += kChangeBytes) {
        Change change{data[at], data[at + 1], 0, data[at + 4]};
        std::memcpy(&change.where, data + at + 2, sizeof change.where);
        alter(change, change.how % 16 < 8 ? portal : cell);
    }
    const dat::Archive archive = dat::Archive::of(fileOf(portal, dat::FileTraits::portal(), "portal"),
                                                  fileOf(cell, dat::FileTraits::cell(), "cell"));
    check(archive, base.hut);
    return 0;
}
