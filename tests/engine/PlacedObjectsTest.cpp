#include "engine/placed/PlacedObjects.h"
#include "engine/placed/RowsOfWorldFile.h"

#include "support/TemporaryDirectory.h"

#include <gmock/gmock.h>

// Rows of a world database as entries for the loader, and entries of world.json as rows.
namespace limen::engine {
namespace {

using placements::Template;

world::PlacedEntry entryOf(const Template& of, const placements::Standing& standing,
                           const std::map<std::uint32_t, Template>& others = {}) {
    return placedEntry(standing, of, [&](std::uint32_t id) -> const Template* {
        const auto found = others.find(id);
        return found != others.end() ? &found->second : nullptr;
    });
}

placements::Standing standingAt(std::uint32_t cell) {
    placements::Standing standing;
    standing.id = 0x7A9B4001;
    standing.templateId = 5;
    standing.spot = {cell, {10.0f, 20.0f, 30.0f}, {0.5f, 0.0f, 0.0f, -0.5f}};
    return standing;
}

TEST(PlacedEntry, hasPlaceTurnAndName) {
    Template of;
    of.name = "Gate";
    of.setup = 0x02000001;
    of.type = 19;
    of.scale = 1.5;
    of.translucency = 0.25;
    of.defaultOpen = true;
    const world::PlacedEntry entry = entryOf(of, standingAt(0xA9B40105));
    EXPECT_EQ(entry.kind, world::PlacedEntry::Kind::Door);
    EXPECT_EQ(entry.name, "Gate 7A9B4001");
    EXPECT_EQ(entry.cell, 0xA9B40105u);
    EXPECT_EQ(entry.position, Vec3(0xA9 * 192.0 + 10, 0xB4 * 192.0 + 20, 30));
    EXPECT_NEAR(glm::length(entry.orientation), 1.0, 1e-12) << "normalised";
    EXPECT_EQ(entry.scale, 1.5);
    EXPECT_EQ(entry.opacity, 0.75);
    EXPECT_TRUE(entry.isOpen);
    EXPECT_TRUE(entry.stopsBodies);
    EXPECT_EQ(entryOf(of, standingAt(0xA9B40032)).cell, 0u) << "a landcell is outdoors";
    EXPECT_EQ(entryOf(of, standingAt(0xA9B40000)).cell, 0u);
}

TEST(PlacedEntry, hasSensibleValuesForDamagedRows) {
    Template of;
    of.scale = -3.0;
    of.translucency = 7.0;
    placements::Standing standing = standingAt(0x01010101);
    standing.spot.angles = {0.0f, 0.0f, 0.0f, 0.0f};
    const world::PlacedEntry entry = entryOf(of, standing);
    EXPECT_EQ(entry.scale, 1.0);
    EXPECT_EQ(entry.opacity, 0.0);
    EXPECT_EQ(entry.orientation, Quat(1.0, 0.0, 0.0, 0.0));
    of.name = "a\x1B[31m\nb\xFF";
    EXPECT_EQ(entryOf(of, standing).name, "a [31m b\uFFFD 7A9B4001") << "findings print it on the terminal";
}

TEST(PlacedEntry, wearsItsClothesInOrder) {
    Template of;
    of.type = 10;
    of.clothingBase = 0x10000001;
    of.paletteTemplate = 3;
    of.shade = 0.5;
    of.paletteBase = 0x04000001;
    of.items = {{2, 11, 7, 0.25f}, {1, 12, 7, 0.25f}, {2, 13, 0, 0.75f}, {2, 99, 0, 0.0f}};
    std::map<std::uint32_t, Template> others;
    for (const std::uint32_t id : {11u, 12u, 13u}) {
        others[id].clothingBase = 0x10000000 + id;
        others[id].paletteTemplate = 4;
    }
    world::PlacedEntry entry = entryOf(of, standingAt(0x01010101), others);
    ASSERT_EQ(entry.clothing.size(), 3u) << "an item in a pack is not worn";
    EXPECT_EQ(entry.clothing[0].table, 0x10000001u);
    EXPECT_EQ(entry.clothing[0].palette, 3u);
    EXPECT_EQ(entry.clothing[0].shades, std::vector{0.5});
    EXPECT_EQ(entry.clothing[1].table, 0x1000000Bu);
    EXPECT_EQ(entry.clothing[1].palette, 7u);
    EXPECT_EQ(entry.clothing[2].table, 0x1000000Du);
    EXPECT_EQ(entry.clothing[2].palette, 4u) << "that of the item's template";
    EXPECT_EQ(entry.clothing[2].shades, std::vector{0.75});
    EXPECT_EQ(entry.basePalette, 0x04000001u);
    placements::Standing made = standingAt(0x01010101);
    made.palette = 9;
    made.shade = 1.0f;
    entry = entryOf(of, made, others);
    EXPECT_EQ(entry.clothing[0].palette, 9u) << "that of the generator";
    EXPECT_EQ(entry.clothing[0].shades, std::vector{1.0});
}

TEST(PlacedEntry, holdsItsWeapon) {
    Template of;
    of.type = 10;
    of.items = {{2, 11, 7, 0.25f}};
    std::map<std::uint32_t, Template> others;
    Template& axe = others[11];
    axe.setup = 0x02000011;
    axe.validLocations = 0x100000;
    axe.clothingBase = 0x10000011;
    axe.paletteBase = 0x04000011;
    axe.scale = 1.5;
    axe.textures = {{0, 0x05000001, 0x05000002}};
    const world::PlacedEntry entry = entryOf(of, standingAt(0x01010101), others);
    EXPECT_TRUE(entry.clothing.empty()) << "an axe is no garment";
    ASSERT_EQ(entry.held.size(), 1u);
    const world::HeldEntry& held = entry.held[0];
    EXPECT_EQ(held.model, 0x02000011u);
    EXPECT_EQ(held.location, 1u);
    EXPECT_EQ(held.placement, 1u);
    EXPECT_EQ(held.scale, 1.5);
    EXPECT_EQ(held.basePalette, 0x04000011u);
    ASSERT_EQ(held.clothing.size(), 1u);
    EXPECT_EQ(held.clothing[0].palette, 7u);
    EXPECT_EQ(held.clothing[0].shades, std::vector{0.25});
    EXPECT_EQ(held.look.textures.at(0).to, 0x05000002u);
}

TEST(PlacedEntry, hasTheFaceThatItsTemplateStates) {
    Template of;
    of.skinPalette = 0x04000001;
    of.hairPalette = 0x04000002;
    of.eyesPalette = 0x04000003;
    of.plainNoseTexture = 0x05000001;
    of.noseTexture = 0x05000002;
    of.mouthTexture = 0x05000003; // of a plain one that is not stated
    of.headObject = 0x01000009;
    const world::LookEntry face = entryOf(of, standingAt(0x01010101)).beneath;
    std::vector<std::array<std::uint32_t, 3>> colours;
    for (const auto& each : face.colours)
        colours.push_back({each.palette, each.offset, each.count});
    EXPECT_EQ(colours, (std::vector<std::array<std::uint32_t, 3>>{
                           {0x04000001, 0, 192}, {0x04000002, 192, 64}, {0x04000003, 256, 64}}));
    ASSERT_EQ(face.textures.size(), 1u);
    EXPECT_EQ(face.textures[0].part, 16u);
    EXPECT_EQ(face.textures[0].to, 0x05000002u);
    ASSERT_EQ(face.parts.size(), 1u);
    EXPECT_EQ(face.parts[0].gfxObj, 0x01000009u);
}

TEST(PlacedEntry, opensIfItIsWithoutLife_andMayBeLocked) {
    Template of;
    for (const std::int32_t type : {1, 20, 21, 24, 26}) {
        of.type = type;
        EXPECT_TRUE(entryOf(of, standingAt(0x01010101)).mayOpen) << type;
    }
    for (const std::int32_t type : {7, 10, 12, 19, 25}) {
        of.type = type;
        EXPECT_FALSE(entryOf(of, standingAt(0x01010101)).mayOpen) << type;
    }
    EXPECT_FALSE(entryOf(of, standingAt(0x01010101)).isLocked);
    of.defaultLocked = true;
    EXPECT_TRUE(entryOf(of, standingAt(0x01010101)).isLocked);
    of.locked = false;
    EXPECT_FALSE(entryOf(of, standingAt(0x01010101)).isLocked) << "the state wins over the default";
}

TEST(PlacedEntry, hasItsEffects) {
    Template of;
    of.physicsEffects = 0x34000007;
    of.physicsScript = 12;
    world::PlacedEntry entry = entryOf(of, standingAt(0x01010101));
    EXPECT_EQ(entry.scriptTable, 0x34000007u);
    EXPECT_EQ(entry.play.kind, 12u);
    EXPECT_EQ(entry.play.intensity, 1.0);
    of.scriptIntensity = 0.25;
    entry = entryOf(of, standingAt(0x01010101));
    EXPECT_EQ(entry.play.intensity, 0.25);
}

TEST(PlacedEntry, changesItsLook) {
    Template of;
    of.palettes = {{0x04000009, 3, 2}, {0x0400000A, 0, 0}};
    of.textures = {{1, 0x05000001, 0x05000002}};
    of.parts = {{4, 0x01000005}};
    const world::LookEntry look = entryOf(of, standingAt(0x01010101)).look;
    ASSERT_EQ(look.colours.size(), 2u);
    EXPECT_EQ(look.colours[0].offset, 24u);
    EXPECT_EQ(look.colours[0].count, 16u);
    EXPECT_EQ(look.colours[1].count, 2048u) << "the whole palette";
    ASSERT_EQ(look.textures.size(), 1u);
    EXPECT_EQ(look.textures[0].to, 0x05000002u);
    ASSERT_EQ(look.parts.size(), 1u);
    EXPECT_EQ(look.parts[0].gfxObj, 0x01000005u);
}

TEST(PlacedEntry, ofATravelPortalLeadsSomewhere) {
    Template of;
    of.type = 7;
    of.destination =
        placements::Spot{0x01250126, {30.0f, -60.0f, 6.0f}, {0.70710678f, 0.0f, 0.0f, -0.70710678f}};
    const world::PlacedEntry entry = entryOf(of, standingAt(0x01010001));
    ASSERT_TRUE(entry.travel);
    EXPECT_EQ(entry.travel->cell, 0x01250126u);
    EXPECT_EQ(entry.travel->feet, Vec3(0x01 * 192.0 + 30, 0x25 * 192.0 - 60, 6));
    EXPECT_NEAR(entry.travel->yaw, 90.0, 1e-4) << "a quarter turn to the east";
    EXPECT_FALSE(entry.stopsBodies);
    of.type = 19;
    EXPECT_FALSE(entryOf(of, standingAt(0x01010001)).travel);
}

TEST(PlacedEntry, isPassableIfItIsEthereal) {
    Template of;
    of.physicsState = 0x4;
    EXPECT_FALSE(entryOf(of, standingAt(0x01010001)).stopsBodies);
    of.physicsState = 0;
    of.ethereal = true;
    EXPECT_FALSE(entryOf(of, standingAt(0x01010001)).stopsBodies);
}

/// A world.db of three smiths, one of them hidden, a portal, and an object without a template.
class PlacedSearch : public ::testing::Test {
protected:
    void SetUp() override {
        placements::Content content;
        content.templates[1] = of(1, "Smith", 10);
        content.templates[2] = of(2, "Hidden Blacksmith", 10);
        content.templates[2].visibility = true; // the property says that it is invisible
        content.templates[3] = of(3, "Gateway", 7);
        add(content, 1, 0xA9B40001, 10.0f);
        add(content, 1, 0xA9B40105, 100.0f);
        add(content, 2, 0xA9B40001, 20.0f);
        add(content, 3, 0xAAB40002, 5.0f);
        add(content, 99, 0xA9B40001, 30.0f);
        const auto path = directory_ / placements::kWorldDbName;
        ASSERT_TRUE(placements::writeWorldDb(path, content, {"the test", ""}));
        Result<placements::WorldDb> database = placements::WorldDb::open(path);
        ASSERT_TRUE(database);
        placed_.emplace(std::move(*database));
    }
    [[nodiscard]] const PlacedObjects& placed() const { return *placed_; }

