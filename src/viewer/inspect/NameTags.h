#pragma once

#include "visibility/View.h"
#include "visibility/VisibleSet.h"
#include "world/DynamicState.h"
#include "world/World.h"

#include <string>
#include <vector>

namespace limen::viewer {

/// The name of a placed object over the picture.
struct NameTag {
    Vec2 at{0.0}; ///< above the object, NDC
    std::string name;
    double distance = 0.0; ///< of the eye, metres
    friend bool operator==(const NameTag&, const NameTag&) = default;
};

/// The names of the placed objects within 40 m, the nearest first. An object has one if a visit to one of its spaces has
/// a region that contains the centre of a part: walls hide names, other objects do not. `dynamics` and `visible`: of the frame.
[[nodiscard]] std::vector<NameTag> nameTags(const world::World& world, const world::DynamicState& dynamics,
                                            const visibility::VisibleSet& visible,
                                            const visibility::View& eye);

} // namespace limen::viewer
