#include "engine/placed/PlacedHealth.h"

#include <algorithm>
#include <fmt/format.h>

namespace limen::engine {
namespace {

bool hasModel(const dat::Archive& archive, dat::RecordId id) {
    return id >> 24 == 0x02 ? archive.contains<dat::Setup>(id) : archive.contains<dat::GfxObj>(id);
}

/// Adds the reasons for which an entry cannot be shown as its row says.
void compareEntry(const world::PlacedEntry& entry, const dat::Archive& archive, PlacedHealth& out) {
    const auto lacks = [&](const char* reason) { out.unresolved[reason].push_back(entry.name); };
    if (!hasModel(archive, entry.model))
        lacks("its Setup is not in the dat files");
    if (entry.motionTable != 0 && !archive.contains<dat::MotionTable>(entry.motionTable))
        lacks("its MotionTable is not in the dat files");
    if (entry.cell != 0 && !archive.contains<dat::EnvCell>(entry.cell))
        lacks("its cell is not in the dat files");
    if (std::any_of(entry.clothing.begin(), entry.clothing.end(), [&](const world::ClothingEntry& garment) {
            return !archive.contains<dat::ClothingTable>(garment.table);
        }))
        lacks("a ClothingTable is not in the dat files");
    if (std::any_of(entry.held.begin(), entry.held.end(),
                    [&](const world::HeldEntry& held) { return !hasModel(archive, held.model); }))
        lacks("the Setup of a held item is not in the dat files");
    if (entry.play.kind != 0 && entry.scriptTable != 0 &&
        !archive.contains<dat::PhysicsScriptTable>(entry.scriptTable))
        lacks("its PhysicsScriptTable is not in the dat files");
}

/// Loads the block of some doors and counts those that hang in an opening.
Result<void> hangDoors(const dat::Archive& archive, dat::BlockCoord block,
                       std::vector<world::PlacedEntry> doors, PlacedHealth& out) {
    world::MovingEntries moving;
    moving.placed = std::move(doors);
    const Result<world::World> world = world::loadWorld(archive, block, {.radius = 0}, moving);
    if (!world) {
        for (const world::PlacedEntry& door : moving.placed)
            out.unresolved["its landblock is not in the dat files"].push_back(door.name);
        return {};
    }
    for (const world::PlacedObject& placed : world->placed) {
        out.hungDoors += placed.isHung ? 1 : 0;
        if (!placed.isHung)
            out.unresolved["the door stands before no opening"].push_back(placed.name);
    }
    return {};
}

} // namespace

Result<PlacedHealth> placedHealth(const PlacedObjects& placed, const dat::Archive& archive,
                                  const HealthProgress& progress) {
    const Result<std::vector<std::uint32_t>> ids = placed.database().landblocks();
    if (!ids)
        return Failure(ids.error());
    PlacedHealth health;
    for (std::size_t i = 0; i < ids->size(); ++i) {
        if (progress && !progress(i, ids->size()))
            return fail(ErrorCode::Unreadable, placed.database().path().string(),
                        "the comparison was cancelled");
        const dat::BlockCoord block{static_cast<int>((*ids)[i] >> 8 & 0xFF),
                                    static_cast<int>((*ids)[i] & 0xFF)};
        const Result<std::vector<world::PlacedEntry>> entries = placed.around(archive, block, {.radius = 0});
        if (!entries)
            return Failure(entries.error());
        std::vector<world::PlacedEntry> doors;
        for (const world::PlacedEntry& entry : *entries) {
            compareEntry(entry, archive, health);
            if (entry.kind == world::PlacedEntry::Kind::Door)
                doors.push_back(entry);
        }
        health.visible += entries->size();
        health.doors += doors.size();
        if (doors.empty())
            continue;
        if (Result<void> hung = hangDoors(archive, block, std::move(doors), health); !hung)
            return Failure(hung.error());
    }
    return health;
}

} // namespace limen::engine
