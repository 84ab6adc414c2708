#pragma once

#include "check/Retracer.h"
#include "reference/Picture.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace limen::check {

/// A drawn picture; row 0 on top, width × height of each image.
struct DrawnImages {
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint32_t> ids; ///< 0 void, 1 sky
    /// depthUnit / view depth, 0 where nothing was drawn; empty: unknown.
    std::vector<float> depth;
    double depthUnit = 0.02;               ///< metres
    std::vector<reference::Layers> layers; ///< translucent surfaces drawn; empty: not counted
    std::vector<std::uint8_t> colour;      ///< R,G,B,A; empty: not drawn
    /// Sample positions of a multisampled picture, which has colour alone: pixels from the centre, y
    /// downwards.
    std::vector<glm::vec2> samples;
    /// Regions of visits in NDC, for pictures of findings; may be empty.
    std::vector<std::vector<Vec2>> outlines;
};

/// A hash of all images. Equal hashes: two runs drew the same bits.
[[nodiscard]] std::uint64_t hashOf(const DrawnImages& images);

/// The verdict on one pixel (docs/ray-rule.md#how-pictures-are-held-against-it; docs/ray-rule.md#tolerances).
enum class Verdict : std::uint8_t {
    Agrees,    ///< the drawn id is among the traced ones of the 3×3 pixels
    ByZone,    ///< an object that pokes through a wall of its zone: the rule allows both results
    Hole,      ///< drawn as void where the rule finds a void too: a defect of the data
    Unjudged,  ///< out of the space of an eye on its wall
    Sliver,    ///< finer rays within the 3×3 pixels meet the drawn polygon
    EdgeOn,    ///< disagrees: the drawn polygon is seen edge-on, and its depth was taken beside it
    Disagrees, ///< disagrees in any other way
    Void,      ///< disagrees: drawn as void, and no ray finds one
    Depth,     ///< the id is right, the depth is wrong
    Layers     ///< the id is right, the translucent surfaces before it are wrong
};
inline constexpr std::size_t kVerdictCount = 10;
inline constexpr std::array<std::string_view, kVerdictCount> kVerdictNames{
    "agrees", "by_zone", "holes", "unjudged", "slivers", "edge_on", "wrong_ids", "voids", "depth", "layers"};

/// True for verdicts by which the picture is wrong.
[[nodiscard]] constexpr bool isFinding(Verdict verdict) {
    return verdict >= Verdict::EdgeOn;
}

/// The verdicts on a picture's pixels.
struct Comparison {
    std::array<std::uint64_t, kVerdictCount> counts{};
    std::vector<Verdict> verdicts; ///< by pixel, row 0 on top

    [[nodiscard]] std::uint64_t count(Verdict verdict) const {
        return counts[static_cast<std::size_t>(verdict)];
    }
    [[nodiscard]] std::uint64_t findings() const;
};

/// Unsuccessful second looks in one view. Further pixels get their first verdict, which is the stricter one.
inline constexpr std::size_t kMostSecondLooks = 400;

/// Compares a drawn picture with the traced one; overwrites `result`. Requires both of one size.
/// `mostSecondLooks`: fewer take less time for pictures that are wrong as a whole, and judge more strictly.
void compare(const DrawnImages& drawn, const reference::Picture& traced, Retracer& retracer,
             Comparison& result, std::size_t mostSecondLooks = kMostSecondLooks);

/// The number of pixels where two pictures of one view differ in any bit of id, depth or colour. Requires
/// equal sizes.
[[nodiscard]] std::size_t pixelsThatMoved(const DrawnImages& first, const DrawnImages& second);

} // namespace limen::check
