#include "frame/DynamicPieces.h"

#include <gtest/gtest.h>

#include <tuple>

namespace limen::frame {
namespace {

constexpr std::uint32_t kStaticPieces = 10;
constexpr std::uint32_t kBox = 0, kLong = 1, kPainted = 2, kNothing = 3; // meshes

/// A mesh of 12 triangles; one whose opaque part takes three pieces; one with a part of each class, of 2, 3
/// and 4 triangles, with one split triangle; and one without triangles.
world::World fourMeshes() {
    constexpr std::uint32_t kLongIndices = 3 * (2 * gpu::kTrianglesPerPiece + 5);
    world::World world;
    world.meshes.resize(4);
    world.meshes[kBox].ranges[0] = {0, 36};
    world.meshes[kLong].ranges[0] = {36, kLongIndices};
    world.meshes[kPainted].ranges = {{{9000, 6}, {9006, 9}, {9015, 12}}};
    world.meshes[kPainted].splitIndexCount = 3;
    return world;
}

/// First index, triangles and instance of a piece.
using Drawn = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;

struct DynamicPiecesTest : ::testing::Test {
    DynamicPiecesTest() { begin(); }
    void begin() {
        plan.clear();
        pieces.begin(plan);
        plan.constants.staticPieces = kStaticPieces;
        beginStage(plan, StageKind::Solid);
        beginBatch(Program::Opaque, true, plan);
    }
    /// The pieces of a run. Checks its counts and the indices before each piece.
    [[nodiscard]] std::vector<Drawn> drawnBy(const PieceRun& run) const {
        std::vector<Drawn> drawn;
        std::uint32_t indices = run.indicesBefore;
        for (std::uint32_t i = 0; i < run.pieceCount; ++i) {
            const gpu::DrawPiece& piece = plan.pieces.at(run.firstPiece - kStaticPieces + i);
            EXPECT_EQ(piece.indicesBefore, indices);
            indices += 3 * piece.triangles;
            drawn.emplace_back(piece.firstIndex, piece.triangles, piece.instance);
        }
        EXPECT_EQ(indices - run.indicesBefore, run.indexCount);
        return drawn;
    }
    const world::World world = fourMeshes();
    const MeshPieces meshes{world};
    DynamicPieces pieces{meshes};
    FramePlan plan;
};

TEST_F(DynamicPiecesTest, ofOneClassAreARunInTheOrderTheyAreAdded) {
    pieces.add(kBox, 7, false);
    pieces.add(kNothing, 8, false);
    pieces.add(kPainted, 9, false);
    pieces.add(kBox, 5, false);
    pieces.moveRuns(DrawClass::Opaque, plan);
    ASSERT_EQ(plan.runs.size(), 1u);
    EXPECT_EQ(drawnBy(plan.runs[0]), (std::vector<Drawn>{{0, 12, 7}, {9000, 2, 9}, {0, 12, 5}}));
    EXPECT_FALSE(plan.runs[0].gated);
    EXPECT_EQ(plan.batches.back().draws, 3u);
}

TEST_F(DynamicPiecesTest, areCutAsThoseOfStaticInstances) {
    pieces.add(kLong, 7, false);
    pieces.moveRuns(DrawClass::Opaque, plan);
    ASSERT_EQ(plan.runs.size(), 1u);
    EXPECT_EQ(drawnBy(plan.runs[0]),
              (std::vector<Drawn>{{36, gpu::kTrianglesPerPiece, 7},
                                  {36 + 3 * gpu::kTrianglesPerPiece, gpu::kTrianglesPerPiece, 7},
                                  {36 + 6 * gpu::kTrianglesPerPiece, 5, 7}}));
}

TEST_F(DynamicPiecesTest, aRunEndsWhereTheTestBeginsOrEnds) {
    pieces.add(kBox, 1, true);
    pieces.add(kBox, 2, true);
    pieces.add(kBox, 3, false);
    pieces.add(kBox, 4, true);
    pieces.moveRuns(DrawClass::Opaque, plan);
    ASSERT_EQ(plan.runs.size(), 3u);
    EXPECT_EQ(drawnBy(plan.runs[0]), (std::vector<Drawn>{{0, 12, 1}, {0, 12, 2}}));
    EXPECT_EQ(drawnBy(plan.runs[1]), (std::vector<Drawn>{{0, 12, 3}}));
    EXPECT_EQ(drawnBy(plan.runs[2]), (std::vector<Drawn>{{0, 12, 4}}));
    EXPECT_TRUE(plan.runs[0].gated && !plan.runs[1].gated && plan.runs[2].gated);
}

TEST_F(DynamicPiecesTest, splitSurfacesAreCutOutAndBlended) {
    pieces.add(kPainted, 7, false);
    for (const DrawClass drawn : {DrawClass::Wall, DrawClass::Terrain, DrawClass::Opaque, DrawClass::CutOut})
        pieces.moveRuns(drawn, plan);
    const auto blended = pieces.movePieces(DrawClass::Blended, plan);
    std::vector<Drawn> solid;
    for (const PieceRun& run : plan.runs) {
        const std::vector<Drawn> drawn = drawnBy(run);
        solid.insert(solid.end(), drawn.begin(), drawn.end());
    }
    EXPECT_EQ(solid, (std::vector<Drawn>{{9000, 2, 7}, {9006, 4, 7}}));
    ASSERT_EQ(blended.size(), 1u);
    EXPECT_EQ(blended[0].firstIndex, 9015u);
    EXPECT_EQ(blended[0].triangles, 4u);
    EXPECT_EQ(blended.data(), plan.pieces.data() + 2) << "behind those before";
}

TEST_F(DynamicPiecesTest, areGoneInTheNextFrame) {
    pieces.add(kBox, 1, true);
    pieces.add(kPainted, 1, true);
    pieces.moveRuns(DrawClass::Opaque, plan);
    begin();
    pieces.add(kBox, 2, false);
    pieces.moveRuns(DrawClass::Opaque, plan);
    pieces.moveRuns(DrawClass::CutOut, plan);
    ASSERT_EQ(plan.runs.size(), 1u);
    EXPECT_EQ(drawnBy(plan.runs[0]), (std::vector<Drawn>{{0, 12, 2}}));
}

} // namespace
} // namespace limen::frame
