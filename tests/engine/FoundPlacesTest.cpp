#include "engine/places/FoundPlaces.h"

#include "check/views/Viewpoints.h"
#include "engine/ViewRequest.h"
#include "engine/WorldSource.h"
#include "engine/places/KnownSpots.h"
#include "motion/Locate.h"
#include "support/TemporaryDirectory.h"
#include "world/Loader.h"
#include "worlds/Demo.h"
#include "worlds/Generated.h"

#include <gtest/gtest.h>

namespace limen::engine {
namespace {

using worlds::GeneratedKind;

/// A world without world.json, and the places found in it. Nullopt: the built-in world.
struct Nameless {
    explicit Nameless(std::optional<GeneratedKind> kind, std::uint32_t size = 12, std::uint32_t seed = 3) {
        const Result<void> written = kind ? worlds::writeGeneratedWorld({*kind, size, seed}, directory.path())
                                          : worlds::writeBuiltInWorld(directory.path());
        EXPECT_TRUE(written);
        std::filesystem::remove(directory / "world.json");
        source.emplace(openWorldSource(directory.path().string()).value());
    }
    [[nodiscard]] const world::WorldFile& file() const { return source->file; }

    test::TemporaryDirectory directory;
    std::optional<WorldSource> source;
};

/// The world around a place as the verbs load it, with the tracer's scene.
struct Around {
    Around(const WorldSource& source, const world::Place& place)
        : block(centreOf(requestAt(place))), world(world::loadWorld(source.archive, block, {1}).value()),
          scene(world) {}
    [[nodiscard]] check::Surroundings surroundings() const { return {world, scene, block}; }

