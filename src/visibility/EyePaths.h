#pragma once

#include "visibility/Graph.h"
#include "visibility/VisibleSet.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace limen::visibility {

struct FloodInput;

/// The ways of rays out of a visit at the eye itself: through openings in whose planes the eye is. The rays are in the
/// visit's own space first. Within its zone they may come into other spaces by such openings, each ray by the first one.
class EyePaths {
public:
    /// Finds the parts of the visit's region whose rays leave by `portal` at the eye. Requires isLeftAtEye.
    void find(const FloodInput& input, const Visit& visit, std::span<const Vec3> region,
              std::uint32_t portal);
    [[nodiscard]] std::span<const std::vector<Vec3>> found() const { return {found_.data(), foundCount_}; }

private:
    /// Openings that meet in a corner: rays pass no more spaces than this within half a micrometre.
    static constexpr std::size_t kMostPaths = 8;
    /// Rays in a space, all from the eye.
    struct Path {
        std::uint32_t space = 0, cameBy = kNone;
        std::size_t parent = 0;
        std::vector<Vec3> region;
    };
    [[nodiscard]] bool isOpen(const FloodInput& input, std::size_t path, std::uint32_t portal) const;
    void leave(const FloodInput& input, std::size_t path, std::uint32_t target);

    std::array<Path, kMostPaths> paths_; ///< fixed, so that the regions keep their capacity
    std::array<std::vector<Vec3>, kMostPaths> found_;
    std::size_t pathCount_ = 0, foundCount_ = 0;
    std::vector<Vec3> rest_, within_, swap_;
};

} // namespace limen::visibility
