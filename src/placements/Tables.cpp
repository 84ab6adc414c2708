#include "placements/Tables.h"

#include "core/Assert.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace limen::placements {
namespace {

using enum ColumnType;

constexpr std::array kWeenie{Column{"class_Id", Unsigned32}, Column{"class_Name", Text},
                             Column{"type", Signed32}, Column{"last_Modified"}};
constexpr std::array kInt{Column{"id"}, Column{"object_Id", Unsigned32}, Column{"type", Unsigned16},
                          Column{"value", Signed32}};
constexpr std::array kBool{Column{"id"}, Column{"object_Id", Unsigned32}, Column{"type", Unsigned16},
                           Column{"value", Bit}};
constexpr std::array kFloat{Column{"id"}, Column{"object_Id", Unsigned32}, Column{"type", Unsigned16},
                            Column{"value", Double}};
constexpr std::array kString{Column{"id"}, Column{"object_Id", Unsigned32}, Column{"type", Unsigned16},
                             Column{"value", Text}};
constexpr std::array kDataId{Column{"id"}, Column{"object_Id", Unsigned32}, Column{"type", Unsigned16},
                             Column{"value", Unsigned32}};
constexpr std::array kPalette{Column{"id"}, Column{"object_Id", Unsigned32},
                              Column{"sub_Palette_Id", Unsigned32}, Column{"offset", Unsigned16},
                              Column{"length", Unsigned16}};
constexpr std::array kTextureMap{Column{"id"}, Column{"object_Id", Unsigned32}, Column{"index", Unsigned8},
                                 Column{"old_Id", Unsigned32}, Column{"new_Id", Unsigned32}};
constexpr std::array kAnimPart{Column{"id"}, Column{"object_Id", Unsigned32}, Column{"index", Unsigned8},
                               Column{"animation_Id", Unsigned32}};
constexpr std::array kCreateList{Column{"id"},
                                 Column{"object_Id", Unsigned32},
                                 Column{"destination_Type", Signed8},
                                 Column{"weenie_Class_Id", Unsigned32},
                                 Column{"stack_Size"},
                                 Column{"palette", Signed8},
                                 Column{"shade", Float},
                                 Column{"try_To_Bond"}};
constexpr std::array kPosition{Column{"id"},
                               Column{"object_Id", Unsigned32},
                               Column{"position_Type", Unsigned16},
                               Column{"obj_Cell_Id", Unsigned32},
                               Column{"origin_X", Float},
                               Column{"origin_Y", Float},
                               Column{"origin_Z", Float},
                               Column{"angles_W", Float},
                               Column{"angles_X", Float},
                               Column{"angles_Y", Float},
                               Column{"angles_Z", Float}};
constexpr std::array kGenerator{Column{"id"},
                                Column{"object_Id", Unsigned32},
                                Column{"probability", Float},
                                Column{"weenie_Class_Id", Unsigned32},
                                Column{"delay"},
                                Column{"init_Create", Signed32},
                                Column{"max_Create", Signed32},
                                Column{"when_Create", Unsigned32},
                                Column{"where_Create", Unsigned32},
                                Column{"stack_Size"},
                                Column{"palette_Id", Unsigned32, true},
                                Column{"shade", Float, true},
                                Column{"obj_Cell_Id", Unsigned32, true},
                                Column{"origin_X", Float, true},
                                Column{"origin_Y", Float, true},
                                Column{"origin_Z", Float, true},
                                Column{"angles_W", Float, true},
                                Column{"angles_X", Float, true},
                                Column{"angles_Y", Float, true},
                                Column{"angles_Z", Float, true}};
constexpr std::array kInstance{Column{"guid", Unsigned32},        Column{"weenie_Class_Id", Unsigned32},
                               Column{"obj_Cell_Id", Unsigned32}, Column{"origin_X", Float},
                               Column{"origin_Y", Float},         Column{"origin_Z", Float},
                               Column{"angles_W", Float},         Column{"angles_X", Float},
                               Column{"angles_Y", Float},         Column{"angles_Z", Float},
                               Column{"is_Link_Child", Bit},      Column{"last_Modified"}};
constexpr std::array kInstanceLink{Column{"id"}, Column{"parent_GUID", Unsigned32},
                                   Column{"child_GUID", Unsigned32}, Column{"last_Modified"}};

constexpr std::array kTables{
    Table{TableKey::Weenie, "weenie", kWeenie, "class_Id"},
    Table{TableKey::Int, "weenie_properties_int", kInt, "id"},
    Table{TableKey::Bool, "weenie_properties_bool", kBool, "id"},
    Table{TableKey::Float, "weenie_properties_float", kFloat, "id"},
    Table{TableKey::String, "weenie_properties_string", kString, "id"},
    Table{TableKey::DataId, "weenie_properties_d_i_d", kDataId, "id"},
    Table{TableKey::Palette, "weenie_properties_palette", kPalette, "id"},
    Table{TableKey::TextureMap, "weenie_properties_texture_map", kTextureMap, "id"},
    Table{TableKey::AnimPart, "weenie_properties_anim_part", kAnimPart, "id"},
    Table{TableKey::CreateList, "weenie_properties_create_list", kCreateList, "id"},
    Table{TableKey::Position, "weenie_properties_position", kPosition, "id"},
    Table{TableKey::Generator, "weenie_properties_generator", kGenerator, "id"},
    Table{TableKey::Instance, "landblock_instance", kInstance, "guid"},
    Table{TableKey::InstanceLink, "landblock_instance_link", kInstanceLink, "id"},
};

constexpr char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
}

