#pragma once

#include "support/TemporaryDirectory.h"

#include "dat/Archive.h"
#include "engine/Pipeline.h"
#include "motion/Locate.h"
#include "world/Loader.h"
#include "world/Places.h"
#include "worlds/Demo.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <gtest/gtest.h>

namespace limen::test {

/// The tour of the built-in world, every `step`th place, and the part of the world around its first.
struct Tour {
    std::vector<world::Place> way;
    std::optional<world::World> world;

    explicit Tour(std::size_t step) {
        const TemporaryDirectory directory;
        EXPECT_TRUE(worlds::writeBuiltInWorld(directory.path()));
        const auto archive = dat::Archive::open(directory.path());
        const auto file = world::loadWorldFile(directory.path());
        EXPECT_TRUE(archive && file && !file->tour.empty());
        for (std::size_t i = 0; i < file->tour.size(); i += step)
            way.push_back(file->tour[i]);
        auto loaded = world::loadWorld(*archive, world::blockAt(way.front().eye), {}, file->moving);
        EXPECT_TRUE(loaded) << loaded.error().message();
        world.emplace(std::move(*loaded));
    }
};

/// The built-in world around its first place, drawn on some device as every verb draws it.
class SteadyWalk {
public:
    /// Pictures of `width` × `height` pixels.
    SteadyWalk(world::World world, gpu::Device& device, std::uint32_t width, std::uint32_t height,
               const gpu::RendererOptions& options = {})
        : pipeline_(device, options), target_(*gpu::RenderTarget::create(device, width, height)) {
        EXPECT_TRUE(pipeline_.show(std::make_unique<engine::PartPlanner>(*engine::partOf(std::move(world)))));
    }

    /// Draws the views of the way while doors move, people walk, and it rains; each frame with ids and without.
    void go(std::span<const world::Place> way) {
        double seconds = 100.0;
        for (const world::Place& place : way) {
            if (world::findBlock(pipeline_.part().world, world::blockAt(place.eye)) == nullptr)
                continue; // not loaded from here
            const world::SpaceIndex root = motion::locate(pipeline_.part().world, place.eye).space;
            inside_ += root != world::kOutside ? 1 : 0;
            seconds += 0.37;
            draw(frame::makeView(place.eye, place.yaw, place.pitch, 75.0, target_.width(), target_.height(),
                                 root),
                 seconds);
            ++frames_;
        }
    }
    [[nodiscard]] std::size_t frames() const { return frames_; }
    /// Those of them from within cells.
    [[nodiscard]] std::size_t inside() const { return inside_; }

    /// GL calls of a frame.
    [[nodiscard]] std::uint32_t mostCalls() const { return mostCalls_; }

private:
    void draw(const frame::FrameView& view, double seconds) {
        motion::DynamicStateInput input;
        input.seconds = seconds;
        input.allDoors = 0.5 + 0.5 * std::sin(seconds);
        input.rain = view.view.root == world::kOutside;
        input.eye = view.view.eye;
        input.right = view.view.right;
        input.up = view.view.up;
        input.forward = view.view.forward;
        pipeline_.updateDynamics(input);
        EXPECT_TRUE(pipeline_.flood(view.view));
        pipeline_.plan(view);
        for (const bool ids : {false, true}) {
            EXPECT_TRUE(pipeline_.render(target_, {.wantIds = ids}));
            mostCalls_ = std::max(mostCalls_, pipeline_.renderer().report().glCalls);
        }
    }

    engine::Pipeline pipeline_;
    gpu::RenderTarget target_;
    std::size_t frames_ = 0, inside_ = 0;
    std::uint32_t mostCalls_ = 0;
};

} // namespace limen::test
