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

std::string groupedText(std::uint64_t number) {
    const std::string digits = std::to_string(number);
    std::string text;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0)
            text += ',';
        text += digits[i];
    }
    return text;
}

} // namespace limen::doctor
