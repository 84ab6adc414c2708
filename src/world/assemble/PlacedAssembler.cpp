#include "world/assemble/PlacedAssembler.h"

#include "world/Ground.h"
#include "world/Lookup.h"
#include "world/assemble/PlacedLook.h"

#include <algorithm>
#include <tuple>

namespace limen::world {
namespace {

std::pair<int, int> keyOf(dat::BlockCoord block) {
    return {block.x, block.y};
}

} // namespace

PlacedAssembler::PlacedAssembler(std::span<const PlacedEntry> entries, Records& records,
                                 ObjectAssembler& objects, UsableAssembler& usables, World& world)
    : records_(records), objects_(objects), usables_(usables), world_(world) {
    for (const PlacedEntry& entry : entries)
        entries_.push_back(&entry);
    std::stable_sort(entries_.begin(), entries_.end(), [](const PlacedEntry* a, const PlacedEntry* b) {
        return std::tuple(keyOf(a->block), a->id) < std::tuple(keyOf(b->block), b->id);
    });
}

std::optional<std::uint32_t> PlacedAssembler::localCell(const PlacedEntry& entry, const BlockContent& block) {
    if (entry.cell == 0)
        return kOutdoorSpace;
    const auto found =
        std::lower_bound(block.cells.begin(), block.cells.end(), entry.cell,
                         [](const CellContent& cell, dat::RecordId id) { return cell.id < id; });
    if (found == block.cells.end() || found->id != entry.cell)
        return std::nullopt;
    return static_cast<std::uint32_t>(found - block.cells.begin());
}

Vec3 PlacedAssembler::localPosition(const PlacedEntry& entry, const Vec3& blockOrigin) const {
    Vec3 position = entry.position - blockOrigin;
    if (entry.isOnGround && entry.cell == 0) {
        const double ground = terrainHeight(world_, entry.position.x, entry.position.y);
        position.z = std::isfinite(ground) ? ground : position.z;
    }
    return position;
}

std::uint32_t PlacedAssembler::note(const PlacedEntry& entry, const ObjectSite& site) {
    PlacedObject placed;
    placed.object = dynamicObject(DynamicObject::Placed, entry.id);
    placed.name = entry.name;
    placed.model = entry.model;
    placed.origin = site.blockOrigin + localPosition(entry, site.blockOrigin);
    placed.orientation = entry.orientation;
    placed.scale = entry.scale;
    placed.space = site.space;
    placed.stopsBodies = entry.stopsBodies;
    placed.templateId = entry.templateId;
    placed.travel = entry.travel;
    world_.placed.push_back(std::move(placed));
    return static_cast<std::uint32_t>(world_.placed.size() - 1);
}

void PlacedAssembler::add(const JoiningBlock& block) {
    if (block.content.isFar)
        return;
    const auto [first, last] = std::equal_range(
        entries_.begin(), entries_.end(), block.content.coord, [](const auto& a, const auto& b) {
            if constexpr (std::is_pointer_v<std::decay_t<decltype(a)>>)
                return keyOf(a->block) < keyOf(b);
            else
                return keyOf(a) < keyOf(b->block);
        });
    for (auto at = first; at != last; ++at) {
        const PlacedEntry& entry = **at;
        const std::optional<std::uint32_t> cell = localCell(entry, block.content);
        if (!cell) {
            world_.findings.push_back(
                {entry.cell, "world.db: \"" + entry.name + "\" stands in a cell that does not exist"});
            continue;
        }
        const ObjectSite site = block.siteOf(*cell);
        const std::uint32_t placed = note(entry, site);
        if (entry.kind == PlacedEntry::Kind::Door)
            waiting_.push_back({&entry, site, placed});
        else
            addThing(entry, site);
    }
}

void PlacedAssembler::addThing(const PlacedEntry& entry, const ObjectSite& site) {
    const Dress dress = dressOf(entry, records_);
    PlacedModel object;
    object.model = entry.model;
    object.object = dynamicObject(DynamicObject::Placed, entry.id);
    object.origin = localPosition(entry, site.blockOrigin);
    object.orientation = entry.orientation;
    object.scale = entry.scale;
    object.motionTable = entry.motionTable;
    object.opacity = entry.opacity;
    object.scriptTable = entry.scriptTable;
    object.play = entry.play;
    object.dress = dress.empty() ? nullptr : &dress;
    if (usables_.add(entry, site.blockOrigin + object.origin, dress, site))
        objects_.addEffects(object, kNone, site);
    else
        objects_.addObject(object, site);
}

void PlacedAssembler::addDoors(PlacedDoorAssembler& doors) {
    for (const WaitingDoor& waiting : waiting_)
        world_.placed[waiting.placed].isHung = doors.add(*waiting.entry);
    doors.finish();
    for (const WaitingDoor& waiting : waiting_) {
        if (world_.placed[waiting.placed].isHung)
            continue;
        world_.findings.push_back(
            {waiting.entry->model, "world.db: the door \"" + waiting.entry->name +
                                       "\" stands before no opening: it does not open"});
        addThing(*waiting.entry, waiting.site);
    }
    waiting_.clear();
}

} // namespace limen::world
