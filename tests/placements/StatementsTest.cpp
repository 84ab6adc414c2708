#include "placements/sql/Statements.h"

#include <cmath>
#include <cstring>
#include <gtest/gtest.h>

// Statements of SQL, typed by hand in the form of the published files.
namespace {

using namespace limen;
using namespace limen::placements;

Result<Content> contentOf(const std::string& text) {
    std::size_t at = 0;
    Tokens tokens(
        [&](std::span<char> out) -> Result<std::size_t> {
            const std::size_t count = std::min(out.size(), text.size() - at);
            std::memcpy(out.data(), text.data() + at, count);
            at += count;
            return count;
        },
        "f.sql");
    ContentBuilder builder;
    const Result<void> done = executeSql(tokens, builder);
    if (!done)
        return Failure(done.error());
    return builder.finish();
}

std::string faultOf(const std::string& text) {
    const Result<Content> content = contentOf(text);
    return content ? "" : content.error().message();
}

constexpr const char* kInstanceColumns = "`guid`, `weenie_Class_Id`, `obj_Cell_Id`, `origin_X`, `origin_Y`, "
                                         "`origin_Z`, `angles_W`, `angles_X`, `angles_Y`, "
                                         "`angles_Z`, `is_Link_Child`, `last_Modified`";

std::string instance(const std::string& values) {
    return std::string("INSERT INTO `landblock_instance` (") + kInstanceColumns + ")\nVALUES (" + values +
           ");\n";
}
const std::string kDoorValues =
    "0x7C000001,   5, 0xC0010100, 12.5, -3, 0.25, -0.707107, 0, 0, 0.707107, False, '2020-01-02 03:04:05'";
const std::string kWeenie = "INSERT INTO `weenie` (`class_Id`, `class_Name`, `type`, `last_Modified`)\n"
                            "VALUES (5, 'gate', 19, '2020-01-01 00:00:00') /* Door */;\n";

TEST(Statements, readAPlacedObject) {
    const Result<Content> content =
        contentOf("DELETE FROM `landblock_instance` WHERE `landblock` = 0xC001;\n\n" + instance(kDoorValues) +
                  "/* @teleloc 0xC0010100 [12 -3 0.25] 1 0 0 0 */\n");
    ASSERT_TRUE(content.has_value()) << content.error().message();
    ASSERT_EQ(content->landblocks.size(), 1u);
    const Landblock& landblock = content->landblocks.at(0xC001);
    ASSERT_EQ(landblock.placements.size(), 1u);
    EXPECT_EQ(
        landblock.placements[0],
        (Placement{
            0x7C000001, 5, {0xC0010100, {12.5f, -3.0f, 0.25f}, {-0.707107f, 0.0f, 0.0f, 0.707107f}}, false}));
}

TEST(Statements, readLinksAndLinkChildren) {
    const Result<Content> content =
        contentOf(instance(kDoorValues) +
                  instance("0x7C000000, 6, 0xC0010000, 1, 2, 3, 1, 0, 0, 0,  True, '2020-01-02'") +
                  "INSERT INTO `landblock_instance_link` (`parent_GUID`, `child_GUID`, `last_Modified`)\n"
                  "VALUES (0x7C000001, 0x7C000009, '2020-01-02') /* a */\n     , (0x7C000001, 0x7C000000, "
                  "'2020-01-02') /* b */;");
    ASSERT_TRUE(content.has_value()) << content.error().message();
    const Landblock& landblock = content->landblocks.at(0xC001);
    EXPECT_EQ(landblock.placements[0].guid, 0x7C000000u) << "ascending guids";
    EXPECT_TRUE(landblock.placements[0].isLinkChild);
    EXPECT_EQ(landblock.links, (std::vector<Link>{{0x7C000001, 0x7C000000}, {0x7C000001, 0x7C000009}}));
}

TEST(Statements, readEveryMemberOfATemplate) {
    const Result<Content> content = contentOf(
        kWeenie +
        "INSERT INTO `weenie_properties_int` (`object_Id`, `type`, `value`) VALUES (5, 3, 4), (5, "
        "81, 2), (5, 82, 1) , "
        "(5,  93,       1044) /* PhysicsState */, (5, 1, 128), (5, 4, 32), (5, 9, 0x200000), (5, 46, 16), "
        "(5, "
        "52, 3), (5, 65, 6), (5, 999, 1);\n"
        "INSERT INTO weenie_properties_bool (object_Id, type, value) VALUES (5, 2, True ), (5, 3, "
        "False), (5, 13, True), "
        "(5, 18, False), (5, 34, True), (5, 35, True), (5, 71, False), (5, 1, True);\n"
        "insert into weenie_properties_float (`object_Id`, `type`, `value`) values (5, 12, 0.5), "
        "(5, 39, 1.25), (5, 43, 3), "
        "(5, 76, .75), (5, 77, 0.125), (5, 11, 300);\n"
        "INSERT INTO `weenie_properties_string` (`object_Id`, `type`, `value`) VALUES (5, 1, 'The "
        "''Old'' Gate'), (5, 14, 'x');\n"
        "INSERT INTO `weenie_properties_d_i_d` (`object_Id`, `type`, `value`) VALUES (5, 1, "
        "0x02000001), (5, 2, 0x09000002), "
        "(5, 6, 0x04000003), (5, 7, 0x10000004), (5, 22, 0x34000005), (5, 8, 0x06000006), "
        "(5, 9, 0x05000011), (5, 10, 0x05000012), (5, 11, 0x05000013), (5, 12, 0x05000014), (5, 13, "
        "0x05000015), (5, 14, 0x05000016), (5, 15, 0x04000017), (5, 16, 0x04000018), (5, 17, "
        "0x04000019), (5, 18, 0x0100001A), (5, 30, 87);\n"
        "INSERT INTO `weenie_properties_palette` (`object_Id`, `sub_Palette_Id`, `offset`, "
        "`length`) VALUES (5, 0x04000007, 8, 16);\n"
        "INSERT INTO `weenie_properties_texture_map` (`object_Id`, `index`, `old_Id`, `new_Id`) "
        "VALUES (5, 2, 0x05000001, 0x05000002);\n"
        "INSERT INTO `weenie_properties_anim_part` (`object_Id`, `index`, `animation_Id`) VALUES "
        "(5, 3, 0x01000009);\n"
        "INSERT INTO `weenie_properties_create_list` (`object_Id`, `destination_Type`, "
        "`weenie_Class_Id`, `stack_Size`, "
        "`palette`, `shade`, `try_To_Bond`) VALUES (5, 2, 124, 0, 7, 0.33, False), (5, -1, 127, 0, "
        "8, 1, False);\n"
        "INSERT INTO `weenie_properties_position` (`object_Id`, `position_Type`, `obj_Cell_Id`, "
        "`origin_X`, `origin_Y`, "
        "`origin_Z`, `angles_W`, `angles_X`, `angles_Y`, `angles_Z`) VALUES (5, 2, 0x01020103, 30, "
        "-60, 6, 1, 0, 0, 0)\n"
        "/* @teleloc 0x01020103 [30 -60 6] 1 0 0 0 */;\n"
        "INSERT INTO `weenie_properties_generator` (`object_Id`, `probability`, `weenie_Class_Id`, "
        "`delay`, `init_Create`, "
        "`max_Create`, `when_Create`, `where_Create`, `stack_Size`, `palette_Id`, `shade`, "
        "`obj_Cell_Id`, `origin_X`, "
        "`origin_Y`, `origin_Z`, `angles_W`, `angles_X`, `angles_Y`, `angles_Z`) VALUES (5, 0.9, "
        "14, 300, 1, 3, 1, 2, -1, "
        "NULL, 0.5, 0, 1, 2, 3, 1, 0, 0, 0);\n");
    ASSERT_TRUE(content.has_value()) << content.error().message();
    Template expected;
    expected.id = 5;
    expected.className = "gate";
    expected.type = 19;
    expected.name = "The 'Old' Gate";
    expected.setup = 0x02000001;
    expected.itemType = 128;
    expected.clothingPriority = 32;
    expected.validLocations = 0x200000;
    expected.combatStyle = 16;
    expected.parentLocation = 3;
    expected.placementPosition = 6;
    expected.scriptIntensity = 0.125;
    expected.eyesTexture = 0x05000011;
    expected.noseTexture = 0x05000012;
    expected.mouthTexture = 0x05000013;
    expected.plainEyesTexture = 0x05000014;
    expected.plainNoseTexture = 0x05000015;
    expected.plainMouthTexture = 0x05000016;
    expected.hairPalette = 0x04000017;
    expected.eyesPalette = 0x04000018;
    expected.skinPalette = 0x04000019;
    expected.headObject = 0x0100001A;
    expected.physicsScript = 87;
    expected.motionTable = 0x09000002;
    expected.paletteBase = 0x04000003;
    expected.clothingBase = 0x10000004;
    expected.physicsEffects = 0x34000005;
    expected.paletteTemplate = 4;
    expected.physicsState = 1044;
    expected.maxGenerated = 2;
    expected.initGenerated = 1;
    expected.shade = 0.5;
    expected.scale = 1.25;
    expected.translucency = 0.75;
    expected.generatorRadius = 3.0;
    expected.open = true;
    expected.locked = false;
    expected.ethereal = true;
    expected.visibility = false;
    expected.defaultOpen = true;
    expected.defaultLocked = true;
    expected.noDraw = false;
    expected.palettes = {{0x04000007, 8, 16}};
    expected.textures = {{2, 0x05000001, 0x05000002}};
    expected.parts = {{3, 0x01000009}};
    expected.items = {{2, 124, 7, 0.33f}, {-1, 127, 8, 1.0f}};
    expected.destination = Spot{0x01020103, {30.0f, -60.0f, 6.0f}, {1.0f, 0.0f, 0.0f, 0.0f}};
    expected.generator = {
        {0.9f, 14, 1, 3, 1, 2, std::nullopt, 0.5f, Spot{0, {1.0f, 2.0f, 3.0f}, {1.0f, 0.0f, 0.0f, 0.0f}}}};
    EXPECT_EQ(content->templates.at(5), expected);
}

TEST(Statements, skipOtherTablesAndStatements) {
    const Result<Content> content = contentOf(
        "/*!40101 SET NAMES utf8mb4 */;\nUSE `world`;\nLOCK TABLES `weenie` WRITE;\n"
        "CREATE TABLE `x` (`a` int COMMENT 'it''s; here');\nDELETE FROM `spell`;\nUPDATE `quest` SET `a` = "
        "1;\n"
        "INSERT INTO `weenie_properties_emote` VALUES (1, 'a;b', NULL);\nSET @parent_id = LAST_INSERT_ID();\n"
        "INSERT INTO `weenie_properties_emote_action` (`emote_Id`) VALUES (@parent_id);\n" +
        kWeenie + "UNLOCK TABLES;\n");
    ASSERT_TRUE(content.has_value()) << content.error().message();
    EXPECT_EQ(content->templates.size(), 1u);
}

TEST(Statements, readADumpWithoutListsOfColumns) {
    const Result<Content> content = contentOf("INSERT INTO `weenie` VALUES (5,'gate',19,'2020-01-01 "
                                              "00:00:00'),(6,'it\\'s',1,'2020-01-01 00:00:00');\n"
                                              "INSERT INTO `weenie_properties_bool` VALUES (1,5,2,_binary "
                                              "'\x01'),(2,5,3,_binary '\\0'),(3,5,13,b'1'),(4,5,71,0x01);\n");
    ASSERT_TRUE(content.has_value()) << content.error().message();
    EXPECT_EQ(content->templates.at(6).className, "it's");
    EXPECT_EQ(content->templates.at(5).open, true);
    EXPECT_EQ(content->templates.at(5).locked, false);
    EXPECT_EQ(content->templates.at(5).ethereal, true);
    EXPECT_EQ(content->templates.at(5).noDraw, true);
}

TEST(Statements, acceptColumnsInAnyOrderAndUnknownOnes) {
    const Result<Content> content = contentOf(
        "INSERT INTO `weenie` (`type`, `future`, `class_Name`, `class_Id`) VALUES (19, NOW(), 'gate', 5);");
    ASSERT_TRUE(content.has_value()) << content.error().message();
    EXPECT_EQ(content->templates.at(5).type, 19);
}

TEST(Statements, aDeleteRemovesTheRowsAndThoseThatReferToThem) {
    const std::string string =
        "INSERT INTO `weenie_properties_string` (`object_Id`, `type`, `value`) VALUES (5, 1, 'a');";
    const std::string link = "INSERT INTO `landblock_instance_link` (`parent_GUID`, `child_GUID`) VALUES "
                             "(0x7C000001, 0x7C000009);";
    Result<Content> content =
        contentOf(kWeenie + string + "DELETE FROM `weenie` WHERE `class_Id` = 5;" + kWeenie);
    ASSERT_TRUE(content.has_value()) << content.error().message();
    EXPECT_EQ(content->templates.at(5).name, "");
    content = contentOf(instance(kDoorValues) + link +
                        "DELETE FROM landblock_instance WHERE landblock = 0xC001;" + instance(kDoorValues));
    ASSERT_TRUE(content.has_value()) << content.error().message();
    EXPECT_TRUE(content->landblocks.at(0xC001).links.empty());
    content =
        contentOf(instance(kDoorValues) + link + "DELETE FROM landblock_instance WHERE guid = 0x7C000001;");
    ASSERT_TRUE(content.has_value()) << content.error().message();
    EXPECT_TRUE(content->landblocks.empty());
}

TEST(Statements, textsAreUtf8WhateverTheirCharacterSet) {
    const Result<Content> content =
        contentOf("INSERT INTO `weenie` (`class_Id`, `class_Name`, `type`, `last_Modified`)\n"
                  "VALUES (5, _binary 'a\xA0', 19, '2020-01-01 00:00:00');\n"
                  "INSERT INTO `weenie_properties_string` (`object_Id`, `type`, `value`) VALUES (5, 1, "
                  "_latin1 'b\xFF');");
    ASSERT_TRUE(content.has_value()) << content.error().message();
    EXPECT_EQ(content->templates.at(5).className, "a\uFFFD");
    EXPECT_EQ(content->templates.at(5).name, "b\uFFFD");
}

TEST(Statements, minusZeroIsZero) {
    const Result<Content> content =
        contentOf(instance("1, 5, 0xC0010100, -0, -0.0, -0e0, 1, 0, 0, 0, False, ''"));
    ASSERT_TRUE(content.has_value()) << content.error().message();
    for (const float x : content->landblocks.at(0xC001).placements[0].spot.origin)
        EXPECT_FALSE(std::signbit(x));
}

struct Fault {
    const char* name;
    std::string text, message;
};
void PrintTo(const Fault& fault, std::ostream* out) {
    *out << fault.name;
}
class StatementFaults : public testing::TestWithParam<Fault> {};

TEST_P(StatementFaults, areOneLineWithFileAndLine) {
    EXPECT_EQ(faultOf(GetParam().text), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    All, StatementFaults,
    testing::Values(
        Fault{"EndInStatement", "\nINSERT INTO `weenie` (`class_Id`,",
              "f.sql:2: the file ends within a statement; it is not complete"},
        Fault{"EndInSkippedStatement", "\nSET @a = 1\n\n",
              "f.sql:2: the file ends within this statement; it is not complete"},
        Fault{"EndInString", "INSERT INTO `weenie` (`class_Id`, `class_Name`, `type`) VALUES (5, 'ga",
              "f.sql:1: the file ends within the string that begins here; it is not complete"},
        Fault{"EndAfterRow", "INSERT INTO `weenie` (`class_Id`, `class_Name`, `type`) VALUES (5, 'a', 1)\n",
              "f.sql:2: the file ends within a statement; it is not complete"},
        Fault{"NoStatement", "= 5;", "f.sql:1: expected a statement, found '='"},
        Fault{"NoValues", "INSERT INTO weenie (class_Id, class_Name, type) SELECT 1;",
              "f.sql:1: expected VALUES, found 'SELECT'"},
        Fault{"MissingColumn", "INSERT INTO weenie (class_Id, type) VALUES (5, 1);",
              "f.sql:1: the row of weenie has no column class_Name"},
        Fault{"TooFewValues", "INSERT INTO weenie (class_Id, class_Name, type) VALUES (5, 'a');",
              "f.sql:1: expected ',', found ')'"},
        Fault{"TooManyValues", "INSERT INTO weenie (class_Id, class_Name, type) VALUES (5, 'a', 1, 2);",
              "f.sql:1: expected ')' after the last value, found ','"},
        Fault{"TextForNumber", "INSERT INTO weenie (class_Id, class_Name, type) VALUES ('5', 'a', 1);",
              "f.sql:1: the value of weenie.class_Id is not an integer"},
        Fault{"Null", "INSERT INTO weenie (class_Id, class_Name, type) VALUES (5, NULL, 1);",
              "f.sql:1: the value of weenie.class_Name is not allowed to be NULL"},
        Fault{"Negative", "INSERT INTO weenie (class_Id, class_Name, type) VALUES (-5, 'a', 1);",
              "f.sql:1: the value of weenie.class_Id is not from 0 to 4294967295"},
        Fault{"TooLarge", "INSERT INTO weenie (class_Id, class_Name, type) VALUES (0x1FFFFFFFF, 'a', 1);",
              "f.sql:1: the value of weenie.class_Id is not from 0 to 4294967295"},
        Fault{"HugeInteger",
              "INSERT INTO weenie (class_Id, class_Name, type) VALUES (99999999999999999999, 'a', 1);",
              "f.sql:1: the value of weenie.class_Id is not an integer"},
        Fault{"NotFinite", instance("1, 5, 0xC0010100, 1e99, 0, 0, 1, 0, 0, 0, False, ''"),
              "f.sql:2: the value of landblock_instance.origin_X is not a number of single precision"},
        Fault{"SameTemplate", kWeenie + kWeenie, "f.sql:4: template 5 is in weenie already"},
        Fault{"SameGuid", instance(kDoorValues) + instance(kDoorValues),
              "f.sql:4: guid 0x7C000001 is in landblock_instance already"},
        Fault{"SameProperty",
              kWeenie +
                  "INSERT INTO weenie_properties_int (object_Id, type, value) VALUES (5, 3, 1), (5, 3, 2);",
              "f.sql:3: template 5 has property 3 already"},
        Fault{"NoTemplate", "INSERT INTO weenie_properties_int (object_Id, type, value) VALUES (5, 3, 1);",
              "f.sql:1: weenie_properties_int has a row for template 5, which is not in weenie"},
        Fault{"NoParent", "INSERT INTO landblock_instance_link (parent_GUID, child_GUID) VALUES (1, 2);",
              "f.sql:1: the parent 0x00000001 of a link is not in landblock_instance"},
        Fault{"Update", "UPDATE `weenie` SET `type` = 1;",
              "f.sql:1: cannot execute UPDATE on weenie; only INSERT and DELETE are read"},
        Fault{"Replace", "REPLACE INTO `world`.`weenie` VALUES (1, 'a', 1, '');",
              "f.sql:1: cannot execute REPLACE on weenie; only INSERT and DELETE are read"},
        Fault{"DeleteAll", "DELETE FROM `weenie`;", "f.sql:1: expected WHERE, found ';'"},
        Fault{"DeleteByName", "DELETE FROM `weenie` WHERE `class_Name` = 5;",
              "f.sql:1: cannot remove rows of weenie by class_Name"},
        Fault{"DeleteByOddName", "DELETE FROM `weenie` WHERE `a\nb` = 5;",
              "f.sql:2: cannot remove rows of weenie by a b"},
        Fault{"Variable", "INSERT INTO weenie (class_Id, class_Name, type) VALUES (@id, 'a', 1);",
              "f.sql:1: the value of weenie.class_Id is not an integer"},
        Fault{"ControlCharacters",
              "INSERT INTO weenie (class_Id, class_Name, type) VALUES (5, 'a', 1) 'x\ny\x1B[31m';",
              "f.sql:2: expected ',' or ';' after a row, found 'x y [31m'"}),
    [](const auto& fault) { return fault.param.name; });

TEST(Statements, noPrefixOfAFileIsReadSilentlyIfItEndsInAStatement) {
    const std::string text = kWeenie + instance(kDoorValues);
    for (std::size_t length = 0; length < text.size(); ++length) {
        const Result<Content> content = contentOf(text.substr(0, length));
        const std::string tail = text.substr(0, length);
        const std::size_t last = tail.find_last_not_of(" \n");
        const bool isWhole = last == std::string::npos || tail[last] == ';';
        EXPECT_EQ(content.has_value(), isWhole)
            << length << ": " << (content ? "" : content.error().message());
    }
}

} // namespace
