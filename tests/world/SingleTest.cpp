#include "world/Single.h"

#include "support/LoadTestWorld.h"

#include <gtest/gtest.h>

namespace limen::world {
namespace {

struct Single : testing::Test {
    test::TestWorld source;
    test::TempDir directory;
    dat::Archive open() {
        EXPECT_TRUE(source.write(directory.path()));
        return *dat::Archive::open(directory.path());
    }
};

TEST_F(Single, aModelIsAWorldOfItsOwn) {
    const auto box = source.addModel(test::boxExterior({0, 0, 0}, {1, 2, 3}, "oak"));
    const dat::Archive archive = open();
    const Result<World> world = loadModel(archive, box);
    ASSERT_TRUE(world) << world.error().message();
    ASSERT_EQ(world->instances.size(), 1u);
    EXPECT_EQ(world->instances[0].record, box);
    EXPECT_EQ(world->instances[0].placedIn, kOutside);
    EXPECT_EQ(world->spaces.size(), 1u);
    EXPECT_FALSE(world->blocks[0].hasTerrain);
    EXPECT_FALSE(loadModel(archive, 0x01FFFFFF));
    EXPECT_FALSE(loadModel(archive, 0x08000001)) << "no model";
}

TEST_F(Single, picturesAreFoundBySurfaceTextureAndPicture) {
    const auto surface = source.picture("red", test::solidImage(4, 2, 0xFFFF0000), dat::Surface::kBase1Image);
    const auto plain = source.plain("plain", 0xFF00FF00);
    const dat::Archive archive = open();
    const dat::RecordId texture = archive.load<dat::Surface>(surface)->texture;
    const dat::RecordId picture = archive.load<dat::SurfaceTexture>(texture)->images.at(0);
    for (const dat::RecordId id : {surface, texture, picture}) {
        const Result<Image> image = loadPicture(archive, id);
        ASSERT_TRUE(image) << image.error().message();
        EXPECT_EQ(image->width, 4u);
        EXPECT_EQ(image->rgba[0], 255);
    }
    EXPECT_FALSE(loadPicture(archive, plain)) << "one colour";
    EXPECT_FALSE(loadPicture(archive, 0x06FFFFFF));
    EXPECT_FALSE(loadPicture(archive, 0x01000001));
}

} // namespace
} // namespace limen::world
