// The special cases in tower, cave and dungeons are in the records.
#include "worlds/Shell.h"
#include "worlds/builtin/land/Stream.h"
#include "worlds/builtin/land/TerrainShape.h"

#include <gtest/gtest.h>
#include <map>
#include <set>

namespace limen::worlds::test {
namespace {

const dat::EnvCell& cellOfPlace(const char* name) {
    const auto& place = world().worldFile.at("places").at(name);
    return *findCell(
        static_cast<std::uint32_t>(std::stoul(place.at("cell").get<std::string>(), nullptr, 16)));
}

/// The number of openings from one cell to each reachable cell, without passing `without`.
std::map<std::uint32_t, int> stepsFrom(const dat::EnvCell& from, std::uint32_t without = 0) {
    std::map<std::uint32_t, int> steps{{from.id, 0}};
    std::vector<const dat::EnvCell*> order{&from};
    for (std::size_t i = 0; i < order.size(); ++i) {
        for (const dat::CellPortal& portal : order[i]->portals) {
            const dat::EnvCell* next = behind(*order[i], portal);
            if (next != nullptr && next->id != without &&
                steps.try_emplace(next->id, steps[order[i]->id] + 1).second)
                order.push_back(next);
        }
    }
    return steps;
}

std::size_t countCells(dat::BlockCoord block) {
    return static_cast<std::size_t>(
        std::count_if(world().envCells.begin(), world().envCells.end(),
                      [&](const dat::EnvCell& c) { return blockOf(c.id) == block; }));
}

const dat::LandBlockInfo& infoOf(dat::BlockCoord block) {
    return *std::find_if(world().landBlockInfos.begin(), world().landBlockInfos.end(),
                         [&](const auto& info) { return info.id == dat::landBlockInfoId(block); });
}

bool isLevel(const std::vector<Vec3>& polygon) {
    return std::abs(planeOf(polygon).n.z) > 0.999;
}

TEST(Dungeon, hasManyCellsBehindTheCave) {
    const auto& building = infoOf(kCaveBlock).buildings.at(0);
    ASSERT_EQ(building.portals.size(), 1u);
    const dat::EnvCell* mouth = findCell(0xAAB50000u | building.portals[0].otherCellId);
    ASSERT_NE(mouth, nullptr);
    const auto steps = stepsFrom(*mouth);
    EXPECT_GE(steps.size(), 120u);
    EXPECT_EQ(steps.size(), countCells(kCaveBlock)) << "none of it is shut off";
    EXPECT_GT(steps.at(cellOfPlace("dungeon.hub").id), 8);
    EXPECT_GT(steps.at(cellOfPlace("dungeon.pit").id), 16);
}

TEST(Dungeon, groundRunsStraightThroughTheCave) {
    const auto mouth = boundsOf(*findCell(0xAAB50100u));
    const Vec3 middle = mouth.centre();
    const Vec3 area = toArea(kCaveBlock, middle);
    const double atMouth = groundHeight(area.x, toArea(kCaveBlock, mouth.min).y);
    EXPECT_LT(atMouth, mouth.max.z - 3.0) << "below the opening's sill";
    EXPECT_GT(groundHeight(area.x, toArea(kCaveBlock, mouth.max).y), mouth.min.z + 0.5)
        << "rises through the cell";
    for (const dat::EnvCell& cell : world().envCells) {
        if (blockOf(cell.id) == kCaveBlock && (cell.id & 0xFFFF) > 0x104) {
            const Aabb box = boundsOf(cell);
            const Vec3 at = toArea(kCaveBlock, box.centre());
            EXPECT_GT(groundHeight(at.x, at.y), box.max.z + 1.0) << std::hex << cell.id;
        }
    }
}

TEST(Dungeon, hubHasManyExitsTwoOfThemIntoOneCell) {
    const dat::EnvCell& hub = cellOfPlace("dungeon.hub");
    std::map<std::uint32_t, int> exits;
    for (const dat::CellPortal& portal : hub.portals) {
        ASSERT_NE(behind(hub, portal), nullptr);
        ++exits[behind(hub, portal)->id];
    }
    EXPECT_GE(exits.size(), 5u);
    EXPECT_EQ(std::count_if(exits.begin(), exits.end(), [](const auto& e) { return e.second == 2; }), 1);
}

TEST(Dungeon, everyTwoExitsOfTheHubAreJoinedByLoopsOfSeveralLengths) {
    const dat::EnvCell& hub = cellOfPlace("dungeon.hub");
    std::set<int> lengths;
    for (const dat::CellPortal& from : hub.portals) {
        const auto steps = stepsFrom(*behind(hub, from), hub.id);
        for (const dat::CellPortal& to : hub.portals) {
            const auto found = steps.find(behind(hub, to)->id);
            ASSERT_NE(found, steps.end());
            lengths.insert(found->second);
        }
    }
    EXPECT_GE(lengths.size(), 4u);
}

TEST(Dungeon, oneCorridorIsSeenDownItsTwelveCells) {
    // East of the hub, at eye height.
    const dat::EnvCell& hub = cellOfPlace("dungeon.hub");
    const Vec3 start(boundsOf(hub).centre().x, boundsOf(hub).centre().y, boundsOf(hub).min.z + 1.7);
    std::set<std::uint32_t> seen;
    double length = 0.0;
    for (bool inside = true; inside; length += 0.25) {
        inside = false;
        for (const dat::EnvCell& cell : world().envCells) {
            if (blockOf(cell.id) == kCaveBlock && contains(cell, start + Vec3(length, 0.0, 0.0))) {
                seen.insert(cell.id);
                inside = true;
            }
        }
    }
    EXPECT_GE(length, 60.0);
    EXPECT_GE(seen.size(), 12u + 2u);
}

TEST(Dungeon, pitIsAShaftOfCellsWithGalleriesOnThreeFloors) {
    const dat::EnvCell* shaft = nullptr;
    const dat::EnvCell& gallery = cellOfPlace("dungeon.pit");
    std::map<std::uint32_t, int> times;
    for (const dat::CellPortal& portal : gallery.portals)
        if (++times[portal.otherCellId] == 2)
            shaft = behind(gallery, portal);
    ASSERT_NE(shaft, nullptr) << "two openings from the gallery into one cell of the shaft";
    std::set<std::uint32_t> column{shaft->id};
    std::vector<const dat::EnvCell*> order{shaft};
    std::size_t floors = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        floors += order[i]->portals.size() >= 9 ? 1 : 0; // eight openings into galleries
        for (std::size_t k = 0; k < order[i]->portals.size(); ++k) {
            const dat::EnvCell* next = behind(*order[i], order[i]->portals[k]);
            if (isLevel(portalPoints(*order[i], k)) && column.insert(next->id).second)
                order.push_back(next);
        }
    }
    EXPECT_GE(column.size(), 6u);
    EXPECT_EQ(floors, 3u);
}

TEST(Dungeon, hollowRoomLooksAtItselfAcrossTheYard) {
    for (const dat::EnvCell& cell : world().envCells) {
        if (isConvex(cell))
            continue;
        std::map<std::uint32_t, std::vector<Vec3>> ways;
        for (std::size_t k = 0; k < cell.portals.size(); ++k)
            ways[cell.portals[k].otherCellId].push_back(planeOf(portalPoints(cell, k)).n);
        const auto yard =
            std::find_if(ways.begin(), ways.end(), [](const auto& w) { return w.second.size() == 2; });
        ASSERT_NE(yard, ways.end());
        EXPECT_NEAR(glm::dot(yard->second[0], yard->second[1]), -1.0, 1e-9) << "the windows face each other";
    }
}

TEST(Dungeon, openingsAreOfManyShapes) {
    std::map<std::size_t, int> corners;
    int slanted = 0;
    for (const dat::EnvCell& cell : world().envCells) {
        for (std::size_t k = 0; k < cell.portals.size(); ++k) {
            const std::vector<Vec3> p = portalPoints(cell, k);
            std::size_t n = 0;
            for (std::size_t i = 0; i < p.size(); ++i) {
                const Vec3 a = glm::normalize(p[(i + 1) % p.size()] - p[i]);
                const Vec3 b = glm::normalize(p[(i + 2) % p.size()] - p[(i + 1) % p.size()]);
                n += glm::length(glm::cross(a, b)) > 1e-3 ? 1 : 0;
            }
            ++corners[n];
            const Vec3 normal = planeOf(p).n;
            slanted += std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)}) < 0.9 ? 1 : 0;
        }
    }
    EXPECT_GT(corners[4], 20);
    EXPECT_GT(corners[8], 5) << "eight-sided hatches";
    EXPECT_GT(corners[10], 5) << "the rock tunnel";
    EXPECT_GT(corners[11], 100) << "arches";
    EXPECT_GT(slanted, 8) << "in walls at 45 degrees";
}

