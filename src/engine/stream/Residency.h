#pragma once

#include "dat/Ids.h"
#include "engine/LoadedPart.h"

namespace limen::engine {

/// Progress of an eye's move to another part of the world.
enum class Passage : std::uint8_t {
    Open,   ///< the part is shown
    Coming, ///< the part is being loaded
    Refused ///< the part cannot be loaded
};

/// Keeps the surroundings of a moving eye loaded. There are no callbacks: `follow` offers a part, and the
/// caller calls `show` when all other users of the part are ready for it.
class Residency {
public:
    virtual ~Residency() = default;
    /// Call it once a frame. Returns a part that can be shown now, or null. An offer is valid until the next
    /// call. `root` is the eye's space in the part on the screen.
    [[nodiscard]] virtual std::shared_ptr<const LoadedPart> follow(const Vec3& eye,
                                                                   world::SpaceIndex root) = 0;
    /// Whether an offer that was not taken is repeated in the next frames, so that a caller can take time to
    /// prepare. If not, each offer comes once.
    [[nodiscard]] virtual bool isPatient() const = 0;
    /// Shows the part that the last `follow` offered. Requires an offer. True: it is shown now, and its
    /// spaces have other indices (rootIn finds the eye's).
    [[nodiscard]] virtual bool show() = 0;
    /// Call it once a frame instead of `follow` while an eye waits for the part around `centre` (a teleport).
    [[nodiscard]] virtual Passage open(dat::BlockCoord centre) = 0;
};

} // namespace limen::engine
