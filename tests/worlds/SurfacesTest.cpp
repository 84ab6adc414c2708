#include "worlds/Standing.h"
#include "worlds/records/Materials.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <set>

namespace limen::worlds::test {
namespace {

constexpr double kSamePlane = 0.002;   ///< metres
constexpr double kSmallArea = 0.0001;  ///< square metres
constexpr double kParallel = 0.999995; ///< cosine; 0.18 degrees

/// Calls `visit` for all pairs whose boxes are nearer than kSamePlane, by a sweep along x.
template <class Visit>
void forNearPairs(const std::vector<Standing>& all, Visit visit) {
    std::vector<const Standing*> sorted;
    for (const Standing& s : all)
        sorted.push_back(&s);
    std::sort(sorted.begin(), sorted.end(),
              [](const auto* a, const auto* b) { return a->box.min.x < b->box.min.x; });
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        for (std::size_t j = i + 1; j < sorted.size(); ++j) {
            const Standing& a = *sorted[i];
            const Standing& b = *sorted[j];
            if (b.box.min.x > a.box.max.x + kSamePlane)
                break;
            const Vec3 gap = glm::max(a.box.min, b.box.min) - glm::min(a.box.max, b.box.max);
            if (std::max(gap.y, gap.z) <= kSamePlane)
                visit(a, b);
        }
    }
}

/// True if their overlap in one plane is larger than kSmallArea.
bool shareAPlane(const Standing& a, const Standing& b) {
    const Overlap overlap = overlapOf(a, b);
    return overlap.area > kSmallArea && overlap.apart <= kSamePlane;
}

std::string message(const Standing& a, const Standing& b) {
    const Vec3 at = 0.5 * (glm::max(a.box.min, b.box.min) + glm::min(a.box.max, b.box.max));
    const Vec3& n = a.plane.n;
    return fmt::format("{} and {} at ({:.3f} {:.3f} {:.3f}), normal ({:.2f} {:.2f} {:.2f})", a.name, b.name,
                       at.x, at.y, at.z, n.x, n.y, n.z);
}

TEST(Surfaces, overlapIsTheCommonAreaAndHowFarApartItLies) {
    const auto square = [](double x, double z, double tilt) {
        Standing s;
        s.points = {{x, 0.0, z}, {x + 1.0, 0.0, z + tilt}, {x + 1.0, 1.0, z + tilt}, {x, 1.0, z}};
        s.plane = planeOf(s.points);
        return s;
    };
    EXPECT_NEAR(overlapOf(square(0.0, 0.0, 0.0), square(0.75, 0.001, 0.0)).area, 0.25, 1e-9);
    EXPECT_NEAR(overlapOf(square(0.0, 0.0, 0.0), square(0.75, 0.001, 0.0)).apart, 0.001, 1e-9);
    EXPECT_NEAR(overlapOf(square(0.0, 0.0, 0.0), square(0.5, 0.0, 0.1)).apart, 0.05, 1e-9);
    EXPECT_EQ(overlapOf(square(0.0, 0.0, 0.0), square(1.5, 0.0, 0.0)).area, 0.0);
}

TEST(Surfaces, noTwoFacesThatLookTheSameWayLieInOnePlane) {
    const std::vector<Standing> all = standingPolygons();
    ASSERT_GT(all.size(), 5000u);
    std::size_t found = 0;
    forNearPairs(all, [&](const Standing& a, const Standing& b) {
        const bool solid = a.kind != SurfaceKind::Portal && b.kind != SurfaceKind::Portal;
        const double facing = glm::dot(a.plane.n, b.plane.n);
        const bool same = facing > kParallel || ((a.twoSided || b.twoSided) && facing < -kParallel);
        if (solid && same && shareAPlane(a, b)) {
            ++found;
            ADD_FAILURE() << message(a, b);
        }
    });
    EXPECT_EQ(found, 0u);
}

TEST(Surfaces, nothingLiesInAnOpening) {
    std::size_t portals = 0;
    const std::vector<Standing> all = standingPolygons();
    forNearPairs(all, [&](const Standing& a, const Standing& b) {
        portals += a.kind == SurfaceKind::Portal && b.kind == SurfaceKind::Portal ? 1 : 0;
        const bool one = (a.kind == SurfaceKind::Portal) != (b.kind == SurfaceKind::Portal);
        if (one && std::abs(glm::dot(a.plane.n, b.plane.n)) > kParallel)
            EXPECT_FALSE(shareAPlane(a, b)) << message(a, b);
    });
    EXPECT_GT(portals, 10u);
}

/// Foliage has normals that do not follow its faces, as if light came through it.
bool isFoliage(dat::RecordId surface) {
    const std::set<dat::RecordId> foliage{surfaceId(Material::Leaves),     surfaceId(Material::BirchLeaves),
                                          surfaceId(Material::PineBranch), surfaceId(Material::GrassTuft),
                                          surfaceId(Material::Flowers),    surfaceId(Material::FarPlants)};
    return foliage.count(surface) != 0;
}

void expectNormalsFollowWinding(const std::string& name, const dat::VertexArray& vertices,
                                const dat::PolygonList& polygons,
                                const std::vector<dat::RecordId>& surfaces) {
    for (const auto& [id, polygon] : polygons) {
        if (polygon.posSurface >= 0 && isFoliage(surfaces.at(static_cast<std::size_t>(polygon.posSurface))))
            continue;
        const Vec3 winding = planeOf(pointsOf(vertices, polygon, {})).n;
        for (const std::uint16_t key : polygon.vertexKeys) {
            const Vec3 normal(vertices.vertices.at(key).second.normal);
            EXPECT_GT(glm::dot(normal, winding), 0.3) << name << " polygon " << id;
            EXPECT_NEAR(glm::length(normal), 1.0, 1e-5) << name << " polygon " << id;
        }
    }
}

TEST(Surfaces, normalsPointTheWayTheFacesLook) {
    for (const dat::GfxObj& g : world().gfxObjs) {
        expectNormalsFollowWinding(fmt::format("0x{:08X}", g.id), g.vertexArray, g.polygons,
                                   {g.surfaces.begin(), g.surfaces.end()});
    }
    for (const dat::EnvCell& cell : world().envCells) {
        std::vector<dat::RecordId> surfaces;
        for (const std::uint16_t s : cell.surfaces)
            surfaces.push_back(0x08000000u | s);
        const dat::CellStruct& shape = shapeOf(cell);
        expectNormalsFollowWinding(fmt::format("0x{:08X}", cell.id), shape.vertexArray, shape.polygons,
                                   surfaces);
    }
}

} // namespace
} // namespace limen::worlds::test
