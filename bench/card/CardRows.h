#pragma once

#include "BenchRow.h"
#include "card/CardTimes.h"

namespace limen::bench {

/// Most milliseconds of GPU time of a frame drawn fast at 2560×1440, in every place.
inline constexpr double kMostOnCard = 0.5;

/// Rows of times on a card, some for each way and size:
/// `card/WAY/WIDTHxHEIGHT`: the slowest place; p95 is over the places. It has a target where the way is drawn fast and the
/// size is 2560×1440. `.../mean`: the mean of all places. `.../STAGE`: the mean of a stage.
[[nodiscard]] std::vector<BenchRow> cardRows(const std::vector<CardTimes>& times);

} // namespace limen::bench
