// Meshes that turn to the eye: static ones outdoors and in rooms, loose ones, and parts of villagers; drawn and
// traced alike.
#include "picture/CaseHelp.h"
#include "picture/EveryCulling.h"
#include "support/MovingHut.h"

#include <limits>
#include <random>

namespace limen::test {
namespace {

constexpr float kEndless = std::numeric_limits<float>::max();

/// A card in x and z, seen from both sides.
Walls card(double width, double height, const std::string& surface) {
    return {{rectangle({-width / 2, 0, 0}, {width / 2, 0, height}), surface, true}};
}

/// The hut's meadow and rooms, with cards of every mode in random places and turns.
struct BillboardsGl : ::testing::TestWithParam<gpu::Culling> {
    MovingHut hut;
    std::mt19937 random{20};
    std::vector<std::uint32_t> cards;

    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    }

    BillboardsGl() {
        for (const std::uint32_t mode : {2u, 3u, 4u, 5u}) {
            const std::string surface = "card" + std::to_string(mode);
            const std::uint32_t far = hut.source.addModel(card(6, 5, surface));
            cards.push_back(
                hut.source.addModel(card(1.5, 1.2, surface), {{TestWorld::kItself, mode, 0, 0, 900}}));
            cards.push_back(hut.source.addModel(boxExterior({-1, -1, 0}, {1, 1, 3}, "oak"),
                                                {{TestWorld::kItself, 1, 0, 0, 10},
                                                 {far, mode, 0, 0, 100},
                                                 {0, 1, kEndless, kEndless, kEndless}}));
            cards.push_back(far);
        }
        for (std::size_t i = 0; i < 60; ++i)
            hut.source.addObject(cards[i / 2 % 4 * 3 + i % 2], randomFrame({0, -90, 2}, {190, 190, 3}));
        for (std::size_t i = 0; i < cards.size(); i += 3) { // the small ones; some reach through the doors
            hut.source.addStatic(hut.front, cards[i], randomFrame({10.5, 10.5, 2}, {13.9, 13.5, 4}));
            hut.source.addStatic(hut.rear, cards[i], randomFrame({14.5, 10.5, 2}, {17.5, 13.5, 4}));
        }
        dat::Setup two; // a villager with a card
        two.parts = {hut.body, cards[9]};
        hut.moving.villagers[0].model = hut.source.addSetup(two);
    }

    dat::Frame randomFrame(const Vec3& low, const Vec3& high) {
        return frameAt({between(low.x, high.x), between(low.y, high.y), between(low.z, high.z)},
                       between(0, 360));
    }
};

INSTANTIATE_TEST_SUITE_P(Culling, BillboardsGl, everyCulling(), nameOfCulling);

TEST_P(BillboardsGl, areTheSameDrawnAndTraced) {
    PictureWorld pictures(hut.source, {.moving = hut.moving, .culling = GetParam()});
    std::vector<std::size_t> seen(cards.size());
    for (int i = 0; i < 60; ++i) {
        SCOPED_TRACE(i);
        const bool indoors = i % 3 == 2;
        const Vec3 eye = indoors ? Vec3(between(10.2, 13.8), between(10.2, 13.8), between(2.3, 4.5))
                                 : Vec3(between(-20, 120), between(-60, 9), between(2.5, 20));
        const world::SpaceIndex root = indoors ? pictures.space(hut.source.id(hut.front)) : world::kOutside;
        const frame::FrameView frame = pictures.look(eye, between(0, 360), between(-30, 30), root);
        pictures.setDynamics(dynamicsFor(frame, between(0, 20), between(0, 1) < 0.5 ? 0.0 : 1.0));
        const Picture picture = pictures.expectClean(frame);
        for (std::size_t k = 0; k < cards.size(); ++k)
            seen[k] += pixelsOfRecord(pictures, picture, cards[k]);
    }
    for (std::size_t k = 0; k < cards.size(); ++k)
        EXPECT_GT(seen[k], 0u) << "nothing is judged of record " << cards[k];
}

// A card of mode 5 shows its whole width from every side, upright.
TEST_P(BillboardsGl, faceTheEyeFromEverySide) {
    TestWorld source;
    source.setFlatTerrain(source.home(), 1);
    const std::uint32_t tree = source.addModel({{rectangle({-2, 0, 0}, {2, 0, 6}), "leaf", false}},
                                               {{TestWorld::kItself, 5, 0, 0, 900}});
    const Vec3 at(96.0, 96.0, 2.0);
    source.addObject(tree, frameAt(at, 77));
    PictureWorld pictures(source, {.culling = GetParam()});
    std::vector<std::size_t> pixels;
    for (int i = 0; i < 12; ++i) {
        const double turn = glm::radians(30.0 * i);
        const Vec3 eye = at + 20.0 * Vec3(-std::sin(turn), -std::cos(turn), 0.0) + Vec3(0, 0, 3);
        const frame::FrameView frame = pictures.look(eye, 30.0 * i, 0, world::kOutside);
        pictures.setDynamics(dynamicsFor(frame, 0.0, {}));
        pixels.push_back(pixelsOfRecord(pictures, pictures.expectClean(frame), tree));
    }
    const auto [least, most] = std::minmax_element(pixels.begin(), pixels.end());
    EXPECT_GT(*least, 50u);
    EXPECT_LE(*most - *least, *least / 5);
}

} // namespace
} // namespace limen::test
