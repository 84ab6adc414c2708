#pragma once

#include "worlds/records/ModelWriter.h"

#include <nlohmann/json_fwd.hpp>

namespace limen::worlds {

/// Adds a MotionTable for each swing that the leaves of opaque doors have, and names it in the leaves as "motionTable". The
/// tables open a Setup of one part in one second, as the swing does. `worldFile`: the content of world.json.
void addDoorMotions(ModelWriter& writer, nlohmann::ordered_json& worldFile);

} // namespace limen::worlds
