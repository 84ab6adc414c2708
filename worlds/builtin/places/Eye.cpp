#include "worlds/builtin/places/Eye.h"

#include "worlds/builtin/land/TerrainShape.h"

#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace limen::worlds {

namespace {

double rounded(double v, double step) {
    return std::round(v / step) * step;
}

} // namespace

void lookAt(Eye& eye, const Vec3& target) {
    const Vec3 d = target - eye.position;
    eye.yaw = std::fmod(std::atan2(d.x, d.y) * 180.0 / std::numbers::pi + 360.0, 360.0);
    eye.pitch = std::atan2(d.z, std::hypot(d.x, d.y)) * 180.0 / std::numbers::pi;
}

Eye eyeTowards(const Vec3& position, const Vec3& target, dat::RecordId cell) {
    Eye eye;
    eye.position = position;
    eye.cell = cell;
    lookAt(eye, target);
    return eye;
}

Eye groundEye(double x, double y, const Vec3& target) {
    return eyeTowards(toGlobal({x, y, groundHeight(x, y) + kEyeHeight}), target, 0);
}

nlohmann::ordered_json toJson(const Eye& eye) {
    nlohmann::ordered_json json;
    json["x"] = rounded(eye.position.x, 1.0 / 1024.0);
    json["y"] = rounded(eye.position.y, 1.0 / 1024.0);
    json["z"] = rounded(eye.position.z, 1.0 / 1024.0);
    json["yaw"] = rounded(eye.yaw, 1.0 / 64.0);
    json["pitch"] = rounded(eye.pitch, 1.0 / 64.0);
    if (eye.cell != 0)
        json["cell"] = fmt::format("0x{:08X}", eye.cell);
    return json;
}

} // namespace limen::worlds
