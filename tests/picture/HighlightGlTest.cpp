// Highlights: a static or dynamic object in another colour, with all other pixels unchanged.
#include "picture/CaseHelp.h"
#include "picture/EveryCulling.h"
#include "support/MovingHut.h"

#include <set>

namespace limen::test {
namespace {

constexpr std::uint32_t kGreen = 0xFF00FF00u; // strength, B, G, R

/// The object at each pixel; 0 for sky and void.
std::vector<std::uint64_t> objectsOf(const PictureWorld& pictures, const Picture& picture) {
    std::vector<std::uint64_t> objects;
    for (const std::uint32_t id : picture.ids) {
        const world::Instance* in = shownAs(pictures.world(), id);
        objects.push_back(in != nullptr ? in->object : 0);
    }
    return objects;
}

std::array<std::uint8_t, 3> colourAt(const Picture& picture, std::size_t pixel) {
    return {picture.colour[4 * pixel], picture.colour[4 * pixel + 1], picture.colour[4 * pixel + 2]};
}

/// With and without culling, because draw commands are made in both.
struct Highlight : ::testing::TestWithParam<gpu::Culling> {};
INSTANTIATE_TEST_SUITE_P(Culling, Highlight, everyCulling(), nameOfCulling);

TEST_P(Highlight, coloursAnObjectAndNothingElse) {
    MovingHut hut;
    hut.moving.emitters.clear(); // they have no ids
    PictureWorld pictures(hut.source, {.moving = hut.moving, .culling = GetParam()});
    frame::FrameView frame =
        pictures.look({13.5, 13.0, 3.6}, 255, -20, pictures.space(hut.source.id(hut.front)));
    pictures.setDynamics(dynamicsFor(frame, 17.5, 1.0)); // the villager leaves by the open door
    const Picture plain = pictures.shoot(frame);
    const std::vector<std::uint64_t> shown = objectsOf(pictures, plain);
    std::set<std::uint64_t> objects(shown.begin(), shown.end());
    objects.erase(0);
    ASSERT_GE(objects.size(), 4u) << "walls, meadow, leaf and villager";
    for (const std::uint64_t object : objects) {
        const frame::Highlight highlight{object, kGreen};
        frame.highlights = std::span(&highlight, 1);
        const Picture picture = pictures.shoot(frame);
        EXPECT_EQ(picture.ids, plain.ids);
        EXPECT_EQ(picture.depth, plain.depth);
        EXPECT_EQ(picture.glCalls, plain.glCalls);
        for (std::size_t i = 0; i < shown.size(); ++i) {
            const std::array<std::uint8_t, 3> green{0, 255, 0};
            ASSERT_EQ(colourAt(picture, i), shown[i] == object ? green : colourAt(plain, i))
                << "pixel " << i << " of object " << object;
        }
    }
}

TEST_P(Highlight, takesSeveralAndMixesByStrength) {
    MovingHut hut;
    PictureWorld pictures(hut.source, {.moving = hut.moving, .culling = GetParam()});
    frame::FrameView frame =
        pictures.look({17.5, 13.5, 3.6}, 235, -20, pictures.space(hut.source.id(hut.rear)));
    const Picture plain = pictures.shoot(frame);
    const std::vector<std::uint64_t> shown = objectsOf(pictures, plain);
    std::set<std::uint64_t> objects(shown.begin(), shown.end());
    objects.erase(0);
    ASSERT_GE(objects.size(), 2u) << "walls and table";
    std::vector<frame::Highlight> highlights;
    for (const std::uint64_t object : objects) {
        highlights.push_back({object, kGreen});
        highlights.push_back({object, 0x80000000u}); // half black; the later of two highlights counts
    }
    highlights.push_back({12345, kGreen}); // no object has this number
    frame.highlights = highlights;
    const Picture picture = pictures.shoot(frame);
    for (std::size_t i = 0; i < shown.size(); ++i)
        for (std::size_t c = 0; shown[i] != 0 && c < 3; ++c)
            ASSERT_NEAR(colourAt(picture, i)[c], colourAt(plain, i)[c] * (127.0 / 255.0), 1.0) << i;
}

} // namespace
} // namespace limen::test