/// The least and the greatest value of an integer column.
struct Range {
    std::int64_t least = 0, greatest = 0;
};
Range rangeOf(ColumnType type) {
    switch (type) {
    case Signed8:
        return {-128, 127};
    case Unsigned8:
        return {0, 255};
    case Unsigned16:
        return {0, 65535};
    case Signed32:
        return {std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max()};
    case Unsigned32:
        return {0, std::numeric_limits<std::uint32_t>::max()};
    case Bit:
        return {0, 1};
    default:
        return {};
    }
}

Failure unfit(const Table& table, const Column& column, const char* expected) {
    return fail(ErrorCode::Malformed, "",
                fmt::format("the value of {}.{} is not {}", table.name, column.name, expected));
}

Result<Value> fittedReal(const Table& table, const Column& column, const Value& value) {
    double real = value.kind == Value::Kind::Integer ? static_cast<double>(value.integer) : value.real;
    if (value.kind != Value::Kind::Integer && value.kind != Value::Kind::Real)
        return unfit(table, column, "a number");
    if (column.type == Float) {
        if (!(std::abs(real) <= static_cast<double>(std::numeric_limits<float>::max())))
            return unfit(table, column, "a number of single precision");
        real = static_cast<double>(static_cast<float>(real));
    }
    if (!std::isfinite(real))
        return unfit(table, column, "a finite number");
    return Value{Value::Kind::Real, 0, real == 0.0 ? 0.0 : real, {}};
}

Result<Value> fittedInteger(const Table& table, const Column& column, const Value& value) {
    std::int64_t integer = value.integer;
    // A dump writes a bit as a string of one byte, a file as a number with fraction 0 only by mistake.
    if (column.type == Bit && value.kind == Value::Kind::Text && value.text.size() <= 1)
        integer = value.text.empty() ? 0 : static_cast<unsigned char>(value.text[0]);
    else if (value.kind != Value::Kind::Integer)
        return unfit(table, column, column.type == Bit ? "True or False" : "an integer");
    const Range range = rangeOf(column.type);
    if (integer < range.least || integer > range.greatest)
        return unfit(table, column, fmt::format("from {} to {}", range.least, range.greatest).c_str());
    return Value{Value::Kind::Integer, integer, 0.0, {}};
}

} // namespace

std::span<const Table> tables() {
    return kTables;
}

bool isSameName(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](char x, char y) { return lower(x) == lower(y); });
}

const Table* findTable(std::string_view name) {
    const auto found = std::find_if(kTables.begin(), kTables.end(),
                                    [&](const Table& t) { return isSameName(t.name, name); });
    return found != kTables.end() ? &*found : nullptr;
}

std::size_t findColumn(const Table& table, std::string_view name) {
    const auto found = std::find_if(table.columns.begin(), table.columns.end(),
                                    [&](const Column& c) { return isSameName(c.name, name); });
    return found != table.columns.end() ? static_cast<std::size_t>(found - table.columns.begin()) : kNoColumn;
}

Result<Value> fitted(const Table& table, const Column& column, const Value& value) {
    LIMEN_ASSERT(column.type != Unread, "unread columns are not fitted");
    if (value.kind == Value::Kind::Null) {
        if (column.mayBeNull)
            return value;
        return unfit(table, column, "allowed to be NULL");
    }
    if (column.type == Text) {
        if (value.kind != Value::Kind::Text)
            return unfit(table, column, "a string");
        return value;
    }
    return column.type == Float || column.type == Double ? fittedReal(table, column, value)
                                                         : fittedInteger(table, column, value);
}

} // namespace limen::placements
