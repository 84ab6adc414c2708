#pragma once

#include "worlds/builtin/effects/Effects.h"

namespace limen::worlds {

/// Models of people, about 1.75 m tall, of six parts (body, head, arms, legs): feet at z = 0, front to the
/// north. The origin of arms and legs is the joint. FolkGaits has their motions.
struct FolkModels {
    dat::RecordId innkeeper = 0, maid = 0, farmer = 0, elder = 0;
    dat::RecordId watchman = 0;  ///< carries a lantern at `kLantern`
    dat::RecordId carter = 0;    ///< pulls a loaded cart
    dat::RecordId traveller = 0; ///< the player's body
    dat::RecordId cloak = 0;     ///< ClothingTable for farmer and traveller
};
inline constexpr Vec3 kLantern{0.31, 0.16, 0.86};
[[nodiscard]] FolkModels addFolkModels(ModelWriter& writer, const Effects& effects);

} // namespace limen::worlds
