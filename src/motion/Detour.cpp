#include "motion/Detour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <queue>

namespace limen::motion {
namespace {

constexpr double kFarthestWay = 8.0; // metres from the body
constexpr double kLastSteps = 0.4;   // metres to go from which the straight way is tried
constexpr double kSameFloor = 1.0;   // metres: squares above one another are different ones
constexpr double kBlockedBy = 0.04;  // metres: a body that ends farther from a square's middle was blocked
constexpr double kGreed = 1.3;       // of the distance to go: fewer squares, ways up to 1.3 times as long
constexpr std::size_t kMostLeft = 2'000; // squares that are left
constexpr std::size_t kNoNode = ~std::size_t{0};

struct Square {
    int x, y, storey;
    friend auto operator<=>(const Square&, const Square&) = default;
};
struct DetourNode {
    Square square{};
    BodyState body;
    double metres = 0.0; ///< walked
    std::size_t before = kNoNode;
    bool isLeft = false;
};

double levelMetres(const Vec3& a, const Vec3& b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

class DetourSearch {
public:
    DetourSearch(const BodyState& body, const Vec3& to, double square, const Collisions& around,
                 std::span<const double> doors, const BodyShape& shape)
        : square_(square), origin_(body.standing.feet), to_(to), around_(around), doors_(doors),
          shape_(shape) {
        nodes_.push_back({squareAt(origin_), body, 0.0, kNoNode, false});
        slots_[nodes_[0].square] = 0;
        queue(0);
    }

    [[nodiscard]] Detour run() {
        std::size_t nearest = 0;
        for (std::size_t left = 0; !open_.empty() && left < kMostLeft; ++left) {
            const std::size_t next = open_.top().second;
            open_.pop();
            if (std::exchange(nodes_[next].isLeft, true))
                continue;
            if (toGo(next) < toGo(nearest))
                nearest = next;
            if (toGo(next) < kLastSteps && reachesPoint(next)) {
                Detour found{cornersTo(next), true};
                found.corners.push_back(to_);
                return found;
            }
            leave(next);
        }
        return {cornersTo(nearest), false};
    }

private:
    [[nodiscard]] Square squareAt(const Vec3& feet) const {
        return {static_cast<int>(std::lround((feet.x - origin_.x) / square_)),
                static_cast<int>(std::lround((feet.y - origin_.y) / square_)),
                static_cast<int>(std::lround((feet.z - origin_.z) / kSameFloor))};
    }
    [[nodiscard]] Vec3 feetOf(std::size_t node) const { return nodes_[node].body.standing.feet; }
    /// Metres to the point; a difference in height counts beyond a step.
    [[nodiscard]] double toGo(std::size_t node) const {
        const Vec3 feet = feetOf(node);
        return levelMetres(feet, to_) + std::max(0.0, std::abs(feet.z - to_.z) - shape_.stepUp);
    }
    void queue(std::size_t node) { open_.push({nodes_[node].metres + kGreed * toGo(node), node}); }

    /// Walks a copy of the node's body to the middle of each neighbour.
    void leave(std::size_t from) {
        const Square here = nodes_[from].square;
        for (int dx = -1; dx <= 1; ++dx)
            for (int dy = -1; dy <= 1; ++dy)
                if (dx != 0 || dy != 0)
                    walk(from, origin_.x + (here.x + dx) * square_, origin_.y + (here.y + dy) * square_);
    }
    void walk(std::size_t from, double x, double y) {
        const Vec3 feet = feetOf(from), middle(x, y, feet.z);
        if (levelMetres(middle, origin_) > kFarthestWay)
            return;
        const Square likely = squareAt(middle);
        if (const auto known = slots_.find(likely); known != slots_.end() && nodes_[known->second].isLeft)
            return;
        const BodyState body = straight(from, middle);
        const double off = levelMetres(body.standing.feet, middle),
                     metres = levelMetres(body.standing.feet, feet);
        // A body in a nook leaves it along the obstacles.
        if (body.isOnGround && (off < kBlockedBy || (from == 0 && metres > kBlockedBy)))
            reach({squareAt(body.standing.feet), body, nodes_[from].metres + metres, from, false});
    }
    /// The body of a node after its steps towards a point.
    [[nodiscard]] BodyState straight(std::size_t from, const Vec3& to) const {
        const Vec3 way = to - feetOf(from);
        BodyInput input;
        input.forward = 1.0;
        input.yaw = glm::degrees(std::atan2(way.x, way.y));
        return moved(nodes_[from].body, input, std::hypot(way.x, way.y) / shape_.walkSpeed, around_, doors_,
                     shape_);
    }
    [[nodiscard]] bool reachesPoint(std::size_t from) const {
        const Vec3 feet = straight(from, to_).standing.feet;
        return levelMetres(feet, to_) < kBlockedBy && std::abs(feet.z - to_.z) < shape_.stepUp;
    }
    void reach(DetourNode node) {
        const auto [slot, isNew] = slots_.try_emplace(node.square, nodes_.size());
        if (isNew)
            nodes_.push_back(std::move(node));
        else if (!nodes_[slot->second].isLeft && node.metres < nodes_[slot->second].metres)
            nodes_[slot->second] = std::move(node);
        else
            return;
        queue(slot->second);
    }

    /// The positions at which the way turns, and its end.
    [[nodiscard]] std::vector<Vec3> cornersTo(std::size_t node) const {
        std::vector<Vec3> corners;
        for (std::size_t at = node, after = kNoNode; at != 0; after = at, at = nodes_[at].before)
            if (after == kNoNode || !isStraight(nodes_[at].before, at, after))
                corners.push_back(feetOf(at));
        std::reverse(corners.begin(), corners.end());
        return corners;
    }
    [[nodiscard]] bool isStraight(std::size_t a, std::size_t b, std::size_t c) const {
        const Square &p = nodes_[a].square, &q = nodes_[b].square, &r = nodes_[c].square;
        return q.x - p.x == r.x - q.x && q.y - p.y == r.y - q.y;
    }

    const double square_; ///< side, metres
    const Vec3 origin_, to_;
    const Collisions& around_;
    const std::span<const double> doors_;
    const BodyShape& shape_;
    std::vector<DetourNode> nodes_; ///< the body's own square first
    std::map<Square, std::size_t> slots_;
    using Open = std::pair<double, std::size_t>; ///< least length of a way through a node, the node
    std::priority_queue<Open, std::vector<Open>, std::greater<>> open_;
};

} // namespace

Detour wayAround(const BodyState& body, const Vec3& to, double square, const Collisions& around,
                 std::span<const double> doors, const BodyShape& shape) {
    if (levelMetres(body.standing.feet, to) > kFarthestWay)
        return {};
    constexpr double kRest = 0.5; // seconds: a body between two obstacles comes to rest
    return DetourSearch(moved(body, {}, kRest, around, doors, shape), to, square, around, doors, shape).run();
}

} // namespace limen::motion
