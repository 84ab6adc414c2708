#include "world/Models.h"

#include "support/LoadTestWorld.h"

#include <gtest/gtest.h>

namespace limen::world {
namespace {

/// Two boxes, and a setup of both. The first has levels of detail.
struct Levels {
    test::TestWorld source;
    std::uint32_t first = source.addModel(test::boxExterior({0, 0, 0}, {1, 1, 1}));
    std::uint32_t second = source.addModel(test::boxExterior({0, 0, 0}, {2, 2, 2}));
    static constexpr dat::RecordId kSetup = 0x02000777, kInfo = 0x11000001;

    explicit Levels(const std::vector<dat::DegradeLevel>& levels) {
        dat::Setup setup;
        setup.id = kSetup;
        setup.parts = {first, second};
        source.portalFile().add(setup);
        source.portalFile().add(dat::DegradeInfo{kInfo, levels});
    }

    /// Parts of a model, by GfxObj.
    std::vector<dat::RecordId> partsOf(dat::RecordId model) {
        const test::TempDir directory;
        EXPECT_TRUE(source.write(directory.path()));
        const Result<dat::Archive> archive = dat::Archive::open(directory.path());
        Result<dat::GfxObj> degraded = archive->load<dat::GfxObj>(first);
        degraded->flags |= dat::GfxObj::kHasDegrade;
        degraded->degradeId = kInfo;
        source.portalFile().add(*degraded);
        const test::TempDir again;
        EXPECT_TRUE(source.write(again.path()));
        const Result<dat::Archive> whole = dat::Archive::open(again.path());
        Records records(*whole);
        Models models(records);
        std::vector<dat::RecordId> parts;
        for (const ModelPart& part : models.model(model).parts)
            parts.push_back(part.gfxObj);
        return parts;
    }
};

using Ids = std::vector<dat::RecordId>;

TEST(Models, drawTheNearestLevelOfDetail) {
    const dat::RecordId other = Levels({}).second; // ids do not depend on levels
    Levels levels({{other, 1, 0, 10, 20}, {0, 1, 20, 30, 40}});
    EXPECT_EQ(levels.partsOf(levels.first), Ids{levels.second});
    EXPECT_EQ(levels.partsOf(Levels::kSetup), (Ids{levels.second, levels.second}));
}

TEST(Models, leaveOutPartsThatShowNothingFromNearby) {
    Levels levels({{0, 1, 0, 0, 1000}});
    EXPECT_EQ(levels.partsOf(levels.first), Ids{});
    EXPECT_EQ(levels.partsOf(Levels::kSetup), Ids{levels.second});
}

TEST(Models, drawThePartItselfWhereItsLevelsAreNotThere) {
    Levels levels({});
    EXPECT_EQ(levels.partsOf(levels.first), Ids{levels.first});
    EXPECT_EQ(levels.partsOf(levels.second), Ids{levels.second});
}

} // namespace
} // namespace limen::world
