// Hard cases 9, 17, 19 and 27 of docs/cases.md: dynamic objects, fillings, transparent surfaces.
#include "picture/CaseHelp.h"
#include "support/Effects.h"

#include "motion/Locate.h"

#include <set>

namespace limen::test {
namespace {

struct CasesMoving : ZoneCases {};
LIMEN_BOTH_ZONINGS(CasesMoving);

constexpr gpu::RenderOptions kCountLayers{.shading = gpu::Shading::IdsOnly, .wantLayers = true};

/// Traced pixels of a record: all that show it, and those whose eight neighbours show it, too.
struct Traced {
    std::size_t all = 0;
    std::vector<std::size_t> inner;
};
Traced tracedPixels(const PictureWorld& pictures, const frame::FrameView& frame, dat::RecordId record) {
    const int width = static_cast<int>(frame.width), height = static_cast<int>(frame.height);
    std::vector<char> shows;
    for (int y = -1; y <= height; ++y) {
        for (int x = -1; x <= width; ++x) {
            const auto id = pictures.tracer().trace(frame.view.root, rayThrough(frame, x, y)).id;
            const world::Instance* in = shownAs(pictures.world(), id);
            shows.push_back(in != nullptr && in->record == record);
        }
    }
    const auto at = [&](int x, int y) {
        return shows[static_cast<std::size_t>((y + 1) * (width + 2) + x + 1)];
    };
    Traced traced;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            int count = 0;
            for (int k = 0; k < 9; ++k)
                count += at(x + k % 3 - 1, y + k / 3 - 1);
            traced.all += static_cast<std::size_t>(at(x, y));
            if (count == 9)
                traced.inner.push_back(static_cast<std::size_t>(y * width + x));
        }
    }
    return traced;
}

TEST_P(CasesMoving, case09_aCharacterWalksOutWhileTheEyeStaysInside) {
    MovingHut hut;
    PictureWorld pictures(hut.source, options(hut.moving));
    pictures.width = 80;
    pictures.height = 56;
    const Vec3 eyes[] = {{13.2, 11.2, 3.4}, {10.4, 11.9, 3.6}};
    std::size_t steps = 0;
    for (const Vec3& eye : eyes) {
        const frame::FrameView frame = pictures.look(eye, 270, -12, pictures.space(hut.source.id(hut.front)));
        for (double seconds = 16.5; seconds < 20.0;
             seconds += 0.125) { // from x = 11.5 through x = 10 to x = 8
            pictures.setDynamics(dynamicsFor(frame, seconds, 1.0));
            SCOPED_TRACE(::testing::Message() << "eye x " << eye.x << ", " << seconds << " s");
            const Picture picture = pictures.expectClean(frame);
            const Traced traced = tracedPixels(pictures, frame, hut.body);
            for (const std::size_t pixel : traced.inner) {
                const world::Instance* in = shownAs(pictures.world(), picture.ids[pixel]);
                ASSERT_TRUE(in != nullptr && in->record == hut.body) << "pixel " << pixel << " is lost";
            }
            EXPECT_NEAR(static_cast<double>(pixelsOfRecord(pictures, picture, hut.body)),
                        static_cast<double>(traced.all), 8.0);
            steps += traced.inner.size() > 20 ? 1 : 0;
        }
    }
    EXPECT_GT(steps, 20u) << "the character is seen at most steps";
}

