#pragma once

#include "world/World.h"

#include <algorithm>
#include <string>

// Header-only, for tests that link limen::world.
namespace limen::test {

/// Names of the arrays in which two worlds differ, and of the differing parts of the sky; empty if equal.
[[nodiscard]] inline std::string differenceOf(const world::World& a, const world::World& b) {
    std::string names;
    const auto compare = [&](const char* name, bool isSame) {
        names += isSame ? "" : std::string(name) + " ";
    };
#define LIMEN_SAME(array) compare(#array, a.array == b.array)
    LIMEN_SAME(blocks);
    LIMEN_SAME(spaces);
    LIMEN_SAME(portals);
    LIMEN_SAME(portalCorners);
    LIMEN_SAME(portalVertices);
    LIMEN_SAME(zones);
    LIMEN_SAME(zoneSpaces);
    LIMEN_SAME(cellBspNodes);
    LIMEN_SAME(vertices);
    LIMEN_SAME(indices);
    LIMEN_SAME(polygonIds);
    LIMEN_SAME(meshes);
    LIMEN_SAME(instances);
    LIMEN_SAME(members);
    LIMEN_SAME(spaceInstances);
    LIMEN_SAME(materials);
    LIMEN_SAME(materialRefs);
    LIMEN_SAME(terrainCells);
    LIMEN_SAME(details);
    LIMEN_SAME(lights);
    LIMEN_SAME(lampRefs);
    LIMEN_SAME(lightSets);
    LIMEN_SAME(instanceLightSets);
    LIMEN_SAME(movingParts);
    LIMEN_SAME(posedParts);
    LIMEN_SAME(cycles);
    LIMEN_SAME(stretches);
    LIMEN_SAME(partFrames);
    LIMEN_SAME(doors);
    LIMEN_SAME(leaves);
    LIMEN_SAME(routes);
    LIMEN_SAME(routePoints);
    LIMEN_SAME(villagers);
    LIMEN_SAME(emitters);
    LIMEN_SAME(player);
    LIMEN_SAME(looseObjects);
    LIMEN_SAME(rainDrop);
    LIMEN_SAME(spriteIds);
    LIMEN_SAME(findings);
    LIMEN_SAME(idEnd);
#undef LIMEN_SAME
    compare("textures", std::equal(a.textures.begin(), a.textures.end(), b.textures.begin(), b.textures.end(),
                                   [](const auto& one, const auto& other) { return *one == *other; }));
    compare("sky", std::equal(a.sky.parts.begin(), a.sky.parts.end(), b.sky.parts.begin(), b.sky.parts.end(),
                              [](const world::SkyPart& one, const world::SkyPart& other) {
                                  return one.mesh == other.mesh && one.firstMaterial == other.firstMaterial &&
                                         one.object.object == other.object.object;
                              }));
    return names;
}

} // namespace limen::test
