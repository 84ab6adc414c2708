#include "visibility/GraphBuilder.h"

#include "geometry/ConvexPolygon.h"

#include <algorithm>
#include <string>

namespace limen::visibility {

namespace {

/// Square metres. A smaller opening is a point or a line.
constexpr double kNoArea = 1e-9;

/// One direction of an opening.
struct HalfOpening {
    std::uint32_t space = 0, destination = kNone;
    std::uint32_t opening = 0;
    bool isBack = false;
};

std::string nameOf(std::size_t opening, const OpeningDesc& desc) {
    return "opening " + std::to_string(opening) + ", from space " + std::to_string(desc.from);
}

Result<void> checkOpening(std::size_t index, const OpeningDesc& desc, std::size_t spaces) {
    const auto refuse = [&](std::string why) {
        return fail(ErrorCode::BadArgument, nameOf(index, desc), std::move(why));
    };
    for (const std::uint32_t space : {desc.from, desc.to})
        if (space >= spaces && (space != kNone || space == desc.from))
            return refuse("there are " + std::to_string(spaces) + " spaces, and none is number " +
                          std::to_string(space));
    if (const auto fault = faultOfOpening(desc.polygon, GraphBuilder::kUneven))
        return refuse("its polygon " + *fault);
    if (desc.backPolygon.empty())
        return {};
    if (const auto fault = faultOfOpening(desc.backPolygon, GraphBuilder::kUneven))
        return refuse("its second polygon " + *fault);
    if (glm::dot(newellNormal(desc.polygon), newellNormal(desc.backPolygon)) >= 0.0)
        return refuse("its two polygons face the same side; list the corners of the second as seen from "
                      "inside the other space");
    return {};
}

/// All directions of all openings, grouped by space.
std::vector<HalfOpening> halvesOf(std::span<const OpeningDesc> openings) {
    std::vector<HalfOpening> halves;
    for (std::uint32_t i = 0; i < openings.size(); ++i) {
        const OpeningDesc& desc = openings[i];
        halves.push_back({desc.from, desc.to, i, false});
        if (!desc.oneWay && desc.to != kNone)
            halves.push_back({desc.to, desc.from, i, true});
    }
    std::stable_sort(halves.begin(), halves.end(),
                     [](const HalfOpening& a, const HalfOpening& b) { return a.space < b.space; });
    return halves;
}

std::vector<PortalPair> numbersOf(std::span<const HalfOpening> halves, std::size_t openings) {
    std::vector<PortalPair> numbers(openings);
    for (std::uint32_t i = 0; i < halves.size(); ++i)
        (halves[i].isBack ? numbers[halves[i].opening].back : numbers[halves[i].opening].out) = i;
    return numbers;
}

/// The corners of one direction, appended.
void addPolygon(const OpeningDesc& desc, bool isBack, std::vector<Vec3>& vertices) {
    if (!isBack)
        vertices.insert(vertices.end(), desc.polygon.begin(), desc.polygon.end());
    else if (desc.backPolygon.empty())
        vertices.insert(vertices.end(), desc.polygon.rbegin(), desc.polygon.rend());
    else
        vertices.insert(vertices.end(), desc.backPolygon.begin(), desc.backPolygon.end());
}

} // namespace

std::optional<std::string> faultOfOpening(std::span<const Vec3> polygon, double uneven) {
    if (polygon.size() < 3)
        return "has fewer than three corners";
    if (!std::all_of(polygon.begin(), polygon.end(), [](const Vec3& v) { return isFinite(v); }))
        return "has a corner that is not finite";
    const Plane plane = planeOf(polygon);
    if (glm::length(newellNormal(polygon)) < 2.0 * kNoArea)
        return "has no area";
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        if (std::abs(plane.signedDistance(polygon[i])) > uneven)
            return "is not flat";
        const Vec3 along = polygon[(i + 1) % polygon.size()] - polygon[i];
        const double length = glm::length(along);
        const Vec3 inwards = length > 0.0 ? glm::cross(plane.n, along) / length : Vec3(0.0);
        for (const Vec3& corner : polygon)
            if (glm::dot(inwards, corner - polygon[i]) < -uneven)
                return "is not convex";
    }
    return std::nullopt;
}

std::uint32_t GraphBuilder::addSpace() {
    return addSpaceInZoneOf(static_cast<std::uint32_t>(zoneOf_.size()));
}

std::uint32_t GraphBuilder::addSpaceInZoneOf(std::uint32_t other) {
    zoneOf_.push_back(other < zoneOf_.size() ? zoneOf_[other] : other);
    return static_cast<std::uint32_t>(zoneOf_.size() - 1);
}

std::uint32_t GraphBuilder::addOpening(OpeningDesc opening) {
    openings_.push_back(std::move(opening));
    return static_cast<std::uint32_t>(openings_.size() - 1);
}

Result<BuiltGraph> GraphBuilder::build() const {
    std::vector<SpaceDesc> spaces(zoneOf_.size());
    for (std::size_t i = 0; i < spaces.size(); ++i) {
        if (zoneOf_[i] > i)
            return fail(ErrorCode::BadArgument, "space " + std::to_string(i),
                        "is in the zone of space " + std::to_string(zoneOf_[i]) + ", which comes later");
        spaces[i].zone = zoneOf_[i];
    }
    for (std::size_t i = 0; i < openings_.size(); ++i)
        if (Result<void> checked = checkOpening(i, openings_[i], spaces.size()); !checked)
            return Failure(checked.error());
    const std::vector<HalfOpening> halves = halvesOf(openings_);
    std::vector<PortalPair> numbers = numbersOf(halves, openings_.size());
    std::vector<PortalDesc> portals;
    std::vector<Vec3> vertices;
    for (const HalfOpening& half : halves) {
        const OpeningDesc& desc = openings_[half.opening];
        const PortalPair& pair = numbers[half.opening];
        SpaceDesc& space = spaces[half.space];
        if (space.portalCount++ == 0)
            space.firstPortal = static_cast<std::uint32_t>(portals.size());
        PortalDesc portal;
        portal.space = half.space;
        portal.destination = half.destination;
        portal.reciprocal = half.isBack ? pair.out : pair.back;
        portal.firstVertex = static_cast<std::uint32_t>(vertices.size());
        addPolygon(desc, half.isBack, vertices);
        portal.vertexCount = static_cast<std::uint32_t>(vertices.size()) - portal.firstVertex;
        portal.exact = desc.backPolygon.empty();
        portals.push_back(portal);
    }
    return Graph::build(spaces, portals, vertices).map([&](Graph&& graph) {
        return BuiltGraph{std::move(graph), std::move(numbers)};
    });
}

} // namespace limen::visibility
