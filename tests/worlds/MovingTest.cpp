#include "worlds/BuiltIn.h"

#include "motion/Locate.h"
#include "world/Loader.h"
#include "worlds/Demo.h"
#include "worlds/Loaded.h"
#include "worlds/builtin/land/TerrainShape.h"

#include <gtest/gtest.h>
#include <set>

// Doors, routes, villagers and emitters of world.json agree with the records and with the loaded world.
namespace limen::worlds::test {
namespace {

using Json = nlohmann::ordered_json;

Vec3 vectorOf(const Json& json) {
    return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}
std::uint32_t idOf(const Json& json) {
    return static_cast<std::uint32_t>(std::stoul(json.get<std::string>(), nullptr, 16));
}
Vec3 inVillage(const Vec3& global) {
    return global - Vec3(kVillage.x * 192.0, kVillage.y * 192.0, 0.0);
}
const Json& listOf(const char* name) {
    return world().worldFile.at(name);
}

/// The polygons of a GfxObj or of all parts of a Setup, in the model's frame.
std::vector<std::vector<Vec3>> modelPolygons(std::uint32_t id) {
    std::vector<std::vector<Vec3>> out;
    const auto add = [&](std::uint32_t gfxObj, const dat::Frame& frame) {
        for (const dat::GfxObj& g : world().gfxObjs)
            for (std::size_t k = 0; g.id == gfxObj && k < g.polygons.size(); ++k)
                out.push_back(pointsOf(g.vertexArray, g.polygons[k].second, frame));
    };
    if (id >> 24 == 0x01)
        add(id, {});
    for (const dat::Setup& setup : world().setups)
        for (std::size_t k = 0; setup.id == id && k < setup.parts.size(); ++k)
            add(setup.parts[k], setup.placementFrames.front().second.parts.at(k));
    return out;
}

/// A leaf's points in the village block when it is open to the degree `open`, 0..1 (docs/world-file.md).
std::vector<Vec3> leafPoints(const Json& leaf, double open) {
    const double yaw = leaf.at("yaw").get<double>() + open * leaf.at("swing").get<double>();
    const double a = -yaw * 3.14159265358979323846 / 180.0; // yaw turns clockwise
    std::vector<Vec3> out;
    for (const auto& polygon : modelPolygons(idOf(leaf.at("model")))) {
        for (const Vec3& p : polygon) {
            out.push_back(
                inVillage(vectorOf(leaf.at("position"))) +
                Vec3(std::cos(a) * p.x - std::sin(a) * p.y, std::sin(a) * p.x + std::cos(a) * p.y, p.z));
        }
    }
    return out;
}

struct DoorOpening {
    const dat::EnvCell* cell = nullptr;
    std::vector<Vec3> polygon;
    Plane plane; ///< of the opening, the cell in front
};
DoorOpening openingOf(const Json& door) {
    DoorOpening out;
    out.cell = findCell(idOf(door.at("cell")));
    if (out.cell != nullptr) {
        out.polygon = portalPoints(*out.cell, door.at("portal").get<std::size_t>());
        out.plane = planeOf(out.polygon);
    }
    return out;
}

TEST(Doors, nameOpeningsThatExistAndNoneTwice) {
    ASSERT_GT(listOf("doors").size(), 20u);
    std::set<std::string> names;
    std::set<std::pair<std::uint32_t, std::size_t>> openings;
    for (const Json& door : listOf("doors")) {
        EXPECT_TRUE(names.insert(door.at("name").get<std::string>()).second) << door.at("name");
        const dat::EnvCell* cell = findCell(idOf(door.at("cell")));
        ASSERT_NE(cell, nullptr) << door.at("name");
        const auto portal = door.at("portal").get<std::size_t>();
        ASSERT_LT(portal, cell->portals.size()) << door.at("name");
        EXPECT_TRUE(openings.insert({cell->id, portal}).second) << door.at("name");
        const dat::CellPortal& p = cell->portals[portal];
        if (p.otherCellId != dat::kOutdoors)
            EXPECT_TRUE(openings.insert({(cell->id & 0xFFFF0000u) | p.otherCellId, p.otherPortalId}).second);
        EXPECT_GE(door.at("open").get<double>(), 0.0);
        EXPECT_LE(door.at("open").get<double>(), 1.0);
        ASSERT_FALSE(door.at("leaves").empty());
        for (const Json& leaf : door.at("leaves"))
            EXPECT_FALSE(modelPolygons(idOf(leaf.at("model"))).empty()) << door.at("name");
    }
    for (const char* name : {"cottage.front", "neighbour.front", "inn.front", "inn.kitchen", "inn.parlour",
                             "inn.back", "inn.balcony", "meetinghall.front"})
        EXPECT_EQ(names.count(name), 1u) << name;
}

TEST(Doors, closedLeavesLieInTheirOpeningAndCoverIt) {
    for (const Json& door : listOf("doors")) {
        const DoorOpening opening = openingOf(door);
        const Vec3 n = opening.plane.n;
        const Vec3 right = glm::cross(-n, Vec3(0, 0, 1));
        std::vector<Aabb> leaves; // coordinates (right, up)
        for (const Json& leaf : door.at("leaves")) {
            Aabb box;
            for (const Vec3& p : leafPoints(leaf, 0.0)) {
                EXPECT_LT(std::abs(opening.plane.signedDistance(p)), 0.05) << door.at("name");
                EXPECT_TRUE(containsProjection(opening.polygon, n, p, 0.001)) << door.at("name");
                box.include({glm::dot(p, right), p.z, 0.0});
            }
            leaves.push_back(box);
        }
        double area = 0.0;
        for (const Aabb& box : leaves)
            area += (box.max.x - box.min.x) * (box.max.y - box.min.y);
        for (std::size_t a = 0; a < leaves.size(); ++a) {
            for (std::size_t b = a + 1; b < leaves.size(); ++b) {
                EXPECT_LT(std::min(leaves[a].max.x, leaves[b].max.x) -
                              std::max(leaves[a].min.x, leaves[b].min.x),
                          0.001)
                    << door.at("name");
            }
        }
        // Leaves inside the opening that do not overlap and have its area leave no gap.
        EXPECT_NEAR(area, glm::length(newellNormal(opening.polygon)) * 0.5, 0.01) << door.at("name");
    }
}

TEST(Doors, openLeavesStandBesideTheOpening) {
    for (const Json& door : listOf("doors")) {
        if (!door.at("opaque").get<bool>())
            continue;
        const DoorOpening opening = openingOf(door);
        Vec3 middle(0.0);
        for (const Vec3& p : opening.polygon)
            middle += p / static_cast<double>(opening.polygon.size());
        for (const Json& leaf : door.at("leaves")) {
            for (const Vec3& p : leafPoints(leaf, 1.0)) {
                const Vec3 off = p - middle;
                const Vec3 inPlane = off - opening.plane.n * glm::dot(off, opening.plane.n);
                EXPECT_GT(std::hypot(inPlane.x, inPlane.y), 0.3) << door.at("name");
                EXPECT_GT(opening.plane.signedDistance(p), -0.06)
                    << door.at("name") << " opens into its cell";
            }
        }
    }
}

TEST(Doors, everyOpeningToTheOutsideHasADoorOrAPane) {
    std::set<std::pair<std::uint32_t, std::size_t>> filled;
    for (const Json& door : listOf("doors"))
        filled.insert({idOf(door.at("cell")), door.at("portal").get<std::size_t>()});
    for (const dat::EnvCell& cell : world().envCells) {
        for (std::size_t k = 0;
             (cell.id >> 16) == (dat::landBlockInfoId(kVillage) >> 16) && k < cell.portals.size(); ++k)
            if (cell.portals[k].otherCellId == dat::kOutdoors)
                EXPECT_EQ(filled.count({cell.id, k}), 1u) << std::hex << cell.id << " portal " << k;
    }
}

TEST(Doors, panesAreTranslucentAndLeavesAreNot) {
    std::map<std::uint32_t, std::uint32_t> types;
    for (const auto& [id, surface] : world().surfaces)
        types[id] = surface.type;
    constexpr std::uint32_t kBlended =
        dat::Surface::kAlpha | dat::Surface::kTranslucent | dat::Surface::kAdditive;
    const auto blended = [&](std::uint32_t gfxObj) {
        for (const dat::GfxObj& g : world().gfxObjs) {
            if (g.id == gfxObj) {
                return std::any_of(g.surfaces.begin(), g.surfaces.end(),
                                   [&](std::uint32_t s) { return (types.at(s) & kBlended) != 0; });
            }
        }
        return false;
    };
    for (const Json& door : listOf("doors")) {
        const std::uint32_t model = idOf(door.at("leaves").at(0).at("model"));
        std::uint32_t gfxObj = model;
        for (const dat::Setup& setup : world().setups)
            gfxObj = setup.id == model ? setup.parts.at(0) : gfxObj;
        EXPECT_EQ(blended(gfxObj), !door.at("opaque").get<bool>()) << door.at("name");
    }
}

struct RoutePoint {
    Vec3 at{0.0};
    world::SpaceIndex space = world::kOutside;
};
std::vector<RoutePoint> routePoints(const Json& route) {
    std::vector<RoutePoint> out;
    for (const Json& point : route.at("points")) {
        RoutePoint p;
        p.at = vectorOf(point.at("position"));
        if (point.at("cell").get<std::string>() != "outside")
            p.space = world::findCell(loaded(), idOf(point.at("cell")));
        out.push_back(p);
    }
    if (route.at("loop").get<bool>())
        out.push_back(out.front());
    return out;
}

TEST(Routes, pointsLieInTheSpaceTheyName) {
    ASSERT_GT(loaded().spaces.size(), 30u);
    for (const Json& route : listOf("routes")) {
        for (const RoutePoint& p : routePoints(route)) {
            const motion::Located found = motion::locate(loaded(), p.at);
            EXPECT_EQ(found.space, p.space)
                << route.at("name") << " at " << p.at.x << " " << p.at.y << " " << p.at.z;
            EXPECT_FALSE(found.ambiguous);
            if (p.space == world::kOutside)
                EXPECT_GE(p.at.z, world::terrainHeight(loaded(), p.at.x, p.at.y)) << route.at("name");
        }
    }
}

TEST(Routes, straightWaysLeadThroughOpeningsBothWays) {
    int crossings = 0;
    for (const Json& route : listOf("routes")) {
        const std::vector<RoutePoint> points = routePoints(route);
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            const RoutePoint& a = points[i];
            const RoutePoint& b = points[i + 1];
            EXPECT_EQ(motion::sweep(loaded(), a.space, a.at, b.at), b.space)
                << route.at("name") << " from point " << i;
            EXPECT_EQ(motion::sweep(loaded(), b.space, b.at, a.at), a.space)
                << route.at("name") << " back to point " << i;
            crossings += a.space != b.space ? 1 : 0;
            // The same in small steps: a route through a wall would leave the cell.
            world::SpaceIndex space = a.space;
            for (int k = 0; k < 50; ++k) {
                const Vec3 from = a.at + (b.at - a.at) * (k / 50.0);
                const Vec3 to = a.at + (b.at - a.at) * ((k + 1) / 50.0);
                space = motion::sweep(loaded(), space, from, to);
                EXPECT_EQ(motion::locate(loaded(), to).space, space)
                    << route.at("name") << " from point " << i;
            }
        }
    }
    EXPECT_GE(crossings, 14);
}

TEST(Routes, feetAreNearTheGroundOutdoors) {
    const double site = siteLevel();
    for (const Json& route : listOf("routes")) {
        const std::vector<RoutePoint> points = routePoints(route);
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            // Steps and balcony are on the level site.
            const bool onBoards = std::max(points[i].at.z, points[i + 1].at.z) > site + 0.1;
            for (int k = 0; k <= 10; ++k) {
                const Vec3 p = points[i].at + (points[i + 1].at - points[i].at) * (k / 10.0);
                const double height = p.z - world::terrainHeight(loaded(), p.x, p.y);
                const bool outside =
                    points[i].space == world::kOutside && points[i + 1].space == world::kOutside;
                EXPECT_TRUE(!outside || onBoards || std::abs(height) < 0.06)
                    << route.at("name") << " point " << i;
            }
        }
    }
}

