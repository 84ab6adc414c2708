#include "worlds/builtin/land/Plants.h"

#include "geometry/Angles.h"
#include "worlds/builtin/land/PlantMeshes.h"

namespace limen::worlds {

namespace {

using Card = PlantPictures::Card;

/// Rows of the picture. Columns 0 to 2 have views of the whole plant, 60 degrees apart.
enum Row { kOakRow, kBirchRow, kPineRow, kYoungPineRow };
constexpr int kOther = 3; ///< the column of a crown or a bush

/// Adds both sides of a card. `roundNormal`: the normal of the plant's rounded outline at a point; each side's normals are
/// turned to its viewer, so that a plant is darker from its shadow side.
template <class Normal>
void addCard(FaceMesh& mesh, const Card& card, Normal roundNormal) {
    const auto withNormals = [&](Face face, const Vec3& front) {
        for (const Vec3& p : face.points)
            face.normals.push_back(glm::normalize(roundNormal(p) + 0.25 * front));
        return face;
    };
    mesh.add(withNormals(faceOf(card), card.facing));
    mesh.add(withNormals(flipped(faceOf(card)), -card.facing));
}

/// Crossing pictures of a whole plant, from the sides of the first `views` fields of a row.
FaceMesh crossedViews(PlantPictures& pictures, const FaceMesh& plant, int row, int views) {
    FaceMesh mesh;
    for (int view = 0; view < views; ++view) {
        const Card card = pictures.draw(plant, 0.5 * kTurn * view / views, view, row);
        addCard(mesh, card, [&](const Vec3& p) {
            return glm::normalize(Vec3(p.x - card.axis.x, p.y - card.axis.y, 0.0)) * 0.66 + Vec3(0, 0, 0.75);
        });
    }
    return mesh;
}

/// Half of a crown's width and height.
Vec2 halfSizeOf(const Crown& crown) {
    return Vec2(0.65 * crown.radius, 0.7 * crown.height) + crown.cardSize;
}

/// Adds crossing cards for a crown. `card`: shows another crown, `shown`.
void addCrownCards(FaceMesh& mesh, const Crown& crown, const Card& card, const Crown& shown, int cards) {
    const Vec2 scale = halfSizeOf(crown) / halfSizeOf(shown);
    const Vec3 bulge = crown.centre - Vec3(0, 0, crown.height * 0.4);
    for (int k = 0; k < cards; ++k) {
        const double turn = kTurn * (0.5 * k / cards + 0.13 * static_cast<double>(crown.seed % 8));
        Card own = card;
        own.axis = crown.centre + Vec3(0, 0, (card.axis.z - shown.centre.z) * scale.y);
        own.facing = {std::sin(turn), -std::cos(turn), 0.0};
        own.halfWidth *= scale.x;
        own.height *= scale.y;
        addCard(mesh, own, [&](const Vec3& p) { return glm::normalize(p - bulge + Vec3(0.0, 0.0, 1.0)); });
    }
}

/// The middle levels of a leaf tree: a trunk, and crossing pictures for each crown.
struct CrownLevels {
    FaceMesh middle, far;
};
CrownLevels crownLevels(PlantPictures& pictures, const LeafTree& tree, int row) {
    const Crown& shown = tree.crowns.front();
    FaceMesh drawn;
    addCrown(drawn, shown);
    const Card card = pictures.draw(drawn, 0.7, kOther, row);
    CrownLevels levels{trunkMesh(tree, 5), straightTrunkMesh(tree, 3)};
    for (const Crown& crown : tree.crowns) {
        addCrownCards(levels.middle, crown, card, shown, 3);
        addCrownCards(levels.far, crown, card, shown, 2);
    }
    return levels;
}

FaceMesh bushOfCards(PlantPictures& pictures) {
    const Card card = pictures.draw(bushMesh(), 0.7, kOther, kPineRow);
    FaceMesh mesh;
    for (int k = 0; k < 3; ++k) {
        Card own = card;
        own.facing = {std::sin(0.5 * kTurn * k / 3), -std::cos(0.5 * kTurn * k / 3), 0.0};
        addCard(mesh, own, [](const Vec3& p) { return glm::normalize(p + Vec3(0, 0, 0.3)); });
    }
    return mesh;
}

/// Adds plants with their levels of detail.
class PlantWriter {
public:
    explicit PlantWriter(ModelWriter& writer) : writer_(writer) {}

