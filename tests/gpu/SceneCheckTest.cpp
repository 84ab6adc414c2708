#include "gpu/scene/SceneCheck.h"

#include "SceneBuilder.h"

#include <gtest/gtest.h>

#include <functional>

namespace limen::gpu::test {
namespace {

SceneBuilder goodScene() {
    SceneBuilder scene;
    scene.root(0);
    const std::uint32_t texture = scene.addTexture(1, 1, {1, 2, 3, 4});
    scene.addWall('A', {-1, -1}, {1, 1}, 1, {.material = scene.addMaterial({1, 1, 1, 1}, texture)});
    scene.upload.terrainCells.resize(1);
    scene.upload.lamps = 2;
    scene.upload.lampRefs = {1, 0};
    scene.upload.lightSets[0].lampCount = 2;
    return scene;
}

TEST(SceneCheck, goodSceneAndEmptySceneAreSound) {
    EXPECT_TRUE(checkScene(goodScene().upload));
    EXPECT_TRUE(checkScene({}));
}

TEST(SceneCheck, eachInvalidIndexIsFound) {
    using Scene = frame::SceneUpload;
    const std::vector<std::pair<std::string, std::function<void(Scene&)>>> faults{
        {"instance 0", [](Scene& s) { s.instances[0].membersAndKind = 0; }},
        {"instance 0", [](Scene& s) { s.instances[0].firstMember = 0xFFFFFFFFu; }},
        {"member 0", [](Scene& s) { s.members[0].lightSet = 1; }},
        {"index 5", [](Scene& s) { s.indices[5] = 6; }},
        {"piece 0", [](Scene& s) { s.pieces[0].triangles = 3; }},
        {"piece 0", [](Scene& s) { s.pieces[0].triangles = layout::kTrianglesPerPiece + 1; }},
        {"piece 0", [](Scene& s) { s.pieces[0].firstIndex = 0xFFFFFFFFu; }},
        {"piece 0", [](Scene& s) { s.pieces[0].instance = 1; }},
        {"piece 0", [](Scene& s) { s.pieces[0].indicesBefore = 3; }},
        {"material reference 0", [](Scene& s) { s.materialRefs[0] = 2; }},
        {"material 1", [](Scene& s) { s.materials[1].texture = 1; }},
        {"terrain cell 0", [](Scene& s) { s.terrainCells[0].base.texture = 1; }},
        {"terrain cell 0",
         [](Scene& s) {
             s.terrainCells[0].overlays[2] = {0, 7, 0, 1};
         }},
        {"terrain cell 0", [](Scene& s) { s.terrainCells[0].roads[1].texture = 7; }},
        {"light set 0", [](Scene& s) { s.lightSets[0].firstLamp = 1; }},
        {"light set 0", [](Scene& s) { s.lightSets[0].lampCount = 3; }},
        {"lamp reference 0", [](Scene& s) { s.lampRefs[0] = 2; }},
        {"texture 0", [](Scene& s) { s.textures[0].height = 2; }},
        {"texture 0", [](Scene& s) { s.textures[0].width = 0; }}};
    for (const auto& [entry, damage] : faults) {
        SceneBuilder scene = goodScene();
        damage(scene.upload);
        const Result<void> checked = checkScene(scene.upload);
        ASSERT_FALSE(checked) << entry;
        EXPECT_EQ(checked.error().where, entry + " of the scene");
    }
}

} // namespace
} // namespace limen::gpu::test