    static constexpr std::uint32_t kFirstGuid = 0x70000000;

private:
    static Template of(std::uint32_t id, const std::string& name, std::int32_t type) {
        Template made;
        made.id = id;
        made.name = name;
        made.type = type;
        made.setup = 0x02000001;
        return made;
    }
    void add(placements::Content& content, std::uint32_t of, std::uint32_t cell, float x) {
        content.landblocks[cell >> 16].placements.push_back(
            {kFirstGuid + count_++, of, {cell, {x, 20.0f, 30.0f}, {1.0f, 0.0f, 0.0f, 0.0f}}, false});
    }

    test::TemporaryDirectory directory_;
    std::optional<PlacedObjects> placed_;
    std::uint32_t count_ = 0;
};

TEST_F(PlacedSearch, findsVisibleObjectsTheNearestFirst) {
    const Vec3 from(0xA9 * 192.0 + 90.0, 0xB4 * 192.0 + 20.0, 0.0);
    const Result<std::vector<FoundObject>> found = placed().search("SMITH", from, 10);
    ASSERT_TRUE(found);
    ASSERT_EQ(found->size(), 2u) << "the hidden one is not found";
    EXPECT_EQ((*found)[0], (FoundObject{kFirstGuid + 1, "Smith", "creature",
                                        Vec3(0xA9 * 192.0 + 100.0, 0xB4 * 192.0 + 20.0, 30.0), 0xA9B40105}));
    EXPECT_EQ((*found)[1].guid, kFirstGuid);
    EXPECT_EQ((*found)[1].cell, 0u) << "outdoors";
    EXPECT_EQ(placed().search("smith", from, 1)->size(), 1u);
    EXPECT_TRUE(placed().search("", from, 10)->empty());
    EXPECT_TRUE(placed().search("nobody", from, 10)->empty());
}

TEST_F(PlacedSearch, yieldsAViewOfAnObjectByItsGuid) {
    const Result<std::optional<world::Place>> view = placed().viewOf(kFirstGuid + 1);
    ASSERT_TRUE(view && *view);
    EXPECT_EQ((*view)->cell, 0xA9B40105u);
    EXPECT_NEAR(glm::distance(Vec2((*view)->eye), Vec2(0xA9 * 192.0 + 100.0, 0xB4 * 192.0 + 20.0)), 1.5,
                1e-6);
    EXPECT_EQ(nameWithoutGuid((*view)->name), "Smith");
    EXPECT_EQ(*placed().viewOf(kFirstGuid + 2), std::nullopt) << "hidden";
    EXPECT_EQ(*placed().viewOf(kFirstGuid + 4), std::nullopt) << "without a template";
    EXPECT_EQ(*placed().viewOf(std::uint32_t{1}), std::nullopt);
}

TEST_F(PlacedSearch, yieldsThePositionOfANamedObject) {
    const Vec3 first(0xA9 * 192.0 + 10.0, 0xB4 * 192.0 + 20.0, 30.0);
    EXPECT_EQ(*placed().positionOf("smith"), first) << "the least guid";
    EXPECT_EQ((*placed().positionOf("Smith 70000001"))->x, 0xA9 * 192.0 + 100.0);
    EXPECT_EQ(*placed().positionOf("hidden blacksmith"), std::nullopt);
    EXPECT_EQ(*placed().positionOf("nobody"), std::nullopt);
}

TEST_F(PlacedSearch, yieldsThePositionsOfAType) {
    const Result<std::vector<Vec3>> portals = placed().positionsOf(placements::TemplateType::Portal);
    ASSERT_TRUE(portals);
    EXPECT_EQ(*portals, std::vector{Vec3(0xAA * 192.0 + 5.0, 0xB4 * 192.0 + 20.0, 30.0)});
    EXPECT_TRUE(placed().positionsOf(placements::TemplateType::Chest)->empty());
    int calls = 0;
    const auto once = [&] { return ++calls < 1; };
    EXPECT_EQ(placed().positionsOf(placements::TemplateType::Creature, once)->size(), 1u) << "it was stopped";
}

TEST(RowsOfWorldFile, doorsAndPeopleComeBackAsEntries) {
    world::WorldFile file;
    world::DoorEntry door;
    door.name = "gate";
    door.cell = 0xA9B40105;
    const Vec3 hinge(0xA9 * 192.0 + 7, 0xB4 * 192.0 + 8, 9);
    door.leaves = {{0x02000001, hinge, 90.0, -95.0, 0x09000001},
                   {0x02000001, hinge, 270.0, 95.0, 0x09000002}};
    file.moving.doors = {door, door};
    file.moving.doors[1].leaves[0].motionTable = 0; // no rows for it
    world::RouteEntry route;
    route.name = "lane";
    route.points = {{hinge, 0}, {hinge + Vec3(10, 0, 0), 0xA9B40106}};
    file.moving.routes = {route};
    world::VillagerEntry person;
    person.name = "anna";
    person.route = "lane";
    person.model = 0x02000002;
    person.start = 4.0;
    person.clothing = {{0x10000001, 3, {0.5}}, {0x10000002, 0, {0.25}}};
    person.basePalette = 0x04000001;
    file.moving.villagers = {person};
    file.moving.emitters.resize(2);
    const WorldFileRows rows = rowsOf(file);
    EXPECT_EQ(rows.doors, 1u);
    EXPECT_EQ(rows.people, 1u);
    EXPECT_EQ(rows.left, 3u);
    const placements::FindTemplate find = [&](std::uint32_t id) -> const Template* {
        const auto found = rows.content.templates.find(id);
        return found != rows.content.templates.end() ? &found->second : nullptr;
    };
    const auto standing = standingIn(rows.content.landblocks.at(0xA9B4), find);
    ASSERT_EQ(standing.size(), 3u);
    const world::PlacedEntry leaf = placedEntry(standing[0], *find(standing[0].templateId), find);
    EXPECT_EQ(leaf.kind, world::PlacedEntry::Kind::Door);
    EXPECT_EQ(leaf.motionTable, 0x09000001u);
    EXPECT_NEAR(glm::length(leaf.position - hinge), 0.0, 1e-4);
    EXPECT_NEAR(glm::length(leaf.orientation * Vec3(0, 1, 0) - Vec3(1, 0, 0)), 0.0, 1e-6) << "+y to the east";
    const world::PlacedEntry anna = placedEntry(standing[2], *find(standing[2].templateId), find);
    EXPECT_NEAR(glm::length(anna.position - (hinge + Vec3(4, 0, 0))), 0.0, 1e-4);
    EXPECT_EQ(anna.cell, 0u) << "that of the leg's first point";
    ASSERT_EQ(anna.clothing.size(), 2u);
    EXPECT_EQ(anna.clothing[0].table, 0x10000001u);
    EXPECT_EQ(anna.clothing[0].palette, 3u);
    EXPECT_EQ(anna.clothing[0].shades, std::vector{0.5});
    EXPECT_EQ(anna.basePalette, 0x04000001u);
}

} // namespace
} // namespace limen::engine