TEST_P(CasesMoving, case19_fillingsAreDrawnByTheirStateAndStopTheFloodWhenShut) {
    MovingHut hut;
    PictureWorld pictures(hut.source, options(hut.moving));
    const world::SpaceIndex front = pictures.space(hut.source.id(hut.front)),
                            rear = pictures.space(hut.source.id(hut.rear));
    struct View {
        Vec3 eye;
        double yaw;
        world::SpaceIndex root;
    };
    const View towardsFrontDoor{{6.5, 11.4, 3.4}, 90, world::kOutside},
        fromFront{{12.6, 12.9, 3.4}, 235, front}, towardsInner{{11.5, 11.6, 3.4}, 90, front},
        towardsPane{{21, 12, 3.5}, 270, world::kOutside};
    for (const double doors : {0.0, 0.004, 0.35, 1.0}) {
        SCOPED_TRACE(doors);
        const auto shoot = [&](const View& view) {
            const frame::FrameView frame = pictures.look(view.eye, view.yaw, -4, view.root);
            pictures.setDynamics(dynamicsFor(frame, 1.0, doors));
            return pictures.expectClean(frame, kCountLayers);
        };
        const Picture outside = shoot(towardsFrontDoor), inside = shoot(fromFront),
                      inner = shoot(towardsInner), pane = shoot(towardsPane);
        for (const Picture* picture : {&outside, &inside, &inner})
            EXPECT_GT(pixelsOfRecord(pictures, *picture, hut.leaf), 0u) << "a leaf is visible";
        const bool shut = doors == 0.0;
        EXPECT_EQ(visitsSpace(outside, front), !shut) << "a closed door stops the flood behind it";
        EXPECT_EQ(seesSpace(inner, rear), !shut);
        EXPECT_EQ(visitsSpace(inside, world::kOutside), !shut);
        EXPECT_EQ(inside.stages[2] > 0, !shut) << "and no sky is drawn behind it";
        const auto& visits = inside.visible.visits;
        EXPECT_EQ(std::all_of(visits.begin() + 1, visits.end(), [](const auto& v) { return v.shut; }), shut)
            << "closed doors end their visits";
        EXPECT_TRUE(seesSpace(pane, rear)) << "glass does not end visits";
        EXPECT_GT(
            std::count_if(pane.layers.begin(), pane.layers.end(), [](const auto& l) { return l.count > 0; }),
            20);
    }
}

TEST_P(CasesMoving, case19_aMissingDoorIsAnOpeningAndNoFillingIsPartOfTheShell) {
    MovingHut with, without;
    without.moving.doors.clear();
    PictureWorld filled(with.source, options(with.moving)), open(without.source, options(without.moving));
    ASSERT_EQ(filled.world().instances.size(), open.world().instances.size());
    for (std::size_t i = 0; i < open.world().instances.size(); ++i) {
        const world::Instance &a = filled.world().instances[i], &b = open.world().instances[i];
        EXPECT_EQ(a.record, b.record);
        EXPECT_EQ(filled.world().meshes[a.mesh].polygonCount, open.world().meshes[b.mesh].polygonCount);
    }
    const frame::FrameView frame = open.look({6.5, 11.4, 3.4}, 90, -4, world::kOutside);
    open.setDynamics(dynamicsFor(frame, 1.0, 0.0));
    const Picture picture = open.expectClean(frame);
    EXPECT_TRUE(visitsSpace(picture, open.space(without.source.id(without.front))));
    EXPECT_EQ(pixelsOfRecord(open, picture, without.leaf), 0u);
}

TEST_P(CasesMoving, case19_aDoorThatOpensIsCleanAtEveryStep) {
    MovingHut hut;
    PictureWorld pictures(hut.source, options(hut.moving));
    pictures.width = 72;
    pictures.height = 48;
    const Vec3 eyes[] = {{8.2, 12.2, 3.2}, {11.8, 12.4, 3.6}};
    for (const Vec3& eye : eyes) {
        for (int step = 0; step <= 20; ++step) {
            const auto root = motion::locate(pictures.world(), hut.at(eye)).space;
            const frame::FrameView frame = pictures.look(eye, eye.x < 10 ? 100 : 250, -5, root);
            pictures.setDynamics(dynamicsFor(frame, 5.0 + step * 0.1, step / 20.0));
            SCOPED_TRACE(::testing::Message() << "eye x " << eye.x << ", step " << step);
            pictures.expectClean(frame, kCountLayers);
        }
    }
}

