#pragma once

#include "world/mesh/Models.h"
#include "world/records/LruCache.h"

namespace limen::world {

/// Models and part meshes of one archive, kept for later loads together with the findings of their records.
/// Thread-safe.
struct ModelCache {
    ModelCache(std::size_t mostModelBytes, std::size_t mostPartBytes)
        : models(mostModelBytes), parts(mostPartBytes) {}

    LruCache<std::pair<dat::RecordId, LevelLimits>, Found<Model>> models;
    LruCache<dat::RecordId, Found<std::optional<PartMesh>>> parts; ///< no value: the record is damaged
};

/// Estimated size in memory, bytes.
[[nodiscard]] std::size_t bytesOf(const MeshData& mesh);
[[nodiscard]] std::size_t bytesOf(const Model& model);
[[nodiscard]] std::size_t bytesOf(const std::optional<PartMesh>& part);

template <class T>
[[nodiscard]] std::size_t bytesOf(const std::vector<T>& list) {
    return list.capacity() * sizeof(T);
}

} // namespace limen::world
