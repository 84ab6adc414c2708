#include "worlds/builtin/land/TerrainShape.h"

#include "worlds/builtin/land/Stream.h"
#include "worlds/pictures/Noise.h"

#include <algorithm>
#include <array>

namespace limen::worlds {

namespace {

/// The period of noise, in vertices.
constexpr double kNoisePeriod = 24.0;

/// A level site: its bounds in vertices, and the width of the transition to natural ground, in vertices.
struct Site {
    double west, east, south, north;
    int index; ///< index of its height
    double reach;
};
/// The landcells of the cottages, the inn and the meeting hall.
constexpr Site kVillageSite{11.0, 13.0, 11.0, 13.0, 85, 3.2};
constexpr Site kTower{12.0, 13.0, 20.0, 21.0, 140, 2.0};
constexpr Site kCave{19.0, 20.0, 16.0, 17.0, 100, 1.0};

double distanceTo(const Site& site, double vx, double vy) {
    const double dx = std::max({site.west - vx, vx - site.east, 0.0});
    const double dy = std::max({site.south - vy, vy - site.north, 0.0});
    return std::hypot(dx, dy);
}
double distanceToSite(double vx, double vy) {
    return distanceTo(kVillageSite, vx, vy);
}

double distanceToLane(double vx, double vy) {
    double nearest = 1e9;
    for (const VertexPath& path : {wholeLane(), towerTrack(), caveTrack()})
        for (const auto& [lx, ly] : path)
            nearest = std::min(nearest, std::hypot(lx - vx, ly - vy));
    return nearest;
}

/// Heights (metres) of the hill below the tower and of the steep hill with the cave.
double landmarks(double vx, double vy) {
    const double knoll =
        16.0 * std::exp(-((vx - 12.5) * (vx - 12.5) + (vy - 20.5) * (vy - 20.5)) / (2.0 * 1.9 * 1.9));
    const double across = (vx - 19.5) / 2.4;
    const double crag = 21.0 * smoothStep(17.0, 18.3, vy) * (1.0 - 0.7 * smoothStep(20.0, 24.0, vy)) *
                        std::exp(-0.5 * across * across);
    return knoll + crag;
}

/// Heights (metres) of the hills and valleys beyond the first hills.
double farHills(double vx, double vy) {
    const double u = vx / (2.0 * kNoisePeriod) + 0.37;
    const double v = vy / (2.0 * kNoisePeriod) + 0.61;
    const double far = std::max(std::abs(vx - 12.0), std::abs(vy - 12.0));
    return smoothStep(11.0, 15.0, far) * 24.0 * fbm(u, v, 5, 5, 3, 4021) +
           smoothStep(15.0, 20.0, far) * 22.0 * (0.6 + 0.8 * fbm(u, v, 4, 4, 2, 4023));
}

/// Natural height (metres) before it is rounded to the Region's table.
double wildHeight(double vx, double vy) {
    const double u = vx / kNoisePeriod;
    const double v = vy / kNoisePeriod;
    const double rolling = 5.5 * fbm(u, v, 5, 5, 3, 4001);
    const double far = std::max(std::abs(vx - 12.0), std::abs(vy - 12.0));
    const double rim = 27.0 * smoothStep(6.5, 12.0, far) * (0.8 + 0.9 * fbm(u, v, 4, 4, 2, 4003));
    const double hill =
        24.0 * std::exp(-((vx - 3.4) * (vx - 3.4) + (vy - 17.2) * (vy - 17.2)) / (2.0 * 2.3 * 2.3));
    const double northSlope = 11.0 * smoothStep(13.0, 18.0, vy);
    const double southDip = -3.5 * std::exp(-(vy - 9.0) * (vy - 9.0) / 3.0);
    double height = heightOfIndex(kVillageSite.index) + rolling + rim + hill + northSlope + southDip +
                    landmarks(vx, vy) + farHills(vx, vy);
    height = cutByStream(height, vx, vy);
    for (const Site& site : {kVillageSite, kTower, kCave}) {
        const double level = heightOfIndex(site.index);
        height = level + (height - level) * smoothStep(0.0, site.reach, distanceTo(site, vx, vy));
    }
    return height;
}

int heightIndex(int vx, int vy) {
    const double wanted = wildHeight(vx, vy);
    int best = 0;
    for (int i = 1; i < 256; ++i)
        if (std::abs(heightOfIndex(i) - wanted) < std::abs(heightOfIndex(best) - wanted))
            best = i;
    return best;
}

double vertexHeight(int vx, int vy) {
    return heightOfIndex(heightIndex(vx, vy));
}

struct Cover {
    TerrainKind kind = TerrainKind::Grassland;
    std::uint32_t scene = 0;
};

Cover coverAt(int vx, int vy) {
    const double u = vx / kNoisePeriod;
    const double v = vy / kNoisePeriod;
    const double site = distanceToSite(vx, vy);
    const double lane = distanceToLane(vx, vy);
    const double stream = distanceToStream(vx, vy);
    if (stream < 0.5)
        return {TerrainKind::RunningWater, 0};
    if (site < 0.5)
        return vy == 12 ? Cover{TerrainKind::PackedDirt, 1} : Cover{TerrainKind::LushGrass, 1};
    const double slope = std::hypot(wildHeight(vx + 0.5, vy) - wildHeight(vx - 0.5, vy),
                                    wildHeight(vx, vy + 0.5) - wildHeight(vx, vy - 0.5));
    const double wood = fbm(u, v, 5, 5, 3, 4011) + 0.16 * smoothStep(14.5, 18.0, vy) -
                        0.5 * std::exp(-std::pow(std::hypot(vx - 3.4, vy - 17.2) / 1.6, 2.0));
    if (distanceTo(kTower, vx, vy) < 0.5 || distanceTo(kCave, vx, vy) < 0.5)
        return {TerrainKind::PatchyGrass, 0};
    if (slope > 11.5)
        return {TerrainKind::BarrenRock, 1};
    if (stream < 1.5)
        return {TerrainKind::LushGrass, 2}; // no trees, because plants here may be in the water
    if (wood > 0.02 && lane > 1.4 && site > 1.9) {
        return hash(static_cast<std::uint32_t>(vx), static_cast<std::uint32_t>(vy), 4013) % 4 == 0
                   ? Cover{TerrainKind::Moss, 1}
                   : Cover{TerrainKind::ForestFloor, wood > 0.2 ? 2u : 1u};
    }
    if (wood > -0.05 && lane > 1.1 && site > 1.5)
        return {TerrainKind::Grassland, 2};
    if (lane < 0.9)
        return {TerrainKind::PatchyGrass, 1};
    return fbm(u, v, 8, 8, 2, 4015) > 0.05 ? Cover{TerrainKind::LushGrass, 1}
                                           : Cover{TerrainKind::Grassland, 1};
}

std::uint16_t terrainWord(int vx, int vy) {
    const Cover cover = coverAt(vx, vy);
    bool road = false;
    for (const VertexPath& path : {wholeLane(), towerTrack(), caveTrack()})
        road = road || std::find(path.begin(), path.end(), std::pair{vx, vy}) != path.end();
    return static_cast<std::uint16_t>((road ? 1u : 0u) | static_cast<std::uint32_t>(cover.kind) << 2 |
                                      cover.scene << 11);
}

/// docs/formats/landscape.md#triangles: true if the landcell's diagonal runs from south-west to north-east.
bool splitsSouthWest(int vx, int vy) {
    const auto x = static_cast<std::uint32_t>(kSouthWest.x * kCellsPerBlock + vx);
    const auto y = static_cast<std::uint32_t>(kSouthWest.y * kCellsPerBlock + vy);
    return x * y * 0x0CCAC033u + y * 0x6C1AC587u - x * 0x421BE3BDu - 0x519B8F25u >= 0x80000000u;
}

} // namespace

double heightOfIndex(int index) {
    return std::round((0.25 * index + 0.0012 * index * index) * 64.0) / 64.0;
}

double siteLevel() {
    return heightOfIndex(kVillageSite.index);
}
double towerLevel() {
    return heightOfIndex(kTower.index);
}
double caveLevel() {
    return heightOfIndex(kCave.index);
}

double groundHeight(double x, double y) {
    const int cx = std::clamp(static_cast<int>(std::floor(x / kLandcell)), kFirstVertex, kLastVertex - 1);
    const int cy = std::clamp(static_cast<int>(std::floor(y / kLandcell)), kFirstVertex, kLastVertex - 1);
    const double fx = x / kLandcell - cx;
    const double fy = y / kLandcell - cy;
    const double sw = vertexHeight(cx, cy);
    const double se = vertexHeight(cx + 1, cy);
    const double ne = vertexHeight(cx + 1, cy + 1);
    const double nw = vertexHeight(cx, cy + 1);
    if (splitsSouthWest(cx, cy))
        return fx >= fy ? sw + (se - sw) * fx + (ne - se) * fy : sw + (ne - nw) * fx + (nw - sw) * fy;
    return fx + fy <= 1.0 ? sw + (se - sw) * fx + (nw - sw) * fy
                          : ne + (nw - ne) * (1.0 - fx) + (se - ne) * (1.0 - fy);
}

VertexPath lanePath() {
    VertexPath path{{0, 18}, {1, 18}, {2, 17}, {3, 16}, {4, 15}, {5, 14}, {6, 13}, {7, 13}};
    for (int x = 8; x <= 15; ++x)
        path.emplace_back(x, 12);
    path.insert(path.end(),
                {{16, 11}, {17, 10}, {18, 9}, {19, 9}, {20, 9}, {21, 8}, {22, 8}, {23, 8}, {24, 7}});
    return path;
}

VertexPath wholeLane() {
    VertexPath path{{-8, 21}, {-7, 21}, {-6, 20}, {-5, 20}, {-4, 20}, {-3, 19}, {-2, 18}, {-1, 18}};
    const VertexPath middle = lanePath();
    path.insert(path.end(), middle.begin(), middle.end());
    path.insert(path.end(), {{25, 7}, {26, 7}, {27, 6}, {28, 5}, {29, 5}, {30, 5}, {31, 4}, {32, 4}});
    return path;
}

VertexPath towerTrack() {
    return {{9, 12}, {9, 13}, {9, 14}, {9, 15}, {9, 16}, {10, 17}, {11, 18}, {12, 19}};
}
VertexPath caveTrack() {
    return {{15, 12}, {16, 13}, {17, 14}, {18, 15}, {19, 16}};
}

double landHeight(double x, double y) {
    constexpr double kBelowHeights = 0.01;
    return groundHeight(x, y) - kBelowHeights;
}

Vec3 overVertex(std::pair<int, int> vertex, double height) {
    const double x = vertex.first * kLandcell;
    const double y = vertex.second * kLandcell;
    return toGlobal({x, y, groundHeight(x, y) + height});
}

Vec3 toGlobal(const Vec3& area) {
    return area + Vec3(kSouthWest.x * kBlockMetres, kSouthWest.y * kBlockMetres, 0.0);
}
Vec3 toArea(dat::BlockCoord block, const Vec3& local) {
    return local +
           Vec3((block.x - kSouthWest.x) * kBlockMetres, (block.y - kSouthWest.y) * kBlockMetres, 0.0);
}

void addLandBlocks(WorldRecords& records, const std::vector<dat::BlockCoord>& withObjects) {
    for (int bx = 0; bx < kBlocksAcross; ++bx) {
        for (int by = 0; by < kBlocksAcross; ++by) {
            const dat::BlockCoord coord{kSouthWest.x - kBlocksBeyond + bx, kSouthWest.y - kBlocksBeyond + by};
            dat::LandBlock block;
            block.id = dat::landBlockId(coord);
            block.hasObjects =
                std::find(withObjects.begin(), withObjects.end(), coord) != withObjects.end() ? 1u : 0u;
            for (int x = 0; x <= kCellsPerBlock; ++x) {
                for (int y = 0; y <= kCellsPerBlock; ++y) {
                    const auto index = static_cast<std::size_t>(x * (kCellsPerBlock + 1) + y);
                    const int vx = kFirstVertex + bx * kCellsPerBlock + x;
                    const int vy = kFirstVertex + by * kCellsPerBlock + y;
                    block.heights[index] = static_cast<std::uint8_t>(heightIndex(vx, vy));
                    block.terrain[index] = terrainWord(vx, vy);
                }
            }
            records.landBlocks.push_back(block);
        }
    }
}

} // namespace limen::worlds
