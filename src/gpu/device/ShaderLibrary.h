#pragma once

#include "core/Error.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace limen::gpu {

/// One shader of the folder `shaders/`, includes resolved at build time (embed/EmbedShaders.cpp).
struct EmbeddedShader {
    std::string_view name;               ///< file name, e.g. "mesh.vert"
    std::string_view text;               ///< without #version
    std::vector<std::string_view> files; ///< file of each source number in its #line directives
};

/// All shaders of the library, in no particular order.
[[nodiscard]] std::span<const EmbeddedShader> embeddedShaders();

/// How TextureStore's binding looks to a shader.
struct TextureBinding {
    bool bindless = false;
    std::uint32_t pageCount = 0; ///< array pages bound; 0 in bindless mode
    std::vector<std::uint32_t>
        pages{};          ///< those that a program may sample, ascending: each one costs, used or not
    bool byIndex = false; ///< unless they are chosen by index (TextureStoreOptions)
    bool operator==(const TextureBinding&) const = default;
};

/// A uint uniform that is set once, when its program is built.
struct UniformValue {
    std::uint32_t location = 0; ///< kUniform... of SharedLayout.h
    std::uint32_t value = 0;
    bool operator==(const UniformValue&) const = default;
};

/// What a program is compiled from.
struct ProgramSource {
    std::string label{};        ///< for debuggers and messages, unique per variant
    std::string vertexShader{}; ///< names of embedded shaders
    std::string fragmentShader{};
    std::vector<std::string> defines{}; ///< e.g. "GATED"
    TextureBinding textures{};
    std::string computeShader{}; ///< instead of the two
    std::vector<UniformValue> uniforms{};
};

/// The text the driver gets for one stage: version, extensions, defines, source. NotFound for an unknown
/// name.
[[nodiscard]] Result<std::string> shaderText(std::string_view name, const ProgramSource& source);

/// A driver's log with source numbers replaced by file names ("2:14(3): error" and "2(14) : error" become
/// "include/gate.glsl:14: ..."). Lines without one stay as they are.
[[nodiscard]] std::string readableLog(std::string_view name, std::string_view log);

} // namespace limen::gpu
