// Pictures drawn in tiles and supersampled pictures, compared with pictures in one piece.
#include "engine/picture/LargePicture.h"
#include "engine/picture/LinearFilter.h"

#include <gtest/gtest.h>

namespace limen::engine {
namespace {

/// The built-in world on a device, with places inside and outside.
class Tiles : public ::testing::TestWithParam<std::tuple<const char*, std::uint32_t>> {
protected:
    void SetUp() override {
        Result<WorldSource> opened = openWorldSource("");
        ASSERT_TRUE(opened) << opened.error().message();
        const auto source = std::make_shared<const WorldSource>(std::move(*opened));
        SessionOptions options;
        options.samples = std::get<1>(GetParam());
        options.load = {.radius = 0, .farRadius = 0};
        Result<HeadlessSession> headless = openHeadless(source, options);
        ASSERT_TRUE(headless) << headless.error().message();
        headless_ = std::move(*headless);
        ViewRequest view;
        view.place = std::get<0>(GetParam());
        view.size = {64, 36};
        view.scene.seconds = 3.0;
        const Result<ViewRequest> resolved = resolvePlace(view, source->file);
        ASSERT_TRUE(resolved) << resolved.error().message();
        ASSERT_TRUE(session().load(centreOf(*resolved)));
        const Result<FrameRequest> request = frameRequest(session().part().world, source->file, *resolved);
        ASSERT_TRUE(request) << request.error().message();
        request_ = *request;
    }
    [[nodiscard]] Session& session() { return *headless_.session; }

    /// R, G, B bytes of a picture in one piece.
    std::vector<std::uint8_t> whole(PixelSize size) {
        FrameRequest request = request_;
        request.size = size;
        EXPECT_TRUE(session().draw(request, {}));
        const std::vector<std::uint8_t> rgba = session().target().readColour();
        std::vector<std::uint8_t> rgb;
        for (std::size_t i = 0; i < rgba.size(); i += 4)
            rgb.insert(rgb.end(), {rgba[i], rgba[i + 1], rgba[i + 2]});
        return rgb;
    }

    void drawsTheMeanOfALargerPicture();

    HeadlessSession headless_;
    FrameRequest request_;
};

std::size_t differing(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    EXPECT_EQ(a.size(), b.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        count += a[i] != b[i] ? 1 : 0;
    return count;
}

/// The driver interpolates some attributes from the target's corner, so that their last bits depend on the
/// tile. A colour can then round to the next of 256 steps: about one byte in 40,000 with llvmpipe.
void expectSame(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    EXPECT_LE(differing(a, b), 4u);
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        ASSERT_LE(std::abs(int{a[i]} - int{b[i]}), 1) << "byte " << i;
}

TEST_P(Tiles, joinToThePictureInOnePiece) {
    const std::vector<std::uint8_t> expected = whole(request_.size);
    for (const std::uint32_t side : {32u, 50u}) {
        SCOPED_TRACE(side);
        const Result<std::vector<std::uint8_t>> tiled =
            drawLargePicture(session(), request_, {.supersample = 1, .tileSide = side});
        ASSERT_TRUE(tiled) << tiled.error().message();
        expectSame(*tiled, expected);
    }
    const Result<std::vector<std::uint8_t>> one = drawLargePicture(session(), request_, {});
    ASSERT_TRUE(one);
    EXPECT_EQ(differing(*one, expected), 0u) << "a single tile is the picture, byte for byte";
    drawsTheMeanOfALargerPicture(); // here, because opening the world takes most of the time
}

void Tiles::drawsTheMeanOfALargerPicture() {
    constexpr std::uint32_t n = 2;
    const LinearMean light;
    const std::vector<std::uint8_t> large = whole({request_.size.width * n, request_.size.height * n});
    std::vector<std::uint8_t> expected;
    for (std::uint32_t y = 0; y < request_.size.height; ++y)
        for (std::uint32_t x = 0; x < request_.size.width; ++x)
            for (std::uint32_t channel = 0; channel < 3; ++channel) {
                float sum = 0.0f;
                for (std::uint32_t i = 0; i < n * n; ++i)
                    sum += light.linear(
                        large[((y * n + i / n) * request_.size.width * n + x * n + i % n) * 3 + channel]);
                expected.push_back(light.encoded(sum / static_cast<float>(n * n)));
            }
    const Result<std::vector<std::uint8_t>> drawn =
        drawLargePicture(session(), request_, {.supersample = n, .tileSide = 64});
    ASSERT_TRUE(drawn) << drawn.error().message();
    EXPECT_LE(differing(*drawn, expected), expected.size() / 2000) << "the order of sums may round otherwise";
    EXPECT_GT(differing(*drawn, whole(request_.size)), drawn->size() / 100) << "edges are smoother";
}

INSTANTIATE_TEST_SUITE_P(Places, Tiles,
                         ::testing::Values(std::tuple("cottage.front", 0u), std::tuple("inn.hall", 0u),
                                           std::tuple("hill", 4u)),
                         [](const auto& tested) {
                             std::string name = std::get<0>(tested.param);
                             std::replace(name.begin(), name.end(), '.', '_');
                             return name + (std::get<1>(tested.param) > 0 ? "_sampled" : "");
                         });

TEST(LargePicture, namesTheSupersamplingThatFits) {
    EXPECT_TRUE(checkLargePicture({8192, 8192}, 2));
    const Result<void> tooLarge = checkLargePicture({8192, 4096}, 4);
    ASSERT_FALSE(tooLarge);
    EXPECT_NE(tooLarge.error().message().find("use supersampling of 2"), std::string::npos)
        << tooLarge.error().message();
    EXPECT_NE(checkLargePicture({10000, 10}, 2).error().message().find("leave out supersampling"),
              std::string::npos);
    EXPECT_FALSE(checkLargePicture({640, 360}, 1, 512)) << "the driver's limit";
}

TEST(LargePicture, memoryIsThePictureAndOneTile) {
    const std::uint64_t picture = std::uint64_t{8192} * 8192 * 3;
    const std::uint64_t once = bytesOfLargePicture({8192, 8192}, {}, 0);
    EXPECT_EQ(once, picture + std::uint64_t{2048} * 2048 * 20);
    EXPECT_EQ(bytesOfLargePicture({8192, 8192}, {.supersample = 2}, 0), once)
        << "samples are filtered tile by tile";
    EXPECT_LT(bytesOfLargePicture({64, 64}, {}, 0), 100000u);
}

} // namespace
} // namespace limen::engine