TEST_P(CasesMoving, case17_particlesOfRecordsAndTurningThingsObeyTheRuleThroughDoors) {
    EffectsHut effects;
    dat::ParticleEmitter drift = EffectsHut::emitter(effects.spark); // opaque, into the hut by its front door
    drift.particleType = dat::ParticleType::GlobalVelocity;
    drift.offset = {{1, 0, 0}, 0.0f, 0.4f};
    drift.a = {{1.2f, 0, 0}, 1.0f, 1.0f};
    drift.birthrate = 0.1;
    drift.maxParticles = 30;
    drift.scale = {1.0f, 2.0f, 0.2f};
    dat::ParticleEmitter glow = EffectsHut::emitter(effects.flake); // blended, faces the eye
    glow.particleType = dat::ParticleType::Swarm;
    glow.b = {{2, 3, 1}, 1.0f, 1.0f};
    glow.c = {{0.8f, 0.5f, 0.5f}, 0.5f, 1.0f};
    glow.translucency = {0.3f, 0.9f, 0.0f};
    const std::uint32_t script =
        effects.addScript({{0.0, EffectsHut::create(effects.add(drift))},
                           {0.0, EffectsHut::create(effects.add(glow), 1, {1.2f, 0, -1})}});
    effects.hut.source.addObject(effects.addScripted(script), frameAt({9, 11.5, 3}));
    dat::Animation round;
    round.id = 0x03000060;
    round.partCount = 2;
    for (int k = 0; k < 8; ++k)
        round.frames.push_back({{frameAt({0, 0, 0}), frameAt({0, 0, 1.2}, 45.0 * k)}, {}});
    effects.hut.source.portalFile().add(round);
    dat::Setup mill; // its arm swings through the inner door
    const std::uint32_t arm =
        effects.hut.source.addModel(boxExterior({0.2, -0.05, 0}, {1.2, 0.05, 0.2}, "red"));
    mill.parts = {effects.post, arm};
    mill.animation = round.id;
    effects.hut.source.addStatic(effects.hut.front, effects.hut.source.addSetup(mill),
                                 frameAt({13.4, 11.5, 2}));
    PictureWorld pictures(effects.hut.source, options(effects.hut.moving));
    pictures.width = 80;
    pictures.height = 56;
    const world::SpaceIndex front = pictures.space(effects.hut.source.id(effects.hut.front)),
                            rear = pictures.space(effects.hut.source.id(effects.hut.rear));
    std::size_t sparks = 0, arms = 0, layered = 0;
    for (int step = 0; step < 12; ++step) {
        const double doors = step % 4 == 3 ? 0.0 : 1.0, seconds = 20.0 + step * 0.0707;
        for (const auto& [eye, yaw, root] : {std::tuple{Vec3(7, 11.4, 3.4), 90.0, world::kOutside},
                                             {Vec3(13, 12.5, 3.6), 250.0, front},
                                             {Vec3(16, 11.6, 3.5), 270.0, rear}}) {
            const frame::FrameView frame = pictures.look(eye, yaw, -6, root);
            pictures.setDynamics(dynamicsFor(frame, seconds, doors));
            SCOPED_TRACE(::testing::Message() << "eye x " << eye.x << ", step " << step);
            const Picture picture = pictures.expectClean(frame, kCountLayers);
            sparks +=
                static_cast<std::size_t>(std::count_if(picture.ids.begin(), picture.ids.end(), [&](auto id) {
                    return id >= pictures.world().spriteIds;
                }));
            arms += pixelsOfRecord(pictures, picture, arm);
            layered += static_cast<std::size_t>(std::count_if(picture.layers.begin(), picture.layers.end(),
                                                              [](const auto& l) { return l.count > 0; }));
        }
    }
    EXPECT_GT(sparks, 500u);
    EXPECT_GT(arms, 500u);
    EXPECT_GT(layered, 500u);
}

