#include "gpu/device/ShaderLibrary.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include <fmt/format.h>

namespace limen::gpu {
namespace {

const EmbeddedShader* findShader(std::string_view name) {
    const std::span<const EmbeddedShader> all = embeddedShaders();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const EmbeddedShader& s) { return s.name == name; });
    return found == all.end() ? nullptr : &*found;
}

// The macros that textures.glsl requires.
std::string textureDefines(const TextureBinding& binding) {
    if (binding.bindless)
        return "#extension GL_ARB_bindless_texture : require\n#define BINDLESS 1\n";
    std::string text = fmt::format("#define PAGE_COUNT {}\n#define EACH_PAGE(x)", binding.pageCount);
    for (const std::uint32_t page : binding.pages)
        text += fmt::format(" x({})", page);
    if (binding.ground)
        text += fmt::format("\n#define GROUND_COLOURS {}\n#define GROUND_MAPS {}", binding.ground->colours,
                            binding.ground->maps);
    if (binding.atlas)
        text += fmt::format("\n#define ATLAS {}\n#define ATLAS_TEXEL (1.0 / vec2({}, {}))",
                            binding.atlas->page, binding.atlas->width, binding.atlas->height);
    return text + (binding.byIndex && binding.pageCount > 0 ? "\n#define PAGES_BY_INDEX 1\n" : "\n");
}

const char* stageDefine(std::string_view name) {
    return name.ends_with(".vert")   ? "#define VERTEX_STAGE 1\n"
           : name.ends_with(".comp") ? "#define COMPUTE_STAGE 1\n"
                                     : "#define FRAGMENT_STAGE 1\n";
}

// Removes the number at the start of `text` and yields it.
std::optional<std::size_t> takeNumber(std::string_view& text) {
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{})
        return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return value;
}

std::string readableLine(const EmbeddedShader& shader, std::string_view line) {
    std::string_view rest = line;
    const std::optional<std::size_t> source = takeNumber(rest);
    if (!source || *source >= shader.files.size() || rest.empty() || (rest[0] != ':' && rest[0] != '('))
        return std::string(line);
    rest.remove_prefix(1);
    const std::optional<std::size_t> number = takeNumber(rest);
    if (!number)
        return std::string(line);
    const std::size_t message = rest.find(": ");
    rest = message == std::string_view::npos ? rest : rest.substr(message + 2);
    return fmt::format("{}:{}: {}", shader.files[*source], *number, rest);
}

} // namespace

Result<std::string> shaderText(std::string_view name, const ProgramSource& source) {
    const EmbeddedShader* shader = findShader(name);
    if (shader == nullptr)
        return fail(ErrorCode::NotFound, std::string(name), "no embedded shader has this name");
    std::string text = "#version 450 core\n" + textureDefines(source.textures);
    text += stageDefine(name);
    for (const std::string& define : source.defines)
        text += "#define " + define + (define.find(' ') == std::string::npos ? " 1\n" : "\n");
    for (const std::string_view part : shader->parts)
        text += part;
    return text;
}

std::string readableLog(std::string_view name, std::string_view log) {
    const EmbeddedShader* shader = findShader(name);
    std::string out;
    while (!log.empty()) {
        const std::string_view line = log.substr(0, log.find('\n'));
        log.remove_prefix(std::min(log.size(), line.size() + 1));
        if (line.find_first_not_of(std::string_view("\0 \t\r", 4)) != std::string_view::npos)
            out += (shader == nullptr ? std::string(line) : readableLine(*shader, line)) + "\n";
    }
    return out;
}

} // namespace limen::gpu
