#pragma once

#include "worlds/records/CellPlan.h"

#include <string>
#include <vector>

namespace limen::worlds {

/// A convex polygon in space. The winding of an opening's outline does not matter.
using Outline = std::vector<Vec3>;

/// A flat convex face without the openings: upright strips of at most four corners. Each opening is in the
/// face's plane and inside it (their borders may touch); no two overlap. Exact for corners on a coarse grid
/// if the face is level, or upright along an axis or at 45 degrees.
[[nodiscard]] std::vector<Face> faceWithout(const Face& face, const std::vector<Outline>& openings);

/// True if the outline is in the face's plane.
[[nodiscard]] bool liesIn(const Outline& outline, const Face& face);

/// Materials by the direction of a face.
struct ShellMaterials {
    Material floor = Material::Flagstones, walls = Material::StoneWall, ceiling = Material::StoneWall;
};

/// The faces, looking inwards, of the body that a convex section sweeps along a vector: sides, then both
/// ends. Pictures continue round the section without seams.
[[nodiscard]] std::vector<Face> sweptFaces(const Outline& section, const Vec3& along,
                                           const ShellMaterials& materials);

/// A level polygon at height z.
[[nodiscard]] Outline levelOutline(const std::vector<Vec2>& corners, double z);
/// An octagon around the origin. Four sides cross the axes at `apothem` and extend `half` to either side; the
/// other four are at 45 degrees.
[[nodiscard]] std::vector<Vec2> octagon(double apothem, double half);
[[nodiscard]] std::vector<Vec2> rectangle(double x0, double y0, double x1, double y1);

/// The base of an upright opening: `foot` is the middle of the sill, which extends `half` to either side
/// along `across` (an axis, or (1,±1,0)).
struct Upright {
    Vec3 foot{0.0};
    Vec3 across{1.0, 0.0, 0.0};
    double half = 1.25;
};
/// An arch with 11 corners: straight sides up to `spring`, round above, `height` in all.
[[nodiscard]] Outline archOutline(const Upright& at, double spring, double height);
[[nodiscard]] Outline rectOutline(const Upright& at, double height);

/// Builds cells as closed bodies that are joined by openings.
class CellComplex {
public:
    /// Adds a closed body whose faces look inwards. Returns its index in the plan.
    std::size_t add(std::string name, std::vector<Face> faces);
    std::size_t addSwept(std::string name, const Outline& section, const Vec3& along,
                         const ShellMaterials& materials) {
        return add(std::move(name), sweptFaces(section, along, materials));
    }
    /// Adds `count` bodies in a row, each swept by `along` and joined to the next by its whole end. Returns
    /// the first one's index; the others follow.
    std::size_t addRun(const std::string& name, const Outline& section, const Vec3& along, std::size_t count,
                       const ShellMaterials& materials);
    /// Cuts an opening into both bodies. Requires: it is in a face of each.
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
