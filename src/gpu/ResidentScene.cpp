#include "gpu/ResidentScene.h"

#include "gpu/SceneCheck.h"

#include <algorithm>

namespace limen::gpu {
namespace {

namespace layout = frame::gpu;

template <class T>
std::span<const std::byte> bytesOf(const std::vector<T>& array) {
    return std::as_bytes(std::span(array));
}

SceneBindings bindingsOf(const frame::SceneUpload& upload, const TextureStore& textures) {
    std::vector<std::uint32_t> meshes, terrain;
    for (const layout::Material& material : upload.materials) {
        meshes.push_back(material.texture);
    }
    const auto addLayer = [&](const layout::TerrainLayer& layer) {
        if (layer.texture != layout::kNoTexture) {
            terrain.insert(terrain.end(), {layer.texture, layer.alpha});
        }
    };
    for (const layout::TerrainCell& cell : upload.terrainCells) {
        terrain.push_back(cell.base.texture);
        std::for_each(std::begin(cell.overlays), std::end(cell.overlays), addLayer);
        std::for_each(std::begin(cell.roads), std::end(cell.roads), addLayer);
    }
    return {textures.bindingFor(meshes), textures.bindingFor(terrain)};
}

std::vector<std::string> definesOf(const RendererOptions& options) {
    std::vector<std::string> defines = options.shaderDefines;
    if (options.exactOutlines) {
        defines.emplace_back("EXACT_OUTLINES");
    }
    return defines;
}

} // namespace

Result<std::unique_ptr<ResidentScene>> ResidentScene::create(Device& device, const frame::SceneUpload& upload,
                                                             const RendererOptions& options) {
    if (Result<void> checked = checkScene(upload); !checked) {
        return tl::unexpected(checked.error());
    }
    Result<TextureStore> textures = TextureStore::create(device, upload.textures, options.textures);
    if (!textures) {
        return tl::unexpected(textures.error());
    }
    Result<Programs> programs = Programs::create(device, bindingsOf(upload, *textures), definesOf(options));
    if (!programs) {
        return tl::unexpected(programs.error());
    }
    Result<DrawCulling> culling = DrawCulling::create(
        device, definesOf(options), options.exactOutlines ? options.culling : Culling::None);
    if (!culling) {
        return tl::unexpected(culling.error());
    }
    std::unique_ptr<ResidentScene> scene(
        new ResidentScene(device, std::move(*textures), std::move(*programs), std::move(*culling)));
    if (Result<void> uploaded = scene->upload(upload); !uploaded) {
        return tl::unexpected(uploaded.error());
    }
    return scene;
}

ResidentScene::~ResidentScene() {
    for (TextureHandle texels : texels_) {
        device_.destroyTexture(texels);
    }
    for (BufferHandle buffer : owned_) {
        device_.destroyBuffer(buffer);
    }
}

Result<void> ResidentScene::upload(const frame::SceneUpload& scene) {
    vertices_ = add("vertices", bytesOf(scene.vertices));
    addStorage(layout::kBindMaterials, "materials", bytesOf(scene.materials));
    addStorage(layout::kBindMaterialRefs, "material references", bytesOf(scene.materialRefs));
    addStorage(layout::kBindTerrain, "terrain cells", bytesOf(scene.terrainCells));
    addStorage(layout::kBindLightSets, "light sets", bytesOf(scene.lightSets));
    addStorage(layout::kBindLights, "lights", bytesOf(scene.lights));
    addStorage(layout::kBindTextures, "texture references", std::as_bytes(textures_.refs()));
    addStorage(layout::kBindIndices, "indices", bytesOf(scene.indices));
    // From kUnitVertices on.
    Result<void> added =
        addTexels("vertices", vertices_)
            .and_then([&] { return addTexels("instances", add("instances", bytesOf(scene.instances))); })
            .and_then([&] { return addTexels("members", add("members", bytesOf(scene.members))); })
            .and_then([&] { return addTexels("pieces", add("pieces", bytesOf(scene.pieces))); });
    pieces_ = static_cast<std::uint32_t>(scene.pieces.size());
    bound_ = texels_;
    bound_.insert(bound_.end(), textures_.pages().begin(), textures_.pages().end());
    return added;
}

BufferHandle ResidentScene::add(std::string_view label, std::span<const std::byte> bytes) {
    const std::size_t texels = (bytes.size() + kBytesPerTexel - 1) / kBytesPerTexel;
    const std::size_t size = std::max(texels * kBytesPerTexel, kSmallestRange);
    std::vector<std::byte> padded;
    if (bytes.size() < size) {
        padded.assign(bytes.begin(), bytes.end());
        padded.resize(size);
        bytes = padded;
    }
    owned_.push_back(device_.createBuffer(label, bytes));
    return owned_.back();
}

void ResidentScene::addStorage(std::uint32_t binding, std::string_view label,
                               std::span<const std::byte> bytes) {
    storage_[binding] = {add(label, bytes), 0, std::max(bytes.size(), kSmallestRange)};
}

Result<void> ResidentScene::addTexels(std::string_view label, BufferHandle buffer) {
    const Result<TextureHandle> texels = device_.createTexels(label, buffer);
    if (!texels) {
        return tl::unexpected(texels.error());
    }
    texels_.push_back(*texels);
    return {};
}

} // namespace limen::gpu
