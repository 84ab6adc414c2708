#include "placements/store/ContentHash.h"

#include "core/Hash.h"
#include "placements/TemplateFields.h"

namespace limen::placements {
namespace {

void addText(Hash& hash, const std::string& text) {
    hash.add(text.size());
    for (const char c : text)
        hash.add(c);
}

template <class T>
void addOptional(Hash& hash, const std::optional<T>& value) {
    hash.add(value.has_value());
    if (value)
        hash.add(*value);
}

void addSpot(Hash& hash, const Spot& spot) {
    hash.add(spot.cell);
    hash.add(spot.origin);
    hash.add(spot.angles);
}

void addSpot(Hash& hash, const std::optional<Spot>& spot) {
    hash.add(spot.has_value());
    if (spot)
        addSpot(hash, *spot);
}

void add(Hash& hash, const PaletteChange& change) {
    hash.add(change.palette);
    hash.add(change.offset);
    hash.add(change.length);
}
void add(Hash& hash, const TextureChange& change) {
    hash.add(change.part);
    hash.add(change.from);
    hash.add(change.to);
}
void add(Hash& hash, const PartChange& change) {
    hash.add(change.part);
    hash.add(change.model);
}
void add(Hash& hash, const CreatedItem& item) {
    hash.add(item.destination);
    hash.add(item.templateId);
    hash.add(item.palette);
    hash.add(item.shade);
}
void add(Hash& hash, const GeneratorEntry& entry) {
    hash.add(entry.probability);
    hash.add(entry.templateId);
    hash.add(entry.initCreate);
    hash.add(entry.maxCreate);
    hash.add(entry.whenCreate);
    hash.add(entry.whereCreate);
    addOptional(hash, entry.palette);
    addOptional(hash, entry.shade);
    addSpot(hash, entry.spot);
}

template <class T>
void addList(Hash& hash, const std::vector<T>& list) {
    hash.add(list.size());
    for (const T& entry : list)
        add(hash, entry);
}

} // namespace

std::uint64_t hashOf(const Landblock& landblock) {
    Hash hash;
    hash.add(landblock.placements.size());
    for (const Placement& placement : landblock.placements) {
        hash.add(placement.guid);
        hash.add(placement.templateId);
        addSpot(hash, placement.spot);
        hash.add(placement.isLinkChild);
    }
    for (const Link& link : landblock.links) {
        hash.add(link.parent);
        hash.add(link.child);
    }
    return hash.value();
}

std::uint64_t hashOf(const Template& of) {
    Hash hash;
    hash.add(of.id);
    addText(hash, of.className);
    hash.add(of.type);
    addText(hash, of.name);
    for (const auto& field : kIdFields)
        hash.add(of.*(field.member));
    for (const auto& field : kIntFields)
        addOptional(hash, of.*(field.member));
    for (const auto& field : kRealFields)
        addOptional(hash, of.*(field.member));
    for (const auto& field : kBoolFields)
        addOptional(hash, of.*(field.member));
    addList(hash, of.palettes);
    addList(hash, of.textures);
    addList(hash, of.parts);
    addList(hash, of.items);
    addList(hash, of.generator);
    addSpot(hash, of.destination);
    return hash.value();
}

} // namespace limen::placements
