#include "visibility/Viewcone.h"

#include <bit>
#include <limits>
#ifdef __x86_64__
#include <immintrin.h>
#endif

// Loops of a fixed length over plain arrays, which compilers turn into vector instructions of the set that
// the calling function is compiled for. Outputs are arrays of their own, so that compilers can exclude
// aliasing, and are not initialised if every element is assigned.
namespace limen::visibility {

namespace {

template <std::size_t Count>
using Values = std::array<float, Count>;

/// The planes to test spheres against, and the tolerances.
struct BatchTest {
    float tolerance, toleranceShare, pixels; ///< as in Viewcones::sphereOf; pixels: radians
    const FourEdges* edges;                  ///< of the root's region
    std::uint32_t edgesCount;
    const FourEdges* rect; ///< null: none
};

/// Output of listWithin.
struct Listing {
    std::uint32_t first, count; ///< count: at least 1
    std::uint32_t* out;
};

/// SeenSpheres; `far` is the radius and the edge tolerance.
template <std::size_t Count>
struct Spheres {
    Values<Count> x, y, z, tolerance, far;
};

/// `Block`: SphereQuad or SphereBatch. `eye`: relative to the block's origin.
template <class Block, class Coordinate, std::size_t Count>
[[gnu::always_inline]] inline void readSpheres(const BatchTest& test, const Block& block,
                                               const std::array<Coordinate, 3>& eye,
                                               Spheres<Count>& spheres) {
    for (std::size_t i = 0; i < Count; ++i) {
        spheres.x[i] = static_cast<float>(block.x[i] - eye[0]);
        spheres.y[i] = static_cast<float>(block.y[i] - eye[1]);
        spheres.z[i] = static_cast<float>(block.z[i] - eye[2]);
    }
    // Values are loaded one by one. A copy of a whole array would be stored in pieces narrower than the
    // vector loads that follow, which would then stall.
    for (std::size_t i = 0; i < Count; ++i) {
        const float x = spheres.x[i], y = spheres.y[i], z = spheres.z[i];
        const float radius = static_cast<float>(block.radius[i]);
        const float distance = std::sqrt(x * x + y * y + z * z) + radius;
        const float tolerance = test.tolerance + test.toleranceShare * distance;
        spheres.tolerance[i] = tolerance;
        spheres.far[i] = radius + (tolerance + test.pixels * distance);
    }
}

/// Lowers `least` to the least of each centre's signed distances to four planes.
template <std::size_t Count>
[[gnu::always_inline]] inline void lowerToLeast(Values<Count>& least, const FourEdges::Floats& edges,
                                                const Spheres<Count>& spheres) {
    for (std::size_t i = 0; i < Count; ++i) {
        const float x = spheres.x[i], y = spheres.y[i], z = spheres.z[i];
        const float a = edges.x[0] * x + edges.y[0] * y + edges.z[0] * z;
        const float b = edges.x[1] * x + edges.y[1] * y + edges.z[1] * z;
        const float c = edges.x[2] * x + edges.y[2] * y + edges.z[2] * z;
        const float d = edges.x[3] * x + edges.y[3] * y + edges.z[3] * z;
        const float ab = a < b ? a : b, cd = c < d ? c : d; // values, not references: no branches
        const float all = ab < cd ? ab : cd;
        least[i] = all < least[i] ? all : least[i];
    }
}

template <std::size_t Count>
[[gnu::always_inline]] inline void leastOf(const BatchTest& test, const Spheres<Count>& spheres,
                                           Values<Count>& least) {
    for (std::size_t i = 0; i < Count; ++i)
        least[i] = std::numeric_limits<float>::infinity();
    for (std::uint32_t e = 0; e < test.edgesCount; ++e)
        lowerToLeast(least, test.edges[e].floats(), spheres);
    if (test.rect != nullptr)
        lowerToLeast(least, test.rect->floats(), spheres);
}

/// Number of values that are nearer to 0 than the tolerance: float precision does not decide their sign.
///
/// The tolerance covers the float error. A value has about fourteen roundings, each of 2^-24 of at most the
/// sphere's distance and radius: less than half the tolerance. The coordinates of a SphereBatch are rounded
/// by 0.2 mm along each axis for the sphere and as much for the eye, at most 0.7 mm in all; the other half of
/// the tolerance is at least 2 mm.
template <std::size_t Count>
[[gnu::always_inline]] inline int countUndecided(const Values<Count>& values,
                                                 const Values<Count>& tolerance) {
    int undecided = 0;
    for (std::size_t i = 0; i < Count; ++i)
        undecided += std::abs(values[i]) < tolerance[i] ? 1 : 0;
    return undecided;
}

/// A bit for each sphere of a batch.
using Bits = std::uint32_t;

/// A sphere is outside if `within` is negative, and undecided if `doubt` is positive.
template <std::size_t Count>
struct Sides {
    Values<Count> within, doubt;
};

/// Tests `Count` spheres of a batch from `at` on. With as many as a vector has, all values stay in registers.
template <std::size_t Count>
[[gnu::always_inline]] inline void findSides(const BatchTest& test, const SphereBatch& block, std::size_t at,
                                             const std::array<float, 3>& eye, Sides<Count>& sides) {
    Spheres<Count> spheres;
    Values<Count> least;
    readSpheres(test, SphereBatch{block.x + at, block.y + at, block.z + at, block.radius + at}, eye, spheres);
    leastOf(test, spheres, least);
    for (std::size_t i = 0; i < Count; ++i) {
        const float within = least[i] + spheres.far[i];
        sides.within[i] = within;
        sides.doubt[i] = spheres.tolerance[i] - std::abs(within);
    }
}

Bits bitsOfCount(const Listing& listing) {
    return ~Bits{0} >> (32 - listing.count);
}

std::uint32_t listByAny(const BatchTest& test, const SphereBatch& block, const std::array<float, 3>& eye,
                        const Listing& listing) {
    Sides<SphereBatch::kCount> sides;
    findSides(test, block, 0, eye, sides);
    int undecided = 0;
    for (std::uint32_t i = 0; i < SphereBatch::kCount; ++i)
        undecided += sides.doubt[i] > 0.0f && i < listing.count ? 1 : 0;
    // Every number is written; only the count depends on the result. A branch here would be unpredictable.
    std::uint32_t found = 0;
    for (std::uint32_t i = 0; i < listing.count; ++i) {
        listing.out[found] = listing.first + i;
        found += static_cast<std::uint32_t>(sides.within[i] >= 0.0f);
    }
    return undecided > 0 ? Viewcones::kUndecided : found;
}

#ifdef __x86_64__
/// By a value of eight bits: the numbers of the set bits, in order, a byte each; the rest is 0.
constexpr std::array<std::uint64_t, 256> numbersOfBits() {
    std::array<std::uint64_t, 256> numbers{};
    for (std::size_t bits = 0; bits < numbers.size(); ++bits) {
        std::uint64_t found = 0;
        for (std::uint64_t i = 0; i < 8; ++i)
            if ((bits >> i & 1) != 0)
                numbers[bits] |= i << 8 * found++;
    }
    return numbers;
}
constexpr std::array<std::uint64_t, 256> kNumbersOfBits = numbersOfBits();

[[gnu::target("avx2,popcnt")]] std::uint32_t listByAvx2(const BatchTest& test, const SphereBatch& block,
                                                        const std::array<float, 3>& eye,
                                                        const Listing& listing) {
    constexpr std::uint32_t kLanes = 8;
    Bits undecided = 0, outside = 0;
    for (std::uint32_t at = 0; at < SphereBatch::kCount; at += kLanes) {
        Sides<kLanes> sides;
        findSides(test, block, at, eye, sides);
        const __m256 isUndecided =
            _mm256_cmp_ps(_mm256_loadu_ps(sides.doubt.data()), _mm256_setzero_ps(), _CMP_GT_OQ);
        undecided |= static_cast<Bits>(_mm256_movemask_ps(isUndecided)) << at;
        // The signs suffice: no decided value is near 0.
        outside |= static_cast<Bits>(_mm256_movemask_ps(_mm256_loadu_ps(sides.within.data()))) << at;
    }
    const Bits listed = bitsOfCount(listing);
    if ((undecided & listed) != 0)
        return Viewcones::kUndecided;
    const Bits inside = ~outside & listed;
    std::uint32_t found = 0;
    for (std::uint32_t at = 0; at < SphereBatch::kCount; at += kLanes) {
        const Bits bits = inside >> at & 0xFF;
        const __m256i first = _mm256_set1_epi32(static_cast<int>(listing.first + at));
        const __m128i numbers = _mm_cvtsi64_si128(static_cast<long long>(kNumbersOfBits[bits]));
        _mm256_storeu_si256(reinterpret_cast<__m256i*>(listing.out + found),
                            _mm256_add_epi32(first, _mm256_cvtepu8_epi32(numbers)));
        found += static_cast<std::uint32_t>(std::popcount(bits));
    }
    return found;
}

[[gnu::target("avx512f,avx512vl,avx512dq,popcnt")]] std::uint32_t
listByAvx512(const BatchTest& test, const SphereBatch& block, const std::array<float, 3>& eye,
             const Listing& listing) {
    Sides<SphereBatch::kCount> sides;
    findSides(test, block, 0, eye, sides);
    const auto listed = static_cast<__mmask16>(bitsOfCount(listing));
    const __m512 within = _mm512_loadu_ps(sides.within.data());
    if (_mm512_mask_cmp_ps_mask(listed, _mm512_loadu_ps(sides.doubt.data()), _mm512_setzero_ps(),
                                _CMP_GT_OQ) != 0)
        return Viewcones::kUndecided;
    const __mmask16 inside = _mm512_mask_cmp_ps_mask(listed, within, _mm512_setzero_ps(), _CMP_GE_OQ);
    const __m512i numbers =
        _mm512_add_epi32(_mm512_set1_epi32(static_cast<int>(listing.first)),
                         _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15));
    _mm512_storeu_si512(listing.out, _mm512_maskz_compress_epi32(inside, numbers));
    return static_cast<std::uint32_t>(std::popcount(static_cast<Bits>(inside)));
}
#endif

} // namespace

