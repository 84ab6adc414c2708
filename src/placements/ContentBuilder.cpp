#include "placements/ContentBuilder.h"

#include "core/Assert.h"
#include "placements/TemplateFields.h"
#include "placements/sql/Text.h"

#include <algorithm>
#include <fmt/format.h>

namespace limen::placements {
namespace {

constexpr std::size_t kMostPlacements = 8'000'000, kMostTemplates = 1'000'000;
constexpr std::size_t kMostRowsOfTemplate = 8'192; // of one table
constexpr std::size_t kMostChildren = 8'192;
constexpr std::int64_t kNameProperty = 1, kDestinationProperty = 2;

Failure refuse(std::string what) {
    return fail(ErrorCode::Malformed, "", std::move(what));
}

std::uint32_t unsignedOf(const Value& value) {
    return static_cast<std::uint32_t>(value.integer);
}
std::int32_t signedOf(const Value& value) {
    return static_cast<std::int32_t>(value.integer);
}
float floatOf(const Value& value) {
    return static_cast<float>(value.real);
}

/// A spot from eight columns: cell, origin, angles. None if one of them is NULL.
std::optional<Spot> spotOf(std::span<const Value, 8> row) {
    for (const Value& value : row)
        if (value.kind == Value::Kind::Null)
            return std::nullopt;
    return Spot{unsignedOf(row[0]),
                {floatOf(row[1]), floatOf(row[2]), floatOf(row[3])},
                {floatOf(row[4]), floatOf(row[5]), floatOf(row[6]), floatOf(row[7])}};
}

GeneratorEntry generatorOf(std::span<const Value> row) {
    GeneratorEntry entry;
    entry.probability = floatOf(row[2]);
    entry.templateId = unsignedOf(row[3]);
    entry.initCreate = signedOf(row[5]);
    entry.maxCreate = signedOf(row[6]);
    entry.whenCreate = unsignedOf(row[7]);
    entry.whereCreate = unsignedOf(row[8]);
    if (row[10].kind != Value::Kind::Null)
        entry.palette = unsignedOf(row[10]);
    if (row[11].kind != Value::Kind::Null)
        entry.shade = floatOf(row[11]);
    entry.spot = spotOf(row.subspan<12, 8>());
    return entry;
}

/// Adds a row of a table that is a list of properties of one type each.
void setProperty(TableKey key, Template& to, std::span<const Value> row) {
    const std::int64_t type = row[2].integer;
    switch (key) {
    case TableKey::Int:
        setField(kIntFields, to, type, signedOf(row[3]));
        break;
    case TableKey::Bool:
        setField(kBoolFields, to, type, row[3].integer != 0);
        break;
    case TableKey::Float:
        setField(kRealFields, to, type, row[3].real);
        break;
    case TableKey::String:
        if (type == kNameProperty)
            to.name = validUtf8(row[3].text); // a text with a character set comes as its bytes
        break;
    case TableKey::DataId:
        setField(kIdFields, to, type, unsignedOf(row[3]));
        break;
    case TableKey::Position:
        if (type == kDestinationProperty)
            to.destination = spotOf(row.subspan<3, 8>());
        break;
    default:
        LIMEN_ASSERT(false, "a table of typed properties");
    }
}

} // namespace

Result<void> ContentBuilder::add(const Table& table, Row row) {
    LIMEN_ASSERT(row.size() == table.columns.size(), "a value for each column");
    fitted_.assign(row.size(), Value());
    for (std::size_t i = 0; i < row.size(); ++i) {
        if (table.columns[i].type == ColumnType::Unread)
            continue;
        Result<Value> value = fitted(table, table.columns[i], row[i]);
        if (!value)
            return Failure(value.error());
        fitted_[i] = *value;
    }
    if (table.key == TableKey::Weenie)
        return addTemplate(fitted_);
    if (table.key == TableKey::Instance)
        return addInstance(fitted_);
    if (table.key == TableKey::InstanceLink)
        return addLink(fitted_);
    const std::uint32_t object = unsignedOf(fitted_[1]);
    const auto found = content_.templates.find(object);
    if (found == content_.templates.end())
        return refuse(
            fmt::format("{} has a row for template {}, which is not in weenie", table.name, object));
    return addProperty(table.key, found->second, fitted_);
}

Result<void> ContentBuilder::addTemplate(Row row) {
    const std::uint32_t id = unsignedOf(row[0]);
    if (content_.templates.size() == kMostTemplates)
        return refuse(fmt::format("there are more than {} templates", kMostTemplates));
    const auto [entry, isNew] = content_.templates.try_emplace(id);
    if (!isNew)
        return refuse(fmt::format("template {} is in weenie already", id));
    entry->second.id = id;
    entry->second.className = validUtf8(row[1].text);
    entry->second.type = signedOf(row[2]);
    return {};
}

Result<void> ContentBuilder::claim(TableKey table, std::uint32_t object, std::int64_t type) {
    std::vector<std::uint64_t>& keys = keys_[object];
    const std::uint64_t key = static_cast<std::uint64_t>(table) << 32 | static_cast<std::uint64_t>(type);
    if (std::find(keys.begin(), keys.end(), key) != keys.end())
        return refuse(fmt::format("template {} has property {} already", object, type));
    if (keys.size() == kMostRowsOfTemplate)
        return refuse(fmt::format("template {} has more than {} rows", object, kMostRowsOfTemplate));
    keys.push_back(key);
    return {};
}

Result<void> ContentBuilder::addProperty(TableKey key, Template& to, Row row) {
    const auto isFull = [&](std::size_t count) -> Result<void> {
        if (count >= kMostRowsOfTemplate)
            return refuse(fmt::format("template {} has more than {} rows", to.id, kMostRowsOfTemplate));
        return {};
    };
    switch (key) {
    case TableKey::Palette:
        to.palettes.push_back({unsignedOf(row[2]), static_cast<std::uint16_t>(row[3].integer),
                               static_cast<std::uint16_t>(row[4].integer)});
        return isFull(to.palettes.size());
    case TableKey::TextureMap:
        to.textures.push_back(
            {static_cast<std::uint8_t>(row[2].integer), unsignedOf(row[3]), unsignedOf(row[4])});
        return isFull(to.textures.size());
    case TableKey::AnimPart:
        to.parts.push_back({static_cast<std::uint8_t>(row[2].integer), unsignedOf(row[3])});
        return isFull(to.parts.size());
    case TableKey::CreateList:
        to.items.push_back({signedOf(row[2]), unsignedOf(row[3]), signedOf(row[5]), floatOf(row[6])});
        return isFull(to.items.size());
    case TableKey::Generator:
        to.generator.push_back(generatorOf(row));
        return isFull(to.generator.size());
    default:
        return claim(key, to.id, row[2].integer).map([&] { setProperty(key, to, row); });
    }
}

Result<void> ContentBuilder::addInstance(Row row) {
    Placement placement;
    placement.guid = unsignedOf(row[0]);
    placement.templateId = unsignedOf(row[1]);
    placement.spot = *spotOf(row.subspan<2, 8>());
    placement.isLinkChild = row[10].integer != 0;
    const std::uint32_t landblock = landblockOf(placement.spot);
    if (landblockOf_.size() == kMostPlacements)
        return refuse(fmt::format("there are more than {} placed objects", kMostPlacements));
    if (!landblockOf_.try_emplace(placement.guid, landblock).second)
        return refuse(fmt::format("guid 0x{:08X} is in landblock_instance already", placement.guid));
    content_.landblocks[landblock].placements.push_back(placement);
    return {};
}

Result<void> ContentBuilder::addLink(Row row) {
    const Link link{unsignedOf(row[1]), unsignedOf(row[2])};
    if (!landblockOf_.contains(link.parent))
        return refuse(fmt::format("the parent 0x{:08X} of a link is not in landblock_instance", link.parent));
    std::vector<std::uint32_t>& children = children_[link.parent];
    if (std::find(children.begin(), children.end(), link.child) != children.end())
        return refuse(
            fmt::format("the link from 0x{:08X} to 0x{:08X} is there already", link.parent, link.child));
    if (children.size() == kMostChildren)
        return refuse(fmt::format("guid 0x{:08X} has more than {} links", link.parent, kMostChildren));
    children.push_back(link.child);
    return {};
}

Result<void> ContentBuilder::remove(const Table& table, std::string_view column, std::int64_t value) {
    if (value < 0 || value > std::int64_t{0xFFFFFFFF})
        return {};
    const auto key = static_cast<std::uint32_t>(value);
    if (table.key == TableKey::Weenie && isSameName(column, "class_Id")) {
        removeTemplate(key);
        return {};
    }
    if (table.key == TableKey::Instance && isSameName(column, "landblock")) {
        removeLandblock(key);
        return {};
    }
    if (table.key == TableKey::Instance && isSameName(column, "guid")) {
        removeInstance(key);
        return {};
    }
    return refuse(fmt::format("cannot remove rows of {} by {}", table.name, printable(column)));
}

void ContentBuilder::removeTemplate(std::uint32_t id) {
    content_.templates.erase(id);
    keys_.erase(id);
}

void ContentBuilder::removeLandblock(std::uint32_t id) {
    const auto found = content_.landblocks.find(id);
    if (found == content_.landblocks.end())
        return;
    for (const Placement& placement : found->second.placements) {
        landblockOf_.erase(placement.guid);
        children_.erase(placement.guid);
    }
    content_.landblocks.erase(found);
}

void ContentBuilder::removeInstance(std::uint32_t guid) {
    const auto found = landblockOf_.find(guid);
    if (found == landblockOf_.end())
        return;
    const auto landblock = content_.landblocks.find(found->second);
    LIMEN_ASSERT(landblock != content_.landblocks.end(), "the guid's landblock has placements");
    std::erase_if(landblock->second.placements, [&](const Placement& p) { return p.guid == guid; });
    if (landblock->second.placements.empty())
        content_.landblocks.erase(landblock);
    landblockOf_.erase(found);
    children_.erase(guid);
}

Content ContentBuilder::finish() {
    for (const auto& [parent, children] : children_) {
        const auto found = landblockOf_.find(parent);
        LIMEN_ASSERT(found != landblockOf_.end(), "links are removed with their parents");
        for (const std::uint32_t child : children)
            content_.landblocks[found->second].links.push_back({parent, child});
    }
    for (auto& [id, landblock] : content_.landblocks) {
        std::sort(landblock.placements.begin(), landblock.placements.end(),
                  [](const Placement& a, const Placement& b) { return a.guid < b.guid; });
        std::sort(landblock.links.begin(), landblock.links.end());
    }
    Content done = std::move(content_);
    *this = ContentBuilder();
    return done;
}

} // namespace limen::placements
