#include "doctor/retail/CensusParts.h"

#include <algorithm>
#include <array>

namespace limen::doctor {
namespace {

constexpr std::uint32_t kKnownCellFlags =
    dat::EnvCell::kSeenOutside | dat::EnvCell::kHasStatics | dat::EnvCell::kHasRestriction;
constexpr std::uint16_t kUnusedTerrainBits = 0x0780;
constexpr std::array<std::uint32_t, 3> kAcademyBlocks{0x7F03, 0x8602, 0x8C04};

bool isOfSetup(dat::RecordId model) {
    return model >> 24 == 0x02;
}

} // namespace

void CellCensus::add(const dat::LandBlock& land) {
    ++census_[Tally::LandBlocks];
    for (const std::uint16_t word : land.terrain)
        census_[Tally::OddTerrainWords] += (word & kUnusedTerrainBits) != 0;
}

void CellCensus::add(const dat::LandBlockInfo& info) {
    ++census_[Tally::LandBlockInfos];
    for (const dat::Stab& stab : info.objects)
        if (isOfSetup(stab.model))
            outdoor_.insert(stab.model);
    census_[Tally::Buildings] += static_cast<double>(info.buildings.size());
    census_[Tally::BuildingsWithRooms] += static_cast<double>(
        std::count_if(info.buildings.begin(), info.buildings.end(),
                      [](const dat::Building& building) { return !building.portals.empty(); }));
}

void CellCensus::countLamp(float intensity, float falloff) {
    const bool isFirst = census_[Tally::PlacedLamps]++ == 0;
    const auto widen = [&](Tally least, Tally most, double value) {
        census_[least] = isFirst ? value : std::min(census_[least], value);
        census_[most] = isFirst ? value : std::max(census_[most], value);
    };
    widen(Tally::LeastLampIntensity, Tally::MostLampIntensity, intensity);
    widen(Tally::LeastLampFalloff, Tally::MostLampFalloff, falloff);
}

void CellCensus::add(const dat::EnvCell& cell) {
    ++census_[Tally::EnvCells];
    census_[Tally::OddCellFlags] += (cell.flags & ~kKnownCellFlags) != 0;
    census_[Tally::CellThings] += static_cast<double>(cell.statics.size());
    const std::uint32_t block = cell.id >> 16;
    const bool isAcademy =
        std::find(kAcademyBlocks.begin(), kAcademyBlocks.end(), block) != kAcademyBlocks.end();
    std::size_t lamps = 0;
    for (const dat::Stab& stab : cell.statics) {
        if (!isOfSetup(stab.model))
            continue;
        indoor_.insert(stab.model);
        if (isAcademy)
            academy_.insert(stab.model);
        const auto traits = portal_.setups().find(stab.model);
        if (traits == portal_.setups().end())
            continue;
        if (traits->second.hasMarker) {
            ++census_[Tally::CellMarkers];
            blocksWithMarkers_.insert(block);
        }
        for (const auto& [intensity, falloff] : traits->second.lamps)
            countLamp(intensity, falloff);
        lamps += traits->second.lamps.size();
        if (!traits->second.lamps.empty())
            placedLamps_.insert(stab.model);
    }
    if (lamps > 0)
        lampsOfCells_.push_back(lamps);
}

void CellCensus::finish() {
    const auto sizeOf = [](const auto& set) { return static_cast<double>(set.size()); };
    census_[Tally::OutdoorSetups] = sizeOf(outdoor_);
    census_[Tally::AnimatedOutdoor] = animatedOf(outdoor_, portal_.setups());
    census_[Tally::IndoorSetups] = sizeOf(indoor_);
    census_[Tally::AnimatedIndoor] = animatedOf(indoor_, portal_.setups());
    census_[Tally::BlocksWithMarkers] = sizeOf(blocksWithMarkers_);
    census_[Tally::PlacedSetupsWithLamps] = sizeOf(placedLamps_);
    census_[Tally::LitCells] = sizeOf(lampsOfCells_);
    census_[Tally::AcademySetups] = sizeOf(academy_);
    for (const dat::RecordId id : academy_) {
        const auto traits = portal_.setups().find(id);
        census_[Tally::AcademySetupsDefaultOnly] +=
            traits != portal_.setups().end() && traits->second.hasDefaultPlacementOnly;
    }
    if (lampsOfCells_.empty())
        return;
    std::sort(lampsOfCells_.begin(), lampsOfCells_.end());
    const auto at = [&](std::size_t percent) {
        return static_cast<double>(lampsOfCells_[(lampsOfCells_.size() - 1) * percent / 100]);
    };
    census_[Tally::MedianLampsOfCell] = at(50);
    census_[Tally::P99LampsOfCell] = at(99);
    census_[Tally::MostLampsOfCell] = at(100);
}

} // namespace limen::doctor
