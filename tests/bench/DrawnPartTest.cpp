#include "DrawnPart.h"
#include "BuiltInFiles.h"

#include "gpu/device/NullDevice.h"

#include <gtest/gtest.h>

namespace limen::bench {
namespace {

/// Whether a planned frame of the built-in world has grain on its walls.
class Grain : public ::testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(files_.open());
        place_ = files_.world.places.front();
        Result<std::shared_ptr<const engine::LoadedPart>> loaded =
            loadAround(*files_.archive, files_.world, place_, {.radius = 0, .farRadius = 0});
        ASSERT_TRUE(loaded) << loaded.error().message();
        loaded_ = *loaded;
    }
    [[nodiscard]] bool isDrawn(bool software, gpu::Drawing drawing, world::Look look) const {
        gpu::Capabilities capabilities = gpu::NullDevice::defaultCapabilities();
        capabilities.software = software;
        gpu::NullDevice device(capabilities);
        Result<std::unique_ptr<DrawnPart>> part =
            DrawnPart::of(loaded_, device, 64, 64, {.drawing = drawing});
        EXPECT_TRUE(part);
        frame::FrameView view = (*part)->viewFrom(place_);
        view.look = look;
        (*part)->move(view);
        (*part)->flood(view);
        (*part)->plan(view);
        return (*part)->plan().constants.detailTiling.z > 0.0f;
    }

    BuiltInFiles files_;
    world::Place place_;
    std::shared_ptr<const engine::LoadedPart> loaded_;
};

TEST_F(Grain, isOnWallsOfEveryDriverWayAndLook) {
    for (const bool software : {false, true})
        for (const gpu::Drawing drawing : {gpu::Drawing::Fast, gpu::Drawing::Exact})
            for (const world::Look look : {world::Look::Retail, world::Look::Enhanced})
                EXPECT_TRUE(isDrawn(software, drawing, look)) << software;
}

} // namespace
} // namespace limen::bench
