#include "world/records/Clothing.h"

#include "support/MovingHut.h"

#include <gmock/gmock.h>

namespace limen::world {
namespace {

using testing::ElementsAre;

constexpr std::uint32_t kTable = 0x10000001, kSet = 0x0F000001, kBase = 0x04000001, kRed = 0x04000002,
                        kBlue = 0x04000003;

/// Eight colours: the index in red, `kind` in green.
dat::Palette paletteOf(std::uint32_t id, std::uint32_t kind) {
    dat::Palette palette;
    palette.id = id;
    for (std::uint32_t i = 0; i < 8; ++i)
        palette.colours.push_back({0xFF000000u | i << 16 | kind << 8});
    return palette;
}

/// A hut whose villager is a Setup of two cubes with an indexed coat, and a table of clothes for it.
struct Wardrobe {
    test::MovingHut hut;
    std::uint32_t setup = 0, plainCube = 0;
    std::uint32_t coat = 0, shirt = 0; ///< SurfaceTexture ids
    dat::ClothingTable table;

    Wardrobe() {
        for (const auto& [id, kind] : {std::pair{kBase, 1u}, {kRed, 2u}, {kBlue, 3u}})
            hut.source.portalFile().add(paletteOf(id, kind));
        hut.source.portalFile().add(dat::PaletteSet{kSet, {kRed, kBlue}});
        coat = addPicture("coat", dat::PixelFormat::P8, {0, 1, 4, 7});
        shirt = addPicture("shirt", dat::PixelFormat::Index16, {5, 0, 5, 0, 1, 0, 1, 0});
        const std::uint32_t cube = hut.source.addModel(test::boxExterior({0, 0, 0}, {1, 1, 1}, "coat"));
        plainCube = hut.source.addModel(test::boxExterior({-1, -1, 0}, {1, 1, 2}, "wool"));
        dat::Setup both;
        both.parts = {cube, cube};
        setup = hut.source.addSetup(both);
        hut.moving.villagers[0].model = setup;
        table.id = kTable;
    }
    std::uint32_t addPicture(const std::string& name, dat::PixelFormat format,
                             std::vector<std::uint8_t> pixels) {
        dat::RenderSurface image;
        image.width = image.height = 2;
        image.format = format;
        image.pixels = std::move(pixels);
        image.defaultPalette = kBase;
        const std::uint32_t texture = hut.source.nextTexture();
        hut.source.picture(name, image, dat::Surface::kBase1Image);
        return texture;
    }
    World load() {
        hut.source.portalFile().add(table);
        World world = hut.load();
        EXPECT_TRUE(world.findings.empty()) << test::findingsOf(world);
        return world;
    }
};

/// Red and green of the texels on one part of the villager.
std::vector<std::pair<int, int>> texelsOf(const World& world, std::uint32_t part) {
    const Instance& in = world.movingParts[world.villagers.at(0).body.firstPart + part];
    const Material& material = world.materials[world.materialRefs[in.firstMaterial]];
    std::vector<std::pair<int, int>> out;
    const Image& image = *world.textures.at(material.texture);
    for (std::size_t i = 0; i < image.rgba.size(); i += 4)
        out.emplace_back(image.rgba[i], image.rgba[i + 1]);
    return out;
}
using Texels = std::vector<std::pair<int, int>>;

TEST(Clothing, laysColoursOverAPaletteAtTheirPlaces) {
    Wardrobe wardrobe;
    wardrobe.table.palettes.entries = {{5, {0, {{{{1, 1}, {6, 2}}, kSet}}}}};
    wardrobe.hut.moving.villagers[0].clothing = {{kTable, 5, {1.0}}};
    const World world = wardrobe.load();
    EXPECT_EQ(texelsOf(world, 0), (Texels{{0, 1}, {1, 3}, {4, 1}, {7, 3}}))
        << "1, 6 and 7 are from the last palette of the set";
    EXPECT_EQ(texelsOf(world, 1), texelsOf(world, 0));
}

TEST(Clothing, takesTheShadeOfASetOrAPaletteByItself) {
    for (const auto& [palettes, shade, kind] :
         {std::tuple{kSet, 0.0, 2}, {kSet, 0.49, 2}, {kSet, 0.51, 3}, {kBlue, 0.0, 3}}) {
        Wardrobe wardrobe;
        wardrobe.table.palettes.entries = {{5, {0, {{{{0, 8}}, palettes}}}}};
        wardrobe.hut.moving.villagers[0].clothing = {{kTable, 5, {shade}}};
        EXPECT_EQ(texelsOf(wardrobe.load(), 0), (Texels{{0, kind}, {1, kind}, {4, kind}, {7, kind}}));
    }
}

TEST(Clothing, hasNoColoursForShadesOutside0To1) {
    for (const double shade : {-0.01, 1.01}) {
        Wardrobe wardrobe;
        wardrobe.table.palettes.entries = {{5, {0, {{{{0, 8}}, kSet}}}}};
        wardrobe.hut.moving.villagers[0].clothing = {{kTable, 5, {shade}}};
        EXPECT_EQ(texelsOf(wardrobe.load(), 0), (Texels{{0, 1}, {1, 1}, {4, 1}, {7, 1}})) << shade;
    }
}

TEST(Clothing, hasAShadeForEachColourChange_theLastForLaterOnes) {
    Wardrobe wardrobe; // texels 0, 1, 4 and 7
    wardrobe.table.palettes.entries = {
        {5, {0, {{{{0, 1}}, kSet}, {{{1, 1}}, kSet}, {{{2, 1}}, kSet}, {{{4, 1}}, kSet}, {{{7, 1}}, kSet}}}}};
    wardrobe.hut.moving.villagers[0].clothing = {{kTable, 5, {0.0, 1.0, 0.0, 1.0}}};
    EXPECT_EQ(texelsOf(wardrobe.load(), 0), (Texels{{0, 2}, {1, 3}, {4, 3}, {7, 3}}));
}

TEST(Clothing, changesTexturesOfOnePartOnly) {
    Wardrobe wardrobe;
    wardrobe.table.parts.entries = {{wardrobe.setup, {{1, 0, {{wardrobe.coat, wardrobe.shirt}}}}}};
    wardrobe.table.palettes.entries = {{5, {0, {{{{5, 1}}, kRed}}}}};
    wardrobe.hut.moving.villagers[0].clothing = {{kTable, 5, {0.0}}};
    const World world = wardrobe.load();
    EXPECT_EQ(texelsOf(world, 0), (Texels{{0, 1}, {1, 1}, {4, 1}, {7, 1}}));
    EXPECT_EQ(texelsOf(world, 1), (Texels{{5, 2}, {5, 2}, {1, 1}, {1, 1}}));
}

TEST(Clothing, ofATableWithoutTheSetupChangesColoursAlone) {
    Wardrobe wardrobe;
    wardrobe.table.parts.entries = {
        {0x02000999, {{0, wardrobe.plainCube, {{wardrobe.coat, wardrobe.shirt}}}}}};
    wardrobe.table.palettes.entries = {{5, {0, {{{{0, 8}}, kRed}}}}};
    wardrobe.hut.moving.villagers[0].clothing = {{kTable, 5, {0.0}}};
    const World world = wardrobe.load();
    for (const std::uint32_t part : {0u, 1u})
        EXPECT_EQ(texelsOf(world, part), (Texels{{0, 2}, {1, 2}, {4, 2}, {7, 2}}));
}

TEST(Clothing, changesMeshesOfParts) {
    Wardrobe wardrobe;
    wardrobe.table.parts.entries = {{wardrobe.setup, {{0, wardrobe.plainCube, {}}}},
                                    {0x02000999, {{1, wardrobe.plainCube, {}}}}};
    wardrobe.hut.moving.villagers[0].clothing = {{kTable, 0, {0.0}}};
    const World world = wardrobe.load();
    const MovingBody& body = world.villagers.at(0).body;
    ASSERT_EQ(body.partCount, 2u);
    EXPECT_EQ(world.movingParts[body.firstPart].record, wardrobe.plainCube);
    EXPECT_NE(world.movingParts[body.firstPart + 1].record, wardrobe.plainCube);
    EXPECT_GE(body.bounds.radius, 1.7) << "the sphere contains the clothes";
}

TEST(Clothing, hasOneBasePaletteForAllIndexedPicturesOfABody) {
    Wardrobe wardrobe;
    wardrobe.table.parts.entries = {{wardrobe.setup, {{1, 0, {{wardrobe.coat, wardrobe.shirt}}}}}};
    wardrobe.table.palettes.entries = {{5, {0, {{{{1, 1}}, kRed}}}}};
    wardrobe.hut.moving.villagers[0].clothing = {{kTable, 5, {0.0}}};
    wardrobe.hut.moving.villagers[0].basePalette = kBlue;
    const World world = wardrobe.load();
    EXPECT_EQ(texelsOf(world, 0), (Texels{{0, 3}, {1, 2}, {4, 3}, {7, 3}}));
    EXPECT_EQ(texelsOf(world, 1), (Texels{{5, 3}, {5, 3}, {1, 2}, {1, 2}})) << "INDEX16 as well";
}

/// Part 0 in two garments, each a swap with texture changes.
Dress dressInTwo(const std::vector<dat::PartChange>& first, const std::vector<dat::PartChange>& second) {
    Wardrobe wardrobe;
    dat::ClothingTable under = wardrobe.table, over = wardrobe.table;
    over.id = kTable + 1;
    under.parts.entries = {{wardrobe.setup, first}};
    over.parts.entries = {{wardrobe.setup, second}};
    wardrobe.hut.source.portalFile().add(under);
    wardrobe.hut.source.portalFile().add(over);
    const test::TempDir directory;
    EXPECT_TRUE(wardrobe.hut.source.write(directory.path()));
    const Result<dat::Archive> archive = dat::Archive::open(directory.path());
    Records records(*archive);
    const std::vector<ClothingEntry> garments{{kTable, 0, {0.0}}, {kTable + 1, 0, {0.0}}};
    return dressOf(wardrobe.setup, {garments, 0}, records);
}

TEST(Clothing, swapsAllPartsBeforeItChangesTextures) {
    const Wardrobe same;
    const std::uint32_t cube = same.plainCube;
    const Dress dress =
        dressInTwo({{0, 0, {{same.coat, same.shirt}}}}, {{0, cube, {{same.shirt, same.coat}}}});
    const DressedPart* part = dress.part(0);
    ASSERT_NE(part, nullptr);
    EXPECT_EQ(part->gfxObj, cube);
    ASSERT_EQ(part->textures.size(), 2u) << "the earlier garment's change acts on the later mesh, too";
    EXPECT_EQ(part->textures[0].to, same.shirt);
}

TEST(Clothing, aSwapToAMissingMeshKeepsTheLimb) {
    const std::uint32_t cube = Wardrobe().plainCube;
    EXPECT_EQ(dressInTwo({{0, cube, {}}}, {{0, 0x0100FFFF, {}}}).part(0)->gfxObj, cube);
}

TEST(Clothing, isSharedByEqualVillagersAndDoesNotAffectOthers) {
    Wardrobe wardrobe;
    wardrobe.table.palettes.entries = {{5, {0, {{{{0, 8}}, kRed}}}}};
    auto& villagers = wardrobe.hut.moving.villagers;
    villagers.push_back(villagers[0]);
    villagers.push_back(villagers[0]);
    villagers[0].clothing = villagers[1].clothing = {{kTable, 5, {0.0}}};
    const World world = wardrobe.load();
    const auto materialOf = [&](std::size_t who) {
        return world.materialRefs[world.movingParts[world.villagers.at(who).body.firstPart].firstMaterial];
    };
    EXPECT_EQ(materialOf(0), materialOf(1));
    EXPECT_NE(materialOf(0), materialOf(2));
    EXPECT_EQ(texelsOf(world, 0).front().second, 2);
    const Material& plain = world.materials[materialOf(2)];
    EXPECT_EQ(world.textures[plain.texture]->rgba[1], 1);
}

TEST(Clothing, isWornByThePlayerSolidAndFaded) {
    Wardrobe wardrobe;
    wardrobe.table.palettes.entries = {{5, {0, {{{{0, 8}}, kRed}}}}};
    wardrobe.hut.moving.player = wardrobe.setup;
    wardrobe.hut.moving.playerClothing = {{kTable, 5, {0.0}}};
    const World world = wardrobe.load();
    for (const MovingBody* body : {&world.player.solid, &world.player.ghost}) {
        const Material& material =
            world.materials[world.materialRefs[world.movingParts[body->firstPart].firstMaterial]];
        EXPECT_EQ(world.textures[material.texture]->rgba[1], 2);
    }
}

TEST(Clothing, thatDoesNotExistIsReported) {
    Wardrobe wardrobe;
    wardrobe.hut.source.portalFile().add(wardrobe.table);
    wardrobe.hut.moving.villagers[0].clothing = {{kTable, 6, {0.0}}, {0x10000099, 0, {0.0}}};
    const World world = wardrobe.hut.load();
    EXPECT_THAT(test::findingsOf(world), testing::HasSubstr("no palette template 6"));
    EXPECT_EQ(world.findings.size(), 2u);
    EXPECT_EQ(texelsOf(world, 0), (Texels{{0, 1}, {1, 1}, {4, 1}, {7, 1}}));
}

TEST(ShadeIndex, spreadsShadesEvenly) {
    EXPECT_EQ(shadeIndex(4, 0.0), 0u);
    EXPECT_EQ(shadeIndex(4, 0.2499), 0u);
    EXPECT_EQ(shadeIndex(4, 0.2501), 1u);
    EXPECT_EQ(shadeIndex(4, 1.0), 3u);
    EXPECT_EQ(shadeIndex(1, 1.0), 0u);
    EXPECT_EQ(shadeIndex(4, -3.0), 0u);
    EXPECT_EQ(shadeIndex(4, 7.0), 3u);
    EXPECT_EQ(shadeIndex(4, std::numeric_limits<double>::quiet_NaN()), 0u);
}

TEST(WithOverlays, keepsWithinBothPalettes) {
    test::TestWorld source;
    source.setFlatTerrain(source.home(), 1);
    dat::Palette small = paletteOf(kRed, 2);
    small.colours.resize(3);
    source.portalFile().add(small);
    const test::TempDir directory;
    ASSERT_TRUE(source.write(directory.path()));
    const Result<dat::Archive> archive = dat::Archive::open(directory.path());
    Records records(*archive);
    const PaletteOverlay overlays[] = {{kRed, 2, 0xFFFFFFFFu}, {kRed, 100, 3}};
    const dat::Palette out = withOverlays(paletteOf(kBase, 1), overlays, records);
    std::vector<std::uint32_t> kinds;
    for (const dat::Colour& colour : out.colours)
        kinds.push_back(colour.argb >> 8 & 255u);
    EXPECT_THAT(kinds, ElementsAre(1, 1, 2, 1, 1, 1, 1, 1));
}

} // namespace
} // namespace limen::world
