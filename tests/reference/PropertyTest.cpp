// Properties of every ray.
#include "reference/DynamicStateMaker.h"

#include <random>
#include <rapidcheck/gtest.h>

namespace limen::test {
namespace {

using reference::Answer;

/// A number between 0 and `most` with 20 binary places: adding whole landblocks keeps it exact.
double onGrid(std::mt19937& random, double most) {
    return std::floor(std::uniform_real_distribution<double>(0, most)(random) * 1048576.0) / 1048576.0;
}

struct Complex {
    TestWorld source;
    std::vector<TestWorld::Cell> cells;
    Complex(dat::BlockCoord home, unsigned seed) : source(home) {
        std::mt19937 random(seed);
        source.setFlatTerrain(home, 0);
        std::vector<TestWorld::Portal> exits;
        for (int i = 0; i < 3; ++i)
            cells.push_back(source.addBox({80.0 + i * 5, 80, 0.5}, {85.0 + i * 5, 86, 4}));
        for (std::size_t i = 0; i < 2; ++i) {
            const double x = 85.0 + 5 * static_cast<double>(i), y = 81 + onGrid(random, 3);
            source.link(cells[i], rectangle({x, y, 0.5}, {x, y + 1.25, 2.5}), cells[i + 1]);
        }
        for (const auto cell : cells) {
            const double x = 81 + 5.0 * static_cast<double>(cell) + onGrid(random, 1.5);
            exits.push_back(source.openOutside(cell, rectangle({x, 80, 1}, {x + 1.5, 80, 2.5})));
            exits.push_back(source.openOutside(cell, rectangle({x, 86, 1}, {x + 1.5, 86, 3})));
        }
        source.addBuilding(boxExterior({80, 80, -1}, {95, 86, 4.5}), exits);
        source.addObject(source.addModel(insideOut(boxWalls({-0.5, -0.5, 0}, {0.5, 0.5, 2}, "pink"))),
                         frameAt({85 + onGrid(random, 4), 80, 0.5}, 30));
    }
};

struct RandomRay {
    world::SpaceIndex root = world::kOutside;
    Vec3 eye{0.0}, direction{0.0};
};
RandomRay randomRay(std::mt19937& random, std::size_t cells) {
    RandomRay ray;
    ray.root = static_cast<world::SpaceIndex>(random() % (cells + 1)); // cells follow the outside
    ray.eye = ray.root == world::kOutside
                  ? Vec3(70 + onGrid(random, 35), (random() % 2 ? 60 : 87) + onGrid(random, 19),
                         0.25 + onGrid(random, 6))
                  : Vec3(75 + 5.0 * ray.root + onGrid(random, 5), 80 + onGrid(random, 6),
                         0.5 + onGrid(random, 3.5));
    ray.direction = Vec3(onGrid(random, 2) - 1, onGrid(random, 2) - 1, onGrid(random, 0.5) - 0.25);
    return ray;
}

RC_GTEST_PROP(ReferenceProperty, wholeLandblocksAwayTheAnswersAreTheSame, (unsigned seed)) {
    Complex here({0, 1}, seed), there({0xC8, 0xF0}, seed);
    const TracedWorld a(here.source, {.radius = 0}), b(there.source, {.radius = 0});
    std::mt19937 random(seed);
    for (int i = 0; i < 300; ++i) {
        const RandomRay ray = randomRay(random, here.cells.size());
        const Answer x = a.trace(ray.root, ray.eye, ray.direction),
                     y = b.trace(ray.root, ray.eye, ray.direction);
        // The division of the ground into triangles depends on the block; its surface does not.
        const bool ground = x.id > 1 && a.kindOf(x.id) == world::InstanceKind::Terrain;
        const bool agree = ground ? y.id > 1 && b.kindOf(y.id) == world::InstanceKind::Terrain : x.id == y.id;
        RC_ASSERT(agree);
        RC_ASSERT(x.space == y.space);
        RC_ASSERT(x.spacesVisited == y.spacesVisited);
        RC_ASSERT(x.id <= 1 || std::abs(x.t - y.t) <= 1e-9 * (1.0 + x.t));
    }
}

RC_GTEST_PROP(ReferenceProperty, aStepAlongTheRayWithinItsSpaceShortensItByThatStep, (unsigned seed)) {
    Complex complex({0x20, 0x30}, seed);
    const TracedWorld traced(complex.source, {.radius = 0});
    std::mt19937 random(seed);
    std::size_t stepped = 0;
    for (int i = 0; i < 300; ++i) {
        const RandomRay ray = randomRay(random, complex.cells.size());
        const Answer whole = traced.trace(ray.root, ray.eye, ray.direction, 0.0);
        if (whole.id <= 1 || whole.spacesVisited > 1)
            continue;
        const double step = whole.t * std::uniform_real_distribution<double>(0.1, 0.9)(random);
        const Answer rest = traced.trace(ray.root, ray.eye + ray.direction * step, ray.direction, 0.0);
        RC_ASSERT(rest.id == whole.id);
        RC_ASSERT(std::abs(rest.t + step - whole.t) < 1e-9 * (1.0 + whole.t));
        ++stepped;
    }
    RC_ASSERT(stepped > 50u);
}

RC_GTEST_PROP(ReferenceProperty, theLengthOfTheDirectionOnlyScalesT, (unsigned seed)) {
    Complex complex({0x20, 0x30}, seed);
    const TracedWorld traced(complex.source, {.radius = 0});
    std::mt19937 random(seed);
    for (int i = 0; i < 300; ++i) {
        const RandomRay ray = randomRay(random, complex.cells.size());
        const double factor = std::ldexp(1.0, static_cast<int>(random() % 9) - 4);
        const Answer plain = traced.trace(ray.root, ray.eye, ray.direction, 0.0);
        const Answer scaled = traced.trace(ray.root, ray.eye, ray.direction * factor, 0.0);
        RC_ASSERT(plain.id == scaled.id);
        RC_ASSERT(plain.spacesVisited == scaled.spacesVisited);
        RC_ASSERT(plain.id <= 1 || std::abs(plain.t - scaled.t * factor) <= 1e-12 * (1.0 + plain.t));
    }
}

} // namespace
} // namespace limen::test
