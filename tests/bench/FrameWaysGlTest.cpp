#include "BenchTable.h"
#include "ComparedWorld.h"
#include "FrameBench.h"
#include "frames/FrameRows.h"
#include "peer/Peer.h"
#include "plain/PlainWay.h"

#include "geometry/Tolerances.h"
#include <cmath>

#include <gtest/gtest.h>

namespace limen::bench::test {
namespace {

constexpr std::uint32_t kWidth = 160, kHeight = 90;

/// Null: the peer is not built.
std::unique_ptr<FrameWay> peerOrNull() {
    Result<std::unique_ptr<FrameWay>> peer = makePeerWay(kWidth, kHeight);
    EXPECT_TRUE(peer) << (peer ? "" : peer.error().message());
    return peer ? std::move(*peer) : nullptr;
}

FramePicture pictureOf(FrameWay& way, const FramePlace& place) {
    const Result<void> drawn =
        way.enter().and_then([&] { return way.show(place); }).and_then([&] { return way.draw(); });
    EXPECT_TRUE(drawn) << (drawn ? "" : drawn.error().message());
    return way.read();
}

/// Whether two depths (near plane / view depth) are those of one surface. The peer's depth of a far surface is off by
/// 1e-6 of its near plane, kNearestPlace.
bool isSameDepth(float a, float b) {
    constexpr auto kFarError = static_cast<float>(1e-6 * kDefaultNearPlane / kNearestPlace);
    return std::abs(a - b) <= 0.01f * std::max(a, b) + kFarError;
}

/// Share of the pixels with another depth than Limen's.
double differingFrom(const FramePicture& limen, const FramePicture& other) {
    EXPECT_EQ(limen.depth.size(), std::size_t{kWidth} * kHeight);
    EXPECT_EQ(other.depth.size(), limen.depth.size());
    std::size_t differing = 0;
    for (std::size_t i = 0; i < limen.depth.size(); ++i)
        differing += isSameDepth(limen.depth[i], other.depth[i]) ? 0 : 1;
    return static_cast<double>(differing) / static_cast<double>(limen.depth.size());
}

/// Expects that a way draws the surfaces that Limen draws, from the same camera.
void expectLimensSurfaces(FrameWay& way) {
    ComparedWorld source;
    Result<std::vector<std::unique_ptr<FrameWay>>> limen = makeLimenWays(limenRenderers(), kWidth, kHeight);
    ASSERT_TRUE(limen) << limen.error().message();
    for (const world::Place& from : {source.inRoom, source.outside}) {
        const FramePlace place = source.placeAt(from, kWidth, kHeight);
        const FramePicture expected = pictureOf(*limen->front(), place);
        const auto covered = std::count_if(expected.depth.begin(), expected.depth.end(),
                                           [](float depth) { return depth > 0.0f; });
        EXPECT_GT(covered, std::ptrdiff_t{kWidth} * kHeight / 4) << from.name;
        EXPECT_LT(differingFrom(expected, pictureOf(way, place)), 0.01) << from.name;
    }
}

TEST(PlainWay, drawsTheSurfacesThatLimenDraws) {
    const Result<std::unique_ptr<FrameWay>> plain = makePlainWay(kWidth, kHeight);
    ASSERT_TRUE(plain) << plain.error().message();
    expectLimensSurfaces(**plain);
}

TEST(PeerWay, drawsTheSurfacesThatLimenDraws) {
    const std::unique_ptr<FrameWay> peer = peerOrNull();
    if (!peer)
        GTEST_SKIP() << "the peer is not built";
    expectLimensSurfaces(*peer);
}

std::set<std::string> namesOf(const std::vector<std::pair<std::string, double>>& against) {
    std::set<std::string> names;
    for (const auto& [name, value] : against)
        names.insert(name);
    return names;
}

TEST(CompareFrames, givesEveryRow) {
    ComparedWorld source;
    const limen::test::TempDir pictures;
    FrameEffort effort{kWidth, kHeight, 1, pictures.path()};
    const std::vector<BenchRow> rows =
        compareFrames(*source.archive, source.file, {source.inRoom, source.outside}, effort);
    std::set<std::string> expected{"frame/ownership"}, found;
    for (const LimenRenderer& renderer : limenRenderers())
        for (const char* kind : {"cells", "outside"})
            for (const char* clock : {"wall", "processor"})
                expected.insert("frame/" + renderer.name + "/" + kind + "/" + clock);
    for (const char* place : {"0", "1"})
        for (const char* clock : {"wall", "processor"})
            expected.insert(std::string("frame/places/") + place + "/" + clock);
    const bool isPeerBuilt = peerOrNull() != nullptr;
    const std::string first = limenRenderers().front().name;
    for (const BenchRow& row : rows) {
        EXPECT_TRUE(found.insert(row.bench).second) << row.bench << " twice";
        EXPECT_TRUE(std::isfinite(row.value)) << row.bench << " " << row.scene;
        if (row.bench == "frame/ownership")
            continue;
        EXPECT_GT(row.value, 0.0) << row.bench;
        const std::set<std::string> against = namesOf(row.against);
        EXPECT_TRUE(against.contains("plain")) << row.bench;
        EXPECT_EQ(against.contains("peer"), isPeerBuilt) << row.bench;
        if (row.bench.find("/places/") != std::string::npos) {
            EXPECT_TRUE(against.contains(first + " without visibility")) << row.bench;
            EXPECT_EQ(row.hasTarget, isPeerBuilt) << row.bench;
        }
    }
    EXPECT_EQ(found, expected);
}

TEST(CompareFrames, writesAPictureOfEachPlaceAndWay) {
    ComparedWorld source;
    const limen::test::TempDir pictures;
    const FrameEffort effort{kWidth, kHeight, 1, pictures.path()};
    static_cast<void>(compareFrames(*source.archive, source.file, {source.inRoom}, effort));
    for (const char* way : {"fast", "fast-without-visibility", "exact", "plain"}) {
        const std::filesystem::path file = pictures.path() / (std::string("00-cell-") + way + ".png");
        EXPECT_TRUE(std::filesystem::exists(file)) << file;
    }
}

TEST(CompareFrames, aPlaceThatIsNotThereMissesTheTarget) {
    ComparedWorld source;
    const FrameEffort effort{kWidth, kHeight, 1, {}};
    world::Place nowhere = source.inRoom;
    nowhere.cell += 0x50;
    const std::vector<BenchRow> rows = compareFrames(*source.archive, source.file, {nowhere}, effort);
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_FALSE(isMet(rows.front()));
    EXPECT_NE(rows.front().scene.find("not loaded"), std::string::npos) << rows.front().scene;
}

} // namespace
} // namespace limen::bench::test
