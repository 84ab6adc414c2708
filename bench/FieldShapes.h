#pragma once

#include "world/Image.h"
#include "world/mesh/MeshData.h"

#include <cstdint>
#include <vector>

namespace limen::bench {

/// The purposes of random numbers.
enum class Draw : std::uint32_t {
    Width,
    Depth,
    Height,
    Material,
    Group,
    Moves,
    East,
    North,
    Turn,
    Place,
    Texel
};

/// Random numbers as hashes of the seed, a purpose, and the number of an object. They are equal on all
/// machines, and do not depend on the order of the calls.
class RandomGenerator {
public:
    explicit RandomGenerator(std::uint32_t seed) : seed_(seed) {}
    [[nodiscard]] double between(double low, double high, Draw draw, std::uint32_t number) const {
        return low + (high - low) * fraction(draw, number);
    }
    [[nodiscard]] std::uint32_t below(std::uint32_t count, Draw draw, std::uint32_t number) const {
        return static_cast<std::uint32_t>(fraction(draw, number) * count);
    }
    /// In [0, 1).
    [[nodiscard]] double fraction(Draw draw, std::uint32_t number) const;

private:
    std::uint32_t seed_;
};

/// The numbers 0 .. count-1 in random order.
[[nodiscard]] std::vector<std::uint32_t> shuffled(std::uint32_t count, const RandomGenerator& random);

/// An opaque picture of size x size texels. Its number determines its colours and noise.
[[nodiscard]] world::Image noisyPicture(std::uint32_t number, std::uint32_t size,
                                        const RandomGenerator& random);

/// A box around the z axis that stands on z = 0, one polygon a side. `half`: half of width, depth and height,
/// in metres.
[[nodiscard]] world::MeshData boxMesh(const Vec3& half);

} // namespace limen::bench
