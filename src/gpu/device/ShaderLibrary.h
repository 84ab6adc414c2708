#pragma once

#include "core/Error.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace limen::gpu {

/// One shader of the folder `shaders/`, includes resolved at build time (embed/EmbedShaders.cpp).
struct EmbeddedShader {
    std::string_view name; ///< file name, e.g. "mesh.vert"
    /// Text without `#version`, in parts: a compiler need not accept a literal of more than 65,536 characters.
    std::vector<std::string_view> parts;
    std::vector<std::string_view> files; ///< file of each source number in its `#line` directives
};

/// All embedded shaders, in no particular order.
[[nodiscard]] std::span<const EmbeddedShader> embeddedShaders();

/// The pages of all textures and of all blend maps of the ground.
struct GroundPages {
    std::uint32_t colours = 0, maps = 0;
    bool operator==(const GroundPages&) const = default;
};

/// The page that is an atlas (texture/Atlas.h), and the size of its layers in texels.
struct AtlasPage {
    std::uint32_t page = 0, width = 0, height = 0;
    bool operator==(const AtlasPage&) const = default;
};

/// Texture binding of a program.
struct TextureBinding {
    bool bindless = false;
    std::uint32_t pageCount = 0; ///< array pages bound; 0 in bindless mode
    std::vector<std::uint32_t>
        pages{}; ///< pages that the program may sample, ascending; each one has a cost even if unused
    bool byIndex = false;                ///< pages are selected by a variable index (TextureStoreOptions)
    std::optional<GroundPages> ground{}; ///< of the ground's programs, if each is one page
    std::optional<AtlasPage> atlas{};    ///< of all textures but the ground's
    bool operator==(const TextureBinding&) const = default;
};

/// A uint uniform set once, when its program is built.
struct UniformValue {
    std::uint32_t location = 0; ///< kUniform... of SharedLayout.h
    std::uint32_t value = 0;
    bool operator==(const UniformValue&) const = default;
};

/// Sources and macros of a program.
struct ProgramSource {
    std::string label{};        ///< for debuggers and messages, unique per variant
    std::string vertexShader{}; ///< names of embedded shaders
    std::string fragmentShader{};
    std::vector<std::string> defines{}; ///< "NAME", e.g. "GATED", or "NAME VALUE"
    TextureBinding textures{};
    std::string computeShader{}; ///< replaces the two others
    std::vector<UniformValue> uniforms{};
};

/// Text of one stage for the driver: version, extensions, macros, source. Errors: NotFound for an unknown
/// name.
[[nodiscard]] Result<std::string> shaderText(std::string_view name, const ProgramSource& source);

/// A driver's log with file names instead of source numbers ("2:14(3): error" and "2(14) : error" become
/// "include/gate.glsl:14: ..."). Other lines are unchanged.
[[nodiscard]] std::string readableLog(std::string_view name, std::string_view log);

} // namespace limen::gpu
