#pragma once

#include <cstdint>
#include <optional>

namespace limen::gpu {

/// Bytes of memory for textures that the current context's driver reports: the total of GL_NVX_gpu_memory_info, or the
/// free memory of GL_ATI_meminfo. No value without both.
[[nodiscard]] std::optional<std::uint64_t> queryTextureMemory();

} // namespace limen::gpu
