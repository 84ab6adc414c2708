#include "motion/TravelReach.h"

namespace limen::motion {
namespace {

constexpr double kTravelReach = 3.0;  // metres from the eye to the middle of the portal
constexpr double kLeastTowards = 0.5; // cosine of the angle between gaze and portal
constexpr double kMiddle = 1.0;       // metres: height of the middle of a portal above its origin

} // namespace

std::optional<std::size_t> travelInReach(const world::World& world, const Vec3& eye, const Vec3& forward) {
    std::optional<std::size_t> best;
    double most = kLeastTowards;
    for (std::size_t i = 0; i < world.placed.size(); ++i) {
        const world::PlacedObject& placed = world.placed[i];
        const Vec3 way = placed.origin + Vec3(0.0, 0.0, kMiddle) - eye;
        const double distance = glm::length(way);
        if (!placed.travel || distance > kTravelReach)
            continue;
        const double towards = distance > 0.0 ? glm::dot(way, forward) / distance : 1.0;
        if (towards > most) {
            most = towards;
            best = i;
        }
    }
    return best;
}

} // namespace limen::motion
