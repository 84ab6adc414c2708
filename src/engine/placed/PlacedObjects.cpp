#include "engine/placed/PlacedObjects.h"

#include "placements/Equipment.h"
#include "placements/sql/Text.h"
#include "world/Nearby.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <tuple>

namespace limen::engine {
namespace {

using placements::Template;
using placements::TemplateType;

constexpr std::uint32_t kFirstIndoors = 0x0100;

Quat orientationOf(const placements::Spot& spot) {
    const Quat q(static_cast<double>(spot.angles[0]), static_cast<double>(spot.angles[1]),
                 static_cast<double>(spot.angles[2]), static_cast<double>(spot.angles[3]));
    const double length = glm::length(q);
    return length > 1e-6 && std::isfinite(length) ? q / length : Quat(1.0, 0.0, 0.0, 0.0);
}

dat::RecordId indoorCellOf(const placements::Spot& spot) {
    return (spot.cell & 0xFFFF) >= kFirstIndoors ? spot.cell : 0;
}

Vec3 globalOf(const placements::Spot& spot) {
    const dat::BlockCoord block = dat::blockOf(spot.cell);
    return Vec3(block.x * world::kBlockSize, block.y * world::kBlockSize, 0.0) +
           Vec3(static_cast<double>(spot.origin[0]), static_cast<double>(spot.origin[1]),
                static_cast<double>(spot.origin[2]));
}

world::TravelEntry travelOf(const placements::Spot& spot) {
    const Vec3 ahead = orientationOf(spot) * Vec3(0.0, 1.0, 0.0); // +y is north
    return {indoorCellOf(spot), globalOf(spot), std::atan2(ahead.x, ahead.y) * 180.0 / std::numbers::pi};
}

bool isSameText(const std::string& a, const std::string& b) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [&](char x, char y) { return lower(x) == lower(y); });
}

/// An eye in front of an object, at the height of a person's eyes.
world::Place viewBefore(const world::PlacedEntry& entry) {
    constexpr double kIndoors = 1.5, kOutdoors = 3.0, kEyes = 1.6; // metres
    const Vec3 front = entry.orientation * Vec3(0.0, 1.0, 0.0);
    world::Place place;
    place.name = entry.name;
    place.eye = entry.position + front * (entry.cell != 0 ? kIndoors : kOutdoors) + Vec3(0.0, 0.0, kEyes);
    place.yaw = std::atan2(-front.x, -front.y) * 180.0 / std::numbers::pi;
    place.cell = entry.cell;
    return place;
}

double scaleOf(const Template& of) {
    constexpr double kLeast = 0.01, kMost = 100.0; // a scale beyond is damaged data
    const double scale = of.scale.value_or(1.0);
    return scale >= kLeast && scale <= kMost ? scale : 1.0;
}

/// The garment of a template's ClothingBase, if it has one.
void addGarment(const Template& of, std::optional<std::int32_t> palette, std::optional<float> shade,
                std::vector<world::ClothingEntry>& out) {
    if (of.clothingBase == 0)
        return;
    const std::int32_t colours = palette.value_or(of.paletteTemplate.value_or(0));
    out.push_back({of.clothingBase,
                   colours > 0 ? static_cast<std::uint32_t>(colours) : 0,
                   {shade ? static_cast<double>(*shade) : of.shade.value_or(0.0)}});
}

world::LookEntry lookOf(const Template& of) {
    constexpr std::uint32_t kColours = 8,
                            kWhole = 2048; // ranges count groups of eight; 0 is the whole palette
    world::LookEntry look;
    for (const placements::PaletteChange& change : of.palettes)
        look.colours.push_back({change.palette, change.offset * kColours,
                                change.length != 0 ? change.length * kColours : kWhole});
    for (const placements::TextureChange& change : of.textures)
        look.textures.push_back({change.part, change.from, change.to});
    for (const placements::PartChange& change : of.parts)
        look.parts.push_back({change.part, change.model});
    return look;
}

/// The skin, hair and face that a template states. A texture without the plain one that it replaces has no effect.
world::LookEntry faceOf(const Template& of) {
    // Ranges of a person's palette, in colours, and the part of a person's Setup. Ref: the ACEmulator project.
    constexpr std::uint32_t kSkinEnd = 192, kHairEnd = 256, kEyesEnd = 320, kHead = 16;
    world::LookEntry look;
    const auto colour = [&](std::uint32_t palette, std::uint32_t from, std::uint32_t end) {
        if (palette != 0)
            look.colours.push_back({palette, from, end - from});
    };
    colour(of.skinPalette, 0, kSkinEnd);
    colour(of.hairPalette, kSkinEnd, kHairEnd);
    colour(of.eyesPalette, kHairEnd, kEyesEnd);
    const auto texture = [&](std::uint32_t plain, std::uint32_t own) {
        if (plain != 0 && own != 0)
            look.textures.push_back({kHead, plain, own});
    };
    texture(of.plainEyesTexture, of.eyesTexture);
    texture(of.plainNoseTexture, of.noseTexture);
    texture(of.plainMouthTexture, of.mouthTexture);
    if (of.headObject != 0)
        look.parts.push_back({kHead, of.headObject});
    return look;
}

