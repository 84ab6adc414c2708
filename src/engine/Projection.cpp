#include "engine/Projection.h"

namespace limen::engine {

std::optional<std::pair<Vec2, Vec2>> projectLine(const Vec3& a, const Vec3& b, const visibility::View& eye) {
    constexpr double kNearest = 0.02; // metres in front of the eye; lines are clipped there
    const Mat3 screen = eye.screenFromEye();
    Vec3 from = screen * (a - eye.eye), to = screen * (b - eye.eye);
    if (from.z < kNearest && to.z < kNearest)
        return std::nullopt;
    const auto cut = [](const Vec3& before, const Vec3& behind) {
        return behind + (before - behind) * ((kNearest - behind.z) / (before.z - behind.z));
    };
    if (from.z < kNearest)
        from = cut(to, from);
    else if (to.z < kNearest)
        to = cut(from, to);
    return std::pair(Vec2(from.x, from.y) / from.z, Vec2(to.x, to.y) / to.z);
}

} // namespace limen::engine
