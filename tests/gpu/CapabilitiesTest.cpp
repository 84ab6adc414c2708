#include "gpu/device/Capabilities.h"

#include <gmock/gmock.h>

namespace limen::gpu {
namespace {

DriverLimits goodDriver() {
    return {.version = 45,
            .shaderDrawParameters = true,
            .coreProfile = true,
            .vertexStorageBlocks = 16,
            .fragmentStorageBlocks = 16,
            .combinedStorageBlocks = 80,
            .storageBindings = 80,
            .computeStorageBlocks = 8,
            .textureUnits = 16,
            .vertexTextureUnits = 16,
            .computeTextureUnits = 16,
            .drawBuffers = 8};
}

TEST(Capabilities, goodDriver_lacksNothing) {
    EXPECT_TRUE(missingFrom(goodDriver()).empty());
}

TEST(Capabilities, everythingMissingIsNamedAtOnce) {
    DriverLimits limits = goodDriver();
    limits.version = 33;
    limits.shaderDrawParameters = false;
    limits.vertexStorageBlocks = 0;
    EXPECT_THAT(missingFrom(limits),
                ::testing::ElementsAre("OpenGL 4.5 (it has 3.3)", "GL_ARB_shader_draw_parameters",
                                       "5 storage blocks in the vertex stage (it has 0)"));
}

TEST(Capabilities, eachLimitIsChecked) {
    for (int DriverLimits::*limit :
         {&DriverLimits::version, &DriverLimits::vertexStorageBlocks, &DriverLimits::fragmentStorageBlocks,
          &DriverLimits::combinedStorageBlocks, &DriverLimits::storageBindings, &DriverLimits::textureUnits,
          &DriverLimits::computeStorageBlocks, &DriverLimits::vertexTextureUnits,
          &DriverLimits::computeTextureUnits, &DriverLimits::drawBuffers}) {
        DriverLimits limits = goodDriver();
        limits.*limit = 2;
        EXPECT_EQ(missingFrom(limits).size(), 1u);
    }
}

} // namespace
} // namespace limen::gpu
