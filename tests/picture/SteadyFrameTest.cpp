// A steady frame allocates nothing on the heap in visibility and frame: counted, over a warm path, by
// replacing the program's allocation functions.
#include "picture/PictureWorld.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

namespace {

std::size_t allocations = 0;

} // namespace

void* operator new(std::size_t size) {
    ++allocations;
    if (void* memory = std::malloc(size == 0 ? 1 : size)) {
        return memory;
    }
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace limen::test {
namespace {

TEST(SteadyFrame, allocatesNothing) {
    TestWorld world;
    world.setFlatTerrain(world.home(), 0);
    const auto room = world.addBox({90, 80, 0}, {96, 86, 3}, "brown");
    const auto closet = world.addBox({96, 80, 0}, {99, 86, 3}, "blue");
    world.link(room, rectangle({96, 82, 0}, {96, 83, 2}), closet);
    const auto exit = world.openOutside(room, rectangle({92, 86, 0.1}, {93.2, 86, 2.1}));
    world.addBuilding(boxExterior({90, 80, 0}, {99, 86, 3}), {exit});
    PictureWorld pictures(world, {false, 1});
    visibility::VisibleSet visible;
    frame::FramePlan plan;
    const auto walk = [&] {
        for (double yaw = 0; yaw < 360; yaw += 20) {
            pictures.plan(pictures.look({92.3, 82.1, 1.6}, yaw, 0, pictures.space(world.id(room))), visible,
                          plan);
            pictures.plan(pictures.look({92.3, 92.1, 1.6}, yaw, 0, world::kOutside), visible, plan);
        }
    };
    walk();
    const std::size_t before = allocations;
    EXPECT_GT(before, 0u) << "the counter counts";
    walk();
    EXPECT_EQ(allocations, before);
}

} // namespace
} // namespace limen::test
