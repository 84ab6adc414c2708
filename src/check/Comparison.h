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
    /// As stored: nearPlane / view depth, 0 where nothing was met; empty: unknown.
    std::vector<float> depth;
    double nearPlane = 0.02;               ///< metres
    std::vector<reference::Layers> layers; ///< translucent surfaces met; empty: not counted
    std::vector<std::uint8_t> colour;      ///< R,G,B,A; empty: not drawn
    /// Of a multisampled picture, which has colour alone: where in a pixel the samples lie, from its centre, y downwards.
    std::vector<glm::vec2> samples;
    std::vector<std::vector<Vec2>>
        outlines; ///< regions of visits in NDC, for pictures of findings; may be empty
};

/// Of all that was drawn, to tell whether two runs drew the same to the bit.
[[nodiscard]] std::uint64_t hashOf(const DrawnImages& images);

/// What is said of one pixel. docs/ray-rule.md#how-pictures-are-held-against-it, docs/ray-rule.md#tolerances.
enum class Verdict : std::uint8_t {
    Agrees,    ///< the drawn id is among the traced ones of the 3×3 pixels
    ByZone,    ///< an object seen where it pokes through a wall of its zone: the rule allows either
    Hole,      ///< drawn as void where the rule finds a void too: a defect of the data
    Unjudged,  ///< seen past a wall that the near plane cuts, or out of the space of an eye on its wall
    Sliver,    ///< finer rays within the 3×3 pixels find what was drawn
    EdgeOn,    ///< disagrees; the drawn polygon is seen edge-on and its depth was taken beside it
    Disagrees, ///< disagrees
    Void,      ///< disagrees: drawn as void, and no ray finds one
    Depth,     ///< the id is the pixel's own, the depth is not
    Layers     ///< the id is right, the translucent surfaces before it are not
};
inline constexpr std::size_t kVerdictCount = 10;
inline constexpr std::array<std::string_view, kVerdictCount> kVerdictNames{
    "agrees", "by_zone", "holes", "unjudged", "slivers", "edge_on", "wrong_ids", "voids", "depth", "layers"};

/// True for verdicts that say the picture is wrong.
[[nodiscard]] constexpr bool isFinding(Verdict verdict) {
    return verdict >= Verdict::EdgeOn;
}

/// A picture's pixels by verdict.
struct Comparison {
    std::array<std::uint64_t, kVerdictCount> counts{};
    std::vector<Verdict> verdicts; ///< by pixel, row 0 on top

    [[nodiscard]] std::uint64_t count(Verdict verdict) const {
        return counts[static_cast<std::size_t>(verdict)];
    }
    [[nodiscard]] std::uint64_t findings() const;
};

/// Pixels of one view that are looked at again with finer rays in vain; those beyond are taken as they are, which is the
/// stricter way.
inline constexpr std::size_t kMostSecondLooks = 400;

/// Holds a drawn picture against the traced one. `result` is overwritten. Requires traced of the drawn size.
void compare(const DrawnImages& drawn, const reference::Picture& traced, Retracer& retracer,
             Comparison& result);

/// Pixels at which two pictures of one view differ in any bit of id, depth or colour. Requires equal sizes.
[[nodiscard]] std::size_t pixelsThatMoved(const DrawnImages& first, const DrawnImages& second);

} // namespace limen::check
