#include "core/platform/posix/MemInfo.h"

#include <charconv>

namespace limen::platform {

std::optional<std::uint64_t> memoryIn(std::string_view meminfo, std::string_view name) {
    const std::size_t line = meminfo.find(name);
    if (line == std::string_view::npos)
        return {};
    const std::size_t digits = meminfo.find_first_not_of(' ', line + name.size());
    if (digits == std::string_view::npos)
        return {};
    std::uint64_t kibibytes = 0;
    const auto [end, error] =
        std::from_chars(meminfo.data() + digits, meminfo.data() + meminfo.size(), kibibytes);
    constexpr std::uint64_t kMost = std::uint64_t{1} << 50;
    if (error != std::errc{} || kibibytes > kMost)
        return {};
    return kibibytes * 1024;
}

} // namespace limen::platform
