#pragma once

#include "dat/records/Mesh.h"

#include <array>

// GfxObj (0x01), Setup (0x02), Environment (0x0D): docs/formats/geometry.md.
LIMEN_API_BEGIN
namespace limen::dat {

struct GfxObj {
    static constexpr std::uint32_t kPhysics = 1, kDrawing = 2, kHasDegrade = 8;
    std::uint32_t id = 0;
    std::uint32_t flags = 0;
    std::vector<std::uint32_t> surfaces; ///< Surface (0x08) ids
    VertexArray vertexArray;
    PolygonList physicsPolygons; ///< flags & kPhysics
    BspTree physicsBsp;          ///< flags & kPhysics
    Vec3f sortCenter{0.0f};
    PolygonList polygons;        ///< flags & kDrawing
    BspTree drawingBsp;          ///< flags & kDrawing; its PORT nodes name the portal polygons
    std::uint32_t degradeId = 0; ///< flags & kHasDegrade
};

/// An animation hook. The payload is kept as bytes; its length depends on the type
/// (docs/formats/effects_anim.md).
struct AnimationHook {
    std::uint32_t type = 0;
    std::int32_t direction = 0;
    std::vector<std::uint8_t> payload;
};

struct AnimationFrame {
    std::vector<Frame> parts; ///< one per part, relative to the object
    std::vector<AnimationHook> hooks;
};

struct Location {
    std::int32_t key = 0;
    std::int32_t part = 0;
    Frame frame;
};

struct LightInfo {
    Frame frame; ///< relative to the object
    Colour colour;
    float intensity = 0.0f;
    float falloff = 0.0f; ///< range, metres
    float coneAngle = 0.0f;
};

struct Setup {
    static constexpr std::uint32_t kParents = 1, kScales = 2, kFreeHeading = 4, kPhysicsBsp = 8;
    static constexpr std::uint32_t kPlacementDefault = 0, kPlacementResting = 0x65;
    std::uint32_t id = 0;
    std::uint32_t flags = 0;
    std::vector<std::uint32_t> parts;   ///< GfxObj ids
    std::vector<std::uint32_t> parents; ///< flags & kParents; 0xFFFFFFFF none
    std::vector<Vec3f> scales;          ///< flags & kScales
    std::vector<Location> holdingLocations;
    std::vector<Location> connectionPoints;
    std::vector<std::pair<std::uint32_t, AnimationFrame>> placementFrames;
    std::vector<CylSphere> cylSpheres;
    std::vector<SphereF> spheres;
    float height = 0.0f, radius = 0.0f, stepUp = 0.0f, stepDown = 0.0f;
    SphereF sortingSphere, selectionSphere;
    std::vector<std::pair<std::int32_t, LightInfo>> lights;
    std::uint32_t animation = 0, script = 0, motionTable = 0, soundTable = 0, scriptTable = 0;
};

/// The shape of a cell, shared by all EnvCells that refer to it.
struct CellStruct {
    VertexArray vertexArray;
    PolygonList polygons;                      ///< drawing polygons, portal polygons included
    std::vector<std::uint16_t> portalPolygons; ///< entry i belongs to EnvCell portal i
    BspTree cellBsp;
    PolygonList physicsPolygons;
    BspTree physicsBsp;
    std::optional<BspTree> drawingBsp;
    /// Bytes up to a multiple of four behind portalPolygons and at the end; the writer stores zeros.
    std::array<std::uint8_t, 3> portalPadding{};
    std::array<std::uint8_t, 3> padding{};
};

struct Environment {
    std::uint32_t id = 0;
    std::vector<std::pair<std::uint32_t, CellStruct>> cells; ///< (key, shape)
};

/// A mesh for a range of distances.
struct DegradeLevel {
    static constexpr std::uint32_t kMesh = 1; ///< does not turn
    /// Turn to the viewer: freely, and about one axis of the mesh.
    static constexpr std::uint32_t kFacesEye = 2, kTurnsX = 3, kTurnsY = 4, kTurnsZ = 5;
    std::uint32_t gfxObj = 0; ///< 0: nothing is drawn
    std::uint32_t mode = kMesh;
    float minDistance = 0.0f, idealDistance = 0.0f, maxDistance = 0.0f; ///< metres
};

/// GfxObjDegradeInfo (0x11).
struct DegradeInfo {
    std::uint32_t id = 0;
    std::vector<DegradeLevel> levels; ///< the first within whose maxDistance the viewer is, else the last
};

} // namespace limen::dat
LIMEN_API_END
