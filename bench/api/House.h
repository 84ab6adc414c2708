#pragma once

#include "visibility/GraphBuilder.h"
#include "visibility/View.h"

#include <filesystem>
#include <vector>

namespace limen::bench {

/// A house and eyes in it, in the form that users of every interface give.
struct House {
    std::uint32_t spaces = 0;
    std::vector<visibility::OpeningDesc> openings;
    std::vector<visibility::LookAt> eyes;
};

/// Square rooms of 10 m with a door of 2 m in each shared wall, and random eyes. `side`: rooms each way.
[[nodiscard]] House gridHouse(std::uint32_t side, std::size_t eyes, std::uint32_t seed);

/// Its graph. Requires a house of this header.
[[nodiscard]] visibility::Graph graphOf(const House& house);
[[nodiscard]] std::vector<visibility::View> viewsOf(const House& house);

/// Writes the house for bench/api/flood.py. Errors: Unreadable.
[[nodiscard]] Result<void> writeHouse(const House& house, const std::filesystem::path& file);

} // namespace limen::bench
