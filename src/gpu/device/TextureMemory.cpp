#include "gpu/device/TextureMemory.h"

#include <epoxy/gl.h>

#include <array>

namespace limen::gpu {
namespace {

constexpr std::uint64_t kKiB = 1024;

} // namespace

std::optional<std::uint64_t> queryTextureMemory() {
    std::array<GLint, 4> kib{};
    if (epoxy_has_gl_extension("GL_NVX_gpu_memory_info"))
        glGetIntegerv(GL_GPU_MEMORY_INFO_TOTAL_AVAILABLE_MEMORY_NVX, kib.data());
    else if (epoxy_has_gl_extension("GL_ATI_meminfo"))
        glGetIntegerv(GL_TEXTURE_FREE_MEMORY_ATI, kib.data());
    if (kib[0] <= 0)
        return std::nullopt;
    return static_cast<std::uint64_t>(kib[0]) * kKiB;
}

} // namespace limen::gpu
