#include "visibility/Viewcone.h"

#include <bit>
#include <limits>
#ifdef __x86_64__
#include <immintrin.h>
#endif

// Loops of a fixed length over plain arrays: compilers make vectors of them, as wide as the function that they are put into is told
// that it may have. Arrays are of their own wherever something is written, so that compilers need not ask whether it lies in the same
// place as what is read, and not initialised where each is about to be.
namespace limen::visibility {

namespace {

template <std::size_t Count>
using Values = std::array<float, Count>;

/// What balls are asked.
struct Question {
    float slack, slackShare, pixels; ///< as SeenSphere's slack and reach are made
    const FourEdges* edges;          ///< of the root's region
    std::uint32_t edgesCount;
    const FourEdges* rect; ///< null: none
};

/// Where those that are found are listed.
struct Listing {
    std::uint32_t first, count; ///< of the block, at least one
    std::uint32_t* out;
};

/// Of SeenSphere; `far` is the radius and the reach.
template <std::size_t Count>
struct Spheres {
    Values<Count> x, y, z, slack, far;
};

/// `Block`: FewSpheres or SphereBatch. `eye`: from where the balls are told from.
template <class Block, class Coordinate, std::size_t Count>
[[gnu::always_inline]] inline void readSpheres(const Question& asked, const Block& block,
                                               const std::array<Coordinate, 3>& eye,
                                               Spheres<Count>& spheres) {
    for (std::size_t i = 0; i < Count; ++i) {
        spheres.x[i] = static_cast<float>(block.x[i] - eye[0]);
        spheres.y[i] = static_cast<float>(block.y[i] - eye[1]);
        spheres.z[i] = static_cast<float>(block.z[i] - eye[2]);
    }
    // No array is copied as it is: that is done in other pieces than vectors, which then wait for it.
    for (std::size_t i = 0; i < Count; ++i) {
        const float x = spheres.x[i], y = spheres.y[i], z = spheres.z[i];
        const float radius = static_cast<float>(block.radius[i]);
        const float distance = std::sqrt(x * x + y * y + z * z) + radius;
        const float slack = asked.slack + asked.slackShare * distance;
        spheres.slack[i] = slack;
        spheres.far[i] = radius + (slack + asked.pixels * distance);
    }
}

/// From each centre to the plane that it lies farthest outside of, or least far inside: what is less than it was.
template <std::size_t Count>
[[gnu::always_inline]] inline void lessen(Values<Count>& least, const FourEdges::Floats& edges,
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
[[gnu::always_inline]] inline void leastOf(const Question& asked, const Spheres<Count>& spheres,
                                           Values<Count>& least) {
    for (std::size_t i = 0; i < Count; ++i)
        least[i] = std::numeric_limits<float>::infinity();
    for (std::uint32_t e = 0; e < asked.edgesCount; ++e)
        lessen(least, asked.edges[e].floats(), spheres);
    if (asked.rect != nullptr)
        lessen(least, asked.rect->floats(), spheres);
}

/// Of a number that comes of a ball some fourteen roundings, each of 2^-24 of what is no more than its distance and reach, make less
/// than half of its slack. What a SphereBatch rounds before makes 0.2 mm along each axis for the ball and as much for the eye: no more than 0.7 mm,
/// of the other half, 2 mm and more. What is nearer to 0 than its slack floats cannot tell from it.
template <std::size_t Count>
[[gnu::always_inline]] inline int countDoubtful(const Values<Count>& values, const Values<Count>& slack) {
    int doubtful = 0;
    for (std::size_t i = 0; i < Count; ++i)
        doubtful += std::abs(values[i]) < slack[i] ? 1 : 0;
    return doubtful;
}

/// A bit for each ball of a block.
using Bits = std::uint32_t;

/// How balls lie: one is within unless that is below 0, and floats cannot tell of one if its doubt is above 0.
template <std::size_t Count>
struct Sides {
    Values<Count> within, doubt;
};

/// Of so many of a block, from one on. As many as a vector has, so that nothing need be put down in between.
template <std::size_t Count>
[[gnu::always_inline]] inline void tellSides(const Question& asked, const SphereBatch& block, std::size_t at,
                                             const std::array<float, 3>& eye, Sides<Count>& sides) {
    Spheres<Count> spheres;
    Values<Count> least;
    readSpheres(asked, SphereBatch{block.x + at, block.y + at, block.z + at, block.radius + at}, eye,
                spheres);
    leastOf(asked, spheres, least);
    for (std::size_t i = 0; i < Count; ++i) {
        const float within = least[i] + spheres.far[i];
        sides.within[i] = within;
        sides.doubt[i] = spheres.slack[i] - std::abs(within);
    }
}

Bits bitsOfThoseListed(const Listing& listing) {
    return ~Bits{0} >> (32 - listing.count);
}

std::uint32_t listByAny(const Question& asked, const SphereBatch& block, const std::array<float, 3>& eye,
                        const Listing& listing) {
    Sides<SphereBatch::kCount> sides;
    tellSides(asked, block, 0, eye, sides);
    int doubtful = 0;
    for (std::uint32_t i = 0; i < SphereBatch::kCount; ++i)
        doubtful += sides.doubt[i] > 0.0f && i < listing.count ? 1 : 0;
    // What is found is written either way, and counts or does not: nobody can foretell.
    std::uint32_t found = 0;
    for (std::uint32_t i = 0; i < listing.count; ++i) {
        listing.out[found] = listing.first + i;
        found += static_cast<std::uint32_t>(sides.within[i] >= 0.0f);
    }
    return doubtful > 0 ? Viewcones::kCannotTell : found;
}

#ifdef __x86_64__
/// By eight bits: the numbers of those that are set, in order, a byte each; what follows them does not count.
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

[[gnu::target("avx2,popcnt")]] std::uint32_t listByAvx2(const Question& asked, const SphereBatch& block,
                                                        const std::array<float, 3>& eye,
                                                        const Listing& listing) {
    constexpr std::uint32_t kLanes = 8;
    Bits doubtful = 0, outside = 0;
    for (std::uint32_t at = 0; at < SphereBatch::kCount; at += kLanes) {
        Sides<kLanes> sides;
        tellSides(asked, block, at, eye, sides);
        const __m256 isDoubtful =
            _mm256_cmp_ps(_mm256_loadu_ps(sides.doubt.data()), _mm256_setzero_ps(), _CMP_GT_OQ);
        doubtful |= static_cast<Bits>(_mm256_movemask_ps(isDoubtful)) << at;
        // The signs: none of these is nearly 0.
        outside |= static_cast<Bits>(_mm256_movemask_ps(_mm256_loadu_ps(sides.within.data()))) << at;
    }
    const Bits listed = bitsOfThoseListed(listing);
    if ((doubtful & listed) != 0)
        return Viewcones::kCannotTell;
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
listByAvx512(const Question& asked, const SphereBatch& block, const std::array<float, 3>& eye,
             const Listing& listing) {
    Sides<SphereBatch::kCount> sides;
    tellSides(asked, block, 0, eye, sides);
    const auto listed = static_cast<__mmask16>(bitsOfThoseListed(listing));
    const __m512 within = _mm512_loadu_ps(sides.within.data());
    if (_mm512_mask_cmp_ps_mask(listed, _mm512_loadu_ps(sides.doubt.data()), _mm512_setzero_ps(),
                                _CMP_GT_OQ) != 0)
        return Viewcones::kCannotTell;
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
    const Question asked{static_cast<float>(kSlack),       static_cast<float>(kSlackShare),
                         static_cast<float>(2.0 * pixel_), edges_.data() + cones_.front().firstEdges,
                         cones_.front().edgesCount,        rect};
    const std::array<float, 3> from{static_cast<float>(eye.x), static_cast<float>(eye.y),
                                    static_cast<float>(eye.z)};
    const Listing listing{first, count, out};
    switch (vectors_) {
#ifdef __x86_64__
    case Vectors::Avx512:
        return listByAvx512(asked, block, from, listing);
    case Vectors::Avx2:
        return listByAvx2(asked, block, from, listing);
#endif
    default:
        return listByAny(asked, block, from, listing);
    }
}

std::array<Containment, Viewcones::kFew> Viewcones::classifyFew(const FewSpheres& block,
                                                                const Vec3& eye) const {
    const Question asked{static_cast<float>(kSlack),       static_cast<float>(kSlackShare),
                         static_cast<float>(2.0 * pixel_), edges_.data() + cones_.front().firstEdges,
                         cones_.front().edgesCount,        nullptr};
    Spheres<kFew> spheres;
    Values<kFew> least, within, beyond;
    readSpheres(asked, block, std::array{eye.x, eye.y, eye.z}, spheres);
    leastOf(asked, spheres, least);
    for (std::size_t i = 0; i < kFew; ++i) {
        within[i] = least[i] + spheres.far[i];
        beyond[i] = least[i] - spheres.far[i];
    }
    if (countDoubtful(within, spheres.slack) + countDoubtful(beyond, spheres.slack) > 0)
        return classifyOneByOne(block, eye);
    std::array<Containment, kFew> found;
    for (std::size_t i = 0; i < kFew; ++i)
        found[i] = static_cast<Containment>((within[i] >= 0.0f ? 1 : 0) + (beyond[i] > 0.0f ? 1 : 0));
    return found;
}

std::array<Containment, Viewcones::kFew> Viewcones::classifyOneByOne(const FewSpheres& block,
                                                                     const Vec3& eye) const {
    std::array<Containment, kFew> found;
    for (std::size_t i = 0; i < kFew; ++i) {
        const SeenSphere sphere = sphereOf({Vec3(block.x[i], block.y[i], block.z[i]) - eye, block.radius[i]});
        found[i] = classifyOnScreen(cones_.front(), sphere);
    }
    return found;
}

} // namespace limen::visibility
