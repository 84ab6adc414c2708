#pragma once

#include "world/Image.h"
#include "world/records/LruCache.h"
#include "world/records/Records.h"

#include <tuple>

namespace limen::world {

/// A picture, its palette (0: the picture's own), and two rules it is decoded by: DecodeRules::clipMap and
/// additive.
using PictureKey = std::tuple<dat::RecordId, dat::RecordId, bool, bool>;

/// Decoded pictures of one archive, kept for later loads together with the findings of their records.
/// Pictures that cannot be decoded are not kept. Thread-safe.
using PictureCache = LruCache<PictureKey, Found<std::shared_ptr<const Image>>>;

} // namespace limen::world
