#pragma once

#include "support/MovingHut.h"

namespace limen::test {

inline constexpr std::uint32_t kPuppetStyle = 0x8000003D, kPuppetStands = 0x41000003,
                               kPuppetWalks = 0x45000005, kPuppetRuns = 0x44000007;

/// A moving hut whose villager is a Setup of two parts, a trunk and a leg that hangs from its joint, without
/// motions. Tests fill in `setup` and `table`, which are written when it is loaded.
struct Puppet {
    MovingHut hut;
    dat::Setup setup;
    dat::MotionTable table;
    std::uint32_t trunk = hut.source.addModel(boxExterior({-0.25, -0.2, 0.8}, {0.25, 0.2, 1.75}, "coat"));
    std::uint32_t leg = hut.source.addModel(boxExterior({-0.05, -0.1, -0.9}, {0.05, 0.1, 0}, "boot"));

    Puppet() {
        setup.parts = {trunk, leg};
        dat::AnimationFrame rest;
        rest.parts = {frameAt({0, 0, 0}), frameAt({0, 0, 0.9})};
        setup.placementFrames = {{dat::Setup::kPlacementResting, rest}};
        setup.motionTable = 0x09000001;
        table.id = 0x09000001;
        table.defaultStyle = kPuppetStyle;
        table.styleDefaults = {{kPuppetStyle, kPuppetStands}};
    }

    /// Replaces its parts; from the third on, parts rest at the body's origin.
    void setParts(std::vector<std::uint32_t> parts) {
        setup.placementFrames.front().second.parts.resize(parts.size(), frameAt({0, 0, 0}));
        setup.parts = std::move(parts);
    }
    /// Adds an animation, a pose of all parts for each frame, and yields its id.
    std::uint32_t animation(const std::vector<std::vector<dat::Frame>>& frames) {
        dat::Animation animation;
        animation.id = nextAnimation_++;
        animation.partCount = frames.empty() ? 0 : static_cast<std::uint32_t>(frames.front().size());
        for (const auto& parts : frames)
            animation.frames.push_back({parts, {}});
        hut.source.portalFile().add(animation);
        return animation.id;
    }
    /// An animation of `count` frames; in frame k the leg's joint is k/10 m ahead.
    std::uint32_t sliding(int count) {
        std::vector<std::vector<dat::Frame>> frames;
        for (int k = 0; k < count; ++k)
            frames.push_back({frameAt({0, 0, 0}), frameAt({0, 0.1 * k, 0.9})});
        return animation(frames);
    }
    /// Gives the default style a cycle.
    void cycle(std::uint32_t substate, std::vector<dat::AnimationRange> ranges,
               const Vec3f& velocity = Vec3f(0.0f)) {
        dat::MotionData data;
        data.animations = std::move(ranges);
        data.velocity = velocity;
        data.flags = velocity != Vec3f(0.0f) ? dat::MotionData::kVelocity : std::uint8_t{0};
        table.cycles.emplace_back(dat::motionKey(kPuppetStyle, substate), data);
    }
    [[nodiscard]] world::World load(const world::LoadOptions& options = {}) {
        hut.source.portalFile().add(table);
        hut.moving.villagers[0].model = hut.source.addSetup(setup);
        return hut.load(options);
    }

private:
    std::uint32_t nextAnimation_ = 0x03000001;
};

/// Turned about +x, in degrees: the hanging leg swings forward.
[[nodiscard]] inline dat::Frame swungAt(const Vec3& origin, double degrees) {
    const double half = degrees * 3.14159265358979323846 / 360.0;
    return {Vec3f(origin),
            Quatf(static_cast<float>(std::cos(half)), static_cast<float>(std::sin(half)), 0.0f, 0.0f)};
}

} // namespace limen::test
