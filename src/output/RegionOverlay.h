#pragma once

#include "output/Picture.h"
#include "visibility/VisibleSet.h"

#include <span>
#include <vector>

namespace limen::output {

/// Outlines the region of each visit on a picture of the frame, in a colour of its own, with the visit's
/// number at the centre.
void drawRegions(Picture& picture, const visibility::VisibleSet& visible);

/// Draws such outlines from corners in NDC, by visit. Outlines without corners are skipped.
void drawOutlines(Picture& picture, std::span<const std::vector<Vec2>> outlines);

/// The id image in colours: void red, sky light blue, each other id in a colour derived from it.
[[nodiscard]] Picture pictureOfIds(std::uint32_t width, std::uint32_t height,
                                   std::span<const std::uint32_t> ids);

/// Distances from the eye in metres as greys on a logarithmic scale: white at 0.1 m, a fifth darker for each
/// factor of ten, black from 10 km on. Pixels without a distance (infinity, NaN) are light blue.
[[nodiscard]] Picture pictureOfDistances(std::uint32_t width, std::uint32_t height,
                                         std::span<const float> distances);

} // namespace limen::output
