#pragma once

#include "worlds/pictures/Canvas.h"
#include "worlds/records/FaceMesh.h"

#include <functional>

namespace limen::worlds {

/// The picture of a material, for drawing models with it.
using PictureOf = std::function<Canvas(Material)>;

/// Models drawn from the side into one picture, Material::FarPlants. It has kColumns × kRows fields.
class PlantPictures {
public:
    static constexpr int kColumns = 4, kRows = 4;

    /// `field`: texels across a field; at least 8, a multiple of 4.
    PlantPictures(PictureOf pictureOf, int field);

    /// A rectangle in space that shows a field: upright, around `axis`. Its front looks along `facing`, a level unit
    /// vector; the back shows the same picture mirrored.
    struct Card {
        Vec3 axis{0.0}; ///< the middle of its lower edge
        Vec3 facing{0.0, -1.0, 0.0};
        double halfWidth = 1.0, height = 1.0;
        int column = 0, row = 0;
    };
    /// Draws the mesh as it is seen from far away along -`facing` and a little downwards, and returns the card that shows it in its place.
    /// `turn`: the direction of `facing` about z, in radians; 0 is -y. Requires: the field is empty.
    [[nodiscard]] Card draw(const FaceMesh& mesh, double turn, int column, int row);

    /// The whole picture. The empty texels of a field have its mean colour, because mip levels mix them in.
    [[nodiscard]] Canvas take() { return std::move(canvas_); }

private:
    [[nodiscard]] const Canvas& pictureOf(Material material);
    void fillEmpty(int column, int row, const Vec3f& colour);

    PictureOf paint_;
    int field_;
    Canvas canvas_;
    std::vector<std::pair<Material, Canvas>> painted_;
};

/// The corners of a card (lower left, lower right, upper right, upper left), seen from its front, and where they are in
/// the picture.
[[nodiscard]] Face faceOf(const PlantPictures::Card& card);

} // namespace limen::worlds
