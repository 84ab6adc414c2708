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
    record.levelRange = number + 6;
    record.opacity = 0.5f * n;
    return record;
}

bool areSame(const layout::Instance& a, const layout::Instance& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

/// Writes a plan in which every third record is visible, two of them highlighted, and there is one record more.
void writeInstances(std::uint32_t count) {
    std::vector<layout::Instance> records;
    frame::FramePlan plan;
    for (std::uint32_t i = 0; i < 3 * count; ++i)
        records.push_back(recordOf(i));
    plan.dynamicRecords = records;
    for (std::uint32_t i = 0; i < count; ++i)
        plan.dynamicInstances.push_back(3 * i + i % 2);
    plan.dynamicHighlights = {{1, 300}, {count - 1, 500}};
    plan.records = {recordOf(12345)};
    const FrameRing ring(plan, 0, 256);
    struct alignas(256) Line {
        std::array<std::byte, 256> bytes{};
    };
    std::vector<Line> memory((ring.size() + sizeof(Line) - 1) / sizeof(Line));
    layout::DeviceConstants constants;
    ring.locate(constants);
    ring.write(constants, {memory.front().bytes.data(), ring.size()});
    std::vector<layout::Instance> written(count + 1);
    std::memcpy(static_cast<void*>(written.data()),
                memory.front().bytes.data() + std::size_t{constants.firstInstance} * 16,
                written.size() * sizeof(layout::Instance));
    for (std::uint32_t i = 0; i < count; ++i) {
        layout::Instance expected = recordOf(3 * i + i % 2);
        expected.highlight = i == 1 ? 300 : i == count - 1 ? 500 : 0;
        ASSERT_TRUE(areSame(written[i], expected)) << i;
    }
    EXPECT_TRUE(areSame(written[count], plan.records[0]));
}

TEST(FrameRing, copiesTheVisibleDynamicRecords) {
    writeInstances(5);
}

TEST(FrameRing, writesTheSameWithStoresThatBypassTheCache) {
    constexpr std::uint32_t kMany = (2u << 20) / sizeof(layout::Instance);
    writeInstances(kMany);
}

} // namespace
} // namespace limen::gpu
