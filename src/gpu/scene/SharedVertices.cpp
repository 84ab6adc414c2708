#include "gpu/scene/SharedVertices.h"

#include <array>
#include <bit>

namespace limen::gpu {

namespace {

namespace layout = frame::gpu;

/// The values of a vertex that fast.vert reads, as bits.
using Key = std::array<std::uint32_t, 10>;

Key keyOf(const layout::Vertex& v) {
    const auto bits = [](float value) { return std::bit_cast<std::uint32_t>(value); };
    return {bits(v.position.x), bits(v.position.y),
            bits(v.position.z), v.normal,
            bits(v.uv.x),       bits(v.uv.y),
            bits(v.rest.x),     bits(v.rest.y),
            bits(v.rest.z),     v.polygonSurface & 0xFFFF0000u};
}

std::size_t hashOf(const Key& key) {
    std::uint64_t hash = 0;
    for (const std::uint32_t word : key)
        hash = (hash ^ word) * 0x9E3779B97F4A7C15u;
    return static_cast<std::size_t>(hash >> 32);
}

constexpr std::uint32_t kEmpty = 0xFFFFFFFFu;

/// The first vertex of each key, by open addressing.
class FirstVertices {
public:
    explicit FirstVertices(std::span<const layout::Vertex> vertices)
        : vertices_(vertices), slots_(std::bit_ceil(2 * vertices.size() + 1), kEmpty) {}

    std::uint32_t findOrAdd(std::uint32_t vertex) {
        const Key key = keyOf(vertices_[vertex]);
        for (std::size_t at = hashOf(key);; ++at) {
            std::uint32_t& slot = slots_[at & (slots_.size() - 1)];
            if (slot == kEmpty)
                slot = vertex;
            if (slot == vertex || keyOf(vertices_[slot]) == key)
                return slot;
        }
    }

private:
    std::span<const layout::Vertex> vertices_;
    std::vector<std::uint32_t> slots_;
};

} // namespace

std::vector<std::uint32_t> shareVertices(std::span<const layout::Vertex> vertices,
                                         std::span<const std::uint32_t> indices) {
    FirstVertices firsts(vertices);
    std::vector<std::uint32_t> shared;
    shared.reserve(indices.size());
    for (const std::uint32_t vertex : indices)
        shared.push_back(firsts.findOrAdd(vertex));
    return shared;
}

} // namespace limen::gpu
