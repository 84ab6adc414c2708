#include "ClassicScene.h"

#include "core/Assert.h"
#include "frame/SceneBuilder.h"
#include "gpu/scene/Programs.h"

#include <algorithm>
#include <map>
#include <utility>

namespace limen::bench {

namespace {

namespace layout = frame::gpu;

constexpr std::size_t kTexelBytes = 16;
constexpr std::size_t kSmallestRange = 256; // bytes; bound ranges must not be empty

template <class T>
std::span<const std::byte> bytesOf(const std::vector<T>& array) {
    return std::as_bytes(std::span(array));
}

std::uint32_t textureOf(const world::World& world, const world::Instance& instance) {
    if (instance.kind == world::InstanceKind::Terrain)
        return world.terrainCells[instance.firstMaterial].base.texture;
    return world.materials[world.materialRefs[instance.firstMaterial]].texture;
}

/// The common properties of a group: mesh and first material.
using GroupKey = std::pair<std::uint32_t, std::uint32_t>;
GroupKey keyOf(const world::Instance& instance) {
    return {instance.mesh, instance.firstMaterial};
}

/// Indices of the instances by group. Groups are in the order of their first instances.
struct Sorted {
    std::vector<world::Instance> examples; ///< one instance of each group
    std::vector<std::vector<std::uint32_t>> standing, moving;
};

Sorted sortByGroup(const world::World& world, const world::DynamicState& dynamics) {
    Sorted sorted;
    std::map<GroupKey, std::size_t> numbers;
    const auto groupFor = [&](const world::Instance& instance) {
        const auto [entry, fresh] = numbers.try_emplace(keyOf(instance), sorted.examples.size());
        if (fresh) {
            sorted.examples.push_back(instance);
            sorted.standing.emplace_back();
            sorted.moving.emplace_back();
        }
        return entry->second;
    };
    for (std::uint32_t i = 0; i < world.instances.size(); ++i)
        sorted.standing[groupFor(world.instances[i])].push_back(i);
    for (std::uint32_t i = 0; i < dynamics.instances.size(); ++i)
        sorted.moving[groupFor(dynamics.instances[i])].push_back(i);
    return sorted;
}

} // namespace

Result<std::unique_ptr<ClassicScene>> ClassicScene::create(gpu::Device& device, const world::World& world,
                                                           const world::DynamicState& dynamics) {
    std::unique_ptr<ClassicScene> scene(new ClassicScene(device));
    scene->programs_.fill(gpu::ProgramHandle::Invalid);
    Result<void> made = scene->upload(world).and_then([&] { return scene->addPrograms(); });
    if (!made)
        return Failure(made.error());
    scene->addGroups(world, dynamics);
    return scene;
}

ClassicScene::~ClassicScene() {
    for (gpu::ProgramHandle program : programs_)
        if (program != gpu::ProgramHandle::Invalid)
            device_.destroyProgram(program);
    for (gpu::TextureHandle texels : texels_)
        device_.destroyTexture(texels);
    for (gpu::BufferHandle buffer : owned_)
        device_.destroyBuffer(buffer);
}

Result<void> ClassicScene::upload(const world::World& world) {
    const frame::SceneUpload scene = frame::buildScene(frame::StaticScene(world));
    if (Result<void> added = addPages(scene.textures); !added)
        return added;
    std::vector<layout::TextureRef> refs;
    for (const gpu::TextureStore& page : pages_)
        refs.push_back(page.refs().front());
    vertices_ = add("classic vertices", bytesOf(scene.vertices));
    indices_ = add("classic indices", bytesOf(scene.indices));
    storage_.fill(
        {indices_, 0, kSmallestRange}); // a placeholder for bindings that no shader of this path reads
    addStorage(layout::kBindLightSets, "classic light sets", bytesOf(scene.lightSets));
    addStorage(layout::kBindLampRefs, "classic lamp references", bytesOf(scene.lampRefs));
    const gpu::BufferHandle materials = add("classic materials", bytesOf(scene.materials));
    const gpu::BufferHandle materialRefs = add("classic material references", bytesOf(scene.materialRefs));
    const gpu::BufferHandle terrain = add("classic terrain cells", bytesOf(scene.terrainCells));
    const gpu::BufferHandle textures = add("classic texture references", bytesOf(refs));
    packed_ = scene.instances;
    staticMembers_ = static_cast<std::uint32_t>(scene.members.size());
    const gpu::BufferHandle members = add("classic members", bytesOf(scene.members));
    if (missing_)
        return Failure(*missing_);
    // All instances are in the frame's memory and there are no pieces, so the shaders never read these
    // arrays.
    return addTexels(layout::kUnitVertices, "classic vertices", vertices_)
        .and_then([&] { return addTexels(layout::kUnitInstances, "classic instances", vertices_); })
        .and_then([&] { return addTexels(layout::kUnitPieces, "classic pieces", vertices_); })
        .and_then([&] { return addTexels(layout::kUnitMembers, "classic members", members); })
        .and_then([&] { return addTexels(layout::kUnitMaterials, "classic materials", materials); })
        .and_then(
            [&] { return addTexels(layout::kUnitMaterialRefs, "classic material references", materialRefs); })
        .and_then([&] { return addTexels(layout::kUnitTerrain, "classic terrain cells", terrain); })
        .and_then([&] { return addTexels(layout::kUnitTextures, "classic texture references", textures); });
}

Result<void> ClassicScene::addPages(std::span<const frame::TextureUpload> textures) {
    for (const frame::TextureUpload& texture : textures) {
        Result<gpu::TextureStore> page = gpu::TextureStore::create(device_, std::span(&texture, 1),
                                                                   {.mode = gpu::TextureMode::ArrayPages});
        if (!page)
            return Failure(page.error());
        pages_.push_back(std::move(*page));
    }
    return {};
}

Result<void> ClassicScene::addPrograms() {
    LIMEN_ASSERT(!pages_.empty(), "every group has a texture");
    const std::uint32_t first = 0;
    const gpu::TextureBinding onePage = pages_.front().bindingFor(std::span(&first, 1));
    for (const frame::Program program :
         {frame::Program::Opaque, frame::Program::Terrain, frame::Program::SkyPlain}) {
        gpu::ProgramSource source = gpu::programSource(gpu::Drawing::Exact, program, {}, onePage);
        source.label = "classic " + source.label;
        source.defines.emplace_back("EXACT_OUTLINES");
        const Result<gpu::ProgramHandle> made = device_.createProgram(source);
        if (!made)
            return Failure(made.error());
        programs_[static_cast<std::size_t>(program)] = *made;
    }
    return {};
}

ClassicGroup ClassicScene::groupOf(const world::World& world, const world::Instance& instance) const {
    const world::Mesh& mesh = world.meshes[instance.mesh];
    const world::Mesh::Range& range = mesh.ranges[static_cast<std::size_t>(world::SurfaceClass::Opaque)];
    const bool isGround = instance.kind == world::InstanceKind::Terrain;
    LIMEN_ASSERT(range.indexCount == mesh.vertexCount, "all surfaces are opaque");
    LIMEN_ASSERT(textureOf(world, instance) != world::kNone, "every group has a texture");
    ClassicGroup group;
    group.program = isGround ? frame::Program::Terrain : frame::Program::Opaque;
    group.firstIndex = range.firstIndex;
    group.indexCount = range.indexCount;
    group.page = pages_[textureOf(world, instance)].pages().front();
    return group;
}

void ClassicScene::addGroups(const world::World& world, const world::DynamicState& dynamics) {
    const Sorted sorted = sortByGroup(world, dynamics);
    for (std::size_t i = 0; i < sorted.examples.size(); ++i) {
        ClassicGroup group = groupOf(world, sorted.examples[i]);
        group.firstStanding = static_cast<std::uint32_t>(standing_.size());
        group.standingCount = static_cast<std::uint32_t>(sorted.standing[i].size());
        for (const std::uint32_t instance : sorted.standing[i])
            standing_.push_back({world.instances[instance].bounds, instance,
                                 world.instances[instance].level != world::kNone, packed_[instance]});
        group.firstMoving = static_cast<std::uint32_t>(moving_.size());
        group.movingCount = static_cast<std::uint32_t>(sorted.moving[i].size());
        moving_.insert(moving_.end(), sorted.moving[i].begin(), sorted.moving[i].end());
        groups_.push_back(group);
    }
    std::stable_partition(groups_.begin(), groups_.end(), [](const ClassicGroup& group) {
        return group.program == frame::Program::Opaque;
    }); // one change of program a frame
    packed_ = {};
}

gpu::BufferHandle ClassicScene::add(std::string_view label, std::span<const std::byte> bytes) {
    std::vector<std::byte> padded(bytes.begin(), bytes.end());
    const std::size_t texels = (bytes.size() + kTexelBytes - 1) / kTexelBytes;
    padded.resize(std::max(texels * kTexelBytes, kSmallestRange));
    const Result<gpu::BufferHandle> buffer = device_.createBuffer(label, padded);
    if (!buffer) {
        missing_ = buffer.error();
        return gpu::BufferHandle::Invalid;
    }
    owned_.push_back(*buffer);
    return *buffer;
}

void ClassicScene::addStorage(std::uint32_t binding, std::string_view label,
                              std::span<const std::byte> bytes) {
    storage_[binding] = {add(label, bytes), 0, std::max(bytes.size(), kSmallestRange)};
}

Result<void> ClassicScene::addTexels(std::uint32_t unit, std::string_view label, gpu::BufferHandle buffer) {
    const Result<gpu::TextureHandle> texels = device_.createTexels(label, buffer);
    if (!texels)
        return Failure(texels.error());
    texels_.push_back(*texels);
    textures_[unit - layout::kUnitVertices] = *texels;
    return {};
}

} // namespace limen::bench
