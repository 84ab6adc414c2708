#include "worlds/builtin/places/Tour.h"

#include "worlds/builtin/land/TerrainShape.h"

#include <algorithm>
#include <cmath>

namespace limen::worlds {

namespace {

/// The greatest distance between way points, metres.
double strideOf(LegKind kind) {
    switch (kind) {
    case LegKind::Ground:
        return 1.0;
    case LegKind::Flight:
        return 1.25;
    case LegKind::Straight:
    case LegKind::Look:
        break;
    }
    return 0.4;
}

constexpr double kTurnsPerSecond = 4.0; ///< way points a second of an eye that turns in place

/// Makes way points along legs. The eye turns smoothly and follows the ground.
class TourWalker {
public:
    explicit TourWalker(const Eye& start) : eyes_{start}, times_{0.0} {}

    void follow(const TourLeg& leg) {
        const Eye from = eyes_.back();
        const Eye end = endOf(leg, from);
        const bool stands = leg.kind == LegKind::Look;
        const double length = glm::length(end.position - from.position);
        const double seconds = stands ? leg.pace : length / leg.pace;
        const double wanted = stands ? std::max(2.0, std::floor(leg.pace * kTurnsPerSecond))
                                     : std::max(1.0, std::ceil(length / strideOf(leg.kind)));
        const int steps = static_cast<int>(wanted);
        for (int k = 1; k <= steps; ++k) {
            const double t = static_cast<double>(k) / steps;
            Vec3 position = from.position + (end.position - from.position) * t;
            if (leg.kind == LegKind::Ground)
                position = onGround(position);
            push(position, from, end, t, seconds / steps);
        }
    }
    [[nodiscard]] nlohmann::ordered_json toJsonList() const {
        nlohmann::ordered_json list = nlohmann::ordered_json::array();
        for (std::size_t i = 0; i < eyes_.size(); ++i) {
            nlohmann::ordered_json item = toJson(eyes_[i]);
            item["t"] = std::round(times_[i] * 64.0) / 64.0;
            list.push_back(std::move(item));
        }
        return list;
    }

private:
    static Vec3 onGround(const Vec3& global) {
        const Vec3 area = global - toGlobal(Vec3(0.0));
        return {global.x, global.y, groundHeight(area.x, area.y) + kEyeHeight};
    }
    static Eye endOf(const TourLeg& leg, const Eye& from) {
        switch (leg.kind) {
        case LegKind::Ground:
            return eyeTowards(onGround(leg.to), leg.target, 0);
        case LegKind::Look:
            return eyeTowards(from.position, leg.target, 0);
        case LegKind::Straight:
        case LegKind::Flight:
            break;
        }
        return eyeTowards(leg.to, leg.target, 0);
    }
    void push(const Vec3& position, const Eye& from, const Eye& to, double t, double seconds) {
        Eye eye;
        eye.position = position;
        const double turn = std::remainder(to.yaw - from.yaw, 360.0);
        const double eased = t * t * (3.0 - 2.0 * t);
        eye.yaw = std::fmod(from.yaw + turn * eased + 720.0, 360.0);
        eye.pitch = from.pitch + (to.pitch - from.pitch) * eased;
        eyes_.push_back(eye);
        times_.push_back(times_.back() + seconds);
    }

    std::vector<Eye> eyes_;
    std::vector<double> times_;
};

} // namespace

nlohmann::ordered_json walkTour(const Eye& start, const std::vector<TourLeg>& legs) {
    TourWalker walker(start);
    for (const TourLeg& leg : legs)
        walker.follow(leg);
    return walker.toJsonList();
}

} // namespace limen::worlds
