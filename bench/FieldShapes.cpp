#include "FieldShapes.h"

#include <numeric>
#include <utility>

namespace limen::bench {

namespace {

/// The output function of splitmix64. Source: Steele, Lea, Flood, "Fast splittable pseudorandom number
/// generators" (2014).
std::uint64_t mixed(std::uint64_t v) {
    v = (v ^ v >> 30) * 0xBF58476D1CE4E5B9u;
    v = (v ^ v >> 27) * 0x94D049BB133111EBu;
    return v ^ v >> 31;
}

} // namespace

double RandomGenerator::fraction(Draw draw, std::uint32_t number) const {
    const std::uint64_t key = std::uint64_t{seed_} << 48 ^ static_cast<std::uint64_t>(draw) << 40 ^ number;
    return static_cast<double>(mixed(mixed(key + 0x9E3779B97F4A7C15u)) >> 11) * 0x1p-53;
}

// The Fisher-Yates shuffle.
std::vector<std::uint32_t> shuffled(std::uint32_t count, const RandomGenerator& random) {
    std::vector<std::uint32_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0u);
    for (std::uint32_t i = count; i > 1; --i)
        std::swap(numbers[i - 1], numbers[random.below(i, Draw::Place, i)]);
    return numbers;
}

world::Image noisyPicture(std::uint32_t number, std::uint32_t size, const RandomGenerator& random) {
    world::Image image{size, size, {}, false};
    const std::uint32_t base = 97 * number;
    for (std::uint32_t i = 0; i < size * size; ++i) {
        const auto shade = static_cast<std::uint32_t>(64.0 * random.fraction(Draw::Texel, number << 16 | i));
        for (const std::uint32_t channel : {base, base * 3, base * 7})
            image.rgba.push_back(static_cast<std::uint8_t>(96 + (channel % 96) + shade));
        image.rgba.push_back(255);
    }
    return image;
}

world::MeshData boxMesh(const Vec3& half) {
    world::MeshData mesh;
    for (int side = 0; side < 6; ++side) {
        const int axis = side / 2;
        Vec3 normal(0.0), right(0.0);
        normal[axis] = side % 2 == 0 ? 1.0 : -1.0;
        right[(axis + 1) % 3] = 1.0;
        const Vec3 up = glm::cross(normal, right);
        const auto corner = [&](double x, double y) {
            world::MeshVertex vertex;
            vertex.placeAt((normal + right * x + up * y) * half + Vec3(0.0, 0.0, half.z));
            vertex.normal = Vec3f(normal);
            vertex.uv = {static_cast<float>(x * 0.5 + 0.5), static_cast<float>(0.5 - y * 0.5)};
            vertex.polygon = static_cast<std::uint16_t>(side);
            mesh.indices[0].push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
            mesh.vertices.push_back(vertex);
        };
        for (const Vec2& at : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, -1), Vec2(1, 1), Vec2(-1, 1)})
            corner(at.x, at.y);
        mesh.polygonIds.push_back(static_cast<std::uint16_t>(side));
    }
    return mesh;
}

} // namespace limen::bench
