#include "visibility/Viewcone.h"

#include <limits>

// Loops of a fixed length over plain arrays: compilers make four of each at once. Arrays are of their own wherever something is
// written, so that compilers need not ask whether it lies in the same place as what is read, and not initialised where each is about to be.
namespace limen::visibility {

namespace {

template <std::size_t Count>
using Values = std::array<float, Count>;

/// Four planes, in floats.
struct Edges {
    std::array<float, 4> x{}, y{}, z{};
    explicit Edges(const FourEdges& edges) {
        for (std::size_t i = 0; i < 4; ++i) {
            const Vec3f edge(edges.edge(i));
            x[i] = edge.x;
            y[i] = edge.y;
            z[i] = edge.z;
        }
    }
};

/// Of SeenBall; `far` is the radius and the reach.
template <std::size_t Count>
struct Balls {
    Values<Count> x, y, z, slack, far;
};

template <std::size_t Count>
Balls<Count> ballsOf(const BallBlock& block, const Vec3& eye, float slack, float slackShare, float pixels) {
    Balls<Count> balls;
    for (std::size_t i = 0; i < Count; ++i) {
        balls.x[i] = static_cast<float>(block.x[i] - eye.x);
        balls.y[i] = static_cast<float>(block.y[i] - eye.y);
        balls.z[i] = static_cast<float>(block.z[i] - eye.z);
        balls.far[i] = static_cast<float>(block.radius[i]);
    }
    for (std::size_t i = 0; i < Count; ++i) {
        const float x = balls.x[i], y = balls.y[i], z = balls.z[i];
        const float distance = std::sqrt(x * x + y * y + z * z) + balls.far[i];
        balls.slack[i] = slack + slackShare * distance;
        balls.far[i] += balls.slack[i] + pixels * distance;
    }
    return balls;
}

/// From each centre to the plane that it lies farthest outside of, or least far inside.
template <std::size_t Count>
Values<Count> leastOf(const Edges& edges, const Balls<Count>& balls) {
    Values<Count> least;
    for (std::size_t i = 0; i < Count; ++i) {
        const float x = balls.x[i], y = balls.y[i], z = balls.z[i];
        const float a = edges.x[0] * x + edges.y[0] * y + edges.z[0] * z;
        const float b = edges.x[1] * x + edges.y[1] * y + edges.z[1] * z;
        const float c = edges.x[2] * x + edges.y[2] * y + edges.z[2] * z;
        const float d = edges.x[3] * x + edges.y[3] * y + edges.z[3] * z;
        const float ab = a < b ? a : b, cd = c < d ? c : d; // values, not references: no branches
        least[i] = ab < cd ? ab : cd;
    }
    return least;
}

template <std::size_t Count>
void lessen(Values<Count>& least, const Values<Count>& other) {
    for (std::size_t i = 0; i < Count; ++i) {
        least[i] = other[i] < least[i] ? other[i] : least[i];
    }
}

template <std::size_t Count>
Values<Count> sumOf(const Values<Count>& a, const Values<Count>& b) {
    Values<Count> sum;
    for (std::size_t i = 0; i < Count; ++i) {
        sum[i] = a[i] + b[i];
    }
    return sum;
}

/// Of a number that comes of a ball some fourteen roundings, each of 2^-24 of what is no more than its distance and reach, make less
/// than half of its slack. What is that near to 0 floats cannot tell from it.
template <std::size_t Count>
bool isAnyDoubtful(const Values<Count>& values, const Values<Count>& slack) {
    int doubtful = 0;
    for (std::size_t i = 0; i < Count; ++i) {
        doubtful += std::abs(values[i]) < slack[i] ? 1 : 0;
    }
    return doubtful > 0;
}

} // namespace

Viewcones::Within Viewcones::within(const BallBlock& block, const Vec3& eye, const FourEdges* rect) const {
    constexpr std::size_t kCount = BallBlock::kCount;
    const auto balls = ballsOf<kCount>(block, eye, static_cast<float>(kSlack),
                                       static_cast<float>(kSlackShare), static_cast<float>(2.0 * pixel_));
    Values<kCount> least;
    least.fill(std::numeric_limits<float>::infinity());
    for (std::uint32_t e = 0; e < cones_.front().edgesCount; ++e) {
        lessen(least, leastOf(Edges(edges_[e]), balls));
    }
    if (rect != nullptr) {
        lessen(least, leastOf(Edges(*rect), balls));
    }
    const Values<kCount> within = sumOf(least, balls.far);
    return isAnyDoubtful(within, balls.slack) ? withinOneByOne(block, eye, rect) : within;
}

Viewcones::Within Viewcones::withinOneByOne(const BallBlock& block, const Vec3& eye,
                                            const FourEdges* rect) const {
    Within within;
    for (std::size_t i = 0; i < BallBlock::kCount; ++i) {
        const SeenBall ball = ballOf({Vec3(block.x[i], block.y[i], block.z[i]) - eye, block.radius[i]});
        const bool isSeen = classifyOnScreen(cones_.front(), ball) != Containment::Outside &&
                            (rect == nullptr || classify(*rect, ball) != Containment::Outside);
        within[i] = isSeen ? 1.0f : -1.0f;
    }
    return within;
}

std::array<Containment, Viewcones::kFew> Viewcones::classifyFew(const BallBlock& block,
                                                                const Vec3& eye) const {
    const auto balls = ballsOf<kFew>(block, eye, static_cast<float>(kSlack), static_cast<float>(kSlackShare),
                                     static_cast<float>(2.0 * pixel_));
    Values<kFew> least;
    least.fill(std::numeric_limits<float>::infinity());
    for (std::uint32_t e = 0; e < cones_.front().edgesCount; ++e) {
        lessen(least, leastOf(Edges(edges_[e]), balls));
    }
    Values<kFew> beyond;
    for (std::size_t i = 0; i < kFew; ++i) {
        beyond[i] = least[i] - balls.far[i];
    }
    const Values<kFew> within = sumOf(least, balls.far);
    if (isAnyDoubtful(within, balls.slack) || isAnyDoubtful(beyond, balls.slack)) {
        return classifyOneByOne(block, eye);
    }
    std::array<Containment, kFew> found;
    for (std::size_t i = 0; i < kFew; ++i) {
        found[i] = static_cast<Containment>((within[i] >= 0.0f ? 1 : 0) + (beyond[i] > 0.0f ? 1 : 0));
    }
    return found;
}

std::array<Containment, Viewcones::kFew> Viewcones::classifyOneByOne(const BallBlock& block,
                                                                     const Vec3& eye) const {
    std::array<Containment, kFew> found;
    for (std::size_t i = 0; i < kFew; ++i) {
        const SeenBall ball = ballOf({Vec3(block.x[i], block.y[i], block.z[i]) - eye, block.radius[i]});
        found[i] = classifyOnScreen(cones_.front(), ball);
    }
    return found;
}

} // namespace limen::visibility