/// The hut with more transparent surfaces: static glow and smoke in both rooms and before the door, a glowing
/// lantern, and panes outside any opening, one in the rear room, one in the meadow, each part of a setup.
struct ShiningHut : MovingHut {
    std::uint32_t glassPart = 0;
    ShiningHut() {
        const std::uint32_t glow =
            source.solid("glow", 0xFFFFC060u, dat::Surface::kAdditive | dat::Surface::kTranslucent, 0.5f);
        for (world::EmitterEntry& emitter : moving.emitters)
            emitter.rate = 12;
        const auto add = [&](const char* name, const Vec3& position, dat::RecordId cell,
                             std::uint32_t surface, const char* carrier) {
            world::EmitterEntry flame;
            flame.name = name;
            flame.attachedTo = carrier;
            flame.surface = surface;
            flame.cell = cell;
            flame.position = position;
            flame.velocity = {0, 0, 0.6};
            flame.spread = 0.3;
            flame.rate = 9;
            flame.life = 1.2;
            flame.size = {0.35, 0.1};
            moving.emitters.push_back(flame);
        };
        add("hearth", at({12, 13, 2.5}), source.id(front), glow, "");
        add("candle", at({16.5, 12.2, 3}), source.id(rear), source.surfaceId("glass"), "");
        add("torch", at({9.7, 12.4, 3.2}), 0, glow, "");
        add("sparks", {-0.3, 0.3, 1.4}, 0, glow, "anna");
        glassPart = source.addModel(boxExterior({-0.4, -0.02, 0}, {0.4, 0.02, 1.2}, "glass"));
        dat::Setup screen;
        screen.parts = {table, glassPart};
        dat::AnimationFrame pose;
        pose.parts = {frameAt({0, 0, 0}), frameAt({0, 0.1, 0.8}, 20)};
        screen.placementFrames = {{0x65, pose}};
        const std::uint32_t setup = source.addSetup(screen);
        source.addStatic(rear, setup, frameAt({16, 11.3, 2}, 90));
        source.addObject(setup, frameAt({7.5, 12.6, 2}, 60));
        source.addStatic(front, setup, frameAt({11, 11.5, 2}, 0)); // stands through the front door
    }
};

TEST_P(CasesMoving, case17_everyLayerOnceWhateverItIsAttachedTo) {
    ShiningHut hut;
    PictureWorld pictures(hut.source, options(hut.moving));
    const Vec3 eyes[] = {
        {6.2, 11.6, 3.5}, {11.6, 12.6, 3.6}, {16.2, 12.6, 3.4}, {21, 12.3, 3.6}, {10.01, 11.6, 3.5}};
    std::set<std::uint32_t> met;
    std::size_t withLayers = 0, deep = 0;
    for (int step = 0; step < 25; ++step) {
        const Vec3& eye = eyes[step % 5];
        const double doors = step % 3 == 0 ? 0.0 : step % 3 == 1 ? 0.45 : 1.0;
        const auto root = motion::locate(pictures.world(), hut.at(eye)).space;
        const double turn = eye.x > 15 ? 270 : 88;
        const frame::FrameView frame =
            pictures.look(eye, turn + (step % 2 == 0 ? 0.0 : 180.0 * (eye.x > 11 && eye.x < 12)), -6, root);
        pictures.setDynamics(dynamicsFor(frame, 4.0 + step * 0.47, doors));
        SCOPED_TRACE(::testing::Message() << "step " << step);
        const Picture picture = pictures.expectClean(frame, kCountLayers);
        for (const gpu::LayerSum& layers : picture.layers) {
            withLayers += layers.count > 0 ? 1 : 0;
            deep += layers.count > 3 ? 1 : 0;
        }
        for (std::uint32_t y = 0; y < frame.height; y += 3) {
            for (std::uint32_t x = 0; x < frame.width; x += 3) {
                const auto layers = pictures.tracer().trace(root, rayThrough(frame, x, y)).layers;
                met.insert(layers.begin(), layers.end());
            }
        }
    }
    EXPECT_GT(withLayers, 4000u);
    EXPECT_GT(deep, 200u) << "several, one behind another";
    EXPECT_GT(met.size(), 60u) << "of many sprites and panes";
}

