#pragma once

#include "world/World.h"

#include <array>
#include <cmath>
#include <random>

namespace limen::test {

/// Two spaces with spheres of all sizes; every ninth is in both spaces, every eleventh in none.
inline world::World spheresInTwoSpaces(std::uint32_t count, std::uint32_t seed) {
    world::World world;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::array<std::vector<world::InstanceIndex>, 2> lists;
    for (std::uint32_t i = 0; i < count; ++i) {
        world::Instance instance;
        instance.bounds = {Vec3(unit(random), unit(random), 0.1 * unit(random)) * 400.0,
                           std::exp(8.0 * unit(random) - 3.0)};
        if (i % 5 == 0)
            instance.bounds.centre = {7.0, 7.0, 7.0}; // many in one place
        instance.firstMember = static_cast<std::uint32_t>(world.members.size());
        const auto join = [&](std::uint32_t space) {
            world.members.push_back(space);
            lists[space].push_back(i);
            ++instance.memberCount;
        };
        if (i % 9 == 0) {
            join(1);
            join(0);
        } else if (i % 11 != 0) {
            join(i % 2);
        }
        world.instances.push_back(instance);
    }
    for (const auto& list : lists) {
        world::Space space;
        space.firstInstance = static_cast<std::uint32_t>(world.spaceInstances.size());
        space.instanceCount = static_cast<std::uint32_t>(list.size());
        space.zone = static_cast<std::uint32_t>(world.spaces.size());
        world.spaces.push_back(space);
        world.spaceInstances.insert(world.spaceInstances.end(), list.begin(), list.end());
    }
    return world;
}

/// The same with levels of detail: two thirds of the instances are drawn at some distances only, in one block.
inline world::World spheresWithLevels(std::uint32_t count, std::uint32_t seed) {
    world::World world = spheresInTwoSpaces(count, seed);
    world.blocks.emplace_back();
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (std::uint32_t i = 0; i < count; ++i) {
        world::Instance& instance = world.instances[i];
        instance.block = 0;
        instance.bounds.radius = std::min(instance.bounds.radius, 10.0);
        if (i % 3 == 0)
            continue;
        const double from = i % 2 == 0 ? 0.0 : 50.0 + 250.0 * unit(random);
        const double upTo = i % 5 == 0 ? 1e9 : from + 50.0 + 100.0 * unit(random);
        const Vec3 origin = instance.bounds.centre + Vec3(unit(random), unit(random), unit(random)) * 5.0;
        instance.level = static_cast<std::uint32_t>(world.levels.size());
        world.levels.push_back({{world::levelRangeLimit(from), world::levelRangeLimit(upTo)},
                                i % 4 < 2 ? world::LevelMeasure::Landcell : world::LevelMeasure::Object,
                                world::localRangeSteps(origin)});
    }
    return world;
}

} // namespace limen::test
