#include "doctor/Bytes.h"

#include <fmt/format.h>

namespace limen::doctor {

std::string bytesText(std::uint64_t bytes) {
    constexpr std::uint64_t kKiB = 1024, kMiB = kKiB * kKiB, kGiB = kKiB * kMiB;
    const auto in = [&](std::uint64_t unit) {
        return static_cast<double>(bytes) / static_cast<double>(unit);
    };
    if (bytes >= kGiB)
        return fmt::format("{:.1f} GiB", in(kGiB));
    if (bytes >= kMiB)
        return fmt::format("{:.0f} MiB", in(kMiB));
    if (bytes >= kKiB)
        return fmt::format("{:.0f} KiB", in(kKiB));
    return fmt::format("{} bytes", bytes);
}

} // namespace limen::doctor
