#pragma once

#include "output/Picture.h"
#include "visibility/VisibleSet.h"

#include <span>
#include <vector>

namespace limen::output {

/// Outlines the region of every visit on a picture of the frame, coloured by visit, the visit's number at its
/// centre.
void drawRegions(Picture& picture, const visibility::VisibleSet& visible);

/// The same of outlines in NDC, by visit; those without corners are passed over.
void drawOutlines(Picture& picture, std::span<const std::vector<Vec2>> outlines);

/// The id image as colours: void red, sky light blue, every other id a colour of its own.
[[nodiscard]] Picture pictureOfIds(std::uint32_t width, std::uint32_t height,
                                   std::span<const std::uint32_t> ids);

/// Distances from the eye, metres, as greys: white at 10 cm, a fifth darker for each factor of ten, black from 10 km on; where there is
/// none (infinity) light blue.
[[nodiscard]] Picture pictureOfDistances(std::uint32_t width, std::uint32_t height,
                                         std::span<const float> distances);

} // namespace limen::output
