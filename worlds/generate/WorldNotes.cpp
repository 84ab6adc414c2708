#include "worlds/generate/WorldNotes.h"

#include <fmt/format.h>

namespace limen::worlds {

namespace {

constexpr double kDegrees = 57.295779513082323;

/// Rounds to six decimals: precise enough, and the same text from every compiler.
double rounded(double v) {
    return std::round(v * 1e6) / 1e6;
}

nlohmann::ordered_json list(const Vec3& p) {
    return nlohmann::ordered_json::array({rounded(p.x), rounded(p.y), rounded(p.z)});
}

std::string cellName(dat::RecordId cell) {
    return fmt::format("0x{:08X}", cell);
}

} // namespace

WorldNotes::WorldNotes() {
    json_["format"] = "limen world";
    json_["version"] = 1;
    json_["places"] = nlohmann::ordered_json::object();
    json_["tour"] = nlohmann::ordered_json::array();
    json_["doors"] = nlohmann::ordered_json::array();
}

void WorldNotes::addPlace(const std::string& name, const Vec3& eye, const Vec3& target, dat::RecordId cell) {
    const Vec3 ahead = target - eye;
    nlohmann::ordered_json place;
    place["eye"] = list(eye);
    place["yaw"] = rounded(std::atan2(ahead.x, ahead.y) * kDegrees);
    place["pitch"] = rounded(std::atan2(ahead.z, std::hypot(ahead.x, ahead.y)) * kDegrees);
    if (cell != 0)
        place["cell"] = cellName(cell);
    json_["places"][name] = std::move(place);
}

void WorldNotes::addDoor(const Door& door, std::span<const Leaf> leaves) {
    nlohmann::ordered_json json;
    json["name"] = fmt::format("door.{}", doorCount());
    json["cell"] = cellName(door.cell);
    json["portal"] = door.portal;
    json["opaque"] = door.opaque;
    json["open"] = rounded(door.open);
    json["leaves"] = nlohmann::ordered_json::array();
    for (const Leaf& leaf : leaves) {
        nlohmann::ordered_json entry;
        entry["model"] = cellName(leaf.model);
        entry["position"] = list(leaf.hinge);
        entry["yaw"] = rounded(leaf.yaw);
        entry["swing"] = rounded(leaf.swing);
        json["leaves"].push_back(std::move(entry));
    }
    json_["doors"].push_back(std::move(json));
}

} // namespace limen::worlds
