#pragma once

#include "frames/FrameWay.h"

#include "world/Places.h"

#include <filesystem>

namespace limen::bench {

/// Milliseconds of one frame until the rasteriser is done.
struct FrameTime {
    double wall = 0.0;
    double processor = 0.0; ///< of all threads of the program
};

/// The times of a place.
struct PlaceTimes {
    std::string scene; ///< options of `limen shot` that show the place
    bool isInCell = false;
    std::vector<FrameTime> ways; ///< medians over the repeats, by FrameTimes::ways
};

struct FrameTimes {
    std::vector<std::string> ways; ///< their names
    std::vector<PlaceTimes> places;
    std::uint64_t hash = 0; ///< of the first way's pictures
};

struct FrameEffort {
    std::uint32_t width = 1280, height = 720;
    int repeats = 5;                ///< of each way at each place, after one frame to warm up
    std::filesystem::path pictures; ///< directory for a picture of each place and way; empty: none
};

/// Draws every place by all ways. They take turns: in each repeat every way draws one frame, so that other
/// programs disturb all of them alike. Errors: the loader's, those of the ways, unwritable pictures.
[[nodiscard]] Result<FrameTimes> timeFrames(const dat::Archive& archive, const world::WorldFile& file,
                                            const std::vector<world::Place>& places,
                                            const std::vector<std::unique_ptr<FrameWay>>& ways,
                                            const FrameEffort& effort);

} // namespace limen::bench
