#pragma once

#include "geometry/Bounds.h"
#include "worlds/records/Materials.h"

#include <array>

#include <vector>

namespace limen::worlds {

/// A flat convex polygon to be written to a record. Points are in counter-clockwise order seen from the
/// front.
struct Face {
    std::vector<Vec3> points;
    std::vector<Vec2> uvs;     ///< one per point
    std::vector<Vec3> normals; ///< one per point for smooth shading; empty: flat
    Material material = Material::Plaster;
    bool twoSided = false;
    bool portal = false;   ///< an opening
    bool pictured = false; ///< of an opening: it has its material's picture; else no surface and no UVs
};

/// A face with its picture mapped in metres: u is level (east on floors), v points down (south on floors).
[[nodiscard]] Face planarFace(std::vector<Vec3> points, Material material);
/// A face of timber: u points along `grain`; `shift` (metres) moves the picture so that beams differ.
[[nodiscard]] Face grainedFace(std::vector<Vec3> points, Material material, const Vec3& grain,
                               const Vec2& shift);
[[nodiscard]] Face portalFace(std::vector<Vec3> points);
/// The face seen from behind.
[[nodiscard]] Face flipped(Face face);
[[nodiscard]] Vec3 faceNormal(const Face& face);

/// The placement of a part in a whole: a turn about z (degrees, counter-clockwise), then a translation.
struct Placement {
    Vec3 origin{0.0};
    double turn = 0.0;
};
[[nodiscard]] Vec3 place(const Placement& placement, const Vec3& point);

/// Collects faces. Box, beam and cylinder are closed and face outwards.
class FaceMesh {
public:
    void add(Face face) { faces_.push_back(std::move(face)); }
    /// Adds a leaf or blade. Both sides have the same normals, as if light came through it.
    void addThin(const Face& face);
    void polygon(std::vector<Vec3> points, Material material) {
        add(planarFace(std::move(points), material));
    }
    /// Adds a quad (lower left, lower right, upper right, upper left) that shows the whole picture once.
    void card(const std::array<Vec3, 4>& corners, Material material, bool twoSided);
    void box(const Vec3& min, const Vec3& max, Material material);
    /// A box whose grain runs along its longest side.
    void beam(const Vec3& min, const Vec3& max, Material material);
    /// Adds a square timber from a to b, `wide` metres along `side` (made perpendicular), `deep` metres in
    /// the third direction.
    void strut(const Vec3& a, const Vec3& b, const Vec3& side, double wide, double deep, Material material);
    /// A smooth round post on `base`. `wrapOnce`: the picture goes round once, else it repeats by
    /// metresPerTile.
    struct Round {
        Vec3 base{0.0};
        double lower = 0.5, upper = 0.5, height = 1.0;
        int sides = 10;
        Material side = Material::Oak, cap = Material::Oak;
        bool wrapOnce = false, caps = true;
    };
    void cylinder(const Round& round);
    void append(const FaceMesh& part, const Placement& placement);

    [[nodiscard]] const std::vector<Face>& faces() const { return faces_; }
    [[nodiscard]] std::vector<Face>& faces() { return faces_; }
    [[nodiscard]] Aabb bounds() const;

private:
    std::vector<Face> faces_;
};

} // namespace limen::worlds
