#include "ObjectField.h"

#include "FieldShapes.h"

#include "core/Assert.h"
#include "frame/WorldGraph.h"
#include "visibility/Flood.h"
#include "world/mesh/MeshArena.h"
#include "world/terrain/Terrain.h"

#include <cmath>
#include <numbers>
#include <numeric>

namespace limen::bench {

namespace {

constexpr std::uint32_t kTextures = 32; // number of the boxes' textures
constexpr double kClearance = 0.02;     // metres above the ground
constexpr double kReach = 0.05;         // metres; largest distance of dynamic objects from their homes
constexpr double kEyeHeight = 1.7;
constexpr double kLeastHalf = 0.2, kMostHalf = 0.6;     // metres, half of a box's width
constexpr double kLeastHeight = 0.3, kMostHeight = 1.5; // metres
constexpr dat::BlockCoord kFirstBlock{0x60, 0x60};
constexpr dat::RecordId kFirstModel = 0x01000001;

/// Builds the arrays of one field.
class Maker {
public:
    Maker(const FieldSpec& spec, ObjectField& field)
        : spec_(spec), field_(field), world_(field.world), arena_(field.world), random_(spec.seed),
          blocks_(static_cast<int>(std::ceil(spec.side / world::kBlockSize))) {}

    void make() {
        addOutside();
        addGround();
        addGroups();
        addObjects();
        world_.spaces[world::kOutside].instanceCount = static_cast<std::uint32_t>(world_.instances.size());
        world_.spaceInstances.resize(world_.instances.size());
        std::iota(world_.spaceInstances.begin(), world_.spaceInstances.end(), 0u);
        field_.eye = middle() + Vec3(0.0, 0.0, kEyeHeight);
        field_.moveTo(0);
    }

private:
    [[nodiscard]] Vec3 middle() const {
        const double half = blocks_ * 0.5;
        return Vec3(kFirstBlock.x + half, kFirstBlock.y + half, 0.0) * world::kBlockSize;
    }

    void addOutside() {
        world::Space outside;
        outside.zone = world::kOutsideZone;
        outside.seenOutside = true;
        world_.spaces.push_back(outside);
        world_.zones.push_back({0, 1});
        world_.zoneSpaces.push_back(world::kOutside);
        world_.lightSets.emplace_back();
    }

    /// Adds an instance outside. `members`: the array for its members.
    void placeOutside(world::Instance& instance, std::vector<world::SpaceIndex>& members) {
        instance.placedIn = world::kOutside;
        instance.firstMember = static_cast<std::uint32_t>(members.size());
        instance.memberCount = 1;
        instance.idBase = world_.idEnd;
        world_.idEnd += world_.meshes[instance.mesh].polygonCount;
        members.push_back(world::kOutside);
    }

    void addGround() {
        world_.textures.push_back(std::make_shared<const world::Image>(noisyPicture(kTextures, 64, random_)));
        world::TerrainCell cell;
        cell.base.texture = 0;
        cell.base.tiling = 4.0f;
        world_.terrainCells.assign(64, cell);
        for (int i = 0; i < blocks_ * blocks_; ++i)
            addBlock({kFirstBlock.x + i % blocks_, kFirstBlock.y + i / blocks_});
    }

    void addBlock(dat::BlockCoord coord) {
        world::Ground ground;
        ground.coord = coord;
        world_.blocks.push_back(
            {coord, true, std::vector<std::uint8_t>(81, 0), std::vector<float>(81, 0.0f)});
        world::Instance instance;
        instance.kind = world::InstanceKind::Terrain;
        instance.record = dat::landBlockId(coord);
        instance.object = instance.record;
        instance.mesh = arena_.add(world::terrainMesh(ground, [](int, int) { return std::optional(0.0f); }),
                                   world::contentKey(world::MeshSource::Terrain, dat::landBlockId(coord)));
        instance.block = static_cast<std::uint32_t>(world_.blocks.size() - 1);
        instance.bounds = world_.meshes[instance.mesh].bounds;
        instance.bounds.centre += world_.blocks.back().origin();
        placeOutside(instance, world_.members);
        world_.instances.push_back(instance);
    }

    void addGroups() {
        for (std::uint32_t i = 0; i < kTextures; ++i) {
            world_.textures.push_back(
                std::make_shared<const world::Image>(noisyPicture(i, 16u << i % 3, random_)));
            world::Material material;
            material.texture = i + 1; // after the ground's texture
            world_.materials.push_back(material);
        }
        for (std::uint32_t group = 0; group < spec_.groups; ++group) {
            const Vec3 half(random_.between(kLeastHalf, kMostHalf, Draw::Width, group),
                            random_.between(kLeastHalf, kMostHalf, Draw::Depth, group),
                            0.5 * random_.between(kLeastHeight, kMostHeight, Draw::Height, group));
            groupMeshes_.push_back(
                arena_.add(boxMesh(half), world::contentKey(world::MeshSource::GfxObj, kFirstModel + group)));
            world_.materialRefs.push_back(random_.below(kTextures, Draw::Material, group));
        }
    }

