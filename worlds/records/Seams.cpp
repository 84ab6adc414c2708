#include "worlds/records/Seams.h"

#include <cmath>
#include <limits>
#include <set>
#include <tuple>

namespace limen::worlds {

namespace {

/// In steps of the grid. A point nearer than this to an edge is on it: rounding moves points by up to 0.87
/// steps.
constexpr double kStepsOnEdge = 2.0;
constexpr double kFar = 1e9; ///< metres; farther than any point

struct Less {
    bool operator()(const Vec3& a, const Vec3& b) const {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    }
};

double snap(double v, double grid) {
    return std::round(v / grid) * grid;
}

/// The parameter (0..1) of the point between a and b on their line, or -1 if it is not strictly between them.
double positionOnEdge(const Vec3& a, const Vec3& b, const Vec3& p, double grid) {
    const Vec3 along = b - a;
    const double t = glm::dot(p - a, along) / glm::dot(along, along);
    if (t <= 0.0 || t >= 1.0 || p == a || p == b)
        return -1.0;
    return glm::length(p - (a + along * t)) <= kStepsOnEdge * grid ? t : -1.0;
}

void insertVertices(Face& face, const std::set<Vec3, Less>& points, double grid) {
    Face out = face;
    out.points.clear();
    out.uvs.clear();
    out.normals.clear();
    const std::size_t n = face.points.size();
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t j = (i + 1) % n;
        const auto push = [&](double t, const Vec3& p) {
            out.points.push_back(p);
            if (!face.uvs.empty())
                out.uvs.push_back(face.uvs[i] + (face.uvs[j] - face.uvs[i]) * t);
            if (!face.normals.empty())
                out.normals.push_back(
                    glm::normalize(face.normals[i] + (face.normals[j] - face.normals[i]) * t));
        };
        push(0.0, face.points[i]);
        std::vector<std::pair<double, Vec3>> between;
        const auto [west, east] = std::minmax(face.points[i].x, face.points[j].x);
        const double reach = kStepsOnEdge * grid;
        const auto end = points.upper_bound({east + reach, kFar, kFar});
        for (auto p = points.lower_bound({west - reach, -kFar, -kFar}); p != end; ++p) {
            const double t = positionOnEdge(face.points[i], face.points[j], *p, grid);
            if (t > 0.0)
                between.emplace_back(t, *p);
        }
        std::sort(between.begin(), between.end(),
                  [](const auto& a, const auto& b) { return a.first < b.first; });
        for (const auto& [t, p] : between)
            push(t, p);
    }
    face = std::move(out);
}

bool straight(const Vec3& a, const Vec3& b, const Vec3& c, double grid) {
    const Vec3 cross = glm::cross(b - a, c - b);
    return glm::length(cross) <= kStepsOnEdge * grid * glm::length(c - a);
}

void rotate(Face& face, std::size_t first) {
    const auto turn = [first](auto& list) {
        if (!list.empty())
            std::rotate(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(first), list.end());
    };
    turn(face.points);
    turn(face.uvs);
    turn(face.normals);
}

/// Polygons are drawn as fans from their first vertex. If that vertex is on a straight edge with others,
/// triangles have no area, and their long side lacks the neighbours' vertices. Rotates to a first vertex
/// without such triangles; false if there is none.
bool chooseFan(Face& face, double grid) {
    const std::size_t n = face.points.size();
    const auto at = [&](std::size_t i) -> const Vec3& { return face.points[i % n]; };
    for (std::size_t first = 0; first < n; ++first) {
        bool good = true;
        for (std::size_t k = 1; good && k + 1 < n; ++k)
            good = !straight(at(first), at(first + k), at(first + k + 1), grid);
        if (good) {
            rotate(face, first);
            return true;
        }
    }
    return false;
}

/// Triangles around the centre: none is without area.
void splitAtCentre(const Face& face, std::vector<Face>& out) {
    const std::size_t n = face.points.size();
    Vec3 centre(0.0);
    Vec2 uv(0.0);
    for (std::size_t i = 0; i < n; ++i) {
        centre += face.points[i] / static_cast<double>(n);
        uv += face.uvs[i] / static_cast<double>(n);
    }
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t j = (i + 1) % n;
        Face part = face;
        part.normals.clear();
        part.points = {centre, face.points[i], face.points[j]};
        part.uvs = {uv, face.uvs[i], face.uvs[j]};
        out.push_back(std::move(part));
    }
}

} // namespace

namespace {

using Points = std::set<Vec3, Less>;

void insertAndFan(std::vector<Face>& faces, const Points& points, double grid) {
    std::vector<Face> out;
    for (Face& face : faces) {
        insertVertices(face, points, grid);
        if (chooseFan(face, grid) || face.portal)
            out.push_back(std::move(face));
        else
            splitAtCentre(face, out);
    }
    faces = std::move(out);
}

} // namespace

double finestGrid(const std::vector<Face>& faces) {
    double farthest = 0.0;
    for (const Face& face : faces)
        for (const Vec3& p : face.points)
            farthest = std::max({farthest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    int exponent = 0; // of the power of two above all coordinates
    (void)std::frexp(farthest, &exponent);
    return std::ldexp(1.0, exponent - std::numeric_limits<float>::digits);
}

void closeSeams(std::vector<Face>& faces, double grid) {
    Points points;
    for (Face& face : faces) {
        for (Vec3& p : face.points) {
            p = {snap(p.x, grid), snap(p.y, grid), snap(p.z, grid)};
            points.insert(p);
        }
    }
    insertAndFan(faces, points, grid);
}

void roundCorners(std::vector<Face>& faces, double grid) {
    for (Face& face : faces) {
        Face out = face;
        out.points.clear();
        out.uvs.clear();
        out.normals.clear();
        for (std::size_t i = 0; i < face.points.size(); ++i) {
            const Vec3& p = face.points[i];
            const Vec3 rounded(snap(p.x, grid), snap(p.y, grid), snap(p.z, grid));
            if (!out.points.empty() && (rounded == out.points.back() || rounded == out.points.front()))
                continue;
            out.points.push_back(rounded);
            if (!face.uvs.empty())
                out.uvs.push_back(face.uvs[i]);
            if (!face.normals.empty())
                out.normals.push_back(face.normals[i]);
        }
        face = std::move(out);
    }
    std::erase_if(faces, [](const Face& face) { return face.points.size() < 3; });
}

void closePortalSeams(const std::vector<std::vector<Face>*>& meshes) {
    Points points;
    for (const std::vector<Face>* mesh : meshes) {
        for (const Face& face : *mesh)
            if (face.portal)
                points.insert(face.points.begin(), face.points.end());
    }
    for (std::vector<Face>* mesh : meshes)
        insertAndFan(*mesh, points, kBuiltGrid);
}

} // namespace limen::worlds