TEST(Dungeon, sealedPartIsABlockOfItsOwnWithoutLand) {
    const dat::EnvCell& hall = cellOfPlace("dungeon.sealed");
    const dat::BlockCoord block = blockOf(hall.id);
    EXPECT_EQ(stepsFrom(hall).size(), countCells(block));
    EXPECT_GE(countCells(block), 5u);
    EXPECT_TRUE(infoOf(block).buildings.empty());
    for (const dat::EnvCell& cell : world().envCells)
        for (const dat::CellPortal& portal : cell.portals)
            EXPECT_TRUE(blockOf(cell.id) != block || portal.otherCellId != dat::kOutdoors);
    const auto land = std::find_if(world().landBlocks.begin(), world().landBlocks.end(),
                                   [&](const auto& b) { return b.id == dat::landBlockId(block); });
    ASSERT_NE(land, world().landBlocks.end());
    EXPECT_TRUE(std::all_of(land->heights.begin(), land->heights.end(), [](auto h) { return h == 0; }));
    EXPECT_GT(std::max(std::abs(block.x - kVillage.x), std::abs(block.y - kVillage.y)), 16);
}

TEST(Dungeon, onlyTheCaveNearItsMouthSeesOutside) {
    std::size_t seeing = 0;
    for (const dat::EnvCell& cell : world().envCells) {
        const bool sees = (cell.flags & dat::EnvCell::kSeenOutside) != 0;
        if (blockOf(cell.id) == kCaveBlock && sees) {
            ++seeing;
            EXPECT_LT(cell.id & 0xFFFF, 0x110u);
        }
    }
    EXPECT_GE(seeing, 2u);
}

