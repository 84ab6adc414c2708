#include "worlds/BuiltIn.h"

#include "worlds/builtin/land/PlantMeshes.h"
#include "worlds/builtin/land/Plants.h"
#include "worlds/records/Materials.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace limen::worlds::test {
namespace {

const Vec4f kRed(1.0f, 0.0f, 0.0f, 1.0f), kGreen(0.0f, 1.0f, 0.0f, 1.0f);

/// Bark is red, all else green.
Canvas redBark(Material material) {
    return Canvas(8, 8, material == Material::Bark ? kRed : kGreen);
}

/// The texel of a field, in shares from its upper left corner.
Vec4f texelOf(const Canvas& picture, int column, int row, double x, double y) {
    const int field = picture.width() / PlantPictures::kColumns;
    return picture.at(column * field + static_cast<int>(x * field),
                      row * field + static_cast<int>(y * field));
}

TEST(PlantPictures, showTheNearestSurfaceWhereItsCardIs) {
    FaceMesh
        mesh; // a green wall 4 m wide and 2 m high, and a red one before its right half, seen from the south
    mesh.polygon({{-2, 1, 0}, {2, 1, 0}, {2, 1, 2}, {-2, 1, 2}}, Material::Oak);
    mesh.polygon({{0, -1, 0}, {2, -1, 0}, {2, -1, 2}, {0, -1, 2}}, Material::Bark);
    PlantPictures pictures(redBark, 64);
    const PlantPictures::Card card = pictures.draw(mesh, 0.0, 1, 2);
    const PlantPictures::Card fromEast = pictures.draw(mesh, std::acos(-1.0) / 2.0, 2, 2);
    const Canvas picture = pictures.take();
    EXPECT_EQ(texelOf(picture, 1, 2, 0.25, 0.5), kGreen);
    EXPECT_EQ(texelOf(picture, 1, 2, 0.75, 0.5), kRed);
    EXPECT_LT(texelOf(picture, 1, 2, 0.5, 0.0).w, 0.5f) << "the border is empty";
    EXPECT_LT(texelOf(picture, 0, 2, 0.5, 0.5).w, 0.5f) << "so is another field";
    EXPECT_NEAR(card.facing.y, -1.0, 1e-12);
    EXPECT_NEAR(card.halfWidth, 2.0, 0.2);
    EXPECT_NEAR(fromEast.facing.x, 1.0, 1e-12);
    EXPECT_NEAR(fromEast.halfWidth, 1.0, 0.1) << "both walls on edge";
    const Face face = faceOf(card);
    EXPECT_GT(glm::dot(faceNormal(face), card.facing), 0.999);
    EXPECT_NEAR(face.points[0].x, -2.0, 0.2);
    EXPECT_EQ(face.uvs[0], Vec2(0.25, 0.75));
    EXPECT_EQ(face.uvs[2], Vec2(0.5, 0.5));
}

TEST(PlantPictures, aCoverOfAThirdCounts_alsoInCoarserMipLevels) {
    FaceMesh mesh; // 16 bars with gaps as wide
    for (int bar = 0; bar < 16; ++bar)
        mesh.polygon({{bar, 0, 0}, {bar + 0.5, 0, 0}, {bar + 0.5, 0, 16}, {bar, 0, 16}}, Material::Bark);
    PlantPictures pictures(redBark, 64);
    (void)pictures.draw(mesh, 0.0, 0, 0);
    const Canvas picture = pictures.take();
    float sum = 0.0f;
    constexpr int kFirst = 16, kEnd = 48;
    for (int x = kFirst; x < kEnd; ++x)
        sum += picture.at(x, 32).w;
    EXPECT_GT(sum / (kEnd - kFirst), 0.5f) << "half of it is covered";
    EXPECT_LT(picture.at(1, 1).w, 0.5f);
}

const dat::GfxObj& meshOf(dat::RecordId id) {
    const auto& all = world().gfxObjs;
    return *std::find_if(all.begin(), all.end(), [id](const dat::GfxObj& g) { return g.id == id; });
}

double heightOf(const dat::GfxObj& mesh) {
    double most = 0.0;
    for (const auto& [key, vertex] : mesh.vertexArray.vertices)
        most = std::max(most, static_cast<double>(vertex.position.z));
    return most;
}

// docs/formats/geometry.md#levels-of-detail
TEST(Plants, haveLevelsOfDetailAsTheFormatStoresThem) {
    std::size_t endlessly = 0;
    for (const dat::DegradeInfo& info : world().degradeInfos) {
        if (info.levels.size() < 2)
            continue; // sprites
        SCOPED_TRACE(info.id);
        float from = 0.0f;
        std::size_t polygons = std::numeric_limits<std::size_t>::max();
        const double height = heightOf(meshOf(info.levels.front().gfxObj));
        for (const dat::DegradeLevel& level : info.levels) {
            const bool isLast = &level == &info.levels.back();
            EXPECT_EQ(level.mode, 1u);
            EXPECT_EQ(level.minDistance, from);
            EXPECT_GE(level.idealDistance, level.minDistance);
            EXPECT_EQ(level.maxDistance == std::numeric_limits<float>::max(), isLast);
            from = level.maxDistance;
            if (level.gfxObj == 0) {
                EXPECT_TRUE(isLast);
                continue;
            }
            const dat::GfxObj& mesh = meshOf(level.gfxObj);
            EXPECT_LT(mesh.polygons.size(), polygons);
            polygons = mesh.polygons.size();
            EXPECT_NEAR(heightOf(mesh), height, 0.25 * height + 0.05) << "the change is not seen";
            EXPECT_EQ((mesh.flags & dat::GfxObj::kPhysics) != 0 && &level != &info.levels.front(), false);
            endlessly += isLast ? 1 : 0;
        }
    }
    EXPECT_GE(endlessly, 5u) << "trees and boulders are seen from everywhere";
}

// A tree is drawn with its trunk in the picture of its last level.
TEST(Plants, keepTheirTrunksFarAway) {
    WorldRecords records;
    addMaterials(records, Pictures::Blank);
    ModelWriter writer(records);
    (void)addPlants(writer, redBark, 64);
    constexpr dat::RecordId kPicture = 0x06000100u + static_cast<std::uint32_t>(Material::FarPlants);
    const auto image = std::find_if(records.renderSurfaces.begin(), records.renderSurfaces.end(),
                                    [](const dat::RenderSurface& r) { return r.id == kPicture; });
    ASSERT_EQ(image->width, 256);
    for (int row = 0; row < PlantPictures::kRows; ++row) {
        int bark = 0;
        for (int x = 0; x < 64; ++x) { // near the lower edge of the first field
            const std::uint8_t* texel =
                &image->pixels[static_cast<std::size_t>((row * 64 + 59) * 256 + x) * 4];
            bark += texel[3] >= 128 && texel[2] > 128 && texel[1] < 128 ? 1 : 0;
        }
        EXPECT_GE(bark, 2) << "row " << row;
        EXPECT_LE(bark, 16) << "row " << row;
    }
}

} // namespace
} // namespace limen::worlds::test
