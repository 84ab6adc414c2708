#include "placements/Standing.h"

#include <gmock/gmock.h>
#include <map>

// The objects that stand in a landblock at the start.
namespace limen::placements {
namespace {

using testing::ElementsAre;

struct StandingWorld {
    std::map<std::uint32_t, Template> templates;
    Landblock landblock;

    Template& of(std::uint32_t id) {
        Template& made = templates[id];
        made.id = id;
        made.setup = 0x02000001;
        return made;
    }
    void place(std::uint32_t guid, std::uint32_t id, bool isChild = false, std::uint32_t cell = 0x01010001) {
        landblock.placements.push_back(
            {guid, id, {cell, {10.0f, 20.0f, 3.0f}, {1.0f, 0.0f, 0.0f, 0.0f}}, isChild});
    }
    [[nodiscard]] std::vector<Standing> standing() const {
        return standingIn(landblock, [&](std::uint32_t id) -> const Template* {
            const auto found = templates.find(id);
            return found != templates.end() ? &found->second : nullptr;
        });
    }
    [[nodiscard]] std::vector<std::uint64_t> ids() const {
        std::vector<std::uint64_t> ids;
        for (const Standing& one : standing())
            ids.push_back(one.id);
        return ids;
    }
};

TEST(Standing, visibleObjectsStand) {
    StandingWorld world;
    for (std::uint32_t id = 1; id <= 7; ++id) {
        world.of(id);
        world.place(id, id);
    }
    world.of(2).visibility = true; // invisible
    world.of(3).noDraw = true;
    world.of(4).physicsState = 0x20;
    world.of(5).physicsState = 0x4000;
    world.of(6).setup = 0;
    world.of(7).physicsState = 0x4 | 0x800; // ethereal and lit, but drawn
    world.place(8, 99);                     // a template that does not exist
    EXPECT_THAT(world.ids(), ElementsAre(1, 7));
}

TEST(Standing, aLinkChildStandsIfItsParentDoes) {
    StandingWorld world;
    world.of(1);
    world.of(2).visibility = true;
    world.place(10, 2);       // invisible, but there
    world.place(11, 1, true); // child of 10
    world.place(12, 1, true); // child of 11
    world.place(13, 1, true); // child of nothing
    world.landblock.links = {{10, 11}, {11, 12}};
    EXPECT_THAT(world.ids(), ElementsAre(11, 12));
}

TEST(Standing, linksInARingEnd) {
    StandingWorld world;
    world.of(1);
    world.place(10, 1);
    world.place(11, 1, true);
    world.place(12, 1, true);
    world.landblock.links = {{10, 11}, {11, 12}, {12, 11}};
    EXPECT_THAT(world.ids(), ElementsAre(10, 11, 12));
}

GeneratorEntry entryOf(std::uint32_t id, float probability, std::int32_t init, std::uint32_t where) {
    GeneratorEntry entry;
    entry.templateId = id;
    entry.probability = probability;
    entry.initCreate = init;
    entry.whereCreate = where;
    return entry;
}

TEST(Standing, aGeneratorMakesItsInitialObjects) {
    StandingWorld world;
    world.of(5);
    Template& generator = world.of(1);
    generator.visibility = true;
    generator.initGenerated = 3;
    generator.generatorRadius = 4.0;
    generator.generator = {entryOf(5, 1.0f, 1, 2)};
    world.place(10, 1);
    const std::vector<Standing> made = world.standing();
    ASSERT_EQ(made.size(), 3u);
    for (const Standing& one : made) {
        EXPECT_EQ(one.templateId, 5u);
        EXPECT_EQ(one.id & 0xFFFFFFFF, 10u);
        EXPECT_TRUE(one.isScattered);
        EXPECT_LE(std::hypot(one.spot.origin[0] - 10.0f, one.spot.origin[1] - 20.0f), 4.001f);
    }
    EXPECT_NE(made[0].spot.origin[0], made[1].spot.origin[0]);
    const std::vector<Standing> again = world.standing();
    for (std::size_t i = 0; i < made.size(); ++i)
        EXPECT_TRUE(again[i].spot == made[i].spot) << "chance depends on the guid alone";
}

TEST(Standing, aGeneratorDrawsByProbability) {
    StandingWorld world;
    world.of(5);
    world.of(6);
    Template& generator = world.of(1);
    generator.visibility = true;
    generator.initGenerated = 1;
    generator.generator = {entryOf(5, 0.25f, 1, 1), entryOf(6, 1.0f, 1, 1)};
    for (std::uint32_t guid = 1; guid <= 2000; ++guid)
        world.place(guid, 1);
    const std::vector<Standing> made = world.standing();
    ASSERT_EQ(made.size(), 2000u);
    const auto first =
        std::count_if(made.begin(), made.end(), [](const Standing& one) { return one.templateId == 5; });
    EXPECT_NEAR(static_cast<double>(first), 500.0, 80.0); // four standard deviations
}

TEST(Standing, aGeneratorPutsObjectsWhereItSays) {
    StandingWorld world;
    world.of(5);
    Template& generator = world.of(1);
    generator.visibility = true;
    GeneratorEntry relative = entryOf(5, -1.0f, 1, 4), absolute = relative, inside = entryOf(5, -1.0f, 1, 8),
                   placeHolder = entryOf(3666, -1.0f, 1, 4);
    relative.spot = Spot{0, {1.0f, 2.0f, 3.0f}, {0.0f, 0.0f, 0.0f, 1.0f}};
    absolute.spot = Spot{0x01010105, {7.0f, 8.0f, 9.0f}, {1.0f, 0.0f, 0.0f, 0.0f}};
    absolute.palette = 4;
    absolute.shade = 0.5f;
    generator.generator = {relative, absolute, inside, placeHolder};
    world.of(3666);
    world.place(10, 1);
    const std::vector<Standing> made = world.standing();
    ASSERT_EQ(made.size(), 2u);
    EXPECT_EQ(made[0].spot, (Spot{0x01010001, {11.0f, 22.0f, 6.0f}, {0.0f, 0.0f, 0.0f, 1.0f}}));
    EXPECT_EQ(made[1].spot, *absolute.spot);
    EXPECT_EQ(made[1].palette, 4);
    EXPECT_EQ(made[1].shade, 0.5f);
}

TEST(Standing, aDamagedGeneratorMakesFewObjects) {
    StandingWorld world;
    world.of(5);
    Template& generator = world.of(1);
    generator.initGenerated = 0x7FFFFFFF;
    generator.generator = {entryOf(5, -1.0f, 0x7FFFFFFF, 1), entryOf(5, 1.0f, -5, 1)};
    world.place(10, 1);
    EXPECT_LE(world.standing().size(), 65u);
}

} // namespace
} // namespace limen::placements
