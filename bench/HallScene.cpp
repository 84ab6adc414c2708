#include "HallScene.h"

#include "core/Assert.h"
#include "worlds/shapes/SolidCutter.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace limen::bench {

namespace {

constexpr double kVolume = 30.0;      ///< mean volume of a cell in cubic metres
constexpr double kLeastRadius = 0.05; ///< metres; faces without room for such a circle get no opening
constexpr double kDoorShare = 0.05;   ///< share of the openings that are between halls
constexpr std::int32_t kFirstCut = 6; ///< the planes before it are the sides of the box

/// Selects the open faces: the largest ones inside of halls, and random ones between halls.
std::vector<worlds::SharedFace> openFaces(const std::vector<worlds::Solid>& solids, const HallSpec& spec,
                                          worlds::Random& random) {
    std::vector<worlds::SharedFace> faces = worlds::sharedFaces(solids, kLeastRadius);
    for (std::size_t i = faces.size(); i > 1; --i)
        std::swap(faces[i - 1], faces[random.below(static_cast<std::uint32_t>(i))]);
    // The largest solid is cut next, so the first cuts separate the halls.
    const std::int32_t firstInside = kFirstCut + static_cast<std::int32_t>(spec.halls) - 1;
    const auto between =
        std::stable_partition(faces.begin(), faces.end(), [&](const worlds::SharedFace& face) {
            return solids[face.first].sides[face.firstSide].cut >= firstInside;
        });
    std::stable_sort(faces.begin(), between, [](const auto& a, const auto& b) {
        return worlds::areaOf(a.points) > worlds::areaOf(b.points);
    });
    const auto doors = static_cast<std::ptrdiff_t>(kDoorShare * spec.openings);
    const std::ptrdiff_t inside = std::min<std::ptrdiff_t>(between - faces.begin(), spec.openings - doors);
    faces.erase(faces.begin() + inside, between);
    faces.resize(std::min<std::size_t>(faces.size(), spec.openings));
    return faces;
}

visibility::Graph graphOf(const std::vector<worlds::SharedFace>& faces, const HallSpec& spec) {
    struct Side {
        std::uint32_t destination, face;
        bool first;
    };
    std::vector<std::vector<Side>> sides(spec.cells);
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
        sides[faces[f].first].push_back({faces[f].second, f, true});
        sides[faces[f].second].push_back({faces[f].first, f, false});
    }
    std::vector<visibility::SpaceDesc> spaces;
    std::vector<visibility::PortalDesc> portals;
    std::vector<Vec3> vertices;
    std::vector<std::uint32_t> portalOfFace(faces.size(), visibility::kNone);
    for (std::uint32_t c = 0; c < spec.cells; ++c) {
        spaces.push_back({static_cast<std::uint32_t>(portals.size()),
                          static_cast<std::uint32_t>(sides[c].size()), spec.merged ? 0 : c});
        for (const Side& side : sides[c]) {
            const auto index = static_cast<std::uint32_t>(portals.size());
            worlds::Polygon points = faces[side.face].points;
            if (!side.first)
                std::reverse(points.begin(), points.end());
            std::uint32_t& other = portalOfFace[side.face];
            portals.push_back({c, side.destination, other, static_cast<std::uint32_t>(vertices.size()),
                               static_cast<std::uint32_t>(points.size()), true});
            if (other != visibility::kNone)
                portals[other].reciprocal = index;
            other = index;
            vertices.insert(vertices.end(), points.begin(), points.end());
        }
    }
    auto graph = visibility::Graph::build(spaces, portals, vertices);
    LIMEN_ASSERT(graph.has_value(), "halls are a valid graph");
    return std::move(*graph);
}

visibility::View randomView(const std::vector<worlds::Solid>& solids, worlds::Random& random) {
    visibility::View view;
    view.root = random.below(static_cast<std::uint32_t>(solids.size()));
    const worlds::Solid& cell = solids[view.root];
    const worlds::Polygon& wall =
        cell.sides[random.below(static_cast<std::uint32_t>(cell.sides.size()))].points;
    const double share = 0.9 * random.unit();
    view.eye = worlds::middleOf(cell) * (1.0 - share) + worlds::centroidOf(wall) * share;
    const double yaw = random.between(0.0, 2.0 * std::numbers::pi);
    const double pitch = random.between(-0.5, 0.5);
    view.forward = {std::sin(yaw) * std::cos(pitch), std::cos(yaw) * std::cos(pitch), std::sin(pitch)};
    view.right = {std::cos(yaw), -std::sin(yaw), 0.0};
    view.up = glm::cross(view.right, view.forward);
    view.tanHalfX = 1.0;
    view.tanHalfY = std::tan(std::numbers::pi / 6.0);
    return view;
}

} // namespace

FloodScene hallScene(const HallSpec& spec) {
    worlds::Random random(spec.seed);
    const double side = std::cbrt(kVolume * spec.cells);
    const std::vector<worlds::Solid> solids =
        worlds::cutBox(Vec3(0.0), Vec3(side * 1.5, side * 1.5, side / 2.25), spec.cells, random);
    const std::vector<worlds::SharedFace> faces = openFaces(solids, spec, random);
    std::vector<visibility::View> views;
    for (std::uint32_t i = 0; i < spec.views; ++i)
        views.push_back(randomView(solids, random));
    return {fmt::format("{} halls of {} cells, {} openings{}", spec.halls, spec.cells, faces.size(),
                        spec.merged ? "" : ", every cell a zone"),
            graphOf(faces, spec), std::move(views)};
}

} // namespace limen::bench
