#include "placements/store/ContentWriter.h"

#include "placements/TemplateFields.h"

namespace limen::placements {
namespace {

void bindSpot(Query& query, int first, const Spot& spot) {
    query.bind(first, spot.cell);
    for (int i = 0; i < 3; ++i)
        query.bindReal(first + 1 + i, static_cast<double>(spot.origin[i]));
    for (int i = 0; i < 4; ++i)
        query.bindReal(first + 4 + i, static_cast<double>(spot.angles[i]));
}

template <class T>
void bindOptional(Query& query, int parameter, const std::optional<T>& value) {
    if (!value)
        query.bindNull(parameter);
    else if constexpr (std::is_floating_point_v<T>)
        query.bindReal(parameter, static_cast<double>(*value));
    else
        query.bind(parameter, static_cast<std::int64_t>(*value));
}

void bindItem(Query& query, const CreatedItem& item) {
    query.bind(2, item.destination);
    query.bind(3, item.templateId);
    query.bind(4, item.palette);
    query.bindReal(5, static_cast<double>(item.shade));
}

void bindGenerator(Query& query, const GeneratorEntry& entry) {
    query.bindReal(2, static_cast<double>(entry.probability));
    query.bind(3, entry.templateId);
    query.bind(4, entry.initCreate);
    query.bind(5, entry.maxCreate);
    query.bind(6, entry.whenCreate);
    query.bind(7, entry.whereCreate);
    bindOptional(query, 8, entry.palette);
    bindOptional(query, 9, entry.shade);
    if (entry.spot)
        bindSpot(query, 10, *entry.spot);
    else
        for (int i = 10; i < 18; ++i)
            query.bindNull(i);
}

} // namespace

template <class T, class Bind>
Result<void> ContentWriter::addList(Statement statement, std::uint32_t id, const std::vector<T>& list,
                                    Bind&& bind) {
    Query& query = queries_[statement];
    for (std::size_t i = 0; i < list.size(); ++i) {
        query.bind(0, id);
        query.bind(1, static_cast<std::int64_t>(i));
        bind(query, list[i]);
        if (Result<void> done = query.execute(); !done)
            return done;
    }
    return {};
}

const std::array<const char*, ContentWriter::StatementCount> ContentWriter::kStatements{
    "INSERT INTO landblock VALUES(?,?)",
    "INSERT INTO placement VALUES(?,?,?,?,?,?,?,?,?,?,?,?)",
    "INSERT INTO link VALUES(?,?,?)",
    "INSERT INTO template VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,"
    "?,?,?,?,?,?,?,?,?,?,?,?,?)",
    "INSERT INTO template_palette VALUES(?,?,?,?,?)",
    "INSERT INTO template_texture VALUES(?,?,?,?,?)",
    "INSERT INTO template_part VALUES(?,?,?,?)",
    "INSERT INTO template_item VALUES(?,?,?,?,?,?)",
    "INSERT INTO template_generator VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)",
    "INSERT INTO template_destination VALUES(?,?,?,?,?,?,?,?,?)",
    "DELETE FROM placement WHERE landblock = ?",
    "DELETE FROM link WHERE landblock = ?",
    "DELETE FROM landblock WHERE id = ?",
    "DELETE FROM template_palette WHERE template = ?",
    "DELETE FROM template_texture WHERE template = ?",
    "DELETE FROM template_part WHERE template = ?",
    "DELETE FROM template_item WHERE template = ?",
    "DELETE FROM template_generator WHERE template = ?",
    "DELETE FROM template_destination WHERE template = ?",
    "DELETE FROM template WHERE id = ?"};

Result<void> ContentWriter::prepare(const Sqlite& file) {
    for (std::size_t i = 0; i < kStatements.size(); ++i) {
        Result<Query> query = file.prepare(kStatements[i]);
        if (!query)
            return Failure(query.error());
        queries_[i] = std::move(*query);
    }
    return {};
}

Result<void> ContentWriter::removeLandblock(std::uint32_t id) {
    for (const Statement statement : {RemovePlacements, RemoveLinks, RemoveLandblock})
        if (Result<void> done = removeBy(statement, id); !done)
            return done;
    return {};
}

Result<void> ContentWriter::removeTemplate(std::uint32_t id) {
    for (const Statement statement : {RemovePalettes, RemoveTextures, RemoveParts, RemoveItems,
                                      RemoveGenerators, RemoveDestination, RemoveTemplate})
        if (Result<void> done = removeBy(statement, id); !done)
            return done;
    return {};
}

Result<void> ContentWriter::add(std::uint32_t id, const Landblock& landblock, std::uint64_t hash) {
    Query& query = queries_[AddLandblock];
    query.bind(0, id);
    query.bind(1, static_cast<std::int64_t>(hash));
    if (Result<void> done = query.execute(); !done)
        return done;
    for (const Placement& placement : landblock.placements)
        if (Result<void> done = addPlacement(id, placement); !done)
            return done;
    for (const Link& link : landblock.links)
        if (Result<void> done = addLink(id, link); !done)
            return done;
    return {};
}

Result<void> ContentWriter::add(const Template& of, std::uint64_t hash) {
    return addRow(of, hash)
        .and_then([&] {
            return addList(AddPalette, of.id, of.palettes, [](Query& q, const PaletteChange& change) {
                q.bind(2, change.palette);
                q.bind(3, change.offset);
                q.bind(4, change.length);
            });
        })
        .and_then([&] {
            return addList(AddTexture, of.id, of.textures, [](Query& q, const TextureChange& change) {
                q.bind(2, change.part);
                q.bind(3, change.from);
                q.bind(4, change.to);
            });
        })
        .and_then([&] {
            return addList(AddPart, of.id, of.parts, [](Query& q, const PartChange& change) {
                q.bind(2, change.part);
                q.bind(3, change.model);
            });
        })
        .and_then([&] { return addList(AddItem, of.id, of.items, bindItem); })
        .and_then([&] { return addList(AddGenerator, of.id, of.generator, bindGenerator); })
        .and_then([&] { return addDestination(of); });
}

Result<void> ContentWriter::removeBy(Statement statement, std::uint32_t key) {
    queries_[statement].bind(0, key);
    return queries_[statement].execute();
}

Result<void> ContentWriter::addPlacement(std::uint32_t landblock, const Placement& placement) {
    Query& query = queries_[AddPlacement];
    query.bind(0, landblock);
    query.bind(1, placement.guid);
    query.bind(2, placement.templateId);
    bindSpot(query, 3, placement.spot);
    query.bind(11, placement.isLinkChild ? 1 : 0);
    return query.execute();
}

Result<void> ContentWriter::addLink(std::uint32_t landblock, const Link& link) {
    Query& query = queries_[AddLink];
    query.bind(0, landblock);
    query.bind(1, link.parent);
    query.bind(2, link.child);
    return query.execute();
}

Result<void> ContentWriter::addRow(const Template& of, std::uint64_t hash) {
    Query& query = queries_[AddTemplate];
    query.bind(0, of.id);
    query.bind(1, static_cast<std::int64_t>(hash));
    query.bindText(2, of.className);
    query.bind(3, of.type);
    query.bindText(4, of.name);
    int next = 5;
    for (const auto& field : kIdFields)
        query.bind(next++, of.*(field.member));
    for (const auto& field : kIntFields)
        bindOptional(query, next++, of.*(field.member));
    for (const auto& field : kRealFields)
        bindOptional(query, next++, of.*(field.member));
    for (const auto& field : kBoolFields)
        bindOptional(query, next++, of.*(field.member));
    return query.execute();
}

Result<void> ContentWriter::addDestination(const Template& of) {
    if (!of.destination)
        return {};
    Query& query = queries_[AddDestination];
    query.bind(0, of.id);
    bindSpot(query, 1, *of.destination);
    return query.execute();
}

} // namespace limen::placements
