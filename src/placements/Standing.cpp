#include "placements/Standing.h"

#include "placements/Chance.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_set>

namespace limen::placements {
namespace {

// Bits of GeneratorEntry::whereCreate. Ref: RegenLocationType of the ACEmulator project.
constexpr std::uint32_t kScatter = 0x2, kSpecific = 0x4, kNotInWorld = 0x8 | 0x10 | 0x20;
constexpr std::uint32_t kPlaceHolder = 3666; ///< the template of entries that stand for link children
constexpr std::int32_t kMostMade = 64;       ///< by one generator
constexpr std::uint32_t kFirstIndoors = 0x0100;

/// The guids that stand: all but link children, and the children of those that stand.
std::unordered_set<std::uint32_t> standingGuids(const Landblock& landblock) {
    std::unordered_set<std::uint32_t> standing;
    std::vector<std::uint32_t> open;
    for (const Placement& placement : landblock.placements)
        if (!placement.isLinkChild && standing.insert(placement.guid).second)
            open.push_back(placement.guid);
    while (!open.empty()) {
        const std::uint32_t parent = open.back();
        open.pop_back();
        const auto first = std::lower_bound(landblock.links.begin(), landblock.links.end(), Link{parent, 0});
        for (auto link = first; link != landblock.links.end() && link->parent == parent; ++link)
            if (standing.insert(link->child).second)
                open.push_back(link->child);
    }
    return standing;
}

/// Makes the initial objects of one generator.
class Generator {
public:
    Generator(const Placement& at, const Template& of, const FindTemplate& find, std::vector<Standing>& out)
        : at_(at), of_(of), find_(find), out_(out) {}

    void run() {
        for (const GeneratorEntry& entry : of_.generator)
            for (std::int32_t i = 0; entry.probability == -1.0f && i < entry.initCreate && made_ < kMostMade;
                 ++i)
                make(entry);
        const std::int32_t wanted = std::min(of_.initGenerated.value_or(0), kMostMade);
        for (std::int32_t i = made_; i < wanted; ++i)
            if (const GeneratorEntry* entry = drawn(static_cast<std::uint32_t>(i)))
                make(*entry);
    }

private:
    /// The first entry whose probability reaches a random number; null if none does.
    [[nodiscard]] const GeneratorEntry* drawn(std::uint32_t number) const {
        const double random = chance(at_.guid, number, 0);
        const auto found =
            std::find_if(of_.generator.begin(), of_.generator.end(), [&](const GeneratorEntry& entry) {
                return static_cast<double>(entry.probability) >= random;
            });
        return found != of_.generator.end() ? &*found : nullptr;
    }

    void make(const GeneratorEntry& entry) {
        const auto number = static_cast<std::uint32_t>(made_++);
        const Template* of = find_(entry.templateId);
        if (entry.templateId == kPlaceHolder || (entry.whereCreate & kNotInWorld) != 0 || of == nullptr ||
            !isVisible(*of))
            return;
        Standing made;
        made.id = std::uint64_t{at_.guid} | std::uint64_t{number + 1} << 32;
        made.templateId = entry.templateId;
        made.spot = spotOf(entry, number, made.isScattered);
        if (entry.palette && *entry.palette != 0)
            made.palette = static_cast<std::int32_t>(*entry.palette);
        if (entry.shade && *entry.shade > 0.0f)
            made.shade = entry.shade;
        out_.push_back(made);
    }

    [[nodiscard]] Spot spotOf(const GeneratorEntry& entry, std::uint32_t number, bool& isScattered) const {
        Spot spot = at_.spot;
        if ((entry.whereCreate & kSpecific) != 0 && entry.spot) {
            if (entry.spot->cell != 0)
                return *entry.spot;
            for (std::size_t i = 0; i < 3; ++i)
                spot.origin[i] += entry.spot->origin[i];
            spot.angles = entry.spot->angles;
            return spot;
        }
        const bool isOutdoors = (spot.cell & 0xFFFF) < kFirstIndoors;
        const double radius = of_.generatorRadius.value_or(0.0);
        if ((entry.whereCreate & kScatter) != 0 && isOutdoors && radius > 0.0) {
            const double away = std::min(radius, 96.0) * std::sqrt(chance(at_.guid, number, 1));
            const double angle = 2.0 * std::numbers::pi * chance(at_.guid, number, 2);
            spot.origin[0] += static_cast<float>(away * std::cos(angle));
            spot.origin[1] += static_cast<float>(away * std::sin(angle));
            isScattered = true;
        }
        return spot;
    }

    const Placement& at_;
    const Template& of_;
    const FindTemplate& find_;
    std::vector<Standing>& out_;
    std::int32_t made_ = 0;
};

} // namespace

bool isVisible(const Template& of) {
    const auto state = static_cast<std::uint32_t>(of.physicsState.value_or(0));
    return of.setup != 0 && (state & (kNoDraw | kHidden)) == 0 && !of.noDraw.value_or(false) &&
           !of.visibility.value_or(false);
}

std::vector<Standing> standingIn(const Landblock& landblock, const FindTemplate& find) {
    const std::unordered_set<std::uint32_t> guids = standingGuids(landblock);
    std::vector<Standing> standing;
    for (const Placement& placement : landblock.placements) {
        const Template* of = guids.contains(placement.guid) ? find(placement.templateId) : nullptr;
        if (of == nullptr)
            continue;
        if (isVisible(*of))
            standing.push_back({placement.guid, placement.templateId, placement.spot, false, {}, {}});
        if (!of->generator.empty()) {
            const Template kept = *of; // `find` may replace the template that it gave before
            Generator(placement, kept, find, standing).run();
        }
    }
    std::sort(standing.begin(), standing.end(),
              [](const Standing& a, const Standing& b) { return a.id < b.id; });
    return standing;
}

} // namespace limen::placements
