#include "visibility/Viewcone.h"

#include <limits>

// Loops of a fixed length over plain arrays: compilers make four or so at once of each.
namespace limen::visibility {

namespace {

constexpr std::size_t kCount = BallBlock::kCount;
using Values = std::array<float, kCount>;

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

/// Eye-relative.
struct Balls {
    Values x, y, z, slack, far; // not initialised: each is about to be
};

/// How far each reaches in.
Values reachOf(const Edges& edges, const Balls& balls) {
    Values reach; // of its own: compilers need not ask whether it lies in the same place as what is read
    for (std::size_t i = 0; i < kCount; ++i) {
        const float x = balls.x[i], y = balls.y[i], z = balls.z[i];
        const float a = edges.x[0] * x + edges.y[0] * y + edges.z[0] * z;
        const float b = edges.x[1] * x + edges.y[1] * y + edges.z[1] * z;
        const float c = edges.x[2] * x + edges.y[2] * y + edges.z[2] * z;
        const float d = edges.x[3] * x + edges.y[3] * y + edges.z[3] * z;
        const float ab = a < b ? a : b, cd = c < d ? c : d; // values, not references: no branches
        reach[i] = (ab < cd ? ab : cd) + balls.far[i];
    }
    return reach;
}

void lessen(Values& within, const Values& other) {
    for (std::size_t i = 0; i < kCount; ++i) {
        within[i] = other[i] < within[i] ? other[i] : within[i];
    }
}

bool isAnyNearer(const Values& within, const Values& slack) {
    int nearer = 0;
    for (std::size_t i = 0; i < kCount; ++i) {
        nearer += std::abs(within[i]) < slack[i] ? 1 : 0;
    }
    return nearer > 0;
}

} // namespace

Viewcones::Within Viewcones::within(const BallBlock& block, const Vec3& eye, const FourEdges* rect) const {
    Balls balls;
    const auto share = static_cast<float>(kSlackShare), pixels = static_cast<float>(2.0 * pixel_);
    for (std::size_t i = 0; i < kCount; ++i) {
        balls.x[i] = static_cast<float>(block.x[i] - eye.x);
        balls.y[i] = static_cast<float>(block.y[i] - eye.y);
        balls.z[i] = static_cast<float>(block.z[i] - eye.z);
        balls.far[i] = static_cast<float>(block.radius[i]);
    }
    for (std::size_t i = 0; i < kCount; ++i) {
        const float x = balls.x[i], y = balls.y[i], z = balls.z[i];
        const float distance = std::sqrt(x * x + y * y + z * z) + balls.far[i];
        balls.slack[i] = static_cast<float>(kSlack) + share * distance;
        balls.far[i] += balls.slack[i] + pixels * distance;
    }
    Values within;
    within.fill(std::numeric_limits<float>::infinity());
    for (std::uint32_t e = 0; e < cones_.front().edgesCount; ++e) {
        lessen(within, reachOf(Edges(edges_[e]), balls));
    }
    if (rect != nullptr) {
        lessen(within, reachOf(Edges(*rect), balls));
    }
    // Of a number that comes of a ball some fourteen roundings, each of 2^-24 of what is no more than its distance and reach, make less
    // than half of its slack.
    return isAnyNearer(within, balls.slack) ? withinOneByOne(block, eye, rect) : within;
}

Viewcones::Within Viewcones::withinOneByOne(const BallBlock& block, const Vec3& eye,
                                            const FourEdges* rect) const {
    Within within;
    for (std::size_t i = 0; i < kCount; ++i) {
        const SeenBall ball = ballOf({Vec3(block.x[i], block.y[i], block.z[i]) - eye, block.radius[i]});
        const bool isSeen = classifyOnScreen(cones_.front(), ball) != Containment::Outside &&
                            (rect == nullptr || classify(*rect, ball) != Containment::Outside);
        within[i] = isSeen ? 1.0f : -1.0f;
    }
    return within;
}

} // namespace limen::visibility
