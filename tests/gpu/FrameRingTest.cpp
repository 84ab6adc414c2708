#include "gpu/FrameRing.h"

#include <gtest/gtest.h>

#include <cstring>

namespace limen::gpu {
namespace {

namespace layout = frame::gpu;

layout::Instance recordOf(std::uint32_t number) {
    layout::Instance record;
    const auto n = static_cast<float>(number);
    record.pose0 = {n, 1, 2, 3};
    record.pose1 = {4, n, 6, 7};
    record.pose2 = {8, 9, n, 11};
    record.block = number + 1;
    record.idBase = number + 2;
    record.firstMaterial = number + 3;
    record.firstMember = number + 4;
    record.membersAndKind = number + 5;
    record.level = number + 6;
    record.opacity = 0.5f * n;
    return record;
}

bool areSame(const layout::Instance& a, const layout::Instance& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

/// frame::DynamicRecords::write for an array of records.
void copyRecords(const void* instances, std::span<const std::uint32_t> numbers,
                 std::span<layout::Instance> out) {
    const auto* const records = static_cast<const layout::Instance*>(instances);
    for (std::size_t i = 0; i < numbers.size(); ++i)
        out[i] = records[numbers[i]];
}

TEST(FrameRing, writesVisibleDynamicInstances_theirChanges_andThePlansRecords) {
    constexpr std::uint32_t kCount = 5;
    std::vector<layout::Instance> records;
    frame::FramePlan plan;
    for (std::uint32_t i = 0; i < 3 * kCount; ++i)
        records.push_back(recordOf(i));
    plan.dynamicRecords = {records.data(), copyRecords};
    for (std::uint32_t i = 0; i < kCount; ++i)
        plan.dynamicInstances.push_back(3 * i + i % 2);
    plan.dynamicChanges = {{1, 100, 200, 300}, {kCount - 1, 400, 500, 0}};
    plan.records = {recordOf(12345)};
    const FrameRing ring(plan, 0, 256);
    struct alignas(256) Line {
        std::array<std::byte, 256> bytes{};
    };
    std::vector<Line> memory((ring.size() + sizeof(Line) - 1) / sizeof(Line));
    layout::DeviceConstants constants;
    ring.locate(constants);
    ring.write(constants, {memory.front().bytes.data(), ring.size()});
    std::vector<layout::Instance> written(kCount + 1);
    std::memcpy(static_cast<void*>(written.data()),
                memory.front().bytes.data() + std::size_t{constants.firstInstance} * 16,
                written.size() * sizeof(layout::Instance));
    for (std::uint32_t i = 0; i < kCount; ++i) {
        layout::Instance expected = recordOf(3 * i + i % 2);
        for (const frame::DynamicChange& change : plan.dynamicChanges)
            if (change.instance == i)
                change.applyTo(expected);
        ASSERT_TRUE(areSame(written[i], expected)) << i;
    }
    EXPECT_EQ(written[1].highlight, 300u);
    EXPECT_TRUE(areSame(written[kCount], plan.records[0]));
}

} // namespace
} // namespace limen::gpu
