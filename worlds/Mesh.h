#pragma once

#include "dat/records/Mesh.h"
#include "geometry/Bounds.h"
#include "worlds/Materials.h"

#include <array>

#include <vector>

namespace limen::worlds {

/// A flat convex polygon on its way into a record. Points run counter-clockwise seen from the front.
struct Face {
    std::vector<Vec3> points;
    std::vector<Vec2> uvs;     ///< one per point
    std::vector<Vec3> normals; ///< one per point for round things; empty: flat
    Material material = Material::Plaster;
    bool twoSided = false;
    bool portal = false; ///< an opening: no surface, no UVs
};

/// A face whose picture is laid on in metres: u runs level (or east on floors), v runs down (or south).
[[nodiscard]] Face planarFace(std::vector<Vec3> points, Material material);
/// A face of timber: u runs along `grain`; `shift` (metres) moves the picture so that no two beams look
/// alike.
[[nodiscard]] Face grainedFace(std::vector<Vec3> points, Material material, const Vec3& grain,
                               const Vec2& shift);
[[nodiscard]] Face portalFace(std::vector<Vec3> points);
/// The face seen from behind.
[[nodiscard]] Face flipped(Face face);
[[nodiscard]] Vec3 faceNormal(const Face& face);

/// Where a part stands in a whole: turned about z (degrees, counter-clockwise), then moved.
struct Placement {
    Vec3 origin{0.0};
    double turn = 0.0;
};
[[nodiscard]] Vec3 place(const Placement& placement, const Vec3& point);

/// Collects faces. Box, beam and cylinder are closed and face outwards.
class MeshBuilder {
public:
    void add(Face face) { faces_.push_back(std::move(face)); }
    /// A leaf or blade: both sides are lit by the same normals, as if light came through it.
    void addThin(const Face& face);
    void polygon(std::vector<Vec3> points, Material material) {
        add(planarFace(std::move(points), material));
    }
    /// A polygon with its picture given: once over the whole quad a,b,c,d = lower left, lower right, upper
    /// right, upper left.
    void card(const std::array<Vec3, 4>& corners, Material material, bool twoSided);
    void box(const Vec3& min, const Vec3& max, Material material);
    /// A box whose grain runs along its longest side.
    void beam(const Vec3& min, const Vec3& max, Material material);
    /// A square timber from a to b; `wide` across (along `side`, made perpendicular), `deep` in the third
    /// direction.
    void strut(const Vec3& a, const Vec3& b, const Vec3& side, double wide, double deep, Material material);
    /// A round post standing on `base`, smooth; picture once around, or `metresPerTile` if `wrapOnce` is
    /// false.
    struct Round {
        Vec3 base{0.0};
        double lower = 0.5, upper = 0.5, height = 1.0;
        int sides = 10;
        Material side = Material::Oak, cap = Material::Oak;
        bool wrapOnce = false, caps = true;
    };
    void cylinder(const Round& round);
    void append(const MeshBuilder& part, const Placement& placement);

    [[nodiscard]] const std::vector<Face>& faces() const { return faces_; }
    [[nodiscard]] std::vector<Face>& faces() { return faces_; }
    [[nodiscard]] Aabb bounds() const;

private:
    std::vector<Face> faces_;
};

/// Metres. What is built at right angles is flat on any grid; on this one, floats hold every point within 1 km exactly.
inline constexpr double kBuiltGrid = 1.0 / 8192.0;
/// The finest grid on which floats hold every point of these faces, metres; a power of two. Walls at odd angles are flat to
/// this; off it, by a tenth of a millimetre say, zones and openings are not told apart as well (docs/cases.md).
[[nodiscard]] double finestGrid(const std::vector<Face>& faces);

/// Adds to every face the vertices of other faces that lie on its edges, so that edges match one to one and
/// no crack or T-junction is left. Points are first rounded to multiples of `grid` metres.
void closeSeams(std::vector<Face>& faces, double grid = kBuiltGrid);

/// The same between meshes that meet at openings: a vertex that one of them has on the border of a portal
/// face is given to all. The meshes' own seams must be closed, on kBuiltGrid.
void closePortalSeams(const std::vector<std::vector<Face>*>& meshes);

/// A mesh as a record stores it. Face i has polygon id i.
struct EncodedMesh {
    dat::VertexArray vertexArray;
    dat::PolygonList polygons;
    std::vector<dat::RecordId> surfaces;
};
/// Requires fewer than 32768 distinct vertices and faces.
[[nodiscard]] EncodedMesh encodeMesh(const std::vector<Face>& faces);

} // namespace limen::worlds