TEST(Tower, floorsAreJoinedByLevelOpeningsAndTheLastLeadsOutside) {
    const dat::EnvCell* cell = findCell(0xA9B50100u);
    std::vector<double> heights;
    for (bool climbing = true; climbing;) {
        climbing = false;
        for (std::size_t k = 0; k < cell->portals.size(); ++k) {
            const std::vector<Vec3> polygon = portalPoints(*cell, k);
            if (isLevel(polygon) && (heights.empty() || polygon[0].z > heights.back())) {
                heights.push_back(polygon[0].z);
                cell = behind(*cell, cell->portals[k]);
                climbing = cell != nullptr;
                break;
            }
        }
        if (cell == nullptr)
            break;
    }
    EXPECT_EQ(cell, nullptr) << "ends outside";
    EXPECT_EQ(heights.size(), 5u) << "ceiling and floor twice, the roof";
    EXPECT_GT(heights.back() - heights.front(), 9.0);
}

TEST(Tower, stepsAreLowEnoughToClimb) {
    // The stair's level faces without those of its rail; each can be reached from the one below.
    const dat::EnvCell& room = *findCell(0xA9B50100u);
    std::vector<double> treads{boundsOf(room).min.z};
    for (const dat::Setup& setup : world().setups) {
        if (setup.id != room.statics.at(0).model)
            continue;
        for (const dat::GfxObj& g : world().gfxObjs) {
            for (const auto& [id, polygon] : g.polygons) {
                const std::vector<Vec3> p = pointsOf(g.vertexArray, polygon, room.statics[0].frame);
                if (g.id == setup.parts.at(0) && planeOf(p).n.z > 0.99 && glm::length(newellNormal(p)) > 0.1)
                    treads.push_back(p[0].z);
            }
        }
    }
    std::sort(treads.begin(), treads.end());
    ASSERT_GT(treads.size(), 20u);
    for (std::size_t i = 0; i + 1 < treads.size(); ++i)
        EXPECT_LT(treads[i + 1] - treads[i], 0.6);
    EXPECT_NEAR(treads.back(), boundsOf(*findCell(0xA9B50102u)).min.z, 0.1);
}

TEST(Land, isAsHighAsEverWhereHousesStand) {
    for (const double x : {264.0, 276.0, 288.0})
        for (const double y : {264.0, 290.0, 312.0})
            EXPECT_EQ(groundHeight(x, y), siteLevel());
    EXPECT_EQ(siteLevel(), 29.921875);
}

TEST(Land, waysNeverJump) {
    for (const VertexPath& way : {wholeLane(), towerTrack(), caveTrack()}) {
        for (std::size_t i = 0; i + 1 < way.size(); ++i) {
            EXPECT_EQ(std::max(std::abs(way[i + 1].first - way[i].first),
                               std::abs(way[i + 1].second - way[i].second)),
                      1);
        }
    }
    EXPECT_EQ(wholeLane().front().first, kFirstVertex);
    EXPECT_EQ(wholeLane().back().first, kLastVertex);
}

TEST(Land, streamRunsDownhillBelowItsBanksAndKeepsOffTheWays) {
    const auto height = [](int vx, int vy) { return groundHeight(vx * kLandcell, vy * kLandcell); };
    const auto& stream = streamPath();
    const auto wet = [&](int vx, int vy) {
        return std::find(stream.begin(), stream.end(), std::pair{vx, vy}) != stream.end();
    };
    for (std::size_t i = 0; i < stream.size(); ++i) {
        const auto [vx, vy] = stream[i];
        if (i > 0) {
            EXPECT_EQ(std::abs(vx - stream[i - 1].first) + std::abs(vy - stream[i - 1].second), 1);
            EXPECT_LE(height(vx, vy), height(stream[i - 1].first, stream[i - 1].second));
        }
        for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
            const bool land = vx + dx >= kFirstVertex && vx + dx <= kLastVertex && vy + dy >= kFirstVertex &&
                              vy + dy <= kLastVertex;
            EXPECT_TRUE(!land || wet(vx + dx, vy + dy) || height(vx + dx, vy + dy) > height(vx, vy) + 0.4)
                << vx << " " << vy;
        }
    }
    for (const VertexPath& way : {wholeLane(), towerTrack(), caveTrack()})
        for (const auto& [vx, vy] : way)
            EXPECT_GT(distanceToStream(vx, vy), 1.9);
}

} // namespace
} // namespace limen::worlds::test
