#pragma once

#include "worlds/Building.h"

#include <string>
#include <vector>

namespace limen::worlds {

/// A convex polygon in space; which way it runs round does not matter where it outlines an opening.
using Outline = std::vector<Vec3>;

/// What is left of a flat convex face without the openings, in upright strips of at most four corners. Each opening
/// lies in the face's plane and inside it (their borders may touch); no two overlap. Exact for corners on a coarse
/// grid if the face is level, upright along an axis or upright at 45 degrees.
[[nodiscard]] std::vector<Face> faceWithout(const Face& face, const std::vector<Outline>& openings);

/// True if the outline lies in the face's plane.
[[nodiscard]] bool liesIn(const Outline& outline, const Face& face);

/// Pictures by where a face looks.
struct ShellMaterials {
    Material floor = Material::Flagstones, walls = Material::StoneWall, ceiling = Material::StoneWall;
};

/// The sides and both ends of the body that a convex section sweeps along a vector, looking inwards. Pictures run
/// round the section without a seam between its sides.
[[nodiscard]] std::vector<Face> sweptFaces(const Outline& section, const Vec3& along,
                                           const ShellMaterials& materials);

/// A level polygon at height z.
[[nodiscard]] Outline levelOutline(const std::vector<Vec2>& corners, double z);
/// An octagon around the origin: straight sides at `apothem` along the axes, `half` to either side of their middle;
/// the sides between them run at 45 degrees.
[[nodiscard]] std::vector<Vec2> octagon(double apothem, double half);
[[nodiscard]] std::vector<Vec2> rectangle(double x0, double y0, double x1, double y1);

/// Upright openings, standing on `foot` (the middle of the sill), `half` to either side along `across` (a step along
/// an axis, or (1,±1,0)).
struct Upright {
    Vec3 foot{0.0};
    Vec3 across{1.0, 0.0, 0.0};
    double half = 1.25;
};
/// An arch: straight up to `spring`, round above it up to `height`; 11 corners.
[[nodiscard]] Outline archOutline(const Upright& at, double spring, double height);
[[nodiscard]] Outline rectOutline(const Upright& at, double height);

/// Cells under construction: closed bodies that get joined through openings.
class CellComplex {
public:
    /// Adds a closed body whose faces look inwards. Returns its number, which is its place in the plan.
    std::size_t add(std::string name, std::vector<Face> faces);
    std::size_t addSwept(std::string name, const Outline& section, const Vec3& along,
                         const ShellMaterials& materials) {
        return add(std::move(name), sweptFaces(section, along, materials));
    }
    /// Adds `count` bodies in a row, each swept along `along` and joined to the next by its whole end. Returns the
    /// first one's number; the others follow.
    std::size_t addRun(const std::string& name, const Outline& section, const Vec3& along, std::size_t count,
                       const ShellMaterials& materials);
    /// Cuts an opening into both bodies. Requires: it lies in a face of each.
    void join(std::size_t a, std::size_t b, const Outline& opening);
    /// Cuts an opening that leads outside.
    void open(std::size_t cell, const Outline& opening);
    void furnish(std::size_t cell, const Furnishing& object) { drafts_.at(cell).statics.push_back(object); }
    [[nodiscard]] std::size_t size() const { return drafts_.size(); }
    [[nodiscard]] std::vector<CellPlan> finish() const;

private:
    struct Draft {
        std::string name;
        std::vector<Face> faces;
        std::vector<Outline> openings;
        std::vector<Furnishing> statics;
    };
    std::vector<Draft> drafts_;
};

} // namespace limen::worlds
