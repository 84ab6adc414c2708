#include "gpu/device/ShaderLibrary.h"

#include <gtest/gtest.h>

namespace limen::gpu {
namespace {

TEST(ShaderLibrary, includesAreResolvedOnceAndLinesKept) {
    const Result<std::string> text = shaderText("opaque.frag", {.textures = {false, 4, {0, 3}}});
    ASSERT_TRUE(text);
    EXPECT_EQ(text->find("#include"), std::string::npos);
    EXPECT_EQ(text->find("#version 450 core"), 0u);
    const std::size_t first = text->find("struct FrameConstants");
    const std::size_t layout = text->find("LIMEN_STRUCT(FrameConstants)");
    EXPECT_TRUE(first != std::string::npos || layout != std::string::npos);
    EXPECT_EQ(text->find("LIMEN_STRUCT(FrameConstants)", layout + 1), std::string::npos) << "once";
    EXPECT_NE(text->find("#line 1 0\n"), std::string::npos);
    EXPECT_NE(text->find("EACH_PAGE(x) x(0) x(3)\n"), std::string::npos);
}

TEST(ShaderLibrary, unknownName_isNotFound) {
    const Result<std::string> text = shaderText("nothing.frag", {});
    ASSERT_FALSE(text);
    EXPECT_EQ(text.error().code, ErrorCode::NotFound);
}

TEST(ReadableLog, namesFilesInBothStylesOfDrivers) {
    EXPECT_EQ(readableLog("mesh.vert", "0:12(5): error: no such thing\n"),
              "mesh.vert:12: error: no such thing\n");
    EXPECT_EQ(readableLog("mesh.vert", "0(7) : error C1008: undefined\n"),
              "mesh.vert:7: error C1008: undefined\n");
}

TEST(ReadableLog, keepsLinesWithoutAPosition) {
    EXPECT_EQ(readableLog("mesh.vert", "999:1(1): x\nplain words\n\n"), "999:1(1): x\nplain words\n");
    EXPECT_EQ(readableLog("unknown.vert", "0:1(1): x"), "0:1(1): x\n");
    EXPECT_EQ(readableLog("mesh.vert", ""), "");
}

} // namespace
} // namespace limen::gpu