/// Puts an item on the body or into a hand.
void addItem(const placements::EquippedItem& item, const Template& of, world::PlacedEntry& entry) {
    if (!item.grip) {
        addGarment(of, item.palette, item.shade, entry.clothing);
        return;
    }
    world::HeldEntry held;
    held.model = of.setup;
    held.location = item.grip->location;
    held.placement = item.grip->placement;
    held.scale = scaleOf(of);
    addGarment(of, item.palette, item.shade, held.clothing);
    held.basePalette = of.paletteBase;
    held.look = lookOf(of);
    entry.held.push_back(std::move(held));
}

/// Chests, levers and other things without life.
bool mayOpen(std::int32_t type) {
    constexpr std::array kTypes{TemplateType::Generic, TemplateType::Chest, TemplateType::Container,
                                TemplateType::PressurePlate, TemplateType::Switch};
    return std::any_of(kTypes.begin(), kTypes.end(),
                       [type](TemplateType each) { return type == static_cast<std::int32_t>(each); });
}

bool stopsBodies(const Template& of) {
    const auto state = static_cast<std::uint32_t>(of.physicsState.value_or(0));
    return (state & placements::kEthereal) == 0 && !of.ethereal.value_or(false) &&
           of.type != static_cast<std::int32_t>(TemplateType::Portal);
}

} // namespace

world::PlacedEntry placedEntry(const placements::Standing& standing, const Template& of,
                               const placements::FindTemplate& find) {
    world::PlacedEntry entry;
    const bool isDoor = of.type == static_cast<std::int32_t>(TemplateType::Door);
    entry.kind = isDoor ? world::PlacedEntry::Kind::Door : world::PlacedEntry::Kind::Thing;
    entry.id = standing.id;
    entry.templateId = standing.templateId;
    entry.name = fmt::format("{} {:08X}", placements::printable(of.name.empty() ? of.className : of.name),
                             standing.id);
    entry.model = of.setup;
    entry.motionTable = of.motionTable;
    const placements::Spot& spot = standing.spot;
    entry.cell = indoorCellOf(spot);
    entry.block = dat::blockOf(spot.cell);
    entry.position = globalOf(spot);
    entry.orientation = orientationOf(spot);
    entry.scale = scaleOf(of);
    entry.opacity = 1.0 - std::clamp(of.translucency.value_or(0.0), 0.0, 1.0);
    entry.isOpen = of.open.value_or(of.defaultOpen.value_or(false));
    entry.stopsBodies = stopsBodies(of);
    entry.isOnGround = standing.isScattered;
    addGarment(of, standing.palette, standing.shade, entry.clothing);
    for (const placements::EquippedItem& item : equipmentOf(of, standing.id, find))
        if (const Template* equipped = find(item.templateId))
            addItem(item, *equipped, entry);
    entry.basePalette = of.paletteBase;
    entry.beneath = faceOf(of);
    entry.look = lookOf(of);
    entry.mayOpen = mayOpen(of.type);
    entry.isLocked = of.locked.value_or(of.defaultLocked.value_or(false));
    entry.scriptTable = of.physicsEffects;
    entry.play = {of.physicsScript, of.scriptIntensity.value_or(1.0)};
    if (of.destination && of.type == static_cast<std::int32_t>(TemplateType::Portal))
        entry.travel = travelOf(*of.destination);
    return entry;
}

const Template* PlacedObjects::find(std::uint32_t id) const {
    const auto [entry, isNew] = templates_.try_emplace(id);
    if (isNew) {
        Result<std::optional<Template>> of = database_.findTemplate(id);
        if (of)
            entry->second = std::move(*of);
        else
            fault_ = Failure(of.error());
    }
    return entry->second ? &*entry->second : nullptr;
}

std::string nameWithoutGuid(const std::string& name) {
    constexpr std::size_t kGuid = 9; // with the blank before it
    const bool hasGuid = name.size() > kGuid && name[name.size() - kGuid] == ' ' &&
                         name.find_last_not_of("0123456789ABCDEFabcdef") == name.size() - kGuid;
    return hasGuid ? name.substr(0, name.size() - kGuid) : name;
}

std::optional<world::Place> PlacedObjects::viewOfPlacement(const placements::Placement& placement) const {
    const Template* of = find(placement.templateId);
    if (of == nullptr || !isVisible(*of))
        return {};
    const placements::Standing standing{placement.guid, of->id, placement.spot, false, {}, {}};
    return viewBefore(placedEntry(standing, *of, [this](std::uint32_t id) { return find(id); }));
}

Result<std::optional<world::Place>> PlacedObjects::viewOf(std::uint32_t guid) const {
    const Result<std::optional<placements::Placement>> found = database_.findPlacement(guid);
    if (!found)
        return Failure(found.error());
    const std::lock_guard guard(lock_);
    std::optional<world::Place> view = *found ? viewOfPlacement(**found) : std::nullopt;
    return fault_.map([&] { return std::move(view); });
}

