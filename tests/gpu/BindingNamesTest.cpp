#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

// Bindings, units, locations and outputs are named constants on both sides (shaders/include/SharedLayout.h).
namespace limen::gpu {
namespace {

namespace fs = std::filesystem;

std::string textOf(const fs::path& path) {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::vector<fs::path> filesUnder(const char* folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(LIMEN_SOURCE_DIR) / folder))
        if (entry.is_regular_file() && entry.path().extension() != ".md" &&
            entry.path().extension() != ".txt")
            files.push_back(entry.path());
    return files;
}

/// GLSL layout qualifiers, and those with a literal number.
struct Qualifiers {
    std::size_t count = 0;
    std::vector<std::string> literal;
};

Qualifiers qualifiersIn(const std::string& text) {
    static const std::regex kQualifier(R"(\blayout\s*\([^)]*=[^)]*\))"), kLiteral(R"(=\s*[0-9])");
    Qualifiers found;
    for (std::sregex_iterator it(text.begin(), text.end(), kQualifier), end; it != end; ++it) {
        ++found.count;
        if (const std::string qualifier = it->str(); std::regex_search(qualifier, kLiteral))
            found.literal.push_back(qualifier);
    }
    return found;
}

/// GL functions with a binding, unit, location or output number, and the index of that argument.
struct NumberedCall {
    std::string_view function;
    std::size_t argument;
};
constexpr std::array<NumberedCall, 25> kNumberedCalls{{
    {"glBindBufferBase", 1},
    {"glBindBufferRange", 1},
    {"glBindBuffersBase", 1},
    {"glBindBuffersRange", 1},
    {"glBindTextureUnit", 0},
    {"glBindTextures", 0},
    {"glBindSampler", 0},
    {"glBindSamplers", 0},
    {"glBindImageTexture", 0},
    {"glBindImageTextures", 0},
    {"glActiveTexture", 0},
    {"glEnablei", 1},
    {"glDisablei", 1},
    {"glBlendFunci", 0},
    {"glBlendEquationi", 0},
    {"glColorMaski", 0},
    {"glEnableVertexArrayAttrib", 1},
    {"glVertexArrayAttribFormat", 1},
    {"glVertexArrayAttribIFormat", 1},
    {"glVertexArrayAttribBinding", 1},
    {"glVertexArrayVertexBuffer", 1},
    {"glClearNamedFramebufferfv", 2},
    {"glClearNamedFramebufferuiv", 2},
    {"glProgramUniform1ui", 1},
    {"glProgramUniform1i", 1},
}};

/// Arguments of the call whose opening parenthesis precedes `at`.
std::vector<std::string> argumentsAt(const std::string& text, std::size_t at) {
    std::vector<std::string> arguments{""};
    for (int depth = 0; at < text.size(); ++at) {
        const char c = text[at];
        if (depth == 0 && c == ')')
            break;
        depth += c == '(' || c == '{' || c == '[' ? 1 : 0;
        depth -= c == ')' || c == '}' || c == ']' ? 1 : 0;
        if (depth == 0 && c == ',')
            arguments.emplace_back();
        else if (c != ' ' && c != '\n')
            arguments.back() += c;
    }
    return arguments;
}

struct Calls {
    std::size_t count = 0;
    std::vector<std::string> literal; ///< function and argument
};

void addCalls(const std::string& text, const NumberedCall& numbered, Calls& found) {
    static const std::regex kLiteral(R"((\w+[({])?[0-9]+[uU]?[)}]?)");
    const std::string function(numbered.function);
    const std::regex call("\\b" + function + "(\\(|,)"); // called directly or by GlDevice::call
    for (std::sregex_iterator it(text.begin(), text.end(), call), end; it != end; ++it) {
        const std::vector<std::string> arguments =
            argumentsAt(text, static_cast<std::size_t>(it->position() + it->length()));
        ++found.count;
        if (numbered.argument >= arguments.size())
            found.literal.push_back(function + ": too few arguments");
        else if (std::regex_match(arguments[numbered.argument], kLiteral))
            found.literal.push_back(function + ": " + arguments[numbered.argument]);
    }
}

Calls callsIn(const std::string& text) {
    Calls found;
    for (const NumberedCall& numbered : kNumberedCalls)
        addCalls(text, numbered, found);
    return found;
}

TEST(BindingNames, shadersHaveNoLiteralNumberInALayoutQualifier) {
    std::size_t count = 0;
    for (const fs::path& file : filesUnder("shaders")) {
        const Qualifiers found = qualifiersIn(textOf(file));
        count += found.count;
        for (const std::string& qualifier : found.literal)
            ADD_FAILURE() << file.filename() << ": " << qualifier;
    }
    EXPECT_GE(count, 60u) << "too few found for the test to mean anything";
}

TEST(BindingNames, gpuPassesNoLiteralNumberToOpenGl) {
    std::size_t count = 0;
    for (const fs::path& file : filesUnder("src/gpu")) {
        const Calls found = callsIn(textOf(file));
        count += found.count;
        for (const std::string& call : found.literal)
            ADD_FAILURE() << file.filename() << ": " << call;
    }
    EXPECT_GE(count, 15u) << "too few found for the test to mean anything";
}

TEST(BindingNames, literalsAreFound) {
    EXPECT_EQ(qualifiersIn("layout(location = 3) in vec3 a; layout(std430, binding=12) buffer B {};")
                  .literal.size(),
              2u);
    EXPECT_TRUE(qualifiersIn("layout(location = kOutputId) out uint a;").literal.empty());
    EXPECT_EQ(callsIn("glBindTextureUnit(3, texture.id());").literal.size(), 1u);
    EXPECT_EQ(callsIn("call(glBindBuffersRange, GLenum{X}, 0u, n);").literal.size(), 1u);
    EXPECT_EQ(callsIn("glVertexArrayAttribFormat(array(1, 2), GLuint{4}, 3, x);").literal.size(), 1u);
    EXPECT_TRUE(callsIn("glVertexArrayAttribFormat(array, kAttributeUv, 3, x);").literal.empty());
}

TEST(BindingNames, everyConstantIsUsedByShadersAndByCpp) {
    std::string shaders, cpp;
    for (const fs::path& file : filesUnder("shaders"))
        shaders += file.filename() == "SharedLayout.h" ? "" : textOf(file);
    for (const fs::path& file : filesUnder("src/gpu"))
        cpp += textOf(file);
    const std::string header = textOf(fs::path(LIMEN_SOURCE_DIR) / "shaders/include/SharedLayout.h");
    static const std::regex kConstant(R"(LIMEN_CONST (k(Bind|Unit|Attribute|Output)\w+) =)");
    std::size_t count = 0;
    for (std::sregex_iterator it(header.begin(), header.end(), kConstant), end; it != end; ++it, ++count) {
        const std::string name = (*it)[1];
        const std::regex use("\\b" + name + "\\b");
        EXPECT_TRUE(std::regex_search(shaders, use)) << name << " is not used by the shaders";
        EXPECT_TRUE(std::regex_search(cpp, use)) << name << " is not used by src/gpu";
    }
    EXPECT_GE(count, 30u);
}

} // namespace
} // namespace limen::gpu
