#pragma once

#include "world/Image.h"
#include "world/mesh/MeshData.h"

#include <cstdint>
#include <vector>

namespace limen::bench {

/// What a number drawn at random is for.
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

/// Random numbers, each a hash of what it is for and of whose it is: the same on every machine, in any order.
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

/// Numbers 0 .. count-1 in a random order.
[[nodiscard]] std::vector<std::uint32_t> shuffled(std::uint32_t count, const RandomGenerator& random);

/// An opaque picture of size x size texels, in colours and noise of its number's own.
[[nodiscard]] world::Image noisyPicture(std::uint32_t number, std::uint32_t size,
                                        const RandomGenerator& random);

/// A box that stands on z = 0 around the z axis, a polygon a side; half its width, depth and height in metres.
[[nodiscard]] world::MeshData boxMesh(const Vec3& half);

} // namespace limen::bench
