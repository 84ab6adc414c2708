#include "gpu/device/Capabilities.h"

#include "frame/GpuLayout.h"
#include "gpu/device/GlObjects.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace limen::gpu {
namespace {

// Storage buffers of SharedLayout.h, and the most that the programs of a stage read. Some drivers allow a
// stage 16.
constexpr int kStorageBindings = static_cast<int>(frame::gpu::kStorageBindings);
constexpr int kVertexBlocks = 5, kFragmentBlocks = 5, kComputeBlocks = 5;
// The ownership target, the arrays read as texels, and at least one array page for each wrapping mode.
constexpr int kLeastTextureUnits = static_cast<int>(frame::gpu::kUnitFirstPage) + 2;
// for stages that sample no page
constexpr int kArrayTextureUnits = static_cast<int>(frame::gpu::kUnitFirstPage);
constexpr int kDrawBuffers = static_cast<int>(frame::gpu::kOutputBlended) + 1;

GLint limitOf(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

std::string text(GLenum name) {
    const GLubyte* value = glGetString(name);
    return value == nullptr ? std::string("unknown") : std::string(reinterpret_cast<const char*>(value));
}

DriverLimits queryLimits() {
    DriverLimits limits;
    limits.version = epoxy_gl_version();
    limits.coreProfile =
        epoxy_is_desktop_gl() && (limitOf(GL_CONTEXT_PROFILE_MASK) & GL_CONTEXT_CORE_PROFILE_BIT) != 0;
    limits.shaderDrawParameters =
        limits.version >= 46 || epoxy_has_gl_extension("GL_ARB_shader_draw_parameters");
    limits.vertexStorageBlocks = limitOf(GL_MAX_VERTEX_SHADER_STORAGE_BLOCKS);
    limits.fragmentStorageBlocks = limitOf(GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS);
    limits.computeStorageBlocks = limitOf(GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS);
    limits.combinedStorageBlocks = limitOf(GL_MAX_COMBINED_SHADER_STORAGE_BLOCKS);
    limits.storageBindings = limitOf(GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS);
    limits.textureUnits = limitOf(GL_MAX_TEXTURE_IMAGE_UNITS);
    limits.vertexTextureUnits = limitOf(GL_MAX_VERTEX_TEXTURE_IMAGE_UNITS);
    limits.computeTextureUnits = limitOf(GL_MAX_COMPUTE_TEXTURE_IMAGE_UNITS);
    limits.drawBuffers = limitOf(GL_MAX_DRAW_BUFFERS);
    return limits;
}

float queryAnisotropy() {
    if (epoxy_gl_version() < 46 && !epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic") &&
        !epoxy_has_gl_extension("GL_ARB_texture_filter_anisotropic"))
        return 1.0f;
    GLfloat value = 1.0f;
    glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &value);
    return value;
}

} // namespace

std::vector<std::string> missingFrom(const DriverLimits& limits) {
    std::vector<std::string> missing;
    // OpenGL 4.5 core has direct state access, clip control, buffer storage, multi-draw-indirect and integer
    // targets.
    if (limits.version < 45)
        missing.push_back(fmt::format("OpenGL 4.5 (it has {}.{})", limits.version / 10, limits.version % 10));
    else if (!limits.coreProfile)
        missing.push_back("a core profile context");
    if (!limits.shaderDrawParameters)
        missing.push_back("GL_ARB_shader_draw_parameters");
    const auto need = [&](int has, int needed, const char* what) {
        if (has < needed)
            missing.push_back(fmt::format("{} {} (it has {})", needed, what, has));
    };
    need(limits.vertexStorageBlocks, kVertexBlocks, "storage blocks in the vertex stage");
    need(limits.fragmentStorageBlocks, kFragmentBlocks, "storage blocks in the fragment stage");
    need(limits.computeStorageBlocks, kComputeBlocks, "storage blocks in the compute stage");
    need(limits.combinedStorageBlocks, kVertexBlocks + kFragmentBlocks, "storage blocks in all stages");
    need(limits.storageBindings, kStorageBindings, "storage buffer bindings");
    need(limits.textureUnits, kLeastTextureUnits, "texture units");
    need(limits.vertexTextureUnits, kArrayTextureUnits, "texture units in the vertex stage");
    need(limits.computeTextureUnits, kArrayTextureUnits, "texture units in the compute stage");
    need(limits.drawBuffers, kDrawBuffers, "draw buffers");
    return missing;
}

Result<void> checkSamples(std::uint32_t samples, const Capabilities& capabilities) {
    if (samples > 1 && samples != frame::gpu::kSamples) {
        return fail(ErrorCode::BadArgument, fmt::format("{} samples", samples),
                    fmt::format("not supported; use 1 or {} samples per pixel", frame::gpu::kSamples));
    }
    if (samples > capabilities.maxSamples) {
        return fail(ErrorCode::Driver, fmt::format("{} / {}", capabilities.vendor, capabilities.renderer),
                    fmt::format("cannot draw {} samples per pixel; use at most {}", samples,
                                capabilities.maxSamples));
    }
    return {};
}

Result<Capabilities> queryCapabilities() {
    const std::vector<std::string> missing = missingFrom(queryLimits());
    if (!missing.empty()) {
        return fail(ErrorCode::Driver, driverString(),
                    fmt::format("the driver lacks {}", fmt::join(missing, ", ")));
    }
    Capabilities caps;
    caps.vendor = text(GL_VENDOR);
    caps.renderer = text(GL_RENDERER);
    caps.version = text(GL_VERSION);
    caps.bindless = epoxy_has_gl_extension("GL_ARB_bindless_texture");
    caps.software = caps.renderer.find("llvmpipe") != std::string::npos ||
                    caps.renderer.find("softpipe") != std::string::npos;
    caps.maxAnisotropy = queryAnisotropy();
    caps.textureUnits = static_cast<std::uint32_t>(limitOf(GL_MAX_TEXTURE_IMAGE_UNITS));
    caps.maxTextureSize = static_cast<std::uint32_t>(limitOf(GL_MAX_TEXTURE_SIZE));
    std::array<GLint, 2> viewport{};
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
    caps.maxViewport = static_cast<std::uint32_t>(std::min(viewport[0], viewport[1]));
    caps.maxBufferTexels = static_cast<std::uint32_t>(limitOf(GL_MAX_TEXTURE_BUFFER_SIZE));
    caps.maxArrayLayers = static_cast<std::uint32_t>(limitOf(GL_MAX_ARRAY_TEXTURE_LAYERS));
    caps.maxSamples = static_cast<std::uint32_t>(
        std::max(1, std::min({limitOf(GL_MAX_COLOR_TEXTURE_SAMPLES), limitOf(GL_MAX_DEPTH_TEXTURE_SAMPLES),
                              limitOf(GL_MAX_INTEGER_SAMPLES)})));
    caps.storageAlignment = static_cast<std::size_t>(std::max(
        {limitOf(GL_SHADER_STORAGE_BUFFER_OFFSET_ALIGNMENT), limitOf(GL_TEXTURE_BUFFER_OFFSET_ALIGNMENT),
         limitOf(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT), 16}));
    return caps;
}

} // namespace limen::gpu
