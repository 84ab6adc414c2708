#pragma once

#include "frame/Gate.h"
#include "geometry/Tolerances.h"
#include "visibility/View.h"
#include "world/LevelRange.h"
#include "world/Look.h"

#include <cstdint>
#include <optional>
#include <span>

namespace limen::frame {

enum class Weather : std::uint8_t { Clear, Rain };

/// Draws an object in another colour, e.g. because it is selected.
struct Highlight {
    std::uint64_t object = 0; ///< world::Instance::object; all its parts
    std::uint32_t colour =
        0; ///< bytes R, G, B and strength, R lowest; mixed with the lit colour by the strength
};

/// Whether instances that land or buildings hide from an eye outside are left out of a plan (Occluders). The picture is the same.
enum class Occlusion : std::uint8_t {
    Off,
    IfWorthwhile, ///< left out in some frames after one in which little was hidden
    Always
};

/// Parts of the method that tests can switch off. Each part is necessary: without it some view is wrong
/// (docs/proof.md), and a test shows that the check notices.
struct Rules {
    bool ownership = true;    ///< off: every pixel belongs to the root
    bool ancestorClip = true; ///< off: openings are not clipped by the visits before them
    bool growth = true;       ///< off: the visits before clip at their exact edges
    bool nearOpening = true;  ///< off: openings within 5 cm of the eye are drawn like any other
    bool viewcone = true;     ///< off: an instance is tested only against the first visit that lists it
};

/// One frame to plan: the eye, and the conditions that are not the world's. Positions are global
/// (world/World.h).
struct FrameView {
    visibility::View view;                   ///< eye in global metres; root is a world::SpaceIndex
    std::uint32_t width = 640, height = 360; ///< pixels
    double nearPlane = kDefaultNearPlane;    ///< metres; portals are met at any distance, surfaces beyond it
    double timeOfDay = 0.5;                  ///< fraction of the day
    double seconds = 0.0;                    ///< for content that moves by itself
    std::uint32_t dayGroup = 0;
    Weather weather = Weather::Clear;
    std::optional<Vec3> viewerLight;    ///< the light that the viewer carries in cells, global; none outdoors
    Vec3f voidColour{0.5f, 0.0f, 0.5f}; ///< shown where the world has a hole
    Rules rules;
    Gate gate = Gate::Ownership;
    /// Instances of the root's zone that no opening can hide are drawn without the ownership test. The picture
    /// is the same, but for surfaces in the plane of a shut opening.
    bool fewTests = false;
    /// Every frame with several visits, or from the plane of an opening of the eye's cell, has a batch of the plain sky, whose
    /// first draw fills voids (voids.frag). The objects of the sky then take no ownership test.
    bool fillsVoids = false;
    /// The rasteriser's coverage decides the outlines of openings: no fragment tests edges. Openings near the eye are
    /// then drawn as the flood's regions.
    bool coverageDecides = false;
    /// For an eye outside with several visits: surfaces of the root visit are drawn without the ownership test. Then pixels whose
    /// ray leaves the root before that surface are cleared, and the other visits are drawn (decision 216). Requires fillsVoids.
    bool rootFirst = false;
    Occlusion occlusion = Occlusion::Off;
    world::LevelShare
        levels; ///< of distances of levels of detail; whole in plans that the device culls (levels.glsl)
    world::Look look = world::Look::Retail;
    bool exactCutOuts = false; ///< cut-outs at mip 0, nearest texel: for ids and depth
    /// Keep them few: for static instances the device searches the list for every draw. Read while the frame
    /// is planned.
    std::span<const Highlight> highlights{};
};

/// A FrameView at `eye` looking along compass direction `yaw` (degrees, 0 = north, +y; 90 = east, +x) and
/// `pitch` (degrees, positive up), `fovY` degrees high. Requires finite angles, 0 < fovY < 180, width and
/// height > 0.
[[nodiscard]] FrameView makeView(const Vec3& eye, double yaw, double pitch, double fovY, std::uint32_t width,
                                 std::uint32_t height, std::uint32_t root);

} // namespace limen::frame