Vectors widestVectors() {
#ifdef __x86_64__
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
        __builtin_cpu_supports("avx512dq"))
        return Vectors::Avx512;
    if (__builtin_cpu_supports("avx2"))
        return Vectors::Avx2;
#endif
    return Vectors::Any;
}

std::uint32_t Viewcones::listWithin(const SphereBatch& block, const Vec3& eye, const FourEdges* rect,
                                    std::uint32_t first, std::uint32_t count, std::uint32_t* out) const {
    const BatchTest test{static_cast<float>(kTolerance),   static_cast<float>(kToleranceShare),
                         static_cast<float>(2.0 * pixel_), edges_.data() + cones_.front().firstEdges,
                         cones_.front().edgesCount,        rect};
    const std::array<float, 3> from{static_cast<float>(eye.x), static_cast<float>(eye.y),
                                    static_cast<float>(eye.z)};
    const Listing listing{first, count, out};
    switch (vectors_) {
#ifdef __x86_64__
    case Vectors::Avx512:
        return listByAvx512(test, block, from, listing);
    case Vectors::Avx2:
        return listByAvx2(test, block, from, listing);
#endif
    default:
        return listByAny(test, block, from, listing);
    }
}

Viewcones::QuadContainment Viewcones::classifyQuad(const SphereQuad& block, const Vec3& eye) const {
    constexpr std::size_t kCount = SphereQuad::kCount;
    const BatchTest test{static_cast<float>(kTolerance),   static_cast<float>(kToleranceShare),
                         static_cast<float>(2.0 * pixel_), edges_.data() + cones_.front().firstEdges,
                         cones_.front().edgesCount,        nullptr};
    Spheres<kCount> spheres;
    Values<kCount> least, within, beyond;
    readSpheres(test, block, std::array{eye.x, eye.y, eye.z}, spheres);
    leastOf(test, spheres, least);
    for (std::size_t i = 0; i < SphereQuad::kCount; ++i) {
        within[i] = least[i] + spheres.far[i];
        beyond[i] = least[i] - spheres.far[i];
    }
    if (countUndecided(within, spheres.tolerance) + countUndecided(beyond, spheres.tolerance) > 0)
        return classifyOneByOne(block, eye);
    QuadContainment found;
    for (std::size_t i = 0; i < SphereQuad::kCount; ++i)
        found[i] = static_cast<Containment>((within[i] >= 0.0f ? 1 : 0) + (beyond[i] > 0.0f ? 1 : 0));
    return found;
}

Viewcones::QuadContainment Viewcones::classifyOneByOne(const SphereQuad& block, const Vec3& eye) const {
    QuadContainment found;
    for (std::size_t i = 0; i < SphereQuad::kCount; ++i) {
        const SeenSphere sphere = sphereOf({Vec3(block.x[i], block.y[i], block.z[i]) - eye, block.radius[i]});
        found[i] = classifyOnScreen(cones_.front(), sphere);
    }
    return found;
}

} // namespace limen::visibility
