#include "worlds/generate/DungeonDoors.h"

#include <algorithm>
#include <cmath>

namespace limen::worlds {

namespace {

FlatOutline rectangle(double from, double to, double top) {
    return {{from, 0.0}, {to, 0.0}, {to, top}, {from, top}};
}

FlatOutline arch() {
    // A half circle of eight chords on upright sides: eleven edges.
    constexpr double kMiddle = 1.25, kRadius = 1.0, kSpring = 1.5;
    FlatOutline out{{kMiddle - kRadius, 0.0}, {kMiddle + kRadius, 0.0}};
    constexpr int kChords = 8;
    for (int k = 0; k <= kChords; ++k) {
        const double a = 3.14159265358979323846 * k / kChords;
        const auto snap = [](double v) { return std::round(v * 1024.0) / 1024.0; };
        out.emplace_back(kMiddle + snap(kRadius * std::cos(a)), kSpring + snap(kRadius * std::sin(a)));
    }
    return out;
}

} // namespace

std::vector<FlatOutline> openingOutlines(Door door) {
    switch (door) {
    case Door::Narrow:
        return {rectangle(-1.875, -0.625, 2.25)};
    case Door::Wide:
        return {rectangle(-1.0, 1.0, 2.5)};
    case Door::Twin:
        return {rectangle(-2.125, -0.875, 2.25), rectangle(0.875, 2.125, 2.25)};
    case Door::Arch:
        return {arch()};
    case Door::None:
        break;
    }
    return {};
}

FlatOutline passageOutline(Door door) {
    switch (door) {
    case Door::Wide:
        return rectangle(-1.5, 1.5, 2.75);
    case Door::Twin:
        return rectangle(-2.5, 2.5, 2.75);
    default:
        return openingOutlines(door).front();
    }
}

FlatOutline hatchOutline(Door door) {
    constexpr double kHalf = 1.0, kBevel = 0.5;
    if (door == Door::Narrow)
        return {{-kHalf, -kHalf}, {kHalf, -kHalf}, {kHalf, kHalf}, {-kHalf, kHalf}};
    return {{-kBevel, -kHalf}, {kBevel, -kHalf}, {kHalf, -kBevel}, {kHalf, kBevel},
            {kBevel, kHalf},   {-kBevel, kHalf}, {-kHalf, kBevel}, {-kHalf, -kBevel}};
}

std::uint16_t openingsOf(Door door) {
    return door == Door::None ? 0 : door == Door::Twin ? 2 : 1;
}

DoorExtent extentOf(Door door, std::uint16_t opening) {
    const FlatOutline outline = openingOutlines(door).at(opening);
    DoorExtent out{1e9, -1e9, 0.0, door != Door::Arch};
    for (const Vec2& p : outline) {
        out.from = std::min(out.from, p.x);
        out.to = std::max(out.to, p.x);
        out.height = std::max(out.height, p.y);
    }
    return out;
}

} // namespace limen::worlds
