#include "worlds/builtin/village/DoorMotions.h"

#include "worlds/builtin/people/MotionCommands.h"

#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

namespace limen::worlds {
namespace {

constexpr int kFramesOfASwing = 30;
constexpr float kFramesASecond = 30.0f;

dat::MotionData framesOf(dat::RecordId animation, int low, int high) {
    dat::MotionData data;
    data.animations = {{animation, low, high, kFramesASecond}};
    return data;
}

/// A table that turns its only part by `swing` degrees, clockwise seen from above, when it goes from Off to On.
dat::RecordId addSwing(ModelWriter& writer, double swing) {
    std::vector<dat::AnimationFrame> frames;
    for (int k = 0; k <= kFramesOfASwing; ++k) {
        const double half = -swing * k / kFramesOfASwing * std::numbers::pi / 360.0;
        const Quatf turn(static_cast<float>(std::cos(half)), 0.0f, 0.0f, static_cast<float>(std::sin(half)));
        frames.push_back({{{Vec3f(0.0f), turn}}, {}});
    }
    const dat::RecordId animation = writer.addAnimation(std::move(frames));
    dat::MotionTable table;
    table.defaultStyle = kNonCombat;
    table.styleDefaults = {{kNonCombat, kOff}};
    const std::uint32_t off = dat::motionKey(kNonCombat, kOff), on = dat::motionKey(kNonCombat, kOn);
    table.cycles = {{off, framesOf(animation, 0, 0)},
                    {on, framesOf(animation, kFramesOfASwing, kFramesOfASwing)}};
    table.links = {{off, {{kOn, framesOf(animation, 1, kFramesOfASwing)}}}};
    return writer.addMotionTable(std::move(table));
}

} // namespace

void addDoorMotions(ModelWriter& writer, nlohmann::ordered_json& worldFile) {
    std::map<double, dat::RecordId> tables;
    for (nlohmann::ordered_json& door : worldFile["doors"]) {
        if (!door.value("opaque", true))
            continue;
        for (nlohmann::ordered_json& leaf : door["leaves"]) {
            const double swing = leaf.value("swing", 0.0);
            dat::RecordId& table = tables[swing];
            if (table == 0)
                table = addSwing(writer, swing);
            leaf["motionTable"] = fmt::format("0x{:08X}", table);
        }
    }
}

} // namespace limen::worlds