TEST(Villagers, haveBodiesAndRoutes) {
    std::set<std::string> routes;
    for (const Json& route : listOf("routes"))
        EXPECT_TRUE(routes.insert(route.at("name").get<std::string>()).second);
    ASSERT_GE(listOf("villagers").size(), 5u);
    for (const Json& villager : listOf("villagers")) {
        EXPECT_EQ(routes.count(villager.at("route").get<std::string>()), 1u) << villager.at("name");
        const std::uint32_t id = idOf(villager.at("model"));
        const auto setup = std::find_if(world().setups.begin(), world().setups.end(),
                                        [id](const dat::Setup& s) { return s.id == id; });
        ASSERT_NE(setup, world().setups.end()) << villager.at("name");
        EXPECT_GE(setup->parts.size(), 6u);
        Aabb box;
        for (const auto& polygon : modelPolygons(id))
            for (const Vec3& p : polygon)
                box.include(p);
        EXPECT_NEAR(box.min.z, 0.0, 0.02) << villager.at("name");
        EXPECT_GT(box.max.z, 1.6);
        EXPECT_LT(box.max.z, 1.9);
        EXPECT_GT(villager.at("speed").get<double>(), 0.0);
    }
}

TEST(Villagers, haveASoftShadowOnTheGroundAsAPartOfTheirSetup) {
    std::map<std::uint32_t, std::uint32_t> types;
    for (const auto& [id, surface] : world().surfaces)
        types[id] = surface.type;
    const auto isShadow = [&](std::uint32_t gfxObj) {
        for (const dat::GfxObj& g : world().gfxObjs) {
            if (g.id != gfxObj)
                continue;
            Aabb box;
            for (const auto& polygon : modelPolygons(gfxObj))
                for (const Vec3& p : polygon)
                    box.include(p);
            return box.max.z < 0.02 && g.surfaces.size() == 1 &&
                   (types.at(g.surfaces[0]) & dat::Surface::kAlpha) != 0;
        }
        return false;
    };
    for (const Json& villager : listOf("villagers")) {
        const std::uint32_t id = idOf(villager.at("model"));
        for (const dat::Setup& setup : world().setups)
            if (setup.id == id)
                EXPECT_GE(std::count_if(setup.parts.begin(), setup.parts.end(), isShadow), 1)
                    << villager.at("name") << ": the carter's cart has a second one";
    }
}