    struct Level {
        const FaceMesh mesh; ///< empty: nothing
        double upTo = 0.0;
    };
    dat::RecordId add(const FaceMesh& nearest, bool solid, double upTo, const std::vector<Level>& farther) {
        const dat::RecordId id = writer_.addMesh(nearest, solid);
        std::vector<FartherLevel> levels;
        for (const Level& level : farther)
            levels.push_back(
                {level.mesh.faces().empty() ? 0 : writer_.addMesh(level.mesh, false), level.upTo});
        writer_.setLevels(id, upTo, levels);
        return id;
    }
    dat::RecordId addTree(const FaceMesh& nearest, double upTo, const std::vector<Level>& farther) {
        return writer_.addSetup({{add(nearest, true, upTo, farther), {}}});
    }

private:
    ModelWriter& writer_;
};

void addTrees(PlantWriter& writer, PlantPictures& pictures, Plants& p) {
    const CrownLevels oaks = crownLevels(pictures, oak(), kOakRow),
                      birches = crownLevels(pictures, birch(), kBirchRow);
    const FaceMesh oakTree = treeMesh(oak()), birchTree = treeMesh(birch());
    p.oak = writer.addTree(
        oakTree, 50.0,
        {{oaks.middle, 200.0}, {oaks.far, 450.0}, {crossedViews(pictures, oakTree, kOakRow, 2)}});
    p.birch = writer.addTree(
        birchTree, 50.0,
        {{birches.middle, 200.0}, {birches.far, 450.0}, {crossedViews(pictures, birchTree, kBirchRow, 2)}});
    const FaceMesh pine = pineMesh({}), youngPine = pineMesh({4.2, 1.5, 6});
    p.pine = writer.addTree(
        pine, 60.0,
        {{pineMesh({9.5, 2.7, 6, 4, 0.66, 4}), 160.0}, {crossedViews(pictures, pine, kPineRow, 3)}});
    p.youngPine = writer.addTree(youngPine, 50.0, {{crossedViews(pictures, youngPine, kYoungPineRow, 3)}});
}

void addUndergrowth(PlantWriter& writer, PlantPictures& pictures, Plants& p) {
    p.bush = writer.add(bushMesh(), false, 20.0, {{bushOfCards(pictures), 450.0}, {}});
    p.stump = writer.add(stumpMesh(9), true, 20.0, {{stumpMesh(5), 300.0}, {}});
    p.grass = writer.add(tuftMesh(Material::GrassTuft, 0.34, 0.42, 2), false, 15.0,
                         {{tuftMesh(Material::GrassTuft, 0.38, 0.42, 1), 130.0}, {}});
    p.tallGrass = writer.add(tuftMesh(Material::GrassTuft, 0.45, 0.75, 3), false, 15.0,
                             {{tuftMesh(Material::GrassTuft, 0.5, 0.75, 1), 180.0}, {}});
    p.flowers = writer.add(tuftMesh(Material::Flowers, 0.28, 0.46, 2), false, 15.0,
                           {{tuftMesh(Material::Flowers, 0.32, 0.46, 1), 160.0}, {}});
    p.fern = writer.add(fernMesh(6, 0.2), false, 15.0, {{fernMesh(3, 0.3), 130.0}, {}});
}

void addStones(PlantWriter& writer, Plants& p) {
    const Vec3 rock(0.55, 0.42, 0.36), boulder(1.5, 1.2, 1.1);
    p.rock = writer.add(stoneMesh(rock, 3041), true, 20.0, {{stoneMesh(rock, 3041, 2), 300.0}, {}});
    p.boulder = writer.add(stoneMesh(boulder, 3043), true, 60.0, {{stoneMesh(boulder, 3043, 2)}});
}

} // namespace

Plants addPlants(ModelWriter& writer, const PictureOf& pictureOf, int field) {
    PlantPictures pictures(pictureOf, field);
    PlantWriter plants(writer);
    Plants p;
    addTrees(plants, pictures, p);
    addUndergrowth(plants, pictures, p);
    addStones(plants, p);
    setPicture(writer.records(), Material::FarPlants, pictures.take());
    return p;
}

} // namespace limen::worlds
