#pragma once

#include "world/BlockContent.h"
#include "world/Cycles.h"
#include "world/EmitterStarts.h"
#include "world/Lights.h"
#include "world/Materials.h"
#include "world/MeshArena.h"
#include "world/MovingEntries.h"

namespace limen::world {

/// A mesh whose triangles are all blended; none is split, so that it is drawn in one way whatever its opacity.
[[nodiscard]] MeshData asGlass(const MeshData& solid);
/// A flat picture that faces -y, u to the right and v downwards as seen from there: x and z from `low` to `high`.
[[nodiscard]] MeshData spriteMesh(SurfaceList surfaces, const Vec2f& low, const Vec2f& high);

/// Identities of moving things; 0xF… is no landblock's.
enum class MovingThing : std::uint64_t {
    Door = 0xF1,
    Villager = 0xF2,
    Sprite = 0xF3,
    Player = 0xF4,
    Particle = 0xF5
};
[[nodiscard]] constexpr std::uint64_t movingObject(MovingThing thing, std::size_t index) {
    return static_cast<std::uint64_t>(thing) << 56 | static_cast<std::uint64_t>(index);
}

/// Joins blocks into a World: indices made global, portals and zones numbered, meshes put into the arenas,
/// members, ids and lights found. Blocks must be added in ascending order of (x, y); then the result depends
/// on nothing else.
class Assembly {
public:
    /// `cache`: null, or where pictures may be that others have decoded. All outlive it.
    Assembly(Records& records, Models& models, const dat::Region* region, LoadCache* cache = nullptr);

    void add(const BlockContent& block);
    [[nodiscard]] World finish(const MovingEntries& moving = {});

private:
    void addTerrain(const BlockContent& block);
    void addSpaces(const BlockContent& block);
    void addPortals(const BlockContent& block);
    void addShells(const BlockContent& block);
    void addExteriors(const BlockContent& block);
    void addObjects(const BlockContent& block);
    void addResident(const PlacedModel& object, const Model& model, const Sphere& bounds);
    void addPart(const PlacedModel& object, const ModelPart& part);
    /// Adds an object that moves where it stands; false, and nothing is added, if it does not.
    [[nodiscard]] bool addIdle(const PlacedModel& object);
    void addSources(const PlacedModel& object, std::uint32_t idle);
    void addSources(std::uint32_t villager, dat::RecordId model, const PlayEntry& play);
    /// `source` with what its start and its style tell; nothing if it can show no particle.
    std::optional<ParticleSource> sourceOf(const EmitterStart& start, const dat::Setup& setup,
                                           ParticleSource source);
    void addWeather();
    void addWeather(std::uint32_t dayGroup, std::uint32_t number, const dat::SkyObject& object);
    [[nodiscard]] std::vector<EmitterStart> startsOf(const dat::Setup& setup,
                                                     std::span<const std::uint32_t> cycles);
    [[nodiscard]] std::uint32_t particleStyle(dat::RecordId emitter);
    [[nodiscard]] std::uint32_t particlePart(const dat::ParticleEmitter& record, ParticleStyle& style);
    [[nodiscard]] std::uint32_t particleSprite(const PartMesh& mesh, const Material& material);
    void findAloneness();
    Instance& addBaked(InstanceKind kind, const MeshData& data, std::uint64_t key, std::uint64_t object,
                       dat::RecordId record);
    std::uint32_t materialRun(std::span<const dat::RecordId> surfaces, const std::vector<bool>& clamp);
    std::uint32_t partMaterials(const PartMesh& part);
    /// Of a part of a Setup that wears something.
    std::uint32_t dressedMaterials(const PartMesh& part, std::uint32_t number, const Dress& dress);
    [[nodiscard]] std::vector<bool> clampOf(const PartMesh& part);
    std::uint32_t terrainRun(const Ground& ground);
    [[nodiscard]] TerrainCell paint(const CellCorners& corners);
    [[nodiscard]] SpaceIndex spaceOf(std::uint32_t local) const;

    void addMoving(const MovingEntries& moving);
    void addDoor(const DoorEntry& entry, std::size_t index);
    void addVillagers(const MovingEntries& moving);
    void addEmitter(const EmitterEntry& entry);
    void addPlayer(dat::RecordId model, const Dress& dress);
    [[nodiscard]] MovingBody addGhost(const MovingBody& solid);
    [[nodiscard]] std::uint32_t ghostMaterials(std::uint32_t firstMaterial, std::size_t count);
    [[nodiscard]] MovingBody addBody(dat::RecordId model, InstanceKind kind, std::uint64_t object,
                                     const Dress& dress = {});
    /// Gives a body, whose parts were just added, what its model does.
    void addCycles(dat::RecordId model, std::span<const PosedPart> posed, MovingBody& body);
    [[nodiscard]] std::uint32_t addRoute(const RouteEntry& entry);
    [[nodiscard]] MovingBody addShutBody(const Leaf& leaf, const Portal& portal);
    [[nodiscard]] std::uint32_t addFilling(const Door& door, std::uint64_t object);
    [[nodiscard]] std::uint32_t addSprite(std::uint32_t firstMaterial, std::uint32_t key);
    [[nodiscard]] std::uint32_t plainMaterial(const Vec4f& colour, SurfaceClass surfaces);
    [[nodiscard]] std::vector<std::uint8_t> allShut() const;

    void gatherOutdoorPortals();
    void findMembers();
    void listInstances();
    void numberPolygons();
    void addSky();
    using SkyMeshes = std::map<std::pair<dat::RecordId, std::size_t>, std::uint32_t>; ///< by model and part
    /// Adds `part` for each part of a model that has something to show.
    void addSkyParts(const SkyPart& part, dat::RecordId model, SkyMeshes& meshes);

    Records& records_;
    Models& models_;
    const dat::Region* region_;
    World world_;
    Materials materials_;
    MeshArena arena_;
    Cycles cycles_;
    EmitterStarts starts_;
    std::unordered_map<dat::RecordId, std::uint32_t> particleStyles_; ///< by ParticleEmitter
    std::unordered_map<dat::RecordId, std::uint32_t> partMaterials_;
    std::map<std::uint32_t, TerrainCell> painted_; ///< by palette code
    std::vector<Portal> outdoorPortals_;           ///< moved to the front at the end
    std::vector<PlacedLamp> lamps_;
    struct Group {
        InstanceIndex first = 0, count = 0;
        Sphere bounds; ///< global, of all parts
    };
    std::vector<Group> objects_; ///< instances whose members are to be found
    std::uint32_t block_ = 0;    ///< index of the block being added
    SpaceIndex firstSpace_ = 0;  ///< of its cells
};

} // namespace limen::world
