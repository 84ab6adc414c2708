#include "placements/ExportSql.h"

#include "placements/TemplateFields.h"

#include <fmt/format.h>
#include <iterator>

namespace limen::placements {
namespace {

/// A string literal.
std::string quoted(const std::string& text) {
    std::string literal = "'";
    for (const char c : text)
        if (c == '\0')
            literal += "\\0";
        else if (c == '\\' || c == '\'')
            literal += std::string(2, c);
        else
            literal += c;
    return literal + "'";
}

/// The columns of a position: cell, origin, angles. The shortest decimals that give the same floats.
std::string columnsOf(const Spot& spot) {
    return fmt::format("0x{:08X}, {}, {}, {}, {}, {}, {}, {}", spot.cell, spot.origin[0], spot.origin[1],
                       spot.origin[2], spot.angles[0], spot.angles[1], spot.angles[2], spot.angles[3]);
}

template <class T>
std::string orNullText(const std::optional<T>& value) {
    return value ? fmt::format("{}", *value) : "NULL";
}

constexpr const char* kSpotColumns =
    "`obj_Cell_Id`, `origin_X`, `origin_Y`, `origin_Z`, `angles_W`, `angles_X`, `angles_Y`, `angles_Z`";

/// INSERT statements of one table. Nothing without rows.
class Insert {
public:
    Insert(std::string table, std::string columns) : table_(std::move(table)), columns_(std::move(columns)) {}
    void add(const std::string& values) {
        constexpr int kRowsOfAStatement = 1000;
        if (rows_ % kRowsOfAStatement == 0)
            text_ += fmt::format("{}INSERT INTO `{}` ({})\nVALUES ({})", rows_ > 0 ? ";\n\n" : "", table_,
                                 columns_, values);
        else
            text_ += fmt::format("\n     , ({})", values);
        ++rows_;
    }
    [[nodiscard]] std::string text() const { return rows_ > 0 ? text_ + ";\n\n" : ""; }

private:
    std::string table_, columns_, text_;
    int rows_ = 0;
};

/// A list of typed properties of one template.
class Properties {
public:
    Properties(std::uint32_t id, const char* kind)
        : id_(id), insert_(std::string("weenie_properties_") + kind, "`object_Id`, `type`, `value`") {}
    template <class T>
    void add(std::int64_t type, const std::optional<T>& value) {
        if (!value)
            return;
        if constexpr (std::is_same_v<T, bool>)
            insert_.add(fmt::format("{}, {}, {}", id_, type, *value ? "True" : "False"));
        else
            insert_.add(fmt::format("{}, {}, {}", id_, type, *value));
    }
    void addId(std::int64_t type, std::uint32_t value) {
        if (value != 0)
            insert_.add(fmt::format("{}, {}, 0x{:08X}", id_, type, value));
    }
    void addText(int type, const std::string& value) {
        if (!value.empty())
            insert_.add(fmt::format("{}, {}, {}", id_, type, quoted(value)));
    }
    [[nodiscard]] std::string text() const { return insert_.text(); }

private:
    std::uint32_t id_;
    Insert insert_;
};

std::string propertiesOf(const Template& of) {
    Properties ints(of.id, "int"), bools(of.id, "bool"), floats(of.id, "float"), strings(of.id, "string"),
        ids(of.id, "d_i_d");
    for (const auto& field : kIntFields)
        ints.add(field.property, of.*(field.member));
    for (const auto& field : kBoolFields)
        bools.add(field.property, of.*(field.member));
    for (const auto& field : kRealFields)
        floats.add(field.property, of.*(field.member));
    strings.addText(1, of.name);
    for (const auto& field : kIdFields)
        ids.addId(field.property, of.*(field.member));
    return ints.text() + bools.text() + floats.text() + strings.text() + ids.text();
}

std::string overridesOf(const Template& of) {
    Insert palettes("weenie_properties_palette", "`object_Id`, `sub_Palette_Id`, `offset`, `length`");
    for (const PaletteChange& change : of.palettes)
        palettes.add(
            fmt::format("{}, 0x{:08X}, {}, {}", of.id, change.palette, change.offset, change.length));
    Insert textures("weenie_properties_texture_map", "`object_Id`, `index`, `old_Id`, `new_Id`");
    for (const TextureChange& change : of.textures)
        textures.add(fmt::format("{}, {}, 0x{:08X}, 0x{:08X}", of.id, change.part, change.from, change.to));
    Insert parts("weenie_properties_anim_part", "`object_Id`, `index`, `animation_Id`");
    for (const PartChange& change : of.parts)
        parts.add(fmt::format("{}, {}, 0x{:08X}", of.id, change.part, change.model));
    return palettes.text() + textures.text() + parts.text();
}

std::string itemsOf(const Template& of) {
    Insert insert("weenie_properties_create_list", "`object_Id`, `destination_Type`, `weenie_Class_Id`, "
                                                   "`stack_Size`, `palette`, `shade`, `try_To_Bond`");
    for (const CreatedItem& item : of.items)
        insert.add(fmt::format("{}, {}, {}, 0, {}, {}, False", of.id, item.destination, item.templateId,
                               item.palette, item.shade));
    return insert.text();
}

std::string generatorRowsOf(const Template& of) {
    Insert insert(
        "weenie_properties_generator",
        fmt::format("`object_Id`, `probability`, `weenie_Class_Id`, `delay`, `init_Create`, `max_Create`, "
                    "`when_Create`, `where_Create`, `stack_Size`, `palette_Id`, `shade`, {}",
                    kSpotColumns));
    for (const GeneratorEntry& entry : of.generator)
        insert.add(fmt::format("{}, {}, {}, 0, {}, {}, {}, {}, -1, {}, {}, {}", of.id, entry.probability,
                               entry.templateId, entry.initCreate, entry.maxCreate, entry.whenCreate,
                               entry.whereCreate, orNullText(entry.palette), orNullText(entry.shade),
                               entry.spot ? columnsOf(*entry.spot)
                                          : "NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL"));
    return insert.text();
}

std::string destinationOf(const Template& of) {
    Insert insert("weenie_properties_position",
                  fmt::format("`object_Id`, `position_Type`, {}", kSpotColumns));
    if (of.destination)
        insert.add(fmt::format("{}, 2, {}", of.id, columnsOf(*of.destination)));
    return insert.text();
}

/// A name as a part of a file's name: other characters than letters, digits and blanks become '_'.
std::string fileNamePart(const std::string& text) {
    constexpr std::size_t kMost = 80;
    std::string part;
    for (const char c : text.substr(0, kMost)) {
        const bool isPlain =
            (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == ' ';
        part += isPlain ? c : '_';
    }
    return part;
}

} // namespace

SqlText sqlOf(std::uint32_t id, const Landblock& landblock) {
    Insert instances(
        "landblock_instance",
        fmt::format("`guid`, `weenie_Class_Id`, {}, `is_Link_Child`, `last_Modified`", kSpotColumns));
    for (const Placement& placement : landblock.placements)
        instances.add(fmt::format("0x{:08X}, {}, {}, {}, '2000-01-01 00:00:00'", placement.guid,
                                  placement.templateId, columnsOf(placement.spot),
                                  placement.isLinkChild ? "True" : "False"));
    Insert links("landblock_instance_link", "`parent_GUID`, `child_GUID`, `last_Modified`");
    for (const Link& link : landblock.links)
        links.add(fmt::format("0x{:08X}, 0x{:08X}, '2000-01-01 00:00:00'", link.parent, link.child));
    return {fmt::format("6 LandBlockExtendedData/{:04X}.sql", id),
            fmt::format("DELETE FROM `landblock_instance` WHERE `landblock` = 0x{:04X};\n\n{}{}", id,
                        instances.text(), links.text())};
}

SqlText sqlOf(const Template& of) {
    const std::string name = of.name.empty() ? of.className : of.name;
    return {
        fmt::format("9 WeenieDefaults/{:05} {}.sql", of.id, fileNamePart(name)),
        fmt::format(
            "DELETE FROM `weenie` WHERE `class_Id` = {0};\n\nINSERT INTO `weenie` (`class_Id`, `class_Name`, "
            "`type`, `last_Modified`)\nVALUES ({0}, {1}, {2}, '2000-01-01 00:00:00');\n\n{3}{4}{5}{6}{7}",
            of.id, quoted(of.className), of.type, propertiesOf(of), overridesOf(of), itemsOf(of),
            generatorRowsOf(of), destinationOf(of))};
}

} // namespace limen::placements
