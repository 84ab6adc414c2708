#pragma once

#include "DrawnPart.h"
#include "frames/FrameWay.h"
#include "motion/DynamicStateBuilder.h"
#include "support/MovingHut.h"

namespace limen::bench::test {

/// The moving hut, with a post of two levels of detail beside it, as frames of a benchmark take it.
struct ComparedWorld {
    /// The distance in the post's record at which it changes to its second level, and the eye's distance
    /// there, metres.
    static constexpr float kChange = 8.0f;
    static constexpr double kChangesAt = kChange + world::kDegradeDistance;
    static constexpr Vec3 kPost{6, 14, 2}; ///< block-local

    limen::test::MovingHut hut;
    limen::test::TempDir directory;
    std::optional<dat::Archive> archive;
    world::WorldFile file;
    world::Place inRoom, outside;

    ComparedWorld() {
        using limen::test::boxExterior;
        using limen::test::frameAt;
        const std::uint32_t thin = hut.source.addModel(boxExterior({-0.2, -0.2, 0}, {0.2, 0.2, 3}, "oak"));
        Walls fine = boxExterior({-0.3, -0.3, 0}, {0.3, 0.3, 1.5}, "oak");
        const Walls top = boxExterior({-0.2, -0.2, 1.5}, {0.2, 0.2, 3}, "red");
        fine.insert(fine.end(), top.begin(), top.end());
        const std::uint32_t post = hut.source.addModel(
            fine, {{limen::test::TestWorld::kItself, dat::DegradeLevel::kMesh, 0, kChange, kChange},
                   {thin, dat::DegradeLevel::kMesh, 0, 60, 60}});
        hut.source.addObject(post, frameAt(kPost));
        file.moving = hut.moving;
        EXPECT_TRUE(hut.source.write(directory.path()));
        Result<dat::Archive> opened = dat::Archive::open(directory.path());
        EXPECT_TRUE(opened);
        archive.emplace(std::move(*opened));
        inRoom = {"in the room", hut.at({12.5, 12.2, 3.6}), 250.0, -5.0, hut.source.id(hut.front)};
        outside = {"outside", hut.at({17, 24, 3.7}), 165.0, -4.0, 0}; // no smoke in view, which has no depth
    }
    using Walls = limen::test::Walls;

    [[nodiscard]] FramePlace placeAt(const world::Place& from, std::uint32_t width, std::uint32_t height) {
        Result<std::shared_ptr<const engine::LoadedPart>> part = loadAround(*archive, file, from);
        EXPECT_TRUE(part) << (part ? "" : part.error().message());
        FramePlace place;
        place.view = viewFrom(**part, from, width, height);
        motion::DynamicStateBuilder((*part)->world).build(dynamicsFor(place.view), place.dynamics);
        place.part = *part;
        return place;
    }
};

} // namespace limen::bench::test
