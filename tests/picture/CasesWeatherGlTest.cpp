// Hard cases 18, 23 and 30 of docs/cases.md: rain and smoke at an open door, with eye and player on different
// sides. The player's position decides whether it rains: tests/engine/FrameRequestTest.cpp.
#include "picture/CaseHelp.h"
#include "support/MovingHut.h"

#include "motion/Locate.h"

#include <cmath>
#include <set>

namespace limen::test {
namespace {

struct CasesWeather : ZoneCases {};
LIMEN_BOTH_ZONINGS(CasesWeather);

constexpr gpu::RenderOptions kCountRain{.shading = gpu::Shading::IdsOnly, .wantLayers = true};

/// The hut with smoke that rises in its front door and no glass in its window, so that all transparent
/// surfaces are sprites.
struct RainyHut : MovingHut {
    RainyHut() {
        moving.doors.pop_back();
        moving.villagers.clear();
        moving.emitters.resize(1);
        world::EmitterEntry& smoke = moving.emitters[0];
        smoke.position = at({9.95, 11.5, 2.2});
        smoke.rate = 14;
        smoke.spread = 0.4;
    }
};

struct Sum {
    std::size_t layers = 0, pixels = 0; ///< pixels with layers
};
Sum sumOf(const Picture& picture) {
    Sum sum;
    for (const gpu::LayerSum& at : picture.layers) {
        sum.layers += at.count;
        sum.pixels += at.count > 0 ? 1 : 0;
    }
    return sum;
}

/// Drops positioned inside the hut's rooms, which a picture must not show there.
std::size_t dropsInRooms(const PictureWorld& pictures, const motion::DynamicStateInput& input) {
    world::DynamicState dynamics;
    motion::DynamicStateBuilder(pictures.world()).build(input, dynamics);
    return static_cast<std::size_t>(
        std::count_if(dynamics.instances.begin(), dynamics.instances.end(), [&](const world::Instance& in) {
            const Vec3 p = in.bounds.centre - pictures.homeOrigin();
            return in.record == 0 && p.x > 10.3 && p.x < 17.7 && p.y > 10.3 && p.y < 13.7 && p.z > 2.3 &&
                   p.z < 4.7;
        }));
}

/// The area of a visit's region.
double pixelsWithin(const Picture& picture, const visibility::Visit& visit) {
    const auto region = picture.visible.region(visit);
    double twice = 0.0;
    for (std::size_t i = 0; i < region.size(); ++i) {
        const Vec3 &a = region[i], &b = region[(i + 1) % region.size()];
        twice += a.x / a.z * (b.y / b.z) - b.x / b.z * (a.y / a.z);
    }
    return std::abs(twice) / 8.0 * picture.frame.width * picture.frame.height;
}

TEST_P(CasesWeather, case18_rainFallsOutsideOnlyWhicheverSideTheEyeIsOn) {
    RainyHut hut;
    hut.moving.emitters.clear();
    PictureWorld pictures(hut.source, options(hut.moving));
    struct Stand {
        Vec3 eye;
        double yaw;
        bool out; ///< rain is visible
    };
    const Stand stands[] = {{{12.8, 11.4, 3.5}, 268, true},   // inside, looking out at the door
                            {{12.8, 11.4, 3.5}, 30, false},   // inside, facing a wall
                            {{8.7, 11.6, 3.5}, 90, true},     // outside, looking in
                            {{8.7, 11.6, 3.5}, 240, true},    // outside, looking away
                            {{16.8, 12.1, 3.6}, 91, true},    // inside, at the open window
                            {{10.004, 11.6, 3.6}, 80, false}, // on the threshold, just inside
                            {{9.996, 11.6, 3.6}, 260, true}}; // just outside
    for (const Stand& stand : stands) {
        SCOPED_TRACE(::testing::Message() << stand.eye.x << " yaw " << stand.yaw);
        const auto root = motion::locate(pictures.world(), hut.at(stand.eye)).space;
        const frame::FrameView frame = pictures.look(stand.eye, stand.yaw, -3, root);
        const motion::DynamicStateInput wet = dynamicsFor(frame, 2.3, 0.0, true);
        EXPECT_GE(dropsInRooms(pictures, wet), 5u);
        for (const double doors : {0.0, 1.0}) {
            motion::DynamicStateInput input = wet;
            input.allDoors = doors;
            pictures.setDynamics(input);
            const Picture rain = pictures.expectClean(frame, kCountRain);
            const bool toBeSeen = stand.out && (doors > 0.0 || root == world::kOutside || stand.eye.x > 14);
            EXPECT_EQ(sumOf(rain).pixels > 0, toBeSeen) << "doors " << doors;
            input.rain = false; // the player is inside
            pictures.setDynamics(input);
            EXPECT_EQ(sumOf(pictures.expectClean(frame, kCountRain)).layers, 0u);
        }
    }
}

TEST_P(CasesWeather, case30_rainAndSmokeAtAnOpenDoorWithTheEyeOnEitherSide) {
    RainyHut hut;
    PictureWorld pictures(hut.source, options(hut.moving));
    std::size_t rainy = 0;
    for (int step = 0; step <= 20; ++step) { // through the door in both directions, faster around the sill
        const double x = 10.0 + 1.6 * std::pow(step / 10.0 - 1.0, 3.0);
        const Vec3 eye(x, 11.4, 3.4);
        const auto root = motion::locate(pictures.world(), hut.at(eye)).space;
        for (const double yaw : {88.0, 272.0}) {
            SCOPED_TRACE(::testing::Message() << "x " << x << " yaw " << yaw);
            const frame::FrameView frame = pictures.look(eye, yaw, -8, root);
            pictures.setDynamics(dynamicsFor(frame, 3.0 + 0.21 * step, 1.0, true));
            const Picture both = pictures.expectClean(frame, kCountRain);
            pictures.setDynamics(dynamicsFor(frame, 3.0 + 0.21 * step, 1.0, false));
            const Picture smoke = pictures.expectClean(frame, kCountRain);
            // A pixel whose ray never gets outside has only the layers of the smoke.
            for (std::uint32_t i = 0; i < both.layers.size(); ++i) {
                const auto traced =
                    pictures.tracer().trace(root, rayThrough(frame, i % frame.width, i / frame.width));
                rainy += both.layers[i].count > smoke.layers[i].count ? 1 : 0;
                if (!traced.reachedOutside && root != world::kOutside &&
                    both.layers[i].count != smoke.layers[i].count) {
                    // Edges of the opening: the ray of a neighbouring pixel must have got outside.
                    bool near = false;
                    for (int k = 0; k < 9; ++k) {
                        near =
                            near || pictures.tracer()
                                        .trace(root, rayThrough(frame, i % frame.width + (k % 3 - 1) * 0.01,
                                                                i / frame.width + (k / 3 - 1) * 0.01))
                                        .reachedOutside;
                    }
                    EXPECT_TRUE(near) << "a drop in the room, pixel " << i;
                }
            }
        }
    }
    EXPECT_GT(rainy, 200u);
}

TEST_P(CasesWeather, case23_aChaseCameraPulledThroughTheDoorSeesWhatRaysSeeAndRunsTheSameStages) {
    RainyHut hut;
    PictureWorld pictures(hut.source, options(hut.moving));
    const std::vector<frame::StageKind> order{frame::StageKind::Ownership, frame::StageKind::Solid,
                                              frame::StageKind::Sky, frame::StageKind::Transparent,
                                              frame::StageKind::Overlay};
    world::SpaceIndex space = pictures.space(hut.source.id(hut.front));
    Vec3 last(10.3, 11.06, 3.3); // 6 cm beside the frame
    std::set<world::SpaceIndex> roots;
    for (int step = 0; step <= 60; ++step) { // backwards out of the door, then along the wall
        const Vec3 eye =
            step < 50 ? Vec3(10.3 - 0.0123 * step, 11.06, 3.3) : Vec3(9.685, 11.06 + 0.07 * (step - 50), 3.3);
        space = motion::sweep(pictures.world(), space, hut.at(last), hut.at(eye));
        last = eye;
        roots.insert(space);
        SCOPED_TRACE(::testing::Message() << "step " << step);
        const frame::FrameView frame = pictures.look(eye, 80 + step % 3 * 15, -4, space);
        pictures.setDynamics(dynamicsFor(frame, 4.0, 1.0, false));
        visibility::VisibleSet set;
        frame::FramePlan plan;
        pictures.plan(frame, set, plan);
        ASSERT_EQ(plan.stages.size(), order.size());
        for (std::size_t i = 0; i < order.size(); ++i)
            EXPECT_EQ(plan.stages[i].kind, order[i]);
        const Picture picture = pictures.expectClean(frame);
        // Spaces that rays show are seen, and every visited zone is reached by a ray.
        std::set<world::SpaceIndex> shown;
        std::set<world::ZoneIndex> zones{pictures.world().spaces[space].zone};
        for (std::uint32_t y = 0; y < frame.height; ++y) {
            for (std::uint32_t x = 0; x < frame.width; ++x) {
                const auto traced = pictures.tracer().trace(space, rayThrough(frame, x, y));
                if (const world::Instance* in = shownAs(pictures.world(), traced.id);
                    in != nullptr && in->kind == world::InstanceKind::Shell) {
                    shown.insert(in->placedIn);
                    zones.insert(pictures.world().spaces[in->placedIn].zone);
                }
                if (traced.reachedOutside) {
                    shown.insert(world::kOutside);
                    zones.insert(world::kOutsideZone);
                }
            }
        }
        for (const world::SpaceIndex s : shown)
            EXPECT_TRUE(seesSpace(picture, s)) << "space " << s;
        for (const visibility::Visit& visit : picture.visible.visits) {
            if (pixelsWithin(picture, visit) > 8.0) {
                EXPECT_TRUE(zones.count(visit.zone) == 1)
                    << "zone " << visit.zone << " is visited and no ray gets there";
            }
        }
    }
    EXPECT_EQ(roots.size(), 2u) << "the eye went out";
}

TEST_P(CasesWeather, case23_thePicturesStagesDoNotDependOnTheRoot) {
    RainyHut hut;
    PictureWorld pictures(hut.source, options(hut.moving));
    const auto shoot = [&](const Vec3& eye, double yaw) {
        const frame::FrameView frame =
            pictures.look(eye, yaw, 0, motion::locate(pictures.world(), hut.at(eye)).space);
        pictures.setDynamics(dynamicsFor(frame, 4.0, 1.0, true));
        return pictures.expectClean(frame);
    };
    const Picture in = shoot({12, 11.5, 3.5}, 270), out = shoot({8, 11.5, 3.5}, 90);
    EXPECT_EQ(in.stages, out.stages);
    EXPECT_EQ(in.glCalls, out.glCalls);
}

} // namespace
} // namespace limen::test