TEST_P(CasesMoving, case17_theNearerOfTwoPanesIsBlendedLast) {
    // A red and a blue pane, both nearly opaque, on opposite sides of the plane of a door between two rooms.
    TestWorld world;
    const auto west = world.addBox({0, 0, 10}, {4, 4, 13}, "grey");
    const auto east = world.addBox({4, 0, 10}, {8, 4, 13}, "grey");
    world.link(west, rectangle({4, 1, 10}, {4, 3, 12}), east);
    world.solid("red pane", 0xFFFF0000u, dat::Surface::kTranslucent, 0.15f);
    world.solid("blue pane", 0xFF0000FFu, dat::Surface::kTranslucent, 0.15f);
    const auto pane = [&](const char* name) {
        return world.addModel(boxExterior({-0.01, -0.9, 0}, {0.01, 0.9, 1.8}, name));
    };
    world.addStatic(west, pane("red pane"), frameAt({3.0, 2, 10.1}));
    world.addStatic(east, pane("blue pane"), frameAt({5.0, 2, 10.1}));
    PictureWorld pictures(world, options());
    const auto middle = [&](const Vec3& eye, double yaw, TestWorld::Cell root) {
        const frame::FrameView frame = pictures.look(eye, yaw, 0, pictures.space(world.id(root)));
        const Picture picture = pictures.expectClean(frame);
        const std::size_t at = (pictures.height / 2 * pictures.width + pictures.width / 2) * 4;
        return Vec3(picture.colour[at], picture.colour[at + 1], picture.colour[at + 2]);
    };
    const Vec3 fromWest = middle({1, 2, 11}, 90, west), fromEast = middle({7, 2, 11}, 270, east);
    EXPECT_GT(fromWest.x, 2.5 * fromWest.z) << "red before blue";
    EXPECT_GT(fromEast.z, 2.5 * fromEast.x) << "blue before red";
    EXPECT_GT(fromWest.z, fromWest.y) << "the surface behind shines through";
}

TEST_P(CasesMoving, case17_noLayerBeforeItsOpeningIsTakenForOneBehind) {
    // A flame on each side of a closed door, visible only from its own side.
    MovingHut hut;
    hut.moving.villagers.clear();
    hut.moving.emitters.erase(hut.moving.emitters.begin() + 1, hut.moving.emitters.end());
    hut.moving.emitters[0].rate = 20;
    hut.moving.emitters[0].position = hut.at({9.95, 11.5, 2.6});
    PictureWorld pictures(hut.source, options(hut.moving));
    const auto layered = [&](const Vec3& eye, double yaw, double doors) {
        const frame::FrameView frame =
            pictures.look(eye, yaw, -5, motion::locate(pictures.world(), hut.at(eye)).space);
        pictures.setDynamics(dynamicsFor(frame, 3.3, doors));
        const Picture picture = pictures.expectClean(frame, kCountLayers);
        return std::count_if(picture.layers.begin(), picture.layers.end(),
                             [](const auto& l) { return l.count > 0; });
    };
    EXPECT_GT(layered({6.5, 11.5, 3.4}, 90, 0.0), 100);
    EXPECT_EQ(layered({13, 11.5, 3.4}, 270, 0.0), 0) << "closed";
    EXPECT_GT(layered({13, 11.5, 3.4}, 270, 1.0), 100);
}

TEST_P(CasesMoving, case27_aStandingEyeAndAFrozenMomentGiveTheSameBits) {
    ShiningHut hut;
    PictureWorld pictures(hut.source, options(hut.moving));
    const Vec3 eyes[] = {{6.2, 11.6, 3.5}, {11.6, 12.6, 3.6}, {10.0, 11.4, 3.5}};
    for (const Vec3& eye : eyes) {
        const auto root = motion::locate(pictures.world(), hut.at(eye)).space;
        const frame::FrameView frame = pictures.look(eye, 93, -6, root);
        const motion::DynamicStateInput still = dynamicsFor(frame, 6.1, 0.5, root == world::kOutside);
        pictures.setDynamics(still);
        const Picture first = pictures.expectClean(frame);
        // A different state and view drawn in between must have no effect.
        const frame::FrameView away = pictures.look(eye, 270, 0, root);
        pictures.setDynamics(dynamicsFor(away, 9.7, 1.0));
        const Picture other = pictures.shoot(away);
        EXPECT_FALSE(other.ids == first.ids);
        pictures.setDynamics(still);
        for (int i = 0; i < 3; ++i) {
            const Picture next = pictures.shoot(frame);
            EXPECT_TRUE(next.ids == first.ids && next.depth == first.depth && next.colour == first.colour);
        }
        pictures.setDynamics(dynamicsFor(frame, 6.2, 0.5, root == world::kOutside));
        EXPECT_FALSE(pictures.shoot(frame).colour == first.colour) << "later something has moved";
    }
}

} // namespace
} // namespace limen::test
