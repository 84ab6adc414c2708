#pragma once

#include "placements/Placements.h"
#include "placements/store/Sqlite.h"

#include <array>

namespace limen::placements {

/// Writes landblocks and templates to the tables of an open world.db. Its statements are prepared once.
class ContentWriter {
public:
    /// Errors: the file lacks a table.
    [[nodiscard]] Result<void> prepare(const Sqlite& file);

    [[nodiscard]] Result<void> removeLandblock(std::uint32_t id);
    [[nodiscard]] Result<void> removeTemplate(std::uint32_t id);
    [[nodiscard]] Result<void> add(std::uint32_t id, const Landblock& landblock, std::uint64_t hash);
    [[nodiscard]] Result<void> add(const Template& of, std::uint64_t hash);

private:
    enum Statement : std::size_t {
        AddLandblock,
        AddPlacement,
        AddLink,
        AddTemplate,
        AddPalette,
        AddTexture,
        AddPart,
        AddItem,
        AddGenerator,
        AddDestination,
        RemovePlacements,
        RemoveLinks,
        RemoveLandblock,
        RemovePalettes,
        RemoveTextures,
        RemoveParts,
        RemoveItems,
        RemoveGenerators,
        RemoveDestination,
        RemoveTemplate,
        StatementCount
    };
    static const std::array<const char*, StatementCount> kStatements;

    [[nodiscard]] Result<void> removeBy(Statement statement, std::uint32_t key);
    [[nodiscard]] Result<void> addPlacement(std::uint32_t landblock, const Placement& placement);
    [[nodiscard]] Result<void> addLink(std::uint32_t landblock, const Link& link);
    [[nodiscard]] Result<void> addRow(const Template& of, std::uint64_t hash);
    [[nodiscard]] Result<void> addDestination(const Template& of);
    /// `bind` gives the values after the template's id and the number in the list.
    template <class T, class Bind>
    [[nodiscard]] Result<void> addList(Statement statement, std::uint32_t id, const std::vector<T>& list,
                                       Bind&& bind);

    std::array<Query, StatementCount> queries_;
};

} // namespace limen::placements
