#include "worlds/generate/Props.h"

namespace limen::worlds {

namespace {

dat::RecordId boxModel(ModelWriter& writer, const Vec3& min, const Vec3& max, Material material) {
    FaceMesh mesh;
    mesh.beam(min, max, material);
    return writer.addMesh(mesh);
}

dat::RecordId cardModel(ModelWriter& writer, double from, double to, double bottom, double top,
                        Material material) {
    FaceMesh mesh;
    mesh.card({{{from, 0, bottom}, {to, 0, bottom}, {to, 0, top}, {from, 0, top}}}, material, true);
    return writer.addMesh(mesh);
}

dat::RecordId pillarModel(ModelWriter& writer) {
    FaceMesh mesh;
    FaceMesh::Round round;
    round.lower = 0.3;
    round.upper = 0.25;
    round.height = 2.2;
    round.sides = 8;
    round.side = Material::StoneWall;
    round.cap = Material::StoneWall;
    mesh.cylinder(round);
    mesh.box({-0.4, -0.4, 2.2}, {0.4, 0.4, 2.4}, Material::StoneWall);
    return writer.addMesh(mesh);
}

dat::RecordId lampModel(ModelWriter& writer) {
    FaceMesh mesh;
    mesh.box({-0.08, -0.08, 0.0}, {0.08, 0.08, 0.9}, Material::Wax);
    mesh.card({{{-0.15, 0, 0.9}, {0.15, 0, 0.9}, {0.15, 0, 1.25}, {-0.15, 0, 1.25}}}, Material::Flame, true);
    const dat::RecordId candle = writer.addMesh(mesh);
    return writer.addSetup({{candle, {}}}, {{{0.0, 0.0, 1.3}, 0xFFFFD9A0u, 1.0, 7.0}});
}

/// A candle on a turned stand.
dat::RecordId standModel(ModelWriter& writer) {
    FaceMesh mesh;
    mesh.cylinder({.base = {0, 0, 0}, .lower = 0.22, .upper = 0.18, .height = 0.06, .sides = 10});
    mesh.beam({-0.025, -0.025, 0.06}, {0.025, 0.025, 1.15}, Material::Iron);
    mesh.cylinder({.base = {0, 0, 1.15},
                   .lower = 0.06,
                   .upper = 0.11,
                   .height = 0.04,
                   .sides = 10,
                   .side = Material::Iron,
                   .cap = Material::Iron});
    mesh.cylinder({.base = {0, 0, 1.19},
                   .lower = 0.03,
                   .upper = 0.028,
                   .height = 0.14,
                   .sides = 8,
                   .side = Material::Wax,
                   .cap = Material::Wax});
    FaceMesh flame;
    for (const Vec3& side : {Vec3(0.045, 0, 0), Vec3(0, 0.045, 0)}) {
        const Vec3 foot(0.0, 0.0, 1.32), up(0.0, 0.0, 0.13);
        flame.card({foot - side, foot + side, foot + side + up, foot - side + up}, Material::Flame, true);
    }
    return writer.addSetup({{writer.addMesh(mesh), {}}, {writer.addMesh(flame, false), {}}},
                           {{{0.0, 0.0, 1.5}, 0xFFFFC070u, 0.5, 8.0}});
}

/// Replaces plain props by those of the built-in world, and adds its furniture.
void furnish(ModelWriter& writer, Props& props) {
    props.furnished = true;
    props.builtIn = addDungeonProps(writer, addFurniture(writer));
    const Furniture& house = props.builtIn.house;
    props.crate = house.crate;
    props.pane = cardModel(writer, -0.5, 0.5, -0.5, 0.5, Material::Glass);
    props.lamp = standModel(writer);
    props.standing = {{props.pillar},
                      {props.screen},
                      {props.lamp},
                      {house.crate, house.barrel, house.chest, house.sacks, house.stool, house.bench}};
}

} // namespace

Props addProps(ModelWriter& writer, bool furnished) {
    Props props;
    props.crate = boxModel(writer, {-0.35, -0.35, 0.0}, {0.35, 0.35, 0.7}, Material::OldPlanks);
    props.pillar = pillarModel(writer);
    props.screen = cardModel(writer, -0.6, 0.6, 0.0, 1.2, Material::Leaves);
    props.pane = cardModel(writer, -0.5, 0.5, -0.5, 0.5, Material::LampGlass);
    props.rod = boxModel(writer, {-0.8, -0.07, -0.07}, {0.8, 0.07, 0.07}, Material::Beam);
    props.pole = boxModel(writer, {-0.07, -0.07, -0.8}, {0.07, 0.07, 0.8}, Material::Beam);
    props.fence = boxModel(writer, {0.0, -0.05, -0.5}, {3.0, 0.05, 1.2}, Material::OldPlanks);
    props.lamp = lampModel(writer);
    props.standing = {{props.pillar}, {props.screen}, {props.lamp}, {props.crate}};
    if (furnished)
        furnish(writer, props);
    return props;
}

dat::RecordId pickProp(const Props& props, Random& random) {
    // One number for both choices: equal seeds give equal layouts, furnished or not.
    const std::uint64_t drawn = static_cast<std::uint64_t>(random.next()) * props.standing.size();
    const std::vector<dat::RecordId>& kind = props.standing[drawn >> 32];
    return kind[(drawn & 0xFFFFFFFFu) * kind.size() >> 32];
}

dat::RecordId addLeaf(ModelWriter& writer, const LeafSpec& leaf) {
    if (!leaf.opaque)
        return cardModel(writer, 0.0, leaf.width, 0.0, leaf.height,
                         leaf.furnished ? Material::Glass : Material::LampGlass);
    if (!leaf.furnished)
        return boxModel(writer, {0.0, -0.03, 0.0}, {leaf.width, 0.03, leaf.height}, Material::Planks);
    FaceMesh mesh;
    mesh.beam({0.0, -0.03, 0.0}, {leaf.width, 0.03, leaf.height}, Material::OldPlanks);
    for (const double z : {0.25, leaf.height - 0.4})
        mesh.box({0.01, -0.037, z}, {0.8 * leaf.width, 0.037, z + 0.06}, Material::Iron);
    mesh.box({leaf.width - 0.13, -0.045, 0.98}, {leaf.width - 0.08, 0.045, 1.12}, Material::Iron);
    return writer.addMesh(mesh);
}

} // namespace limen::worlds
