#include "placements/Equipment.h"

#include "placements/Chance.h"

#include <algorithm>
#include <tuple>

namespace limen::placements {
namespace {

// Bits of Template::validLocations. Ref: EquipMask of the ACEmulator project.
constexpr std::uint32_t kArmour = 0x7F00; ///< of trunk, limbs and feet
constexpr std::uint32_t kMelee = 0x100000, kShield = 0x200000, kMissile = 0x400000, kHeld = 0x1000000,
                        kTwoHanded = 0x2000000;
constexpr std::uint32_t kAmmunition = 0x800000; ///< not drawn: nobody shoots
// Holding locations of Setups, and keys of placement frames. Ref: ParentLocation and Placement of the same project.
constexpr std::uint32_t kRightHand = 1, kLeftHand = 2, kOnShieldArm = 3, kLeftWeapon = 8;
constexpr std::uint32_t kInRightHand = 1, kAtRightSide = 2, kInLeftHand = 3, kAsShield = 6;
constexpr std::int32_t kArmourType = 2;               ///< of Template::itemType
constexpr std::int32_t kBow = 0x10, kCrossbow = 0x20; ///< of Template::combatStyle
constexpr std::uint32_t kPurpose = 3;                 ///< of chance()

/// The item's row, with the facts that order it.
struct Candidate {
    EquippedItem item;
    std::uint32_t locations = 0;
    bool isArmour = false;
    std::int32_t priority = 0;
};

/// The grip of an item that is held in a hand; none for one that is worn.
std::optional<Grip> gripOf(const Template& item) {
    const auto locations = static_cast<std::uint32_t>(item.validLocations.value_or(0));
    if ((locations & (kMelee | kHeld | kTwoHanded)) != 0)
        return Grip{kRightHand, kInRightHand};
    if ((locations & kShield) != 0)
        return item.itemType == kArmourType ? Grip{kOnShieldArm, kAsShield} : Grip{kLeftWeapon, kAtRightSide};
    if ((locations & kMissile) != 0) {
        const bool isBow = item.combatStyle == kBow || item.combatStyle == kCrossbow;
        return isBow ? Grip{kLeftHand, kInLeftHand} : Grip{kRightHand, kInRightHand};
    }
    if (locations == 0 && item.parentLocation.value_or(0) > 0)
        return Grip{static_cast<std::uint32_t>(*item.parentLocation),
                    static_cast<std::uint32_t>(std::max(item.placementPosition.value_or(1), 0))};
    return std::nullopt;
}

/// Draws the items that are there: all without a probability, and one of each set whose probabilities add up to 1.
class Draw {
public:
    explicit Draw(std::uint64_t object) : object_(object) {}

    [[nodiscard]] bool takes(const CreatedItem& item) {
        if ((item.destination & CreatedItem::kTreasure) == 0 || item.shade == 0.0f)
            return true;
        if (total_ >= 1.0) {
            ++set_;
            total_ = 0.0;
            isTaken_ = false;
        }
        total_ += static_cast<double>(item.shade);
        if (isTaken_ || chance(object_, set_, kPurpose) >= total_)
            return false;
        isTaken_ = true;
        return true;
    }

private:
    std::uint64_t object_;
    std::uint32_t set_ = 0;
    double total_ = 0.0; ///< of the probabilities of the set so far
    bool isTaken_ = false;
};

std::vector<Candidate> candidatesOf(const Template& of, std::uint64_t object, const FindTemplate& find) {
    std::vector<Candidate> candidates;
    Draw draw(object);
    for (const CreatedItem& row : of.items) {
        if ((row.destination & CreatedItem::kWield) == 0 || !draw.takes(row))
            continue;
        const Template* item = find(row.templateId);
        if (item == nullptr)
            continue;
        Candidate candidate;
        candidate.locations = static_cast<std::uint32_t>(item->validLocations.value_or(0));
        if ((candidate.locations & kAmmunition) != 0)
            continue;
        candidate.item.templateId = row.templateId;
        candidate.item.grip = gripOf(*item);
        if (row.palette > 0)
            candidate.item.palette = row.palette;
        if ((row.destination & CreatedItem::kTreasure) == 0 && row.shade > 0.0f)
            candidate.item.shade = row.shade;
        candidate.isArmour = (candidate.locations & kArmour) != 0;
        candidate.priority = item->clothingPriority.value_or(0);
        candidates.push_back(candidate);
    }
    return candidates;
}

/// The first item for each hand. Two hands at a weapon leave none for a shield; so does a bow.
void addHeld(const std::vector<Candidate>& candidates, std::vector<EquippedItem>& out) {
    const auto isWeapon = [](const Candidate& candidate) {
        const std::uint32_t location = candidate.item.grip ? candidate.item.grip->location : 0;
        return location == kRightHand || location == kLeftHand;
    };
    const auto weapon = std::find_if(candidates.begin(), candidates.end(), isWeapon);
    if (weapon != candidates.end()) {
        out.push_back(weapon->item);
        if ((weapon->locations & kTwoHanded) != 0 || weapon->item.grip->location == kLeftHand)
            return;
    }
    const auto second = std::find_if(candidates.begin(), candidates.end(), [&](const Candidate& candidate) {
        return candidate.item.grip && !isWeapon(candidate);
    });
    if (second != candidates.end())
        out.push_back(second->item);
}

} // namespace

std::vector<EquippedItem> equipmentOf(const Template& of, std::uint64_t object, const FindTemplate& find) {
    std::vector<Candidate> candidates = candidatesOf(of, object, find);
    std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
        return std::tuple(a.isArmour, a.priority) < std::tuple(b.isArmour, b.priority);
    });
    std::vector<EquippedItem> equipment;
    for (const Candidate& candidate : candidates)
        if (!candidate.item.grip)
            equipment.push_back(candidate.item);
    addHeld(candidates, equipment);
    return equipment;
}

} // namespace limen::placements
