#pragma once

#include "dat/Ids.h"
#include "engine/LoadedPart.h"

namespace limen::engine {

/// Whether an eye may go to another part of the world.
enum class Passage : std::uint8_t {
    Open,   ///< it is shown
    Coming, ///< it is being loaded
    Refused ///< it cannot be loaded
};

/// Keeps the surroundings of a moving eye loaded. It calls nobody back: `follow` offers a part, and its caller has the part shown
/// when everything else that needs it is ready.
class Residency {
public:
    virtual ~Residency() = default;
    /// Once a frame. Yields a part that can be shown now, or null. An offer holds until the next call.
    [[nodiscard]] virtual std::shared_ptr<const LoadedPart> follow(const Vec3& eye,
                                                                   world::SpaceIndex root) = 0;
    /// Whether offers come in later frames, too, so that a caller may prepare for them; else they come once.
    [[nodiscard]] virtual bool isPatient() const = 0;
    /// Shows the part that the last `follow` offered. True if it is shown now; its spaces have other numbers (rootIn).
    [[nodiscard]] virtual bool show() = 0;
    /// Once a frame in place of `follow`, while an eye waits to go to the part of the world around `centre`.
    [[nodiscard]] virtual Passage open(dat::BlockCoord centre) = 0;
};

} // namespace limen::engine
