#include "engine/places/WalkGrid.h"

#include "engine/ViewRequest.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace limen::engine {
namespace {

constexpr double kLow = 0.35, kHigh = 2.0; // metres above the ground between which a surface blocks
constexpr double kMargin = 0.75;           // metres from a surface to the middle of an open square
constexpr double kSteepest = 0.9;          // rise per metre between neighbouring squares
constexpr double kPiece = 0.7;             // metres, sides of the pieces that triangles are cut into
constexpr int kMostCuts = 14;              // halvings of a triangle
constexpr double kUnderFloor = 1.0;        // metres below the ground at which a room's floor still counts
constexpr double kReach = 3.0;             // metres that ends of a way are moved

/// Squares in eight directions.
constexpr int kSteps[8][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}};

} // namespace

WalkGrid::WalkGrid(Shapes& shapes, const BlockShape& block, const std::vector<FrontDoor>& doors)
    : origin_(originOf(block.coord)), ground_(std::size_t{kSide} * kSide),
      open_(std::size_t{kSide} * kSide, 1) {
    for (int x = 0; x < kSide; ++x)
        for (int y = 0; y < kSide; ++y)
            ground_[slot(x, y)] = static_cast<float>(shapes.ground(origin_.x + x + 0.5, origin_.y + y + 0.5));
    for (int x = 0; x < kSide; ++x) {
        for (int y = 0; y < kSide; ++y) {
            const float here = ground_[slot(x, y)];
            const float east = x + 1 < kSide ? ground_[slot(x + 1, y)] : here;
            const float north = y + 1 < kSide ? ground_[slot(x, y + 1)] : here;
            if (!(std::hypot(east - here, north - here) < kSteepest)) // false for NaN
                open_[slot(x, y)] = 0;
        }
    }
    for (const Obstacles::Group& group : block.solids.groups())
        for (const Triangle& triangle : group.triangles)
            close(triangle, 0);
    for (const FrontDoor& door : doors)
        if (const CellShape* cell = shapes.cell(door.cell))
            for (const Obstacles::Group& group : cell->solids.groups())
                for (const Triangle& triangle : group.triangles) {
                    Triangle raised = triangle; // a floor at ground level closes its squares
                    for (Vec3* corner : {&raised.a, &raised.b, &raised.c})
                        corner->z += kLow + kUnderFloor;
                    close(raised, 0);
                }
}

void WalkGrid::close(const Triangle& t, int depth) {
    const Vec3 low = glm::min(glm::min(t.a, t.b), t.c) - origin_;
    const Vec3 high = glm::max(glm::max(t.a, t.b), t.c) - origin_;
    if (!isFinite(low) || !isFinite(high) || high.x < -kMargin || high.y < -kMargin ||
        low.x > kSide + kMargin || low.y > kSide + kMargin)
        return;
    const Vec3 edges[3] = {t.b - t.a, t.c - t.b, t.a - t.c};
    int longest = 0;
    for (int i = 1; i < 3; ++i)
        longest = glm::length(edges[i]) > glm::length(edges[longest]) ? i : longest;
    if (glm::length(edges[longest]) > kPiece && depth < kMostCuts) {
        const Vec3 corners[3] = {t.a, t.b, t.c};
        const Vec3 &p = corners[longest], &q = corners[(longest + 1) % 3], &r = corners[(longest + 2) % 3];
        const Vec3 middle = (p + q) * 0.5;
        close({p, middle, r}, depth + 1);
        close({middle, q, r}, depth + 1);
        return;
    }
    for (int x = std::max(static_cast<int>(low.x - kMargin), 0); x <= std::min(high.x + kMargin, kSide - 1.0);
         ++x) {
        for (int y = std::max(static_cast<int>(low.y - kMargin), 0);
             y <= std::min(high.y + kMargin, kSide - 1.0); ++y) {
            const double ground = static_cast<double>(ground_[slot(x, y)]);
            const double dx = std::max({low.x - (x + 0.5), (x + 0.5) - high.x, 0.0});
            const double dy = std::max({low.y - (y + 0.5), (y + 0.5) - high.y, 0.0});
            if (high.z > ground + kLow && low.z < ground + kHigh && std::hypot(dx, dy) < kMargin)
                open_[slot(x, y)] = 0;
        }
    }
}

Vec3 WalkGrid::eyeAt(Square square) const {
    return origin_ + Vec3(square.x + 0.5, square.y + 0.5,
                          static_cast<double>(ground_[slot(square.x, square.y)]) + kEyeHeight);
}

