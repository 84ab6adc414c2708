#pragma once

#include "engine/FrameRequest.h"
#include "engine/report/FrameReport.h"
#include "engine/report/IdTable.h"
#include "frame/FramePlan.h"

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>

namespace limen::output {

/// A frame as `limen shot --json` writes it. `ids` is the id image; empty: it was not drawn. Unknown times
/// become null.
[[nodiscard]] nlohmann::ordered_json
frameJson(const world::World& world, const engine::IdTable& table, const engine::FrameRequest& request,
          const world::DynamicState& dynamics, const visibility::VisibleSet& visible,
          const frame::FramePlan& plan, const engine::FrameFigures& figures,
          std::span<const std::uint32_t> ids);

/// The player's body; null if there is none.
[[nodiscard]] nlohmann::ordered_json bodyJson(const world::World& world,
                                              const std::optional<motion::PlayerBody>& body);

} // namespace limen::output
