#pragma once

#include "worlds/builtin/land/PlantPictures.h"

#include <vector>

namespace limen::worlds {

/// Meshes of plants and stones, each on z = 0. Without other words they are the nearest level of detail.
/// A crown of leaves: cards spread over a sphere.
struct Crown {
    Vec3 centre{0.0};
    double radius = 2.0, height = 2.0; ///< half sizes
    int cards = 14;
    double cardSize = 1.2; ///< half size
    Material material = Material::Leaves;
    std::uint32_t seed = 1;
};
void addCrown(FaceMesh& mesh, const Crown& crown);

/// Trunk and crowns. The nearest level has branches between them.
struct LeafTree {
    double radius = 0.34, height = 3.6; ///< of the trunk
    double bend = 0.5;                  ///< metres, of each joint
    std::uint32_t seed = 1;
    std::vector<Crown> crowns;
    double branch = 0.0; ///< thickness, metres; 0: none
};
[[nodiscard]] LeafTree oak();
[[nodiscard]] LeafTree birch();
[[nodiscard]] FaceMesh treeMesh(const LeafTree& tree);
/// Its trunk: in three pieces, which bend, or in a straight one.
[[nodiscard]] FaceMesh trunkMesh(const LeafTree& tree, int sides);
[[nodiscard]] FaceMesh straightTrunkMesh(const LeafTree& tree, int sides);

/// A cone of branches in rings.
struct PineTree {
    double height = 9.5, spread = 2.7;
    int rings = 9;
    int branches = 6;          ///< of a ring
    double branchWidth = 0.42; ///< half width, share of its length
    int trunkSides = 6;
};
[[nodiscard]] FaceMesh pineMesh(const PineTree& tree);

[[nodiscard]] FaceMesh bushMesh();
/// Crossing pictures that begin at the ground; `half`: half their width, metres.
[[nodiscard]] FaceMesh tuftMesh(Material material, double half, double height, int cards);
/// Fronds around the middle; `half`: half their width, metres.
[[nodiscard]] FaceMesh fernMesh(int fronds, double half);
[[nodiscard]] FaceMesh stumpMesh(int sides);

/// A rough stone: a sphere of a few flat faces with random radii. `step`: a divisor of 8; only each `step`-th corner of a
/// ring is used.
[[nodiscard]] FaceMesh stoneMesh(const Vec3& size, std::uint32_t seed, int step = 1);

} // namespace limen::worlds
