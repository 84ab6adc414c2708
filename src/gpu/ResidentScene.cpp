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
    const auto storage = [&](std::uint32_t binding, std::string_view label,
                             std::span<const std::byte> bytes) {
        return [=, this] { return addStorage(binding, label, bytes); };
    };
    const auto texels = [&](std::string_view label, std::span<const std::byte> bytes) {
        return [=, this] { return addTexels(label, bytes); };
    };
    Result<void> added =
        storage(layout::kBindMaterials, "materials", bytesOf(scene.materials))()
            .and_then(storage(layout::kBindMaterialRefs, "material references", bytesOf(scene.materialRefs)))
            .and_then(storage(layout::kBindTerrain, "terrain cells", bytesOf(scene.terrainCells)))
            .and_then(storage(layout::kBindLightSets, "light sets", bytesOf(scene.lightSets)))
            .and_then(storage(layout::kBindLights, "lights", bytesOf(scene.lights)))
            .and_then(storage(layout::kBindTextures, "texture references", std::as_bytes(textures_.refs())))
            .and_then(storage(layout::kBindIndices, "indices", bytesOf(scene.indices)))
            // From kUnitVertices on.
            .and_then(texels("vertices", bytesOf(scene.vertices)))
            .map([&] { vertices_ = owned_.back(); })
            .and_then(texels("instances", bytesOf(scene.instances)))
            .and_then(texels("members", bytesOf(scene.members)))
            .and_then(texels("pieces", bytesOf(scene.pieces)));
    pieces_ = static_cast<std::uint32_t>(scene.pieces.size());
    bound_ = texels_;
    bound_.insert(bound_.end(), textures_.pages().begin(), textures_.pages().end());
    return added;
}

Result<BufferHandle> ResidentScene::add(std::string_view label, std::span<const std::byte> bytes) {
    const std::size_t texels = (bytes.size() + kBytesPerTexel - 1) / kBytesPerTexel;
    const std::size_t size = std::max(texels * kBytesPerTexel, kSmallestRange);
    std::vector<std::byte> padded;
    if (bytes.size() < size) {
        padded.assign(bytes.begin(), bytes.end());
        padded.resize(size);
        bytes = padded;
    }
    Result<BufferHandle> buffer = device_.createBuffer(label, bytes);
    if (buffer) {
        owned_.push_back(*buffer);
    }
    return buffer;
}

Result<void> ResidentScene::addStorage(std::uint32_t binding, std::string_view label,
                                       std::span<const std::byte> bytes) {
    return add(label, bytes).map([&](BufferHandle buffer) {
        storage_[binding] = {buffer, 0, std::max(bytes.size(), kSmallestRange)};
    });
}

Result<void> ResidentScene::addTexels(std::string_view label, std::span<const std::byte> bytes) {
    return add(label, bytes)
        .and_then([&](BufferHandle buffer) { return device_.createTexels(label, buffer); })
        .map([&](TextureHandle texels) { texels_.push_back(texels); });
}

} // namespace limen::gpu