std::optional<WalkGrid::Square> WalkGrid::squareNear(const Vec3& at, double metres) const {
    const Vec3 local = at - origin_;
    const int middleX = static_cast<int>(std::floor(local.x)),
              middleY = static_cast<int>(std::floor(local.y));
    const int reach = static_cast<int>(std::ceil(metres));
    std::optional<Square> best;
    double nearest = metres;
    for (int x = middleX - reach; x <= middleX + reach; ++x) {
        for (int y = middleY - reach; y <= middleY + reach; ++y) {
            const double distance = std::hypot(x + 0.5 - local.x, y + 0.5 - local.y);
            if (isOpen(x, y) && distance < nearest) {
                nearest = distance;
                best = Square{x, y};
            }
        }
    }
    return best;
}

std::optional<Vec3> WalkGrid::openNear(const Vec3& at, double metres) const {
    const std::optional<Square> square = squareNear(at, metres);
    return square ? std::optional(eyeAt(*square)) : std::nullopt;
}

bool WalkGrid::isClear(Square from, Square to) const {
    const int steps = 2 * std::max({std::abs(to.x - from.x), std::abs(to.y - from.y), 1});
    const Vec3 a = eyeAt(from), b = eyeAt(to);
    for (int i = 0; i <= steps; ++i) {
        const double share = static_cast<double>(i) / steps;
        const double x = from.x + 0.5 + (to.x - from.x) * share, y = from.y + 0.5 + (to.y - from.y) * share;
        if (!isOpen(static_cast<int>(x), static_cast<int>(y)))
            return false;
        // The straight line stays near the height of a walking eye.
        const double ground = static_cast<double>(ground_[slot(static_cast<int>(x), static_cast<int>(y))]);
        if (std::abs(a.z + (b.z - a.z) * share - ground - kEyeHeight) > 0.5)
            return false;
    }
    return true;
}

std::vector<Vec3> WalkGrid::way(const Vec3& from, const Vec3& to) const {
    const std::optional<Square> start = squareNear(from, kReach), end = squareNear(to, kReach);
    if (!start || !end)
        return {};
    // A*, with the straight distance as the estimate.
    constexpr float kFar = std::numeric_limits<float>::infinity();
    std::vector<float> cost(open_.size(), kFar);
    std::vector<std::uint8_t> cameBy(open_.size(), 0);
    struct Open {
        float estimate;
        std::uint32_t slot;
        bool operator<(const Open& other) const {
            return estimate != other.estimate ? estimate > other.estimate : slot > other.slot;
        }
    };
    std::priority_queue<Open> queue;
    const auto push = [&](int x, int y, float soFar) {
        const float rest = std::hypot(static_cast<float>(end->x - x), static_cast<float>(end->y - y));
        queue.push({soFar + rest, static_cast<std::uint32_t>(slot(x, y))});
    };
    cost[slot(start->x, start->y)] = 0.0f;
    push(start->x, start->y, 0.0f);
    const std::size_t goal = slot(end->x, end->y);
    while (!queue.empty() && queue.top().slot != goal) {
        const int x = static_cast<int>(queue.top().slot / kSide),
                  y = static_cast<int>(queue.top().slot % kSide);
        queue.pop();
        for (std::uint8_t i = 0; i < 8; ++i) {
            const int nextX = x + kSteps[i][0], nextY = y + kSteps[i][1];
            if (!isOpen(nextX, nextY) || !isOpen(x, nextY) || !isOpen(nextX, y))
                continue;
            const float through = cost[slot(x, y)] + (i < 4 ? 1.0f : 1.41421356f);
            if (through < cost[slot(nextX, nextY)] - 1e-4f) {
                cost[slot(nextX, nextY)] = through;
                cameBy[slot(nextX, nextY)] = i;
                push(nextX, nextY, through);
            }
        }
    }
    if (!(cost[goal] < kFar))
        return {};
    std::vector<Square> squares{*end};
    for (Square at = *end; at.x != start->x || at.y != start->y;) {
        const std::uint8_t by = cameBy[slot(at.x, at.y)];
        at = {at.x - kSteps[by][0], at.y - kSteps[by][1]};
        squares.push_back(at);
    }
    std::reverse(squares.begin(), squares.end());
    // Keep the corners: from each kept square the last one that a clear straight line leads to.
    std::vector<Vec3> eyes;
    for (std::size_t i = 0; i + 1 < squares.size();) {
        std::size_t next = i + 1;
        for (std::size_t far = std::min(i + 40, squares.size() - 1); far > next; --far)
            if (isClear(squares[i], squares[far]))
                next = far;
        eyes.push_back(eyeAt(squares[next]));
        i = next;
    }
    if (eyes.empty())
        eyes.push_back(eyeAt(*end));
    return eyes;
}

} // namespace limen::engine
