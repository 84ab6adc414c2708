#include "placements/Equipment.h"

#include <gmock/gmock.h>
#include <map>

// The items that an object wears and holds at the start.
namespace limen::placements {
namespace {

using testing::ElementsAre;

constexpr std::int32_t kMelee = 0x100000, kShield = 0x200000, kMissile = 0x400000, kAmmunition = 0x800000,
                       kHeld = 0x1000000, kTwoHanded = 0x2000000;

/// A smith, and templates of the items that he has.
struct Smith {
    std::map<std::uint32_t, Template> templates;
    Template of;

    Template& item(std::uint32_t id, std::int32_t locations, std::int32_t destination = CreatedItem::kWield,
                   float shade = 0.0f, std::int32_t palette = 0) {
        of.items.push_back({destination, id, palette, shade});
        Template& made = templates[id];
        made.id = id;
        made.validLocations = locations;
        return made;
    }
    [[nodiscard]] std::vector<EquippedItem> equipment(std::uint64_t guid = 1) const {
        return equipmentOf(of, guid, [&](std::uint32_t id) -> const Template* {
            const auto found = templates.find(id);
            return found != templates.end() ? &found->second : nullptr;
        });
    }
    [[nodiscard]] std::vector<std::uint32_t> ids(std::uint64_t guid = 1) const {
        std::vector<std::uint32_t> ids;
        for (const EquippedItem& item : equipment(guid))
            ids.push_back(item.templateId);
        return ids;
    }
    /// The grip of the only item.
    [[nodiscard]] std::optional<Grip> grip() const { return equipment().at(0).grip; }
};

TEST(Equipment, isWornFromTheSkinOutwards_armourOverClothes) {
    Smith smith;
    smith.item(1, 0x0200).clothingPriority = 1; // a breastplate
    smith.item(2, 0x0002).clothingPriority = 16;
    smith.item(3, 0x0040).clothingPriority = 8;
    smith.item(4, 0x0001).clothingPriority = 16;
    EXPECT_THAT(smith.ids(), ElementsAre(3, 2, 4, 1));
    for (const EquippedItem& item : smith.equipment())
        EXPECT_FALSE(item.grip);
}

TEST(Equipment, hasColoursOfItsRow_elseOfItsTemplate) {
    Smith smith;
    smith.item(1, 2, CreatedItem::kWield, 0.5f, 7);
    smith.item(2, 2);
    const std::vector<EquippedItem> items = smith.equipment();
    EXPECT_EQ(items[0].palette, 7);
    EXPECT_EQ(items[0].shade, 0.5f);
    EXPECT_EQ(items[1].palette, std::nullopt);
    EXPECT_EQ(items[1].shade, std::nullopt);
}

TEST(Equipment, otherDestinationsAreNotWorn) {
    Smith smith;
    smith.item(1, 2, 4);                                          // in the shop
    smith.item(2, 2, 1);                                          // in the pack
    smith.item(3, 2, 8);                                          // loot
    smith.of.items.push_back({CreatedItem::kWield, 99, 0, 0.0f}); // no such template
    EXPECT_TRUE(smith.equipment().empty());
}

TEST(Equipment, isHeldByItsLocation) {
    const auto gripOf = [](std::int32_t locations, std::int32_t type = 1, std::int32_t style = 0) {
        Smith smith;
        Template& item = smith.item(1, locations);
        item.itemType = type;
        item.combatStyle = style;
        return smith.grip();
    };
    EXPECT_EQ(gripOf(kMelee), (Grip{1, 1})) << "an axe: right hand";
    EXPECT_EQ(gripOf(kHeld), (Grip{1, 1})) << "a wand";
    EXPECT_EQ(gripOf(kTwoHanded), (Grip{1, 1}));
    EXPECT_EQ(gripOf(kShield, 2), (Grip{3, 6})) << "a shield is armour";
    EXPECT_EQ(gripOf(kShield, 1), (Grip{8, 2})) << "a second weapon";
    EXPECT_EQ(gripOf(kMissile, 0x100, 0x10), (Grip{2, 3})) << "a bow: left hand";
    EXPECT_EQ(gripOf(kMissile, 0x100, 0x20), (Grip{2, 3})) << "a crossbow";
    EXPECT_EQ(gripOf(kMissile, 0x100, 0x80), (Grip{1, 1})) << "a dart";
}

TEST(Equipment, withoutLocationsIsHeldWhereItsTemplateSays) {
    Smith smith;
    Template& torch = smith.item(1, 0);
    torch.parentLocation = 4;
    torch.placementPosition = 5;
    EXPECT_EQ(smith.grip(), (Grip{4, 5}));
    torch.placementPosition.reset();
    EXPECT_EQ(smith.grip(), (Grip{4, 1}));
}

TEST(Equipment, fillsEachHandOnce) {
    Smith smith;
    smith.item(1, 2);
    smith.item(2, kMelee);
    smith.item(3, kMelee);
    smith.item(4, kAmmunition);
    smith.item(5, kShield).itemType = 2;
    smith.item(6, kShield).itemType = 2;
    EXPECT_THAT(smith.ids(), ElementsAre(1, 2, 5));
    Smith archer;
    archer.item(2, kMissile).combatStyle = 0x10;
    archer.item(5, kShield).itemType = 2;
    EXPECT_THAT(archer.ids(), ElementsAre(2)) << "a bow needs both hands";
    Smith giant;
    giant.item(5, kShield).itemType = 2;
    giant.item(2, kTwoHanded);
    EXPECT_THAT(giant.ids(), ElementsAre(2));
}

TEST(Equipment, ofItemsWithAProbabilityOneOfEachSetIsChosen) {
    constexpr std::int32_t kWieldedTreasure = CreatedItem::kWield | CreatedItem::kTreasure;
    Smith smith;
    smith.item(1, 2, kWieldedTreasure, 0.25f);
    smith.item(2, 2, kWieldedTreasure, 0.75f); // the first set ends here
    smith.item(3, 2, kWieldedTreasure, 0.1f);
    smith.item(4, 2, kWieldedTreasure, 0.0f); // always
    std::map<std::uint32_t, int> counts;
    constexpr int kGuids = 4000;
    for (std::uint64_t guid = 0; guid < kGuids; ++guid) {
        const std::vector<std::uint32_t> ids = smith.ids(guid);
        EXPECT_EQ(ids, smith.ids(guid)) << "chance is the same at each start";
        EXPECT_EQ(std::count(ids.begin(), ids.end(), 1u) + std::count(ids.begin(), ids.end(), 2u), 1);
        for (const std::uint32_t id : ids)
            ++counts[id];
    }
    // Four standard deviations of 4000 draws are below 0.03.
    EXPECT_NEAR(counts[1] / double{kGuids}, 0.25, 0.03);
    EXPECT_NEAR(counts[3] / double{kGuids}, 0.1, 0.03);
    EXPECT_EQ(counts[4], kGuids);
    EXPECT_EQ(smith.equipment(0).at(0).shade, std::nullopt) << "a probability is no shade";
}

} // namespace
} // namespace limen::placements