Result<std::vector<FoundObject>> PlacedObjects::search(const std::string& name, const Vec3& from,
                                                       std::size_t limit) const {
    constexpr std::size_t kMostCompared = 100'000;
    if (name.empty())
        return std::vector<FoundObject>();
    const Result<std::vector<placements::Found>> found = database_.search(name, std::nullopt, kMostCompared);
    if (!found)
        return Failure(found.error());
    std::vector<std::pair<double, std::size_t>> nearest; // metres along the ground
    for (std::size_t i = 0; i < found->size(); ++i)
        nearest.emplace_back(glm::distance(Vec2(globalOf((*found)[i].placement.spot)), Vec2(from)), i);
    std::sort(nearest.begin(), nearest.end());
    std::vector<FoundObject> objects;
    const std::lock_guard guard(lock_);
    for (const auto& [distance, i] : nearest) {
        if (objects.size() == limit)
            break;
        const placements::Found& one = (*found)[i];
        const Template* of = find(one.placement.templateId);
        if (of != nullptr && isVisible(*of))
            objects.push_back({one.placement.guid, one.name, placements::typeName(one.type),
                               globalOf(one.placement.spot), indoorCellOf(one.placement.spot)});
    }
    return fault_.map([&] { return std::move(objects); });
}

Result<std::vector<Vec3>> PlacedObjects::positionsOf(placements::TemplateType type,
                                                     const std::function<bool()>& proceed) const {
    std::vector<Vec3> positions;
    return database_
        .eachOfType(static_cast<std::int32_t>(type),
                    [&](const placements::Spot& spot) {
                        positions.push_back(globalOf(spot));
                        return !proceed || proceed();
                    })
        .map([&] { return std::move(positions); });
}

Result<std::vector<placements::Placement>> PlacedObjects::named(const std::string& name) const {
    constexpr std::size_t kMostFound = 1000;
    Result<std::vector<placements::Found>> found =
        database_.search(nameWithoutGuid(name), std::nullopt, kMostFound);
    if (!found)
        return Failure(found.error());
    // The object itself, then those whose whole name is the text, then those whose name contains it.
    const auto rank = [&](const placements::Found& one) {
        return fmt::format("{} {:08X}", one.name, one.placement.guid) == name ? 0
               : isSameText(one.name, name)                                   ? 1
                                                                              : 2;
    };
    std::stable_sort(found->begin(), found->end(),
                     [&](const placements::Found& a, const placements::Found& b) {
                         return std::tuple(rank(a), a.placement.guid) < std::tuple(rank(b), b.placement.guid);
                     });
    std::vector<placements::Placement> placements;
    for (const placements::Found& one : *found)
        if (rank(one) < 2 || nameWithoutGuid(name) == name)
            placements.push_back(one.placement);
    return placements;
}

Result<std::optional<world::Place>> PlacedObjects::viewOf(const std::string& name) const {
    const Result<std::vector<placements::Placement>> candidates = named(name);
    if (!candidates)
        return Failure(candidates.error());
    const std::lock_guard guard(lock_);
    for (const placements::Placement& placement : *candidates)
        if (std::optional<world::Place> view = viewOfPlacement(placement))
            return view;
    return fault_.map([] { return std::optional<world::Place>(); });
}

Result<std::optional<Vec3>> PlacedObjects::positionOf(const std::string& name) const {
    const Result<std::vector<placements::Placement>> candidates = named(name);
    if (!candidates)
        return Failure(candidates.error());
    const std::lock_guard guard(lock_);
    for (const placements::Placement& placement : *candidates)
        if (viewOfPlacement(placement))
            return std::optional(globalOf(placement.spot));
    return fault_.map([] { return std::optional<Vec3>(); });
}

Result<void> PlacedObjects::addBlock(dat::BlockCoord block, std::vector<world::PlacedEntry>& out) const {
    const auto number = static_cast<std::uint32_t>(block.x) << 8 | static_cast<std::uint32_t>(block.y);
    const Result<placements::Landblock> landblock = database_.landblock(number);
    if (!landblock)
        return Failure(landblock.error());
    const std::lock_guard guard(lock_);
    constexpr std::size_t kMostTemplates = 4096; // some MiB; pointers to them are not kept between blocks
    if (templates_.size() > kMostTemplates)
        templates_.clear();
    const placements::FindTemplate findTemplate = [this](std::uint32_t id) { return find(id); };
    for (const placements::Standing& standing : standingIn(*landblock, findTemplate))
        if (const Template* of = find(standing.templateId))
            out.push_back(placedEntry(standing, *of, findTemplate));
    return fault_;
}

Result<std::vector<world::PlacedEntry>> PlacedObjects::around(const dat::Archive& archive,
                                                              dat::BlockCoord centre,
                                                              const world::LoadOptions& options) const {
    std::vector<world::PlacedEntry> entries;
    const int radius = world::isDungeon(archive, centre) ? 0 : std::clamp(options.radius, 0, 255);
    for (const dat::BlockCoord block : world::blocksAround(centre, radius))
        if (Result<void> added = addBlock(block, entries); !added)
            return Failure(added.error());
    return entries;
}

} // namespace limen::engine
