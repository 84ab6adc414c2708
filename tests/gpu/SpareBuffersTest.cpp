#include "gpu/scene/SpareBuffers.h"

#include "FailingDevice.h"
#include "gpu/device/NullDevice.h"

#include <gtest/gtest.h>

namespace limen::gpu::test {
namespace {

class SpareBuffersTest : public ::testing::Test {
protected:
    SizedBuffer take(std::size_t bytes) {
        const Result<SizedBuffer> taken = spare_.take("an array", bytes);
        EXPECT_TRUE(taken);
        EXPECT_GE(taken->bytes, bytes);
        return *taken;
    }
    std::size_t made() const { return null_.objects().buffers; }

    NullDevice null_;
    FailingDevice device_{null_};
    SpareBuffers spare_{device_};
};

TEST_F(SpareBuffersTest, releasedBufferIsReused) {
    const SizedBuffer first = take(1 << 20);
    spare_.giveBack(first);
    EXPECT_EQ(take(1 << 20).handle, first.handle);
    EXPECT_NE(take(1 << 20).handle, first.handle) << "once";
}

TEST_F(SpareBuffersTest, somewhatLongerArrayFitsToo) {
    const SizedBuffer first = take(900'000);
    spare_.giveBack(first);
    EXPECT_EQ(take(first.bytes).handle, first.handle);
}

TEST_F(SpareBuffersTest, extraCapacityIsAQuarterAtMost) {
    for (std::size_t bytes = 100'000; bytes < 1'000'000; bytes += 7'777)
        EXPECT_LE(take(bytes).bytes, bytes + bytes / 4);
}

TEST_F(SpareBuffersTest, shortestSufficientBufferIsTaken) {
    const SizedBuffer a = take(400'000), b = take(300'000), c = take(200'000);
    for (const SizedBuffer& buffer : {a, b, c})
        spare_.giveBack(buffer);
    EXPECT_EQ(take(250'000).handle, b.handle);
}

TEST_F(SpareBuffersTest, muchLongerBufferIsNotTaken) {
    const SizedBuffer large = take(10'000'000);
    spare_.giveBack(large);
    EXPECT_NE(take(1'000'000).handle, large.handle);
    EXPECT_EQ(take(9'000'000).handle, large.handle);
}

TEST_F(SpareBuffersTest, unusedBuffersAreDestroyedOneByOne) {
    for (const SizedBuffer& buffer : {take(1000), take(1000)})
        spare_.giveBack(buffer);
    EXPECT_FALSE(spare_.releaseSome()) << "a later scene may need it";
    spare_.endScene();
    const SizedBuffer later = take(500'000);
    spare_.giveBack(later);
    EXPECT_TRUE(spare_.releaseSome());
    EXPECT_EQ(made(), 2u);
    EXPECT_TRUE(spare_.releaseSome());
    EXPECT_FALSE(spare_.releaseSome());
    EXPECT_EQ(made(), 1u);
    EXPECT_EQ(take(500'000).handle, later.handle);
}

TEST_F(SpareBuffersTest, bufferTakenInTimeIsNotDestroyed) {
    const SizedBuffer a = take(400'000), b = take(1000);
    spare_.giveBack(a);
    spare_.giveBack(b);
    spare_.endScene();
    EXPECT_EQ(take(400'000).handle, a.handle);
    EXPECT_TRUE(spare_.releaseSome());
    EXPECT_FALSE(spare_.releaseSome());
    EXPECT_EQ(made(), 1u) << "it is the scene's";
}

TEST_F(SpareBuffersTest, spareBuffersAreDestroyedWithoutMemory) {
    const SizedBuffer small = take(1000);
    spare_.giveBack(small);
    device_.madeBeforeFailure = 0;
    const SizedBuffer large = take(10'000'000);
    EXPECT_GE(large.bytes, 10'000'000u);
    EXPECT_EQ(made(), 1u);
}

TEST_F(SpareBuffersTest, aTwinIsTakenAsItsOriginalWouldBe) {
    const SizedBuffer original = take(300'000);
    ASSERT_TRUE(spare_.addTwin(original));
    EXPECT_EQ(made(), 2u);
    EXPECT_EQ(take(300'000).bytes, original.bytes);
    EXPECT_EQ(made(), 2u);
    device_.madeBeforeFailure = 0;
    EXPECT_FALSE(spare_.addTwin(original));
}

TEST_F(SpareBuffersTest, withoutMemoryTheErrorIsTheDevices) {
    device_.madeBeforeFailure = 0;
    const Result<SizedBuffer> taken = spare_.take("an array", 10);
    ASSERT_FALSE(taken);
    EXPECT_EQ(taken.error().code, ErrorCode::Driver);
}

TEST_F(SpareBuffersTest, sizesStayWithinTheTexelLimit) {
    const std::size_t most = device_.capabilities().maxBufferTexels * kBytesPerTexel;
    EXPECT_EQ(take(most - 5000).bytes, most);
    EXPECT_EQ(take(most).bytes, most);
    EXPECT_EQ(take(most + 4).bytes, most + 4) << "beyond the texel limit anyway";
}

} // namespace
} // namespace limen::gpu::test
