#include "output/Gltf.h"

#include "support/LoadTestWorld.h"
#include "world/Single.h"

#include <gtest/gtest.h>

#include <numeric>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wconversion"
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>
#pragma GCC diagnostic pop

namespace limen::output {
namespace {

/// Keeps the encoded pictures without decoding them.
bool keepImage(tinygltf::Image* image, int, std::string*, std::string*, int, int, const unsigned char* bytes,
               int size, void*) {
    image->image.assign(bytes, bytes + size);
    return true;
}

tinygltf::Model readBack(const std::string& bytes) {
    tinygltf::TinyGLTF gltf;
    gltf.SetImageLoader(keepImage, nullptr);
    tinygltf::Model model;
    std::string error, warning;
    EXPECT_TRUE(gltf.LoadBinaryFromMemory(&model, &error, &warning,
                                          reinterpret_cast<const unsigned char*>(bytes.data()),
                                          static_cast<unsigned>(bytes.size())))
        << error;
    EXPECT_EQ(error + warning, "");
    return model;
}

world::World modelWorld(test::TestWorld& source, dat::RecordId id) {
    const test::TempDir directory;
    EXPECT_TRUE(source.write(directory.path()));
    const Result<dat::Archive> archive = dat::Archive::open(directory.path());
    Result<world::World> world = world::loadModel(*archive, id);
    EXPECT_TRUE(world) << (world ? "" : world.error().message());
    return world ? std::move(*world) : world::World{};
}

Result<std::string> encodeAll(const world::World& world) {
    std::vector<world::InstanceIndex> all(world.instances.size());
    std::iota(all.begin(), all.end(), 0u);
    return encodeGlb(world, all, Vec3(0.0));
}

TEST(Gltf, aModelReadsBackAsItWas) {
    test::TestWorld source;
    source.plain("oak", 0xFF806040u);
    const auto box = source.addModel(test::boxExterior({0, 0, 0}, {1, 2, 3}, "oak"));
    const Result<std::string> bytes = encodeAll(modelWorld(source, box));
    ASSERT_TRUE(bytes) << bytes.error().message();
    const tinygltf::Model model = readBack(*bytes);
    ASSERT_EQ(model.nodes.size(), 2u);
    EXPECT_EQ(model.nodes[0].children, std::vector<int>{1});
    EXPECT_NEAR(model.nodes[0].rotation[0], -std::sqrt(0.5), 1e-9) << "z up becomes y up";
    ASSERT_EQ(model.meshes.size(), 1u);
    ASSERT_EQ(model.meshes[0].primitives.size(), 1u);
    const tinygltf::Primitive& primitive = model.meshes[0].primitives[0];
    const tinygltf::Accessor& positions =
        model.accessors[static_cast<std::size_t>(primitive.attributes.at("POSITION"))];
    EXPECT_EQ(positions.count, 36u);
    EXPECT_EQ(positions.minValues, (std::vector<double>{0, 0, 0}));
    EXPECT_EQ(positions.maxValues, (std::vector<double>{1, 2, 3}));
    EXPECT_EQ(primitive.attributes.count("NORMAL") + primitive.attributes.count("TEXCOORD_0"), 2u);
    ASSERT_EQ(model.materials.size(), 1u);
    EXPECT_EQ(model.materials[0].alphaMode, "OPAQUE");
    EXPECT_TRUE(model.images.empty()) << "one colour";
}

TEST(Gltf, surfacesKeepTheirPicturesAndTheirKind) {
    test::TestWorld source;
    using S = dat::Surface;
    const dat::RenderSurface picture = test::solidImage(4, 4, 0x80336699);
    source.picture("cut", picture, S::kBase1ClipMap);
    source.picture("veil", picture, S::kBase1Image | S::kAlpha);
    test::Walls walls = test::boxExterior({0, 0, 0}, {1, 1, 1}, "cut");
    walls[0].surface = "veil";
    const Result<std::string> bytes = encodeAll(modelWorld(source, source.addModel(walls)));
    ASSERT_TRUE(bytes) << bytes.error().message();
    const tinygltf::Model model = readBack(*bytes);
    ASSERT_EQ(model.materials.size(), 2u);
    std::vector<std::string> modes{model.materials[0].alphaMode, model.materials[1].alphaMode};
    std::sort(modes.begin(), modes.end());
    EXPECT_EQ(modes, (std::vector<std::string>{"BLEND", "MASK"}));
    ASSERT_FALSE(model.images.empty());
    for (const tinygltf::Image& image : model.images) {
        ASSERT_GT(image.image.size(), 8u);
        EXPECT_EQ(std::string(image.image.begin() + 1, image.image.begin() + 4), "PNG");
    }
}

TEST(Gltf, partsShareTheirMeshAndStandWhereTheyStand) {
    test::TestWorld source;
    const auto box = source.addModel(test::boxExterior({0, 0, 0}, {1, 1, 1}, "oak"));
    dat::Setup setup;
    setup.parts = {box, box};
    dat::AnimationFrame pose;
    pose.parts = {dat::Frame{}, dat::Frame{{5, 6, 7}, {1, 0, 0, 0}}};
    setup.placementFrames = {{dat::Setup::kPlacementDefault, pose}};
    const Result<std::string> bytes = encodeAll(modelWorld(source, source.addSetup(setup)));
    ASSERT_TRUE(bytes) << bytes.error().message();
    const tinygltf::Model model = readBack(*bytes);
    EXPECT_EQ(model.meshes.size(), 1u);
    ASSERT_EQ(model.nodes.size(), 3u);
    ASSERT_EQ(model.nodes[2].matrix.size(), 16u);
    EXPECT_EQ(model.nodes[2].matrix[12], 5.0);
    EXPECT_EQ(model.nodes[2].matrix[13], 6.0);
    EXPECT_EQ(model.nodes[2].matrix[14], 7.0);
}

TEST(Gltf, nothingIsRefused) {
    test::TestWorld source;
    const auto box = source.addModel(test::boxExterior({0, 0, 0}, {1, 1, 1}, "oak"));
    EXPECT_FALSE(encodeGlb(modelWorld(source, box), {}, Vec3(0.0)));
}

} // namespace
} // namespace limen::output
