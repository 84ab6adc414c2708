#include "gpu/FrameRing.h"

#include <gtest/gtest.h>

#include <cstring>

namespace limen::gpu {
namespace {

namespace layout = frame::gpu;

/// A caller's record: begins like a layout::Instance and has more members.
struct Record {
    layout::Instance instance;
    std::array<std::uint32_t, 5> rest{};
};

constexpr std::uint32_t kHere = 77; // at the place of the device's highlight; must not become one

Record recordOf(std::uint32_t number) {
    Record record;
    const auto n = static_cast<float>(number);
    record.instance.pose0 = {n, 1, 2, 3};
    record.instance.pose1 = {4, n, 6, 7};
    record.instance.pose2 = {8, 9, n, 11};
    record.instance.block = number + 1;
    record.instance.idBase = number + 2;
    record.instance.firstMaterial = number + 3;
    record.instance.firstMember = number + 4;
    record.instance.membersAndKind = number + 5;
    record.instance.reach = number + 6;
    record.instance.highlight = kHere;
    record.instance.opacity = 0.5f * n;
    return record;
}

layout::Instance expectedOf(std::uint32_t number) {
    layout::Instance instance = recordOf(number).instance;
    instance.highlight = 0;
    return instance;
}

bool areSame(const layout::Instance& a, const layout::Instance& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

/// Every third record is drawn, two of them with changes, followed by one record of the frame's own.
void writesWhatIsDrawn(std::uint32_t count) {
    std::vector<Record> records;
    frame::FramePlan plan;
    for (std::uint32_t i = 0; i < 3 * count; ++i)
        records.push_back(recordOf(i));
    plan.moving = {reinterpret_cast<const std::byte*>(records.data()), sizeof(Record)};
    for (std::uint32_t i = 0; i < count; ++i)
        plan.movers.push_back(3 * i + i % 2);
    plan.moverChanges = {{1, 100, 200, 300}, {count - 1, 400, 500, 0}};
    plan.records = {recordOf(12345).instance};
    const FrameRing ring(plan, 0, 256);
    struct alignas(256) Line {
        std::array<std::byte, 256> bytes{};
    };
    std::vector<Line> memory((ring.size() + sizeof(Line) - 1) / sizeof(Line));
    layout::FrameConstants constants;
    ring.locate(constants);
    ring.write(constants, {memory.front().bytes.data(), ring.size()});
    std::vector<layout::Instance> written(count + 1);
    std::memcpy(static_cast<void*>(written.data()),
                memory.front().bytes.data() + std::size_t{constants.firstMover} * 16,
                written.size() * sizeof(layout::Instance));
    for (std::uint32_t i = 0; i < count; ++i) {
        layout::Instance expected = expectedOf(3 * i + i % 2);
        for (const frame::MoverChange& change : plan.moverChanges)
            if (change.mover == i)
                change.applyTo(expected);
        ASSERT_TRUE(areSame(written[i], expected)) << i;
    }
    EXPECT_EQ(written[1].highlight, 300u);
    EXPECT_TRUE(areSame(written[count], plan.records[0]));
}

TEST(FrameRing, copiesTheRecordsOfDynamicInstances) {
    writesWhatIsDrawn(5);
}

TEST(FrameRing, nonTemporalStoresWriteTheSame) {
    constexpr std::uint32_t kMany = (2u << 20) / sizeof(layout::Instance);
    writesWhatIsDrawn(kMany);
}

} // namespace
} // namespace limen::gpu
