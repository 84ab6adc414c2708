#include "engine/Projection.h"

#include "geometry/Tolerances.h"

namespace limen::engine {

std::optional<std::pair<Vec2, Vec2>> projectLine(const Vec3& a, const Vec3& b, const visibility::View& eye) {
    const Mat3 screen = eye.screenFromEye();
    Vec3 from = screen * (a - eye.eye), to = screen * (b - eye.eye);
    if (from.z < kNearestPlace && to.z < kNearestPlace)
        return std::nullopt;
    const auto cut = [](const Vec3& before, const Vec3& behind) {
        return behind + (before - behind) * ((kNearestPlace - behind.z) / (before.z - behind.z));
    };
    if (from.z < kNearestPlace)
        from = cut(to, from);
    else if (to.z < kNearestPlace)
        to = cut(from, to);
    return std::pair(Vec2(from.x, from.y) / from.z, Vec2(to.x, to.y) / to.z);
}

} // namespace limen::engine
