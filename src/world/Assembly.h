#pragma once

#include "world/BlockContent.h"
#include "world/Cycles.h"
#include "world/Lights.h"
#include "world/Materials.h"
#include "world/MeshArena.h"
#include "world/MovingEntries.h"

namespace limen::world {

/// Identities of moving things; 0xF… is no landblock's.
enum class MovingThing : std::uint64_t { Door = 0xF1, Villager = 0xF2, Sprite = 0xF3, Player = 0xF4 };
[[nodiscard]] constexpr std::uint64_t movingObject(MovingThing thing, std::size_t index) {
    return static_cast<std::uint64_t>(thing) << 56 | static_cast<std::uint64_t>(index);
}

/// Joins blocks into a World: indices made global, portals and zones numbered, meshes put into the arenas,
/// members, ids and lights found. Blocks must be added in ascending order of (x, y); then the result depends
/// on nothing else.
class Assembly {
public:
    Assembly(Records& records, Models& models, const dat::Region* region);

    void add(const BlockContent& block);
    [[nodiscard]] World finish(const MovingEntries& moving = {});

private:
    void addTerrain(const BlockContent& block);
    void addSpaces(const BlockContent& block);
    void addPortals(const BlockContent& block);
    void addShells(const BlockContent& block);
    void addExteriors(const BlockContent& block);
    void addObjects(const BlockContent& block);
    void addPart(const PlacedModel& object, const ModelPart& part);
    Instance& addBaked(Kind kind, const MeshData& data, std::uint64_t key, std::uint64_t object,
                       dat::RecordId record);
    std::uint32_t materialRun(std::span<const dat::RecordId> surfaces, const std::vector<bool>& clamp);
    std::uint32_t partMaterials(const PartMesh& part);
    std::uint32_t terrainRun(const Ground& ground);
    [[nodiscard]] TerrainCell paint(const CellCorners& corners);
    [[nodiscard]] SpaceIndex spaceOf(std::uint32_t local) const;

    void addMoving(const MovingEntries& moving);
    void addDoor(const DoorEntry& entry, std::size_t index);
    void addVillagers(const MovingEntries& moving);
    void addEmitter(const EmitterEntry& entry);
    void addPlayer(dat::RecordId model);
    [[nodiscard]] MovingBody addGhost(const MovingBody& solid);
    [[nodiscard]] std::uint32_t ghostMaterials(std::uint32_t firstMaterial, std::size_t count);
    [[nodiscard]] MovingBody addBody(dat::RecordId model, Kind kind, std::uint64_t object);
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

    Records& records_;
    Models& models_;
    const dat::Region* region_;
    World world_;
    Materials materials_;
    MeshArena arena_;
    Cycles cycles_;
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
