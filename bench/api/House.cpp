#include "api/House.h"

#include "core/Assert.h"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>

namespace limen::bench {
namespace {

constexpr double kRoom = 10.0, kDoorHeight = 3.0, kHalfDoor = 1.0, kEyeHeight = 1.7; // metres
constexpr double kWallGap = 0.05; // of a room: no eye is closer to a wall

/// A door in the wall that begins at `corner` and runs along `along`, counter-clockwise as seen from its right-hand side.
std::vector<Vec3> doorway(const Vec3& corner, const Vec3& along) {
    const Vec3 low = corner + along * (kRoom / 2.0 - kHalfDoor),
               high = corner + along * (kRoom / 2.0 + kHalfDoor);
    const Vec3 up(0.0, 0.0, kDoorHeight);
    return {low, high, high + up, low + up};
}

visibility::LookAt randomEye(std::uint32_t side, std::mt19937& random) {
    std::uniform_real_distribution<double> within(kWallGap, 1.0 - kWallGap),
        turn(0.0, 2.0 * std::numbers::pi);
    std::uniform_int_distribution<std::uint32_t> room(0, side - 1);
    const std::uint32_t column = room(random), row = room(random);
    visibility::LookAt look;
    look.eye = {(column + within(random)) * kRoom, (row + within(random)) * kRoom, kEyeHeight};
    const double yaw = turn(random);
    look.target = look.eye + Vec3(std::sin(yaw), std::cos(yaw), 0.0);
    look.aspect = 1.5;
    look.root = row * side + column;
    return look;
}

nlohmann::json listOf(const Vec3& v) {
    return {v.x, v.y, v.z};
}

} // namespace

House gridHouse(std::uint32_t side, std::size_t eyes, std::uint32_t seed) {
    House house;
    house.spaces = side * side;
    for (std::uint32_t row = 0; row < side; ++row)
        for (std::uint32_t column = 0; column < side; ++column) {
            const std::uint32_t here = row * side + column;
            const Vec3 far((column + 1) * kRoom, (row + 1) * kRoom, 0.0);
            if (column + 1 < side) // the wall to the east, seen from its west
                house.openings.push_back(
                    {.from = here, .to = here + 1, .polygon = doorway(far, {0.0, -1.0, 0.0})});
            if (row + 1 < side) // the wall to the north, seen from its south
                house.openings.push_back({.from = here,
                                          .to = here + side,
                                          .polygon = doorway(far - Vec3(kRoom, 0.0, 0.0), {1.0, 0.0, 0.0})});
        }
    std::mt19937 random(seed);
    for (std::size_t i = 0; i < eyes; ++i)
        house.eyes.push_back(randomEye(side, random));
    return house;
}

visibility::Graph graphOf(const House& house) {
    visibility::GraphBuilder builder;
    for (std::uint32_t space = 0; space < house.spaces; ++space)
        builder.addSpace();
    for (const visibility::OpeningDesc& opening : house.openings)
        builder.addOpening(opening);
    Result<visibility::BuiltGraph> built = builder.build();
    LIMEN_ASSERT(built.has_value(), "the house is sound");
    return std::move(built->graph);
}

std::vector<visibility::View> viewsOf(const House& house) {
    std::vector<visibility::View> views;
    for (const visibility::LookAt& eye : house.eyes) {
        const Result<visibility::View> view = visibility::viewOf(eye);
        LIMEN_ASSERT(view.has_value(), "the eyes are sound");
        views.push_back(*view);
    }
    return views;
}

Result<void> writeHouse(const House& house, const std::filesystem::path& file) {
    nlohmann::json text{
        {"spaces", house.spaces}, {"openings", nlohmann::json::array()}, {"eyes", nlohmann::json::array()}};
    for (const visibility::OpeningDesc& opening : house.openings) {
        nlohmann::json polygon = nlohmann::json::array();
        for (const Vec3& corner : opening.polygon)
            polygon.push_back(listOf(corner));
        text["openings"].push_back({opening.from, opening.to, polygon});
    }
    for (const visibility::LookAt& eye : house.eyes)
        text["eyes"].push_back(
            {listOf(eye.eye), listOf(eye.target), eye.root, eye.heightDegrees, eye.aspect});
    std::ofstream out(file);
    if (!(out << text.dump() << std::flush))
        return fail(ErrorCode::Unreadable, file.string(), "cannot be written");
    return {};
}

} // namespace limen::bench
