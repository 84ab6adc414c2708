#pragma once

#include "worlds/builtin/places/Eye.h"

#include <vector>

namespace limen::worlds {

enum class LegKind {
    Ground,   ///< along the ground, to x and y of the goal
    Straight, ///< a straight line through the air: indoors, over steps
    Flight,   ///< a straight line through the air with way points farther apart
    Look      ///< a turn in place
};

/// A leg of the tour: a way to a point, or a turn in place. At its end the eye looks at `target`. Global
/// metres.
struct TourLeg {
    LegKind kind = LegKind::Straight;
    Vec3 to{0.0}, target{0.0};
    double pace = 1.8; ///< metres a second; of LegKind::Look: seconds
};

/// Collects legs; global metres.
class TourPath {
public:
    void ground(const Vec3& to, double pace, const Vec3& target) {
        legs.push_back({LegKind::Ground, to, target, pace});
    }
    void straight(const Vec3& to, double pace, const Vec3& target) {
        legs.push_back({LegKind::Straight, to, target, pace});
    }
    void flight(const Vec3& to, double pace, const Vec3& target) {
        legs.push_back({LegKind::Flight, to, target, pace});
    }
    void look(const Vec3& target, double seconds) {
        legs.push_back({LegKind::Look, Vec3(0.0), target, seconds});
    }

    std::vector<TourLeg> legs;
};

/// The tour of `world.json` (docs/world-file.md): way points from `start` along the legs.
[[nodiscard]] nlohmann::ordered_json walkTour(const Eye& start, const std::vector<TourLeg>& legs);

} // namespace limen::worlds