    /// The square is divided into as many squares as there are objects; each object has a random position in
    /// its own.
    void addObjects() {
        const auto row = static_cast<std::uint32_t>(std::ceil(std::sqrt(spec_.objects)));
        const double room = spec_.side / row;
        const double free = room * 0.5 - std::hypot(kMostHalf, kMostHalf) - kReach;
        LIMEN_ASSERT(free > 0.0, "the square has room for the boxes");
        const std::vector<std::uint32_t> places = shuffled(row * row, random_);
        for (std::uint32_t i = 0; i < spec_.objects; ++i) {
            const Vec3 offset((places[i] % row + 0.5) * room + random_.between(-free, free, Draw::East, i),
                              (places[i] / row + 0.5) * room + random_.between(-free, free, Draw::North, i),
                              kClearance);
            addObject(i, middle() - Vec3(spec_.side, spec_.side, 0.0) * 0.5 + offset);
        }
    }

    void addObject(std::uint32_t number, const Vec3& at) {
        const bool moves = random_.fraction(Draw::Moves, number) < spec_.movingShare;
        const std::uint32_t group =
            number < spec_.groups ? number : random_.below(spec_.groups, Draw::Group, number);
        const Vec3 block = glm::floor(at / world::kBlockSize);
        const Vec3 origin(block.x * world::kBlockSize, block.y * world::kBlockSize, 0.0);
        const auto turn =
            static_cast<float>(random_.between(0.0, 2.0 * std::numbers::pi, Draw::Turn, number));
        world::Instance instance;
        instance.kind = world::InstanceKind::Scenery;
        instance.mesh = groupMeshes_[group];
        instance.block =
            static_cast<std::uint32_t>((block.y - kFirstBlock.y) * blocks_ + block.x - kFirstBlock.x);
        instance.linear[0] = {std::cos(turn), std::sin(turn), 0.0f};
        instance.linear[1] = {-std::sin(turn), std::cos(turn), 0.0f};
        instance.origin = Vec3f(at - origin);
        instance.bounds = world_.meshes[instance.mesh].bounds;
        instance.bounds.centre += at;
        instance.object = std::uint64_t{number} + 1;
        instance.record = kFirstModel + group;
        instance.firstMaterial = group;
        placeOutside(instance, moves ? field_.dynamics.members : world_.members);
        (moves ? field_.dynamics.instances : world_.instances).push_back(instance);
        if (moves)
            field_.homes.push_back(at - origin);
    }

    const FieldSpec& spec_;
    ObjectField& field_;
    world::World& world_;
    world::MeshArena arena_;
    RandomGenerator random_;
    int blocks_; ///< blocks along each side
    std::vector<std::uint32_t> groupMeshes_;
};

} // namespace

void ObjectField::moveTo(std::uint32_t frame) {
    for (std::size_t i = 0; i < dynamics.instances.size(); ++i) {
        world::Instance& instance = dynamics.instances[i];
        const double angle = 0.1 * frame + static_cast<double>(i);
        const Vec3 at = homes[i] + kReach * Vec3(std::cos(angle), std::sin(angle), 0.0);
        const Sphere& bounds = world.meshes[instance.mesh].bounds;
        instance.origin = Vec3f(at);
        instance.bounds.centre = world.blocks[instance.block].origin() + at + bounds.centre;
    }
    world::listBySpace(world.spaces.size(), dynamics);
}

ObjectField makeField(const FieldSpec& spec) {
    LIMEN_ASSERT(spec.groups > 0 && spec.groups <= spec.objects, "every group has an object");
    ObjectField field;
    Maker(spec, field).make();
    return field;
}

std::vector<FieldView> fieldViews(const ObjectField& field, std::uint32_t count, std::uint32_t width,
                                  std::uint32_t height) {
    const Result<visibility::Graph> graph = frame::visibilityGraph(field.world);
    LIMEN_ASSERT(graph.has_value(), "a field is a valid graph");
    visibility::FloodScratch scratch;
    std::vector<FieldView> views(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        views[i].frame =
            frame::makeView(field.eye, 360.0 * i / count, 0.0, 75.0, width, height, world::kOutside);
        LIMEN_ASSERT(visibility::flood(*graph, {}, views[i].frame.view, {}, scratch, views[i].visible),
                     "the views of a bench are valid");
    }
    return views;
}

} // namespace limen::bench