TEST(Villagers, fourOrMoreWalkThroughDoors) {
    std::set<std::string> throughDoors;
    for (const Json& route : listOf("routes")) {
        const std::vector<RoutePoint> points = routePoints(route);
        for (const Json& door : listOf("doors")) {
            const DoorOpening opening = openingOf(door);
            for (std::size_t i = 0; i + 1 < points.size(); ++i) {
                const Vec3 a = inVillage(points[i].at);
                const Vec3 b = inVillage(points[i + 1].at);
                const double da = opening.plane.signedDistance(a);
                const double db = opening.plane.signedDistance(b);
                if (door.at("opaque").get<bool>() && da * db < 0.0 &&
                    containsProjection(opening.polygon, opening.plane.n, a + (b - a) * (da / (da - db)), 0.0))
                    throughDoors.insert(route.at("name").get<std::string>());
            }
        }
    }
    EXPECT_GE(throughDoors.size(), 4u);
}

TEST(Emitters, areWhereTheySayAndTranslucent) {
    std::set<std::string> villagers;
    for (const Json& villager : listOf("villagers"))
        villagers.insert(villager.at("name").get<std::string>());
    std::map<std::uint32_t, std::uint32_t> types;
    for (const auto& [id, surface] : world().surfaces)
        types[id] = surface.type;
    std::set<std::string> names;
    bool additive = false;
    bool alpha = false;
    for (const Json& emitter : listOf("emitters")) {
        EXPECT_TRUE(names.insert(emitter.at("name").get<std::string>()).second);
        const std::uint32_t type = types.at(idOf(emitter.at("surface")));
        EXPECT_NE(type & (dat::Surface::kAlpha | dat::Surface::kAdditive), 0u) << emitter.at("name");
        additive = additive || (type & dat::Surface::kAdditive) != 0;
        alpha = alpha || (type & dat::Surface::kAlpha) != 0;
        EXPECT_GT(emitter.at("rate").get<double>(), 0.0);
        EXPECT_GT(emitter.at("life").get<double>(), 0.0);
        const std::string carrier = emitter.at("attachedTo").get<std::string>();
        if (!carrier.empty()) {
            EXPECT_EQ(villagers.count(carrier), 1u);
            EXPECT_LT(glm::length(vectorOf(emitter.at("position"))), 3.0);
            continue;
        }
        const std::string cell = emitter.at("cell").get<std::string>();
        const world::SpaceIndex space =
            cell == "outside" ? world::kOutside : world::findCell(loaded(), idOf(emitter.at("cell")));
        EXPECT_EQ(motion::locate(loaded(), vectorOf(emitter.at("position"))).space, space)
            << emitter.at("name");
    }
    EXPECT_TRUE(additive && alpha);
}

} // namespace
} // namespace limen::worlds::test
