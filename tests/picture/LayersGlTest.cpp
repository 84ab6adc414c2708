// Transparent layers, counted as they would be drawn and compared with the ray rule: panes, and emitters'
// sprites at several times.
#include "picture/PictureWorld.h"
#include "reference/Scene.h"
#include "support/MovingHut.h"

#include "motion/Locate.h"

#include <gtest/gtest.h>

namespace limen::test {
namespace {

gpu::LayerSum sumOf(const std::vector<std::uint32_t>& ids) {
    gpu::LayerSum sum;
    for (const std::uint32_t id : ids) {
        ++sum.count;
        sum.hash += reference::layerHash(id);
    }
    return sum;
}

struct Tally {
    std::size_t pixels = 0, withLayers = 0, wrong = 0, byZone = 0;
    std::string first;
};

/// Compares with the naive tracer and judges as `limen check` does. A pixel is wrong if no naive ray through
/// its 3 by 3 neighbourhood has the counted layers, and it is neither a sliver nor exempt.
void tally(PictureWorld& pictures, const Picture& picture, Tally& tally) {
    const check::Comparison judged = pictures.judge(picture);
    const auto meets = [&](double x, double y) {
        return sumOf(
            pictures.tracer().trace(picture.frame.view.root, rayThrough(picture.frame, x, y)).layers);
    };
    for (std::uint32_t y = 0; y < picture.frame.height; ++y) {
        for (std::uint32_t x = 0; x < picture.frame.width; ++x) {
            const gpu::LayerSum& drawn = picture.layers[y * picture.frame.width + x];
            ++tally.pixels;
            tally.withLayers += drawn.count > 0 ? 1 : 0;
            bool right = false;
            for (int i = 0; i < 9 && !right; ++i) // like ids: the 3 by 3 pixels
                right = meets(x + i % 3 - 1.0, y + i / 3 - 1.0) == drawn;
            const check::Verdict verdict = judged.verdicts[y * picture.frame.width + x];
            // Within a zone, a sprite that passes through a wall may be hit beyond it (docs/ray-rule.md); the
            // naive tracer has no zones.
            tally.byZone += !right && verdict == check::Verdict::ByZone ? 1 : 0;
            right = right || verdict == check::Verdict::Sliver || verdict == check::Verdict::Unjudged ||
                    verdict == check::Verdict::ByZone;
            if (!right && tally.wrong++ == 0) {
                tally.first = "pixel " + std::to_string(x) + ", " + std::to_string(y) + ": drawn " +
                              std::to_string(drawn.count) + ", traced " + std::to_string(meets(x, y).count) +
                              ", judged " +
                              std::string(check::kVerdictNames[static_cast<std::size_t>(verdict)]);
            }
        }
    }
}

struct Layers : ::testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Zones, Layers, ::testing::Bool(),
                         [](const auto& zones) { return zones.param ? "merged" : "apart"; });

TEST_P(Layers, ofPanesAndMovingSpritesAreThoseThatRaysMeet) {
    MovingHut hut;
    for (world::EmitterEntry& emitter : hut.moving.emitters) { // thick smoke
        emitter.rate = 25;
        emitter.size = {0.3, 0.9};
    }
    PictureWorld pictures(hut.source, {GetParam(), 1, hut.moving});
    Tally sum;
    const Vec3 eyes[] = {{6.5, 11.5, 3.6}, {11, 13, 3.5}, {16, 11.2, 3.4}, {21, 12, 3.5}, {10.02, 11.4, 3.3}};
    for (int step = 0; step < 12; ++step) {
        for (const double doors : {0.0, 0.6}) {
            const Vec3& eye = eyes[step % 5];
            const world::SpaceIndex root = motion::locate(pictures.world(), hut.at(eye)).space;
            // Along the lantern's path, so that sprites are visible.
            const frame::FrameView frame = pictures.look(eye, eye.x > 12 ? 270 : 95, -5, root);
            motion::DynamicStateInput input;
            input.seconds = 3.0 + step * 0.83;
            input.allDoors = doors;
            input.eye = frame.view.eye;
            input.right = frame.view.right;
            input.up = frame.view.up;
            input.forward = frame.view.forward;
            pictures.setDynamics(input);
            SCOPED_TRACE(::testing::Message() << "step " << step << " doors " << doors);
            const Picture picture =
                pictures.shoot(frame, {.shading = gpu::Shading::IdsOnly, .wantLayers = true});
            EXPECT_LE(picture.glCalls, 40u);
            tally(pictures, picture, sum);
            EXPECT_EQ(sum.wrong, 0u) << sum.first;
        }
    }
    EXPECT_GT(sum.withLayers, sum.pixels / 50) << "layers are visible";
    EXPECT_LE(sum.byZone, GetParam() ? sum.pixels / 1000 : 0u) << "only within one zone, and rarely";
    RecordProperty("pixelsWithLayers", static_cast<int>(sum.withLayers));
}

TEST_P(Layers, ofAPaneIsMetBeforeTheBarThatTouchesIt) {
    MovingHut hut;
    const auto plate = hut.source.addModel({{{{0, 0, 0}, {0, 2, 0}, {0, 2, 1}, {0, 0, 1}}, "glass", true}});
    hut.moving.doors.back().leaves.front().model = plate;
    // A bar whose face towards the room is 0.1 mm before the pane.
    hut.source.addStatic(hut.rear,
                         hut.source.addModel(boxExterior({-0.0001, 0, 0}, {-0.00005, 0.3, 0.8}, "oak")),
                         frameAt({18, 12, 3.1}));
    PictureWorld pictures(hut.source, {GetParam(), 1, hut.moving});
    pictures.setDynamics({});
    const world::SpaceIndex root = pictures.space(hut.source.id(hut.rear));
    Tally sum;
    std::size_t bars = 0;
    for (const Vec3& eye : {Vec3(16, 12, 3.5), Vec3(17.9, 11.9, 3.3), Vec3(17.97, 12.2, 3.6)}) {
        const Picture picture = pictures.shoot(pictures.look(eye, 85, 3, root),
                                               {.shading = gpu::Shading::IdsOnly, .wantLayers = true});
        tally(pictures, picture, sum);
        EXPECT_EQ(sum.wrong, 0u) << sum.first;
        for (std::size_t i = 0; i < picture.ids.size(); ++i) {
            const std::uint32_t instance = instanceOfId(pictures.world(), picture.ids[i]);
            if (instance != world::kNone &&
                pictures.world().instances[instance].kind == world::InstanceKind::Static)
                bars += picture.layers[i].count == 1 ? 1 : 0;
        }
    }
    EXPECT_GT(bars, 100u) << "the bar is seen through the pane";
}

} // namespace
} // namespace limen::test
