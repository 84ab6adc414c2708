#include "engine/map/MarksInBackground.h"

#include "placements/WorldDb.h"
#include "support/TemporaryDirectory.h"
#include "worlds/Generated.h"

#include <gtest/gtest.h>
#include <thread>

// The marks of a map are read beside the thread that draws.
namespace limen::engine {
namespace {

using Types = std::vector<placements::TemplateType>;

/// A small dungeon with portals and doors in rows, and a thread's marks of them.
class MarkedWorld {
public:
    explicit MarkedWorld(int portals, int doors) {
        EXPECT_TRUE(worlds::writeGeneratedWorld({worlds::GeneratedKind::Dungeon, 5, 1, 0.0, false},
                                                directory_.path()));
        placements::Content content;
        std::uint32_t guid = 0x70000000;
        const auto add = [&](placements::TemplateType type, int count) {
            const auto id = static_cast<std::uint32_t>(type);
            content.templates[id].id = id;
            content.templates[id].type = static_cast<std::int32_t>(type);
            for (int i = 0; i < count; ++i)
                content.landblocks[0xA9B4].placements.push_back(
                    {guid++, id, {0xA9B40001, {1.0f, 2.0f, 3.0f}, {1.0f, 0.0f, 0.0f, 0.0f}}, false});
        };
        add(placements::TemplateType::Portal, portals);
        add(placements::TemplateType::Door, doors);
        EXPECT_TRUE(
            placements::writeWorldDb(directory_.path() / placements::kWorldDbName, content, {"", ""}));
        source_ = open();
    }
    [[nodiscard]] std::shared_ptr<const WorldSource> open() const {
        Result<WorldSource> source = openWorldSource(directory_.path().string(), PlaceSearch::Skip);
        EXPECT_TRUE(source);
        return std::make_shared<const WorldSource>(std::move(*source));
    }
    [[nodiscard]] const std::shared_ptr<const WorldSource>& source() const { return source_; }
    void removeRows() { std::filesystem::remove(directory_.path() / placements::kWorldDbName); }

private:
    test::TemporaryDirectory directory_;
    std::shared_ptr<const WorldSource> source_;
};

std::unique_ptr<const MarksInBackground::Marks> waitFor(MarksInBackground& reading) {
    for (int i = 0; i < 2000; ++i) {
        if (auto marks = reading.take())
            return marks;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return nullptr;
}

TEST(MarksInBackground, areReadByType_andTakenOnce) {
    MarkedWorld world(2, 3);
    MarksInBackground reading(world.source(),
                              {placements::TemplateType::Portal, placements::TemplateType::Lifestone,
                               placements::TemplateType::Door});
    const auto marks = waitFor(reading);
    ASSERT_NE(marks, nullptr);
    ASSERT_EQ(marks->size(), 3u);
    EXPECT_EQ((*marks)[0].size(), 2u);
    EXPECT_TRUE((*marks)[1].empty());
    EXPECT_EQ((*marks)[2].size(), 3u);
    EXPECT_EQ((*marks)[2][0], Vec2(0xA9 * 192.0 + 1.0, 0xB4 * 192.0 + 2.0));
    EXPECT_EQ(reading.take(), nullptr);
}

TEST(MarksInBackground, ofAWorldWithoutRowsAreEmpty) {
    MarkedWorld world(0, 0);
    world.removeRows();
    MarksInBackground reading(world.open(), Types{placements::TemplateType::Door});
    const auto marks = waitFor(reading);
    ASSERT_NE(marks, nullptr);
    EXPECT_TRUE(marks->at(0).empty());
}

TEST(MarksInBackground, canBeLeftAtAnyTime) {
    MarkedWorld world(0, 4000);
    for (int i = 0; i < 20; ++i)
        MarksInBackground(world.source(), Types(50, placements::TemplateType::Door));
}

} // namespace
} // namespace limen::engine
