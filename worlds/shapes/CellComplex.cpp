#include "worlds/shapes/CellComplex.h"

#include "core/Assert.h"
#include "geometry/Plane.h"
#include "worlds/records/Seams.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limen::worlds {

namespace {

/// Metres. Corners are planned on this grid or a coarser one.
constexpr double kPlanGrid = 1.0 / 1024.0;

double onGrid(double v) {
    return std::round(v / kPlanGrid) * kPlanGrid;
}

Face facing(Face face, const Vec3& direction) {
    return glm::dot(faceNormal(face), direction) < 0.0 ? flipped(std::move(face)) : face;
}

Material materialOf(const ShellMaterials& materials, const Vec3& normal) {
    return normal.z > 0.7 ? materials.floor : normal.z < -0.7 ? materials.ceiling : materials.walls;
}

/// Maps the picture to a side of a swept body: u along it, v round the section, starting at `rolled` metres.
void layRound(Face& face, const Vec3& along, const Vec3& edgeStart, const Vec3& edge, double rolled) {
    const double scale = 1.0 / metresPerTile(face.material);
    const Vec3 axis = glm::normalize(along);
    const Vec3 round = glm::normalize(edge - axis * glm::dot(edge, axis));
    for (std::size_t i = 0; i < face.points.size(); ++i) {
        const Vec3& p = face.points[i];
        face.uvs[i] = Vec2(glm::dot(p, axis), -(rolled + glm::dot(p - edgeStart, round))) * scale;
    }
}

} // namespace

std::vector<Face> sweptFaces(const Outline& section, const Vec3& along, const ShellMaterials& materials) {
    Vec3 middle = 0.5 * along;
    for (const Vec3& p : section)
        middle += p / static_cast<double>(section.size());
    const auto inward = [&](std::vector<Vec3> points) {
        if (glm::dot(planeOf(points).n, middle - points[0]) < 0.0)
            std::reverse(points.begin(), points.end());
        const Material material = materialOf(materials, planeOf(points).n);
        return planarFace(std::move(points), material);
    };
    const bool lying = std::abs(along.z) < 0.9 * glm::length(along);
    std::vector<Face> faces;
    double rolled = 0.0;
    for (std::size_t i = 0; i < section.size(); ++i) {
        const Vec3& a = section[i];
        const Vec3& b = section[(i + 1) % section.size()];
        Face side = inward({a, b, b + along, a + along});
        if (lying && std::abs(faceNormal(side).z) < 0.99)
            layRound(side, along, a, b - a, rolled);
        rolled += glm::length(b - a);
        faces.push_back(std::move(side));
    }
    std::vector<Vec3> end;
    for (const Vec3& p : section)
        end.push_back(p + along);
    faces.push_back(inward(section));
    faces.push_back(inward(std::move(end)));
    return faces;
}

Outline levelOutline(const std::vector<Vec2>& corners, double z) {
    Outline out;
    for (const Vec2& p : corners)
        out.emplace_back(p, z);
    return out;
}

std::vector<Vec2> octagon(double a, double h) {
    return {{a, -h}, {a, h}, {h, a}, {-h, a}, {-a, h}, {-a, -h}, {-h, -a}, {h, -a}};
}

std::vector<Vec2> rectangle(double x0, double y0, double x1, double y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

Outline archOutline(const Upright& at, double spring, double height) {
    constexpr int kArcs = 8;
    Outline out{at.foot - at.across * at.half, at.foot + at.across * at.half};
    for (int k = 0; k <= kArcs; ++k) {
        const double angle = std::numbers::pi * k / kArcs;
        out.push_back(at.foot + at.across * onGrid(at.half * std::cos(angle)) +
                      Vec3(0.0, 0.0, onGrid(spring + (height - spring) * std::sin(angle))));
    }
    return out;
}

Outline rectOutline(const Upright& at, double height) {
    const Vec3 up{0.0, 0.0, height};
    const Vec3 side = at.across * at.half;
    return {at.foot - side, at.foot + side, at.foot + side + up, at.foot - side + up};
}

std::size_t CellComplex::add(std::string name, std::vector<Face> faces) {
    drafts_.push_back({std::move(name), std::move(faces), {}, {}});
    return drafts_.size() - 1;
}

std::size_t CellComplex::addRun(const std::string& name, const Outline& section, const Vec3& along,
                                std::size_t count, const ShellMaterials& materials) {
    const std::size_t first = drafts_.size();
    Outline at = section;
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t cell = addSwept(name + "." + std::to_string(k), at, along, materials);
        if (k > 0)
            join(cell - 1, cell, at);
        for (Vec3& p : at)
            p += along;
    }
    return first;
}

void CellComplex::join(std::size_t a, std::size_t b, const Outline& opening) {
    open(a, opening);
    open(b, opening);
}

void CellComplex::open(std::size_t cell, const Outline& opening) {
    drafts_.at(cell).openings.push_back(opening);
}

std::vector<CellPlan> CellComplex::finish() const {
    std::vector<CellPlan> plans;
    for (const Draft& draft : drafts_) {
        CellPlan plan;
        plan.name = draft.name;
        plan.statics = draft.statics;
        std::vector<Face> portals;
        for (const Face& face : draft.faces) {
            std::vector<Outline> own;
            std::copy_if(draft.openings.begin(), draft.openings.end(), std::back_inserter(own),
                         [&](const Outline& o) { return liesIn(o, face); });
            for (Face& strip : faceWithout(face, own))
                plan.faces.push_back(std::move(strip));
            for (const Outline& o : own)
                portals.push_back(facing(portalFace(o), faceNormal(face)));
        }
        LIMEN_ASSERT(portals.size() == draft.openings.size(),
                     "an opening lies in exactly one face of its cell");
        plan.faces.insert(plan.faces.end(), portals.begin(), portals.end());
        closeSeams(plan.faces);
        plans.push_back(std::move(plan));
    }
    return plans;
}

} // namespace limen::worlds