    dat::BlockCoord block;
    world::World world;
    reference::Scene scene;
};

/// The eye is in the space that the place names, above the ground and in no solid.
void expectSensible(const Around& around, const world::Place& place) {
    const world::SpaceIndex space =
        place.cell == 0 ? world::kOutside : world::findCell(around.world, place.cell);
    ASSERT_NE(space, world::kNone) << place.name;
    if (place.cell == 0) {
        const double ground = world::terrainHeight(around.world, place.eye.x, place.eye.y);
        EXPECT_NEAR(place.eye.z - ground, kEyeHeight, 0.01) << place.name;
        EXPECT_EQ(motion::locate(around.world, place.eye).space, world::kOutside) << place.name;
    } else if (around.world.spaces[space].bspNodeCount > 0) {
        EXPECT_TRUE(motion::cellContains(around.world, space, place.eye)) << place.name;
    }
    check::RandomGenerator random(1, {7});
    EXPECT_TRUE(check::isFreeViewpoint(around.surroundings(), space, place.eye, random)) << place.name;
}

const world::Place& startOf(const world::WorldFile& file) {
    static const world::Place kNone;
    const world::Place* start = firstPlace(file);
    EXPECT_NE(start, nullptr);
    return start == nullptr ? kNone : *start;
}

/// Every leg but jumps is a free line that leads from the space of its first point to that of the second.
void expectConnected(const Nameless& nameless) {
    const std::vector<world::Place>& tour = nameless.file().tour;
    ASSERT_GT(tour.size(), 2u);
    std::optional<Around> around;
    for (std::size_t i = 0; i + 1 < tour.size(); ++i) {
        if (world::isJump(tour[i], tour[i + 1]))
            continue;
        if (!around || !(around->block == centreOf(requestAt(tour[i]))))
            around.emplace(*nameless.source, tour[i]);
        const auto spaceOf = [&](const world::Place& p) {
            return p.cell == 0 ? world::kOutside : world::findCell(around->world, p.cell);
        };
        const auto end = check::walk(around->surroundings(), spaceOf(tour[i]), tour[i].eye, tour[i + 1].eye);
        ASSERT_TRUE(end.has_value()) << "a surface is on the way from point " << i;
        EXPECT_EQ(*end, spaceOf(tour[i + 1])) << "from point " << i;
    }
}

std::size_t cellsOn(const std::vector<world::Place>& tour) {
    std::set<dat::RecordId> cells;
    for (const world::Place& point : tour)
        if (point.cell != 0)
            cells.insert(point.cell);
    return cells.size();
}

TEST(FoundPlaces, aTownBeginsOutsideBeforeADoor) {
    const Nameless town(GeneratedKind::Town);
    const world::Place& start = startOf(town.file());
    EXPECT_TRUE(start.name.starts_with("town ")) << start.name;
    EXPECT_EQ(start.cell, 0u);
    expectSensible(Around(*town.source, start), start);
}

TEST(FoundPlaces, theTourOfATownEntersHouses) {
    const Nameless town(GeneratedKind::Town);
    EXPECT_GE(cellsOn(town.file().tour), 2u);
    expectConnected(town);
}

TEST(FoundPlaces, theBuiltInWorldIsFoundWithoutItsFile) {
    const Nameless builtIn(std::nullopt);
    const world::Place& start = startOf(builtIn.file());
    EXPECT_EQ(start.cell, 0u);
    for (const world::Place& place : builtIn.file().places)
        expectSensible(Around(*builtIn.source, place), place);
    EXPECT_GE(cellsOn(builtIn.file().tour), 3u);
    expectConnected(builtIn);
}

TEST(FoundPlaces, aWorldOfCellsBeginsInsideOne) {
    // In the complex of seed 1 the start sees an opening with a picture on its far side, and isFreeViewpoint looks back.
    for (const auto& [kind, seed] : {std::pair{GeneratedKind::Dungeon, 1u}, {GeneratedKind::Complex, 5u}}) {
        const Nameless dungeon(kind, 30, seed);
        const world::Place& start = startOf(dungeon.file());
        EXPECT_NE(start.cell, 0u);
        expectSensible(Around(*dungeon.source, start), start);
    }
}

TEST(FoundPlaces, theTourOfADungeonPassesItsRooms) {
    const Nameless dungeon(GeneratedKind::Dungeon, 30);
    EXPECT_GE(cellsOn(dungeon.file().tour), 4u);
    expectConnected(dungeon);
}

TEST(FoundPlaces, terrainBeginsOnTheGround) {
    const Nameless terrain(GeneratedKind::Terrain, 6);
    const world::Place& start = startOf(terrain.file());
    expectSensible(Around(*terrain.source, start), start);
    expectConnected(terrain);
}

TEST(FoundPlaces, landWithoutRoomsHasARoundOnTheGround) {
    const Nameless land(GeneratedKind::Complex, 30, 3); // one building on land, without a door
    EXPECT_EQ(startOf(land.file()).cell, 0u);
    EXPECT_EQ(cellsOn(land.file().tour), 0u);
    expectConnected(land);
}

TEST(FoundPlaces, equalFilesGiveEqualPlaces) {
    const Nameless town(GeneratedKind::Town, 4);
    const world::WorldFile again = findPlaces(town.source->archive).value();
    ASSERT_EQ(again.places.size(), town.file().places.size());
    for (std::size_t i = 0; i < again.places.size(); ++i)
        EXPECT_EQ(again.places[i].eye, town.file().places[i].eye);
    EXPECT_EQ(again.tour.size(), town.file().tour.size());
}

TEST(FoundPlaces, theCacheKeepsEveryBitAndADamagedOneIsReplaced) {
    const Nameless town(GeneratedKind::Town, 4);
    const test::TemporaryDirectory cache;
    const auto search = [&] { return findPlacesCached(town.source->archive, cache.path(), 0).value(); };
    const auto expectFound = [&](const world::WorldFile& file) {
        ASSERT_EQ(file.tour.size(), town.file().tour.size());
        for (std::size_t i = 0; i < file.tour.size(); ++i) {
            EXPECT_EQ(file.tour[i].eye, town.file().tour[i].eye);
            EXPECT_EQ(file.tour[i].yaw, town.file().tour[i].yaw);
            EXPECT_EQ(file.tour[i].cell, town.file().tour[i].cell);
        }
        EXPECT_EQ(file.start, town.file().start);
    };
    expectFound(search());
    ASSERT_EQ(std::distance(std::filesystem::directory_iterator(cache / "places"),
                            std::filesystem::directory_iterator()),
              1);
    const std::filesystem::path kept = std::filesystem::directory_iterator(cache / "places")->path();
    std::string text = test::getText(kept);
    text.replace(text.rfind(town.file().start), 4, "camp"); // the cache is read, not searched again
    test::putText(kept, text);
    EXPECT_TRUE(search().start.starts_with("camp"));
    test::putText(kept, text.substr(0, text.size() / 2));
    expectFound(search());
}

TEST(FoundPlaces, aWorldFileWithPlacesAloneGetsATour) {
    const Nameless town(GeneratedKind::Town, 4);
    ASSERT_TRUE(worlds::writeGeneratedWorld({GeneratedKind::Town, 4, 3}, town.directory.path()));
    const WorldSource named = openWorldSource(town.directory.path().string()).value();
    ASSERT_FALSE(named.file.places.empty());
    ASSERT_TRUE(named.file.tour.empty());
    const std::vector<world::Place> tour = tourOf(named).value();
    ASSERT_EQ(tour.size(), town.file().tour.size());
    for (std::size_t i = 0; i < tour.size(); ++i)
        EXPECT_EQ(tour[i].eye, town.file().tour[i].eye);
    EXPECT_GE(tour.size(), 2u);
}

TEST(FoundPlaces, aSearchReportsItsStepsAndCanBeEnded) {
    const Nameless town(GeneratedKind::Town, 4);
    std::vector<std::size_t> steps;
    const auto count = [&](std::size_t done, std::size_t all) {
        EXPECT_LE(done, all);
        steps.push_back(done);
        return done < all; // the last answer ends nothing
    };
    ASSERT_TRUE(findPlaces(town.source->archive, count));
    ASSERT_GE(steps.size(), 3u) << "the spots, a town, the tour";
    for (std::size_t i = 0; i < steps.size(); ++i)
        EXPECT_EQ(steps[i], i + 1);
    const std::size_t whole = steps.size();
    steps.clear();
    const auto end = [&](std::size_t done, std::size_t) {
        steps.push_back(done);
        return false;
    };
    const auto ended = findPlaces(town.source->archive, end);
    ASSERT_FALSE(ended);
    EXPECT_NE(ended.error().message().find("cancelled"), std::string::npos);
    EXPECT_LT(steps.size(), whole);
}

// A world whose records give no tour is searched by openWorldSource alone.
TEST(FoundPlaces, aTourIsSearchedOnce) {
    Nameless town(GeneratedKind::Town, 4);
    std::size_t steps = 0;
    const auto count = [&](std::size_t, std::size_t) { return ++steps > 0; };
    town.source->file.tour.clear();
    EXPECT_TRUE(tourOf(*town.source, count).value().empty());
    EXPECT_EQ(steps, 0u);
    ASSERT_TRUE(worlds::writeGeneratedWorld({GeneratedKind::Town, 4, 3}, town.directory.path()));
    const WorldSource named = openWorldSource(town.directory.path().string()).value();
    EXPECT_FALSE(tourOf(named, count).value().empty());
    EXPECT_GT(steps, 0u) << "world.json has no tour";
}

TEST(FoundPlaces, aPositionSavesTheSearch) {
    const Nameless town(GeneratedKind::Town, 2);
    const WorldSource source = openWorldSource(town.directory.path().string(), PlaceSearch::Skip).value();
    EXPECT_TRUE(source.file.places.empty());
}

TEST(FoundPlaces, namesMatchWithoutCaseSpacesAndHyphens) {
    const Nameless town(GeneratedKind::Town, 4);
    std::string name = startOf(town.file()).name;
    for (char& letter : name)
        letter = letter == ' ' ? '-' : static_cast<char>(std::toupper(letter));
    ViewRequest request;
    request.place = name;
    const Result<ViewRequest> resolved = resolvePlace(request, town.file());
    ASSERT_TRUE(resolved) << resolved.error().message();
    EXPECT_EQ(resolved->eye, startOf(town.file()).eye);
    request.place = "twon" + startOf(town.file()).name.substr(4);
    const Result<ViewRequest> misspelt = resolvePlace(request, town.file());
    ASSERT_FALSE(misspelt);
    EXPECT_NE(misspelt.error().what.find("Did you mean '" + startOf(town.file()).name), std::string::npos)
        << misspelt.error().what;
}

TEST(FoundPlaces, aRememberedPlaceComesFirstIfTheWorldHasIt) {
    const Nameless town(GeneratedKind::Town, 4);
    const world::Place& start = startOf(town.file());
    const RememberedPlace there{start.eye + Vec3(3.0, 0.0, 0.0), 12.0, 3.0, 0};
    EXPECT_EQ(firstView(*town.source, there)->eye, there.eye);
    EXPECT_EQ(firstView(*town.source, RememberedPlace{there.eye, 0.0, 0.0, 0x12340156})->eye, start.eye);
    EXPECT_EQ(firstView(*town.source)->eye, start.eye);
}

TEST(KnownSpots, standInTheLandcellTheyName) {
    for (const KnownSpot& spot : knownSpots()) {
        if (!spot.isOutdoors() || std::string_view(spot.name) == "Khayyaban") // its source disagrees
            continue;
        const int x = static_cast<int>(spot.feet.x / 24.0), y = static_cast<int>(spot.feet.y / 24.0);
        EXPECT_EQ(spot.cell & 0xFFFFu, static_cast<std::uint32_t>(8 * x + y + 1)) << spot.name;
    }
    EXPECT_EQ(knownSpots().size(), 58u);
}

} // namespace
} // namespace limen::engine
