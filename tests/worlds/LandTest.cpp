#include "worlds/Loaded.h"
#include "worlds/Standing.h"
#include "worlds/builtin/buildings/Cottages.h"
#include "worlds/builtin/land/PlantMeshes.h"
#include "worlds/builtin/land/Stream.h"
#include "worlds/builtin/land/TerrainShape.h"
#include "worlds/pictures/Painters.h"

#include <gtest/gtest.h>

// The pictures of the ground, and the things that stand on it.
namespace limen::worlds::test {
namespace {

double brightness(const Vec4f& texel) {
    return (static_cast<double>(texel.x) + static_cast<double>(texel.y) + static_cast<double>(texel.z)) / 3.0;
}

/// The greatest difference between the mean brightness of a stripe and that of the picture, as a share of the latter.
double stripes(const Canvas& picture, bool rows) {
    constexpr int kWide = 16; // texels across a stripe
    const int size = picture.width();
    std::vector<double> sums(static_cast<std::size_t>(size / kWide), 0.0);
    double all = 0.0;
    for (int i = 0; i < size * size; ++i) {
        const double b = brightness(picture.at(i % size, i / size));
        sums[static_cast<std::size_t>((rows ? i / size : i % size) / kWide)] += b;
        all += b;
    }
    double worst = 0.0;
    for (const double sum : sums)
        worst = std::max(worst, std::abs(sum * static_cast<double>(sums.size()) / all - 1.0));
    return worst;
}

TEST(GroundPictures, ofLanesHaveNoDirection) {
    const Canvas road = paintRoad();
    EXPECT_LT(stripes(road, true), 0.1);
    EXPECT_LT(stripes(road, false), 0.1);
}

/// Alpha along a border of a blend map: its west edge (`side` 0), north, east, south.
std::vector<float> borderOf(const Canvas& map, int side) {
    std::vector<float> out;
    const int last = map.width() - 1;
    for (int i = 0; i <= last; ++i) {
        const int x = side == 0 ? 0 : side == 2 ? last : i;
        const int y = side == 1 ? 0 : side == 3 ? last : i;
        out.push_back(map.at(x, y).w);
    }
    return out;
}

float difference(const std::vector<float>& a, const std::vector<float>& b) {
    float worst = 0.0f;
    for (std::size_t i = 0; i < a.size(); ++i)
        worst = std::max(worst, std::abs(a[i] - b[i]));
    return worst;
}

TEST(BlendMaps, ofLanesContinueAcrossTheBordersOfLandcells) {
    const Canvas corner = paintBlend(BlendShape::RoadCorner, 1), side = paintBlend(BlendShape::RoadSide, 2),
                 other = paintBlend(BlendShape::RoadSide, 3),
                 diagonal = paintBlend(BlendShape::RoadDiagonal, 4);
    EXPECT_LT(difference(borderOf(side, 1), borderOf(other, 3)), 0.1f) << "a straight lane";
    EXPECT_LT(difference(borderOf(corner, 1), borderOf(diagonal, 1)), 0.1f)
        << "a diagonal and the corner beside it";
    EXPECT_LT(difference(borderOf(corner, 0), borderOf(diagonal, 0)), 0.1f);
}

/// Two landcells with a lane between them have pictures of different seeds, one of them turned by 180 degrees.
TEST(BlendMaps, ofLanesMeetInTheMiddleOfTheirGrass) {
    std::vector<float> first;
    for (const std::uint32_t seed : {2408u, 2409u, 1u, 2u}) {
        std::vector<float> middle = borderOf(paintBlend(BlendShape::RoadSide, seed), 0);
        if (first.empty())
            first = middle;
        EXPECT_LT(difference(middle, first), 0.1f) << seed;
        std::reverse(middle.begin(), middle.end());
        EXPECT_LT(difference(middle, first), 0.1f) << seed << ", turned";
    }
}

TEST(BlendMaps, ofLanesShowGrassInTheMiddleAndNoneOnTheTracks) {
    for (const std::uint32_t seed : {2408u, 2409u}) {
        const Canvas side = paintBlend(BlendShape::RoadSide, seed);
        float middle = 0.0f, track = 0.0f;
        for (int y = 0; y < side.height(); ++y) {
            middle = std::max(middle, side.at(0, y).w);
            track = std::max(track, side.at(side.width() / 17, y).w); // 1.4 m from the middle
        }
        EXPECT_GT(middle, 0.5f);
        EXPECT_LT(track, 0.25f);
    }
}

/// Metres around a vertex up to which water reaches: half a landcell, and the rough, swaying border.
constexpr double kWater = 16.6;

TEST(BlendMaps, ofGroundsMeetAtTheBordersOfLandcellsAndSwayBetweenThem) {
    const Canvas corner = paintBlend(BlendShape::Corner, 2401);
    float leastSway = 1e9f;
    for (const std::uint32_t seed : {2404u, 2405u, 2406u}) {
        const Canvas side = paintBlend(BlendShape::Side, seed);
        EXPECT_LT(difference(borderOf(side, 1), borderOf(side, 3)), 0.1f) << "its two ends";
        EXPECT_LT(difference(borderOf(side, 1), borderOf(corner, 1)), 0.1f) << "a corner beside it";
        float most = 0.0f, least = 1.0f; // share of the landcell that the overlay covers, by rows
        for (int y = 0; y < side.height(); ++y) {
            float covered = 0.0f;
            for (int x = 0; x < side.width(); ++x) {
                covered += 1.0f - side.at(x, y).w;
                if (x > side.width() * kWater / kLandcell)
                    EXPECT_GT(side.at(x, y).w, 0.5f) << seed << " " << x << "," << y;
            }
            most = std::max(most, covered / static_cast<float>(side.width()));
            least = std::min(least, covered / static_cast<float>(side.width()));
        }
        leastSway = std::min(leastSway, most - least);
    }
    EXPECT_GT(leastSway, 0.08f) << "2 m";
}

TEST(BlendMaps, ofGroundsCutCorners) {
    // Two corners in a diagonal: the border between them is nearly straight, not an arc around each vertex.
    constexpr std::uint32_t kSeeds = 12; // the roughness of one map is as large as the cut
    double covered = 0.0;
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
        const Canvas corner = paintBlend(BlendShape::Corner, seed);
        double one = 0.0;
        for (int y = 0; y < corner.height(); ++y)
            for (int x = 0; x < corner.width(); ++x)
                one += 1.0 - static_cast<double>(corner.at(x, y).w);
        covered += one / (corner.width() * corner.height()) / kSeeds;
    }
    EXPECT_NEAR(covered, 0.160, 0.01) << "a triangle has 0.125, a quarter of a circle 0.196";
}

TEST(Scenery, isNeverInTheStream) {
    std::size_t count = 0;
    for (const world::Instance& instance : loaded().instances) {
        if (instance.kind != world::InstanceKind::Scenery)
            continue;
        ++count;
        const Vec3 at = instance.bounds.centre - toGlobal(Vec3(0.0));
        EXPECT_GT(kLandcell * distanceToStream(at.x / kLandcell, at.y / kLandcell), kWater)
            << at.x << " " << at.y;
    }
    EXPECT_GT(count, 1000u);
}

/// The greatest half width of a mesh at and below a height.
double reachBelow(const FaceMesh& mesh, double z, bool below) {
    double most = 0.0;
    for (const Face& face : mesh.faces())
        for (const Vec3& p : face.points)
            if ((p.z <= z) == below)
                most = std::max(most, std::hypot(p.x, p.y));
    return most;
}

TEST(Stones, doNotNarrowTowardsTheGround) {
    for (const std::uint32_t seed : {3041u, 3043u}) {
        for (const int step : {1, 2}) {
            const FaceMesh stone = stoneMesh({1.5, 1.2, 1.1}, seed, step);
            EXPECT_GE(reachBelow(stone, 0.0, true), reachBelow(stone, 0.0, false)) << seed << " " << step;
            for (const Face& face : stone.faces()) {
                const bool under = std::all_of(face.points.begin(), face.points.end(),
                                               [](const Vec3& p) { return p.z < -1.0; });
                EXPECT_TRUE(under || faceNormal(face).z > -0.1) << seed << " " << step;
            }
        }
    }
}

/// Width and length of a rectangle's polygon.
std::pair<double, double> sizeOf(const Standing& s) {
    double shortest = 1e300, longest = 0.0;
    for (std::size_t i = 0; i < s.points.size(); ++i) {
        const double length = glm::length(s.points[(i + 1) % s.points.size()] - s.points[i]);
        shortest = std::min(shortest, length);
        longest = std::max(longest, length);
    }
    return {shortest, longest};
}

TEST(Exteriors, haveNoLongLevelLedgesNearTheGround) {
    std::size_t slopes = 0;
    for (const Standing& s : standingPolygons()) {
        if (s.kind != SurfaceKind::Exterior || s.points.size() != 4)
            continue;
        const auto [width, length] = sizeOf(s);
        const bool ledge =
            width < 0.15 && length > 1.5 && s.box.max.z < siteLevel() + kFloorAboveGround + 0.5;
        EXPECT_FALSE(ledge && s.plane.n.z > 0.99) << s.name << " " << s.box.min.x << " " << s.box.min.y;
        slopes += width < 0.2 && length > 1.5 && s.plane.n.z > 0.6 && s.plane.n.z < 0.8 ? 1 : 0;
    }
    EXPECT_GT(slopes, 8u) << "of plinths";
}

} // namespace
} // namespace limen::worlds::test
