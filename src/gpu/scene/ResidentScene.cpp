#include "gpu/scene/ResidentScene.h"

#include "gpu/scene/PackedTerrain.h"

#include <algorithm>
#include <array>

namespace limen::gpu {
namespace {

namespace layout = frame::gpu;

constexpr const char* kSharedIndices = "shared indices";

template <class T>
std::span<const std::byte> bytesOf(const std::vector<T>& array) {
    return std::as_bytes(std::span(array));
}

} // namespace

ResidentScene::ResidentScene(Device& device, StagedScene staged, std::shared_ptr<Programs> programs,
                             const ResidentScene* before, SpareBuffers& spare)
    : device_(device), spare_(spare),
      textures_(device, std::move(staged.textures), before != nullptr ? &before->textures_ : nullptr),
      programs_(std::move(programs)), scene_(std::move(staged.arrays)),
      shared_(std::move(staged.sharedIndices)), pieces_(static_cast<std::uint32_t>(scene_->pieces.size())),
      tables_(std::move(staged.tables)), packsTerrain_(staged.packsTerrain),
      blendMaps_(std::move(staged.blendMaps)) {}

ResidentScene::~ResidentScene() {
    for (TextureHandle texels : texels_)
        device_.destroyTexture(texels);
    for (const SizedBuffer& buffer : owned_) // frames in flight may still read them
        device_.destroyBuffer(buffer.handle);
}

bool ResidentScene::releaseSome() {
    if (textures_.releaseSome())
        return true;
    for (TextureHandle texels : texels_) // views of the buffers
        device_.destroyTexture(texels);
    texels_.clear();
    for (const SizedBuffer& buffer : owned_)
        spare_.giveBack(buffer);
    owned_.clear();
    return false;
}

void ResidentScene::listArrays() {
    const auto storage = [&](std::uint32_t binding, const char* label, std::span<const std::byte> bytes) {
        arrays_.push_back({label, bytes, binding});
    };
    const auto texels = [&](std::uint32_t unit, const char* label, std::span<const std::byte> bytes) {
        arrays_.push_back({label, bytes, kNowhere, unit});
    };
    texels(layout::kUnitMaterials, "materials", bytesOf(scene_->materials));
    texels(layout::kUnitMaterialRefs, "material references", bytesOf(scene_->materialRefs));
    if (packsTerrain_) {
        packed_ = packTerrain(scene_->terrainCells, textures_.pageRefs(), blendMaps_);
        texels(layout::kUnitTerrain, "packed terrain cells", bytesOf(packed_));
    } else {
        texels(layout::kUnitTerrain, "terrain cells", bytesOf(scene_->terrainCells));
    }
    storage(layout::kBindLightSets, "light sets", bytesOf(scene_->lightSets));
    storage(layout::kBindLampRefs, "lamp references", bytesOf(scene_->lampRefs));
    texels(layout::kUnitTextures, "texture references", std::as_bytes(textures_.refs()));
    storage(layout::kBindLevels, "levels of detail", bytesOf(scene_->levels));
    storage(layout::kBindIndices, "indices", bytesOf(scene_->indices));
    texels(layout::kUnitVertices, "vertices", bytesOf(scene_->vertices));
    texels(layout::kUnitInstances, "instances", bytesOf(scene_->instances));
    texels(layout::kUnitMembers, "members", bytesOf(scene_->members));
    texels(layout::kUnitPieces, "pieces", bytesOf(scene_->pieces));
    if (!shared_->empty())
        arrays_.push_back({kSharedIndices, bytesOf(*shared_)});
    bound_.assign(layout::kUnitFirstPage - layout::kUnitVertices, TextureHandle::Invalid);
}

Result<bool> ResidentScene::advance(std::size_t& bytes) {
    if (Result<bool> filled = textures_.advance(bytes); !filled || !*filled)
        return filled;
    if (arrays_.empty())
        listArrays();
    for (; done_ < arrays_.size(); ++done_)
        if (Result<bool> uploaded = upload(arrays_[done_], bytes); !uploaded || !*uploaded)
            return uploaded;
    if (scene_ != nullptr) {
        bound_.insert(bound_.end(), textures_.pages().begin(), textures_.pages().end());
        scene_.reset();
        shared_.reset();
        packed_ = {};
    }
    return programs_->buildNext(bytes);
}

Result<bool> ResidentScene::upload(Array& array, std::size_t& bytes) {
    const std::size_t texels = (array.bytes.size() + kBytesPerTexel - 1) / kBytesPerTexel;
    const std::size_t size = std::max(texels * kBytesPerTexel, kSmallestRange);
    if (bytes == 0)
        return false;
    if (array.buffer == BufferHandle::Invalid) {
        const Result<SizedBuffer> taken = spare_.take(array.label, size);
        if (!taken)
            return Failure(taken.error());
        array.buffer = taken->handle;
        owned_.push_back(*taken);
    }
    const std::size_t count = std::min(bytes, array.bytes.size() - array.written);
    if (count > 0) {
        device_.writeBuffer(array.buffer, array.written, array.bytes.subspan(array.written, count));
        array.written += count;
        bytes -= count;
    }
    if (array.written < array.bytes.size())
        return false;
    if (array.written < size) {
        constexpr std::array<std::byte, std::max(kBytesPerTexel, kSmallestRange)> kNothing{};
        device_.writeBuffer(array.buffer, array.written, std::span(kNothing).first(size - array.written));
        bytes -= std::min(bytes, size - array.written);
    }
    return finish(array).map([] { return true; });
}

Result<void> ResidentScene::finish(const Array& array) {
    if (array.binding != kNowhere)
        storage_[array.binding] = {array.buffer, 0, std::max(array.bytes.size(), kSmallestRange)};
    if (array.label == kSharedIndices)
        sharedIndices_ = array.buffer;
    if (array.unit == kNowhere)
        return {};
    const Result<TextureHandle> texels = device_.createTexels(array.label, array.buffer);
    if (!texels)
        return Failure(texels.error());
    texels_.push_back(*texels);
    bound_[array.unit - layout::kUnitVertices] = *texels;
    if (array.unit == layout::kUnitVertices)
        vertices_ = array.buffer;
    return {};
}

} // namespace limen::gpu
