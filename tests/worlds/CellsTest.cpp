#include "worlds/Shell.h"
#include "worlds/builtin/buildings/Cottages.h"
#include "worlds/builtin/buildings/Inn.h"
#include "worlds/builtin/land/TerrainShape.h"
#include "worlds/records/Bsp.h"

#include <gtest/gtest.h>
#include <set>

namespace limen::worlds::test {
namespace {

// Low words of ids. Houses are numbered in the order of addition.
constexpr std::uint32_t kFirstOfInn = 0x109;

std::uint32_t idOf(CottageCell cell) {
    return 0x100 + static_cast<std::uint32_t>(cell);
}
std::uint32_t idOf(InnCell cell) {
    return kFirstOfInn + static_cast<std::uint32_t>(cell);
}

using Point = std::array<double, 3>;
using Edge = std::pair<Point, Point>;

Point key(const Vec3& p) {
    return {p.x, p.y, p.z};
}

std::vector<Edge> edgesOf(const std::vector<Vec3>& polygon) {
    std::vector<Edge> out;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        out.emplace_back(key(polygon[i]), key(polygon[(i + 1) % polygon.size()]));
    return out;
}

TEST(Cells, everyEdgeHasExactlyOnePartnerRunningTheOtherWay) {
    for (const dat::EnvCell& cell : world().envCells) {
        const dat::CellStruct& shape = shapeOf(cell);
        std::map<Edge, int> count;
        for (const auto& [id, polygon] : shape.polygons)
            for (const Edge& e : edgesOf(pointsOf(shape.vertexArray, polygon, cell.position)))
                ++count[e];
        for (const auto& [e, n] : count) {
            EXPECT_EQ(n, 1) << std::hex << cell.id;
            EXPECT_EQ(count.count({e.second, e.first}), 1u)
                << std::hex << cell.id << " edge at " << e.first[0] << " " << e.first[1] << " " << e.first[2];
        }
    }
}

/// The cells of the houses in the village's block.
std::vector<dat::EnvCell> villageCells() {
    std::vector<dat::EnvCell> out;
    for (const dat::EnvCell& cell : world().envCells)
        if (blockOf(cell.id) == kVillage)
            out.push_back(cell);
    return out;
}

TEST(Cells, noFanTriangleOfASurfaceIsFlat) {
    for (const dat::EnvCell& cell : world().envCells) {
        const dat::CellStruct& shape = shapeOf(cell);
        for (const auto& [id, polygon] : shape.polygons) {
            if (polygon.posSurface < 0)
                continue; // openings need no fan: readers triangulate them
            const std::vector<Vec3> p = pointsOf(shape.vertexArray, polygon, cell.position);
            for (std::size_t k = 1; k + 1 < p.size(); ++k) {
                EXPECT_GT(glm::length(glm::cross(p[k] - p[0], p[k + 1] - p[0])), 1e-3)
                    << std::hex << cell.id << " polygon " << id;
            }
        }
    }
}

TEST(Cells, polygonsAreFlatAndConvex) {
    for (const dat::EnvCell& cell : world().envCells) {
        const dat::CellStruct& shape = shapeOf(cell);
        for (const auto& [id, polygon] : shape.polygons) {
            const std::vector<Vec3> p = pointsOf(shape.vertexArray, polygon, cell.position);
            const Plane plane = planeOf(p);
            for (std::size_t k = 0; k < p.size(); ++k) {
                EXPECT_LT(std::abs(plane.signedDistance(p[k])), 1e-4);
                const Vec3 turn =
                    glm::cross(p[(k + 1) % p.size()] - p[k], p[(k + 2) % p.size()] - p[(k + 1) % p.size()]);
                EXPECT_GT(glm::dot(turn, plane.n), -1e-6) << std::hex << cell.id << " polygon " << id;
            }
        }
    }
}

TEST(Cells, portalPairsNameEachOtherAndHaveTheSameCorners) {
    for (const dat::EnvCell& cell : world().envCells) {
        for (std::size_t k = 0; k < cell.portals.size(); ++k) {
            const dat::CellPortal& portal = cell.portals[k];
            EXPECT_EQ(shapeOf(cell).portalPolygons.at(k), portal.polygonId);
            if (portal.otherCellId == dat::kOutdoors)
                continue;
            const dat::EnvCell* other = findCell((cell.id & 0xFFFF0000u) | portal.otherCellId);
            ASSERT_NE(other, nullptr);
            const dat::CellPortal& back = other->portals.at(portal.otherPortalId);
            EXPECT_EQ(back.otherCellId, cell.id & 0xFFFF);
            EXPECT_EQ(back.otherPortalId, k);
            EXPECT_EQ(mismatch(portalPoints(cell, k), portalPoints(*other, portal.otherPortalId)), 0.0);
        }
    }
}

TEST(Cells, interiorLiesOnTheSideThatTheFlagSays) {
    for (const dat::EnvCell& cell : world().envCells) {
        for (std::size_t k = 0; k < cell.portals.size(); ++k) {
            const std::vector<Vec3> polygon = portalPoints(cell, k);
            Vec3 middle(0.0);
            for (const Vec3& p : polygon)
                middle += p / static_cast<double>(polygon.size());
            const Vec3 n = planeOf(polygon).n;
            const bool front = windingAround(cell, middle + n * 0.05) > 0.5;
            EXPECT_NE(front, windingAround(cell, middle - n * 0.05) > 0.5);
            EXPECT_EQ((cell.portals[k].flags & dat::CellPortal::kPortalSide) != 0, front);
        }
    }
}

/// Calls `visit` for points in and around a cell, none within 1 cm of a wall's plane.
template <class Visit>
void forPointsAround(const dat::EnvCell& cell, const Aabb& box, Visit visit) {
    for (int k = 0; k < 343; ++k) {
        const Vec3 t{(k % 7) / 4.9 - 0.11, (k / 7 % 7) / 4.9 - 0.11, (k / 49) / 4.9 - 0.11};
        const Vec3 p = box.min + (box.max - box.min) * t;
        if (distanceToPlanes(cell, p) > 0.01)
            visit(p);
    }
}

/// The planes of a cell's shell, interior in front.
std::vector<Plane> planesOf(const dat::EnvCell& cell) {
    const dat::CellStruct& shape = shapeOf(cell);
    std::vector<Plane> out;
    for (const auto& [id, polygon] : shape.polygons)
        out.push_back(planeOf(pointsOf(shape.vertexArray, polygon, cell.position)));
    return out;
}

std::vector<Vec3> cornersOf(const dat::EnvCell& cell) {
    std::vector<Vec3> out;
    for (const auto& [key, vertex] : shapeOf(cell).vertexArray.vertices)
        out.push_back(apply(cell.position, Vec3(vertex.position)));
    return out;
}

TEST(Cells, areConvexButForTheDungeonsHollowRoom) {
    std::vector<std::uint32_t> hollow;
    for (const dat::EnvCell& cell : world().envCells) {
        const std::vector<Vec3> corners = cornersOf(cell);
        const std::vector<Plane> planes = planesOf(cell);
        const bool convex = std::all_of(planes.begin(), planes.end(), [&](const Plane& plane) {
            return std::all_of(corners.begin(), corners.end(),
                               [&](const Vec3& p) { return plane.signedDistance(p) > -0.0005; });
        });
        if (!convex)
            hollow.push_back(cell.id);
    }
    ASSERT_EQ(hollow.size(), 1u);
    EXPECT_EQ(blockOf(hollow[0]), kCaveBlock);
}

TEST(Cells, cellTreeHoldsTheInsideAndNothingElse) {
    for (const dat::EnvCell& cell : world().envCells) {
        const bool convex = isConvex(cell);
        forPointsAround(cell, boundsOf(cell), [&](const Vec3& p) {
            const double winding = windingAround(cell, p);
            EXPECT_NEAR(winding, std::round(winding), 1e-6);
            if (convex)
                EXPECT_EQ(contains(cell, p), winding > 0.5)
                    << std::hex << cell.id << " " << p.x << " " << p.y << " " << p.z;
            else
                EXPECT_TRUE(winding < 0.5 || contains(cell, p));
        });
    }
}

TEST(Cells, cellTreeOfAConvexCellIsExactToAMillimetre) {
    for (const dat::EnvCell& cell : world().envCells) {
        const Aabb box = boundsOf(cell);
        const std::vector<Plane> planes = planesOf(cell);
        const int points = isConvex(cell) ? 343 : 0;
        for (int k = 0; k < points; ++k) {
            const Vec3 t{(k % 7) / 5.0 - 0.1, (k / 7 % 7) / 5.0 - 0.1, (k / 49) / 5.0 - 0.1};
            const Vec3 p = box.min + (box.max - box.min) * t;
            double depth = 1e300; // distance to the nearest plane of the shell
            for (const Plane& plane : planes)
                depth = std::min(depth, plane.signedDistance(p));
            if (std::abs(depth) > 0.001) {
                EXPECT_EQ(contains(cell, p), depth > 0.0)
                    << std::hex << cell.id << " " << t.x << " " << t.y << " " << t.z;
            }
        }
    }
}

/// True if all corners are behind one of the planes.
bool behindOne(const std::vector<Plane>& planes, const std::vector<Vec3>& corners) {
    return std::any_of(planes.begin(), planes.end(), [&](const Plane& plane) {
        return std::all_of(corners.begin(), corners.end(),
                           [&](const Vec3& p) { return plane.signedDistance(p) < 0.001; });
    });
}

TEST(Cells, ofTheVillageArePartedByAWallOfOneOfThem) {
    const std::vector<dat::EnvCell> cells = villageCells();
    for (std::size_t a = 0; a < cells.size(); ++a) {
        for (std::size_t b = a + 1; b < cells.size(); ++b) {
            // Convex and nearly upright prisms: one of their own planes separates them.
            EXPECT_TRUE(behindOne(planesOf(cells[a]), cornersOf(cells[b])) ||
                        behindOne(planesOf(cells[b]), cornersOf(cells[a])))
                << std::hex << cells[a].id << " " << cells[b].id;
        }
    }
}

TEST(Cells, ofABlockAreDisjointButForThePlacesMeantToOverlap) {
    const auto& cells = world().envCells;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> overlapping;
    for (std::size_t a = 0; a < cells.size(); ++a) {
        const Aabb p = boundsOf(cells[a]);
        for (std::size_t b = a + 1; b < cells.size(); ++b) {
            const Aabb q = boundsOf(cells[b]);
            const Aabb both{glm::max(p.min, q.min), glm::min(p.max, q.max)};
            const Vec3 size = both.max - both.min;
            if (blockOf(cells[a].id) != blockOf(cells[b].id) || std::min({size.x, size.y, size.z}) < 0.02)
                continue;
            bool shared = false;
            forPointsAround(cells[a], both, [&](const Vec3& point) {
                shared =
                    shared || (distanceToPlanes(cells[b], point) > 0.01 &&
                               windingAround(cells[a], point) > 0.5 && windingAround(cells[b], point) > 0.5);
            });
            if (shared)
                overlapping.emplace_back(cells[a].id, cells[b].id);
        }
    }
    // The crypt and the corridor behind it, whose third and fourth cells intersect the crypt.
    ASSERT_EQ(overlapping.size(), 2u);
    EXPECT_EQ(overlapping[0].first, overlapping[1].first);
    EXPECT_EQ(overlapping[0].second, overlapping[0].first + 3);
    EXPECT_EQ(overlapping[1].second, overlapping[0].first + 4);
    EXPECT_EQ(blockOf(overlapping[0].first), kCaveBlock);
}

TEST(Cells, haveTreesForDrawingAndCollision) {
    for (const dat::EnvCell& cell : world().envCells) {
        const dat::CellStruct& shape = shapeOf(cell);
        EXPECT_EQ(shape.physicsPolygons.size() + shape.portalPolygons.size(), shape.polygons.size());
        ASSERT_TRUE(shape.drawingBsp.has_value());
        std::set<std::uint16_t> drawn;
        for (const dat::BspNode& n : shape.drawingBsp->nodes) {
            drawn.insert(n.polygonIds.begin(), n.polygonIds.end());
            for (const dat::PortalRef& ref : n.portals)
                drawn.insert(ref.polygonId);
        }
        EXPECT_EQ(drawn.size(), shape.polygons.size());
        std::set<std::uint16_t> solid;
        for (const dat::BspNode& n : shape.physicsBsp.nodes)
            solid.insert(n.polygonIds.begin(), n.polygonIds.end());
        EXPECT_EQ(solid.size(), shape.physicsPolygons.size());
    }
}

TEST(Cells, ofTheVillageOnlyCellarsCannotSeeOutside) {
    std::set<std::uint32_t> blind;
    for (const dat::EnvCell& cell : villageCells())
        if ((cell.flags & dat::EnvCell::kSeenOutside) == 0)
            blind.insert(cell.id & 0xFFFF);
    // A strip of sky is visible from the inn's basement, up the stairs and through the store's window.
    const std::set<std::uint32_t> blindCells{idOf(CottageCell::CellarDoorway), idOf(CottageCell::Cellar),
                                             idOf(InnCell::VaultArch), idOf(InnCell::Vault)};
    EXPECT_EQ(blind, blindCells);
}

TEST(Cells, listAllCellsOfTheirHouseAsVisible) {
    for (const dat::EnvCell& cell : villageCells()) {
        std::set<std::uint32_t> house{cell.id};
        std::vector<const dat::EnvCell*> order{&cell};
        for (std::size_t i = 0; i < order.size(); ++i) {
            for (const dat::CellPortal& portal : order[i]->portals) {
                const dat::EnvCell* next = behind(*order[i], portal);
                if (next != nullptr && house.insert(next->id).second)
                    order.push_back(next);
            }
        }
        std::set<std::uint32_t> visible;
        for (const auto low : cell.visibleCells)
            visible.insert((cell.id & 0xFFFF0000u) | low);
        EXPECT_EQ(visible, house) << std::hex << cell.id;
    }
}

class Buildings : public ::testing::Test {
protected:
    /// All buildings with the ids of their landblocks.
    static std::vector<std::pair<std::uint32_t, dat::Building>> all() {
        std::vector<std::pair<std::uint32_t, dat::Building>> out;
        for (const dat::LandBlockInfo& info : world().landBlockInfos)
            for (const dat::Building& building : info.buildings)
                out.emplace_back(info.id & 0xFFFF0000u, building);
        return out;
    }
    const dat::GfxObj& model(const dat::Building& building) const {
        return *std::find_if(world().gfxObjs.begin(), world().gfxObjs.end(),
                             [&](const auto& g) { return g.id == building.model; });
    }
};

TEST_F(Buildings, everyPortalIsThePolygonOfTheCellsExit) {
    ASSERT_GE(all().size(), 6u);
    std::size_t exits = 0;
    for (const auto& [block, building] : all()) {
        const dat::GfxObj& exterior = model(building);
        std::map<std::uint16_t, std::uint16_t> polygonOfPortal;
        for (const dat::BspNode& n : exterior.drawingBsp.nodes) {
            EXPECT_EQ(n.tag == dat::BspTag::Port, !n.portals.empty());
            for (const dat::PortalRef& ref : n.portals)
                polygonOfPortal[ref.portalIndex] = ref.polygonId;
        }
        ASSERT_EQ(polygonOfPortal.size(), building.portals.size());
        for (std::size_t k = 0; k < building.portals.size(); ++k) {
            const dat::BuildingPortal& portal = building.portals[k];
            const dat::EnvCell* cell = findCell(block | portal.otherCellId);
            ASSERT_NE(cell, nullptr);
            EXPECT_EQ(cell->portals.at(portal.otherPortalId).otherCellId, dat::kOutdoors);
            const dat::Polygon& polygon =
                exterior.polygons.at(polygonOfPortal.at(static_cast<std::uint16_t>(k))).second;
            const std::vector<Vec3> outer = pointsOf(exterior.vertexArray, polygon, building.frame);
            EXPECT_EQ(mismatch(outer, portalPoints(*cell, portal.otherPortalId)), 0.0);
            // Flag: the outside is on the positive side.
            EXPECT_TRUE((portal.flags & dat::CellPortal::kPortalSide) != 0);
            EXPECT_LT(planeOf(outer).signedDistance(boundsOf(*cell).centre()), 0.0);
            EXPECT_NE(std::find(portal.stabs.begin(), portal.stabs.end(), portal.otherCellId),
                      portal.stabs.end());
            ++exits;
        }
        EXPECT_EQ(building.numLeaves, leafCount(exterior.drawingBsp));
    }
    std::size_t ofCells = 0;
    for (const dat::EnvCell& cell : world().envCells) {
        ofCells += static_cast<std::size_t>(
            std::count_if(cell.portals.begin(), cell.portals.end(),
                          [](const auto& p) { return p.otherCellId == dat::kOutdoors; }));
    }
    EXPECT_EQ(exits, ofCells);
}

TEST_F(Buildings, wallsMeetTheOpeningsEdgeForEdge) {
    for (const auto& [block, building] : all()) {
        const dat::GfxObj& exterior = model(building);
        std::map<Edge, int> count;
        for (const auto& [id, polygon] : exterior.polygons)
            for (const Edge& e : edgesOf(pointsOf(exterior.vertexArray, polygon, building.frame)))
                ++count[e];
        for (const auto& [id, polygon] : exterior.polygons) {
            if ((polygon.stippling & dat::kNoPositiveUv) != 0)
                for (const Edge& e : edgesOf(pointsOf(exterior.vertexArray, polygon, building.frame)))
                    EXPECT_EQ(count.count({e.second, e.first}), 1u) << "an opening's edge without a reveal";
        }
    }
}

TEST_F(Buildings, groundLiesBelowTheFloorAndRunsThroughAboveTheCellar) {
    const dat::Region& region = world().regions.at(0);
    const auto block = std::find_if(world().landBlocks.begin(), world().landBlocks.end(),
                                    [&](const auto& b) { return b.id == dat::landBlockId(kVillage); });
    ASSERT_NE(block, world().landBlocks.end());
    const std::set<std::uint32_t> below{idOf(CottageCell::CellarDoorway), idOf(CottageCell::Cellar),
                                        idOf(InnCell::BasementDoor),      idOf(InnCell::Basement),
                                        idOf(InnCell::VaultArch),         idOf(InnCell::Vault)};
    for (const dat::EnvCell& cell : villageCells()) {
        const Aabb box = boundsOf(cell);
        const auto west = static_cast<std::size_t>(box.min.x / 24.0);
        const auto east = static_cast<std::size_t>(box.max.x / 24.0);
        const auto south = static_cast<std::size_t>(box.min.y / 24.0);
        const auto north = static_cast<std::size_t>(box.max.y / 24.0);
        for (std::size_t x = west; x <= east + 1; ++x) {
            for (std::size_t y = south; y <= north + 1; ++y) {
                const double ground = static_cast<double>(region.landDefs.heights[block->heights[x * 9 + y]]);
                const std::uint32_t id = cell.id & 0xFFFF;
                if (below.count(id) != 0) {
                    EXPECT_GT(ground, box.max.z + 0.02);
                } else if (id == idOf(CottageCell::Stairwell) || id == idOf(InnCell::BasementStairs)) {
                    EXPECT_GT(ground, box.min.z + 1.0);
                    EXPECT_LT(ground, box.max.z - 0.1);
                } else {
                    EXPECT_LT(ground, box.min.z - 0.1);
                }
            }
        }
    }
}

} // namespace
} // namespace limen::worlds::test
