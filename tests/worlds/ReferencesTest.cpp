#include "worlds/BuiltIn.h"

#include "dat/Archive.h"
#include "worlds/Demo.h"
#include "worlds/builtin/land/TerrainShape.h"

#include <fstream>
#include <gtest/gtest.h>
#include <set>
#include <unistd.h>

namespace limen::worlds::test {
namespace {

template <class Records>
std::set<std::uint32_t> idsOf(const Records& records) {
    std::set<std::uint32_t> out;
    for (const auto& record : records)
        EXPECT_TRUE(out.insert(record.id).second) << "an id is used twice";
    return out;
}

class References : public ::testing::Test {
protected:
    References() {
        for (const auto& [id, surface] : world().surfaces)
            surfaces.insert(id);
        models = idsOf(world().gfxObjs);
        for (const std::uint32_t id : idsOf(world().setups))
            models.insert(id);
    }
    std::set<std::uint32_t> surfaces, models;
};

// Two compilers made different worlds, because records were made in the arguments of one call.
TEST_F(References, ofTheSnowyDayAreNumberedInOneOrder) {
    const dat::DayGroup& snowy = world().regions.front().sky.dayGroups.at(1);
    const dat::ParticleEmitter& flakes = world().particleEmitters.front();
    EXPECT_LT(flakes.gfxObj, snowy.objects.at(1).object) << "the snow is made before the cloud";
}

TEST_F(References, ofTexturesResolve) {
    const auto textures = idsOf(world().surfaceTextures);
    const auto images = idsOf(world().renderSurfaces);
    const auto palettes = idsOf(world().palettes);
    for (const auto& [id, surface] : world().surfaces)
        EXPECT_TRUE(!surface.hasImage() || textures.count(surface.texture) == 1);
    for (const dat::SurfaceTexture& texture : world().surfaceTextures)
        for (const std::uint32_t image : texture.images)
            EXPECT_EQ(images.count(image), 1u);
    for (const dat::RenderSurface& image : world().renderSurfaces) {
        const bool indexed =
            image.format == dat::PixelFormat::P8 || image.format == dat::PixelFormat::Index16;
        EXPECT_EQ(palettes.count(image.defaultPalette), indexed ? 1u : 0u);
    }
}

TEST_F(References, ofModelsAndCellsResolve) {
    for (const dat::GfxObj& object : world().gfxObjs)
        for (const std::uint32_t surface : object.surfaces)
            EXPECT_EQ(surfaces.count(surface), 1u);
    for (const dat::Setup& setup : world().setups) {
        for (const std::uint32_t part : setup.parts)
            EXPECT_EQ(models.count(part), 1u);
        EXPECT_EQ(setup.placementFrames.at(0).second.parts.size(), setup.parts.size());
    }
    for (const dat::EnvCell& cell : world().envCells) {
        for (const std::uint16_t surface : cell.surfaces)
            EXPECT_EQ(surfaces.count(0x08000000u | surface), 1u);
        for (const dat::Stab& object : cell.statics)
            EXPECT_EQ(models.count(object.model), 1u);
        for (const std::uint16_t other : cell.visibleCells)
            EXPECT_NE(findCell((cell.id & 0xFFFF0000u) | other), nullptr);
    }
    for (const dat::LandBlockInfo& info : world().landBlockInfos)
        for (const dat::Stab& object : info.objects)
            EXPECT_EQ(models.count(object.model), 1u);
}

TEST_F(References, ofMotionsResolve) {
    const auto animations = idsOf(world().animations);
    const auto tables = idsOf(world().motionTables);
    std::set<std::uint32_t> used, played;
    for (const dat::Setup& setup : world().setups) {
        EXPECT_TRUE(setup.motionTable == 0 || tables.count(setup.motionTable) == 1);
        used.insert(setup.motionTable);
        EXPECT_TRUE(setup.animation == 0 || animations.count(setup.animation) == 1);
        played.insert(setup.animation);
    }
    // Tables that open doors are named by the leaves in world.json, from which the rows of a database are made.
    for (const auto& door : world().worldFile.at("doors")) {
        for (const auto& leaf : door.at("leaves")) {
            const auto id = static_cast<std::uint32_t>(
                std::stoul(leaf.value("motionTable", std::string("0x0")), nullptr, 16));
            EXPECT_TRUE(id == 0 || tables.count(id) == 1) << "a motion table that is not there";
            EXPECT_EQ(id != 0, door.at("opaque").get<bool>()) << "opaque doors have one, panes have none";
            used.insert(id);
        }
    }
    for (const dat::MotionTable& table : world().motionTables) {
        EXPECT_EQ(dat::kindOf(dat::FileRole::Portal, table.id), dat::RecordKind::MotionTable);
        EXPECT_EQ(used.count(table.id), 1u) << "an unused motion table";
        for (const auto& [key, data] : table.cycles) {
            for (const dat::AnimationRange& range : data.animations) {
                EXPECT_EQ(animations.count(range.animation), 1u);
                played.insert(range.animation);
            }
        }
    }
    for (const dat::Animation& animation : world().animations) {
        EXPECT_EQ(dat::kindOf(dat::FileRole::Portal, animation.id), dat::RecordKind::Animation);
        EXPECT_EQ(played.count(animation.id), 1u);
    }
}

TEST_F(References, ofTheRegionResolve) {
    const dat::Region& region = world().regions.at(0);
    const auto scenes = idsOf(world().scenes);
    const auto textures = idsOf(world().surfaceTextures);
    for (const dat::SceneType& type : region.sceneTypes)
        for (const std::uint32_t scene : type.scenes)
            EXPECT_EQ(scenes.count(scene), 1u);
    for (const dat::Scene& scene : world().scenes)
        for (const dat::SceneObject& object : scene.objects)
            EXPECT_EQ(models.count(object.object), 1u);
    for (const dat::TerrainType& type : region.terrainTypes)
        for (const std::uint32_t index : type.sceneTypes)
            EXPECT_LT(index, region.sceneTypes.size());
    for (const auto* maps : {&region.texMerge.corners, &region.texMerge.sides, &region.texMerge.roads}) {
        EXPECT_FALSE(maps->empty());
        for (const dat::AlphaMap& map : *maps)
            EXPECT_EQ(textures.count(map.texture), 1u);
    }
    for (const dat::SkyObject& object : region.sky.dayGroups.at(0).objects)
        EXPECT_EQ(models.count(object.object), 1u);
}

TEST_F(References, ofPolygonsStayInsideTheirMesh) {
    const auto check = [](const dat::VertexArray& array, const dat::PolygonList& polygons,
                          std::size_t surfaceCount) {
        for (const auto& [id, polygon] : polygons) {
            const bool portal = (polygon.stippling & dat::kNoPositiveUv) != 0;
            EXPECT_EQ(polygon.posUv.size(), portal ? 0u : polygon.vertexKeys.size());
            EXPECT_TRUE(portal || static_cast<std::size_t>(polygon.posSurface) < surfaceCount);
            for (std::size_t k = 0; k < polygon.posUv.size(); ++k)
                EXPECT_LT(polygon.posUv[k], array.vertices.at(polygon.vertexKeys[k]).second.uvs.size());
        }
    };
    for (const dat::GfxObj& object : world().gfxObjs)
        check(object.vertexArray, object.polygons, object.surfaces.size());
    for (const dat::EnvCell& cell : world().envCells)
        check(shapeOf(cell).vertexArray, shapeOf(cell).polygons, cell.surfaces.size());
}

TEST(Landscape, neighbouringBlocksAgreeOnTheirSharedEdge) {
    std::map<std::uint32_t, const dat::LandBlock*> blocks;
    for (const dat::LandBlock& block : world().landBlocks)
        blocks[block.id] = &block;
    ASSERT_EQ(blocks.size(), kBlocksAcross * kBlocksAcross + 1u) << "the land, and the sealed dungeon";
    for (const auto& [id, block] : blocks) {
        const auto east = blocks.find(id + 0x01000000u);
        const auto north = blocks.find(id + 0x00010000u);
        for (std::size_t k = 0; k < 9; ++k) {
            if (east != blocks.end()) {
                EXPECT_EQ(block->heights[8 * 9 + k], east->second->heights[k]);
                EXPECT_EQ(block->terrain[8 * 9 + k], east->second->terrain[k]);
            }
            if (north != blocks.end())
                EXPECT_EQ(block->heights[k * 9 + 8], north->second->heights[k * 9]);
        }
    }
}

TEST(Landscape, laneNeverJumps) {
    const auto lane = lanePath();
    for (std::size_t i = 0; i + 1 < lane.size(); ++i) {
        EXPECT_EQ(std::max(std::abs(lane[i + 1].first - lane[i].first),
                           std::abs(lane[i + 1].second - lane[i].second)),
                  1);
    }
}

std::string bytesOf(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// A temporary folder.
class Folder {
public:
    Folder()
        : path_(std::filesystem::temp_directory_path() / ("limen_demo_test_" + std::to_string(::getpid()))) {}
    ~Folder() { std::filesystem::remove_all(path_); }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

template <class Record>
void expectStored(const dat::Archive& archive, const std::vector<Record>& records) {
    for (const Record& record : records) {
        const auto read = archive.load<Record>(record.id);
        ASSERT_TRUE(read.has_value()) << read.error().message();
        EXPECT_EQ(*dat::encode(*read), *dat::encode(record)) << std::hex << record.id;
    }
}

TEST(Files, readBackToTheRecordsThatAreBuiltAnew) {
    const Folder folder;
    ASSERT_TRUE(writeBuiltInWorld(folder.path()).has_value());
    const auto archive = dat::Archive::open(folder.path());
    ASSERT_TRUE(archive.has_value()) << archive.error().message();
    const WorldRecords again = buildBuiltInWorld();
    expectStored(*archive, again.palettes);
    expectStored(*archive, again.surfaceTextures);
    expectStored(*archive, again.renderSurfaces);
    expectStored(*archive, again.gfxObjs);
    expectStored(*archive, again.setups);
    expectStored(*archive, again.animations);
    expectStored(*archive, again.motionTables);
    expectStored(*archive, again.environments);
    expectStored(*archive, again.scenes);
    expectStored(*archive, again.regions);
    expectStored(*archive, again.landBlocks);
    expectStored(*archive, again.landBlockInfos);
    expectStored(*archive, again.envCells);
    for (const auto& [id, surface] : again.surfaces) {
        const auto read = archive->load<dat::Surface>(id);
        ASSERT_TRUE(read.has_value());
        EXPECT_EQ(*dat::encode(*read), *dat::encode(surface));
    }
    EXPECT_EQ(bytesOf(folder.path() / "world.json"), again.worldFile.dump(1) + "\n");
}

TEST(Files, anUnwritableFolderIsAnError) {
    const auto result = writeBuiltInWorld("/proc/nowhere");
    ASSERT_FALSE(result.has_value());
    EXPECT_EQ(result.error().code, ErrorCode::Unreadable);
}

} // namespace
} // namespace limen::worlds::test
