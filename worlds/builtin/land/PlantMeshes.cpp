#include "worlds/builtin/land/PlantMeshes.h"

#include "geometry/Angles.h"
#include "worlds/pictures/Noise.h"

namespace limen::worlds {

namespace {

/// Adds a square picture: its centre, and half its right and upper edges as vectors.
void addLeafCard(FaceMesh& mesh, const Vec3& centre, const Vec3& right, const Vec3& up, const Vec3& bulge,
                 Material material) {
    Face face;
    face.points = {centre - right - up, centre + right - up, centre + right + up, centre - right + up};
    face.uvs = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    face.material = material;
    // Normals of a round crown; those of flat cards would show the cards.
    for (const Vec3& p : face.points)
        face.normals.push_back(glm::normalize(p - bulge + Vec3(0.0, 0.0, 0.6)));
    mesh.addThin(face);
}

/// Adds a trunk of straight pieces with a small bend at each joint. Returns its upper end.
Vec3 addTrunk(FaceMesh& mesh, double radius, double height, double bend, std::uint32_t seed, int sides) {
    constexpr int kPieces = 3;
    Vec3 foot(0.0, 0.0, -0.4);
    for (int k = 0; k < kPieces; ++k) {
        const auto i = static_cast<std::uint32_t>(k);
        const double lower = radius * (1.0 - 0.28 * k);
        const double upper = radius * (1.0 - 0.28 * (k + 1));
        const Vec3 lean(bend * (random01(i, 1, seed) - 0.5), bend * (random01(i, 2, seed) - 0.5), 0.0);
        FaceMesh piece;
        piece.cylinder({.base = foot,
                        .lower = k == 0 ? radius * 1.35 : lower,
                        .upper = upper,
                        .height = (height + 0.4) / kPieces,
                        .sides = sides,
                        .side = Material::Bark,
                        .cap = Material::Bark,
                        .caps = k + 1 == kPieces});
        const double top = foot.z + (height + 0.4) / kPieces;
        for (Face& face : piece.faces()) {
            for (Vec3& p : face.points)
                p += p.z > 0.5 * (foot.z + top) ? lean : Vec3(0.0);
            // The offset of the upper rim makes the quads non-planar: they are split into triangles.
            if (face.points.size() == 4) {
                Face other = face;
                other.points.erase(other.points.begin() + 1);
                other.uvs.erase(other.uvs.begin() + 1);
                other.normals.erase(other.normals.begin() + 1);
                face.points.pop_back();
                face.uvs.pop_back();
                face.normals.pop_back();
                mesh.add(std::move(other));
            }
            mesh.add(std::move(face));
        }
        foot = Vec3(foot.x, foot.y, top) + lean;
    }
    return foot;
}

void addFrond(FaceMesh& mesh, double a, double half) {
    const Vec3 out(std::cos(a), std::sin(a), 0.0);
    const Vec3 side = Vec3(-out.y, out.x, 0.0) * half;
    const Vec3 tip = out * 0.62 + Vec3(0, 0, 0.42);
    Face face;
    face.points = {-side, tip - side, tip + side, side};
    face.uvs = {{0, 0.75}, {1, 0.75}, {1, 0.25}, {0, 0.25}};
    face.normals.assign(4, Vec3(0, 0, 1));
    face.material = Material::PineBranch;
    mesh.addThin(face);
}

void addPineBranch(FaceMesh& mesh, double a, double z, double length, double width) {
    const Vec3 out(std::cos(a), std::sin(a), 0.0);
    const Vec3 side = Vec3(-out.y, out.x, 0.0) * length * width;
    const Vec3 tip = out * length - Vec3(0, 0, length * 0.34);
    const Vec3 root(0, 0, z);
    Face face;
    face.points = {root - side, root + tip - side, root + tip + side, root + side};
    face.uvs = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    face.normals.assign(4, glm::normalize(out * 0.7 + Vec3(0, 0, 0.8)));
    face.material = Material::PineBranch;
    mesh.addThin(face);
}

} // namespace

void addCrown(FaceMesh& mesh, const Crown& c) {
    for (int k = 0; k < c.cards; ++k) {
        const auto i = static_cast<std::uint32_t>(k);
        // Evenly over the sphere by the golden angle, each card with a random turn.
        const double z = 1.0 - 2.0 * (k + 0.5) / c.cards;
        const double a = 2.39996323 * k + 0.5 * random01(i, 1, c.seed);
        const double r = std::sqrt(1.0 - z * z) * (0.55 + 0.2 * random01(i, 2, c.seed));
        const Vec3 centre =
            c.centre + Vec3(c.radius * r * std::cos(a), c.radius * r * std::sin(a), c.height * 0.7 * z);
        const double turn = kTurn * random01(i, 3, c.seed);
        const double tilt = 0.9 * (random01(i, 4, c.seed) - 0.5);
        const Vec3 right = c.cardSize * Vec3(std::cos(turn), std::sin(turn), 0.0);
        const Vec3 up = c.cardSize * glm::normalize(Vec3(-std::sin(turn) * tilt, std::cos(turn) * tilt, 1.0));
        addLeafCard(mesh, centre, right, up, c.centre - Vec3(0, 0, c.height * 0.4), c.material);
    }
}

LeafTree oak() {
    const Crown lobe{{}, 2.0, 1.7, 13, 1.25, Material::Leaves, 3003};
    LeafTree tree{0.34, 3.6, 0.5, 3001, {}, 0.15};
    for (const Vec3& centre :
         {Vec3(1.5, 0.6, 4.9), Vec3(-1.4, 0.9, 5.2), Vec3(0.1, -1.5, 5.0), Vec3(0.1, 0.2, 6.6)}) {
        Crown crown = lobe;
        crown.centre = centre;
        crown.seed += static_cast<std::uint32_t>(tree.crowns.size());
        tree.crowns.push_back(crown);
    }
    return tree;
}

LeafTree birch() {
    LeafTree tree{0.17, 4.6, 0.7, 3011, {}, 0.0};
    FaceMesh unused;
    const Vec3 head = addTrunk(unused, tree.radius, tree.height, tree.bend, tree.seed, 3);
    tree.crowns = {{head + Vec3(0, 0, 0.6), 1.5, 2.3, 18, 1.0, Material::BirchLeaves, 3013},
                   {head - Vec3(0.3, 0.2, 1.2), 1.5, 1.2, 9, 0.9, Material::BirchLeaves, 3015}};
    return tree;
}

FaceMesh treeMesh(const LeafTree& tree) {
    FaceMesh mesh;
    const Vec3 head = addTrunk(mesh, tree.radius, tree.height, tree.bend, tree.seed, 7);
    for (const Crown& crown : tree.crowns) {
        if (tree.branch > 0.0)
            mesh.strut(head - Vec3(0, 0, 0.3), crown.centre, {0.3, 0.7, 0.1}, tree.branch, tree.branch,
                       Material::Bark);
        addCrown(mesh, crown);
    }
    return mesh;
}

FaceMesh trunkMesh(const LeafTree& tree, int sides) {
    FaceMesh mesh;
    addTrunk(mesh, tree.radius, tree.height, tree.bend, tree.seed, sides);
    return mesh;
}

FaceMesh straightTrunkMesh(const LeafTree& tree, int sides) {
    FaceMesh bent, mesh;
    const Vec3 head = addTrunk(bent, tree.radius, tree.height, tree.bend, tree.seed, sides);
    const Vec3 foot(0.0, 0.0, -0.4);
    mesh.cylinder({.base = foot,
                   .lower = 1.2 * tree.radius,
                   .upper = 0.4 * tree.radius,
                   .height = head.z - foot.z,
                   .sides = sides,
                   .side = Material::Bark,
                   .cap = Material::Bark,
                   .caps = false});
    for (Face& face : mesh.faces())
        for (Vec3& p : face.points)
            p += p.z > foot.z ? Vec3(head.x, head.y, 0.0) : Vec3(0.0);
    return mesh;
}

FaceMesh pineMesh(const PineTree& tree) {
    FaceMesh mesh;
    mesh.cylinder({.base = {0, 0, -0.4},
                   .lower = 0.035 * tree.height,
                   .upper = 0.0,
                   .height = tree.height * 0.97 + 0.4,
                   .sides = tree.trunkSides,
                   .side = Material::Bark,
                   .cap = Material::Bark,
                   .caps = false});
    for (int ring = 0; ring < tree.rings; ++ring) {
        const double t = static_cast<double>(ring) / tree.rings;
        const int branches = ring + 2 >= tree.rings ? tree.branches - 1 : tree.branches;
        for (int k = 0; k < branches; ++k)
            addPineBranch(mesh, kTurn * (k + 0.37 * ring) / branches, tree.height * (0.16 + 0.80 * t),
                          tree.spread * (1.0 - 0.88 * t), tree.branchWidth);
    }
    return mesh;
}

FaceMesh bushMesh() {
    FaceMesh mesh;
    addCrown(mesh, {{0, 0, 0.55}, 0.85, 0.65, 10, 0.62, Material::Leaves, 3031});
    return mesh;
}

FaceMesh tuftMesh(Material material, double half, double height, int cards) {
    FaceMesh mesh;
    for (int k = 0; k < cards; ++k) {
        const double a = 0.5 * kTurn * (k + 0.15) / cards;
        const Vec3 right(half * std::cos(a), half * std::sin(a), 0.0);
        Face face;
        face.points = {-right - Vec3(0, 0, 0.06), right - Vec3(0, 0, 0.06), right + Vec3(0, 0, height),
                       -right + Vec3(0, 0, height)};
        face.uvs = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
        face.normals.assign(4, Vec3(0, 0, 1)); // the light of the ground below
        face.material = material;
        mesh.addThin(face);
    }
    return mesh;
}

FaceMesh fernMesh(int fronds, double half) {
    FaceMesh mesh;
    for (int k = 0; k < fronds; ++k)
        addFrond(mesh, kTurn * k / fronds, half);
    return mesh;
}

FaceMesh stumpMesh(int sides) {
    FaceMesh mesh;
    mesh.cylinder({.base = {0, 0, -0.3},
                   .lower = 0.46,
                   .upper = 0.30,
                   .height = 0.75,
                   .sides = sides,
                   .side = Material::Bark,
                   .cap = Material::OldPlanks});
    return mesh;
}

FaceMesh stoneMesh(const Vec3& size, std::uint32_t seed, int step) {
    constexpr int kAround = 8;
    constexpr int kRings = 4;
    constexpr double kFoot = 1.3, kDepth = 1.0; // half width and depth of its foot, in half sizes
    const auto at = [&](int ring, int k) {
        const double polar = 3.14159265 * ring / kRings;
        const double a = kTurn * (k % kAround) / kAround;
        const bool pole = ring == 0 || ring == kRings;
        const auto key = static_cast<std::uint32_t>(ring * 64 + (pole ? 0 : k % kAround));
        const double lump = 0.78 + 0.44 * random01(key, seed);
        if (2 * ring <= kRings)
            return size * lump *
                       Vec3(std::sin(polar) * std::cos(a), std::sin(polar) * std::sin(a), std::cos(polar)) +
                   Vec3(0, 0, size.z * 0.45);
        // Deep in the ground the stone is wider than above, so that it shows no underside on a slope either.
        return Vec3(size.x, size.y, size.z) * Vec3(std::cos(a), std::sin(a), 0.0) * (pole ? 0.0 : kFoot) -
               Vec3(0, 0, kDepth * size.z);
    };
    FaceMesh mesh;
    for (int ring = 0; ring < kRings; ++ring) {
        for (int k = 0; k < kAround; k += step) {
            const int lower = ring + 1, next = k + step;
            if (ring > 0)
                mesh.polygon({at(ring, k), at(lower, k), at(ring, next)}, Material::Rock);
            if (lower < kRings)
                mesh.polygon({at(ring, next), at(lower, k), at(lower, next)}, Material::Rock);
        }
    }
    return mesh;
}

} // namespace limen::worlds
