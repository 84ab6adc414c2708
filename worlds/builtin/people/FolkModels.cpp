#include "worlds/builtin/people/FolkModels.h"

#include "geometry/Angles.h"
#include "worlds/builtin/people/FolkClothes.h"
#include "worlds/builtin/people/FolkGaits.h"

namespace limen::worlds {

namespace {

constexpr double kNeck = 1.48;
constexpr double kShoulderOut = 0.205,
                 kShoulderUp = 1.365; ///< metres; inside the body, so that no pose parts the arm from it

struct Clothes {
    Material coat = Material::BrownCloth, legs = Material::GreenCloth;
    bool gown = false, apron = false, hat = false;
};

void addRing(FaceMesh& mesh, double z0, double z1, double lower, double upper, Material side, bool caps) {
    mesh.cylinder({.base = {0, 0, z0},
                   .lower = lower,
                   .upper = upper,
                   .height = z1 - z0,
                   .sides = 10,
                   .side = side,
                   .cap = side,
                   .caps = caps});
}

constexpr double kWaist = 1.02, kHem = 0.10; ///< heights of a gown, metres

/// Scales the depth of a body: shoulders are wider than a body is deep.
void flatten(FaceMesh& mesh, double depth) {
    for (Face& face : mesh.faces()) {
        for (Vec3& p : face.points)
            p.y *= depth;
        for (Vec3& n : face.normals)
            n = glm::normalize(Vec3(n.x, n.y / depth, n.z));
    }
}

/// A skirt nearly as deep as wide, so that the legs can move inside.
FaceMesh skirtMesh(const Clothes& c) {
    FaceMesh mesh;
    addRing(mesh, kHem, kWaist, 0.36, 0.15, c.coat, true);
    flatten(mesh, 0.9);
    if (c.apron)
        mesh.strut({0, 0.13, 1.03}, {0, 0.25, 0.45}, {1, 0, 0}, 0.28, 0.03, Material::Linen);
    return mesh;
}

FaceMesh bodyMesh(const Clothes& c) {
    FaceMesh mesh;
    if (!c.gown)
        addRing(mesh, 0.74, kWaist, 0.235, 0.195, c.coat, true);
    addRing(mesh, kWaist, 1.07, 0.20, 0.20, Material::Hair, true);
    addRing(mesh, 1.07, 1.34, 0.19, 0.235, c.coat, true);
    addRing(mesh, 1.34, 1.42, 0.235, 0.20, c.coat, true);
    addRing(mesh, 1.42, kNeck, 0.20, 0.10, c.coat, true);
    flatten(mesh, 0.68);
    if (c.gown)
        mesh.append(skirtMesh(c), {});
    else if (c.apron)
        mesh.box({-0.13, 0.12, 0.50}, {0.13, 0.215, 1.03}, Material::Linen);
    if (c.apron)
        mesh.box({-0.11, 0.10, 1.05}, {0.11, 0.17, 1.30}, Material::Linen);
    return mesh;
}

FaceMesh headMesh(const Clothes& c) {
    FaceMesh mesh; // origin at the neck
    addRing(mesh, -0.03, 0.05, 0.058, 0.055, Material::Skin, true);
    addRing(mesh, 0.04, 0.10, 0.072, 0.098, Material::Skin, true);
    addRing(mesh, 0.10, 0.18, 0.098, 0.104, Material::Skin, true);
    addRing(mesh, 0.18, 0.26, 0.104, 0.06, Material::Skin, true);
    mesh.box({-0.016, 0.09, 0.10}, {0.016, 0.125, 0.15}, Material::Skin);
    for (const double x : {-0.042, 0.042})
        mesh.box({x - 0.012, 0.088, 0.158}, {x + 0.012, 0.103, 0.176}, Material::Hair);
    FaceMesh hair;
    addRing(hair, 0.07, 0.20, 0.10, 0.115, Material::Hair, true);
    for (Face& face : hair.faces())
        for (Vec3& p : face.points)
            p.y = std::min(p.y - 0.028, 0.02);
    mesh.append(hair, {});
    addRing(mesh, 0.20, 0.28, 0.114, 0.055, Material::Hair, true);
    if (c.hat) {
        addRing(mesh, 0.205, 0.222, 0.21, 0.20, c.legs, true);
        addRing(mesh, 0.222, 0.33, 0.118, 0.085, c.legs, true);
    }
    return mesh;
}

/// The origin is the shoulder's joint. `side`: -1 left, 1 right; the arm hangs a little away from the body. `bend`: of the
/// elbow, radians.
FaceMesh armMesh(const Clothes& c, double side, double bend) {
    FaceMesh mesh;
    const Vec3 elbow{side * 0.085, 0.02, -0.28};
    const Vec3 hand = elbow + Vec3(side * 0.01, 0.24 * std::sin(bend), -0.24 * std::cos(bend));
    // The ball of the shoulder: round about the axis about which the arm swings.
    for (const auto& [z, lower, upper] : {std::array{-0.055, 0.060, 0.074}, std::array{0.0, 0.074, 0.035}}) {
        mesh.cylinder({.base = {side * 0.02, 0, z},
                       .lower = lower,
                       .upper = upper,
                       .height = 0.055,
                       .sides = 8,
                       .side = c.coat,
                       .cap = c.coat});
    }
    mesh.strut({side * 0.03, 0, -0.03}, elbow + Vec3(0, 0.01, -0.03), {1, 0, 0}, 0.105, 0.11, c.coat);
    mesh.strut(elbow + Vec3(0, 0.0, 0.01), hand, {1, 0, 0}, 0.088, 0.088, c.coat);
    const Vec3 ahead = glm::normalize(hand - elbow);
    mesh.strut(hand - ahead * 0.01, hand + ahead * 0.10, {1, 0, 0}, 0.062, 0.075, Material::Skin);
    return mesh;
}

FaceMesh legMesh(const Clothes& c) {
    FaceMesh mesh;                                         // origin at the hip
    addRing(mesh, -0.18, 0.0, 0.095, 0.045, c.legs, true); // inside the coat at every angle of the leg
    addRing(mesh, -0.46, -0.18, 0.075, 0.095, c.legs, true);
    addRing(mesh, -0.82, -0.44, 0.058, 0.078, c.legs, true);
    mesh.box({-0.055, kHeel, -kHip}, {0.055, kToe, -0.79}, Material::Hair);
    return mesh;
}

/// A shadow on the ground: an octagon, `half` metres to each side of the origin. It is high enough not to fight with the ground.
FaceMesh shadowMesh(const Vec2& half) {
    constexpr double kAbove = 0.015;
    constexpr int kCorners = 8;
    Face face;
    face.material = Material::Shadow;
    for (int k = 0; k < kCorners; ++k) {
        const Vec2 d(std::cos(kTurn * k / kCorners), std::sin(kTurn * k / kCorners));
        face.points.emplace_back(half.x * d.x, half.y * d.y, kAbove);
        face.uvs.push_back(0.5 + 0.5 * d);
    }
    FaceMesh mesh;
    mesh.add(std::move(face));
    return mesh;
}

struct Bends {
    double left = 0.2, right = 0.2;
};

std::vector<SetupPart> person(ModelWriter& writer, const Clothes& c, const Bends& bends) {
    const dat::RecordId leg = writer.addMesh(legMesh(c), false);
    return {{writer.addMesh(bodyMesh(c), false), {}},
            {writer.addMesh(headMesh(c), false), {{0.0, 0.0, kNeck}, 0.0}},
            {writer.addMesh(armMesh(c, -1.0, bends.left), false), {{-kShoulderOut, 0.0, kShoulderUp}, 0.0}},
            {writer.addMesh(armMesh(c, 1.0, bends.right), false), {{kShoulderOut, 0.0, kShoulderUp}, 0.0}},
            {leg, {{-0.105, 0.0, kHip}, 0.0}},
            {leg, {{0.105, 0.0, kHip}, 0.0}}};
}

/// Adds a person's shadow as the last part, which keeps the pose of the Setup.
dat::RecordId addPerson(ModelWriter& writer, std::vector<SetupPart> parts, dat::RecordId shadow,
                        dat::RecordId gaits) {
    parts.push_back({shadow, {}});
    return writer.addSetup(parts, {}, gaits);
}

FaceMesh lanternMesh() {
    FaceMesh mesh; // origin at the middle of its flame
    mesh.box({-0.07, -0.07, -0.13}, {0.07, 0.07, -0.10}, Material::Iron);
    mesh.box({-0.07, -0.07, 0.10}, {0.07, 0.07, 0.13}, Material::Iron);
    for (const double x : {-0.06, 0.048})
        for (const double y : {-0.06, 0.048})
            mesh.beam({x, y, -0.10}, {x + 0.012, y + 0.012, 0.10}, Material::Iron);
    mesh.beam({-0.006, -0.006, 0.13}, {0.006, 0.006, 0.24}, Material::Iron);
    mesh.box({-0.02, -0.02, -0.10}, {0.02, 0.02, -0.02}, Material::Wax);
    return mesh;
}

/// A wheel in the plane x = 0, its hub at the origin.
FaceMesh wheelMesh() {
    FaceMesh mesh;
    constexpr double kRim = 0.52;
    for (int k = 0; k < kSpokes; ++k) {
        const auto at = [](double turns) {
            const double a = kTurn * turns / kSpokes;
            return Vec3(0.0, kRim * std::cos(a), kRim * std::sin(a));
        };
        mesh.strut(at(k - 0.02), at(k + 1.02), {1, 0, 0}, 0.07, 0.08, Material::OldPlanks);
        mesh.strut({0, 0, 0}, at(k) * 0.97, {1, 0, 0}, 0.036, 0.045, Material::OldPlanks);
    }
    mesh.box({-0.09, -0.08, -0.08}, {0.09, 0.08, 0.08}, Material::Beam);
    return mesh;
}

FaceMesh cartMesh() {
    FaceMesh mesh; // origin on the ground below the axle
    mesh.beam({-0.74, -0.05, 0.46}, {0.74, 0.05, 0.56}, Material::Beam);
    mesh.beam({-0.58, -1.05, 0.62}, {0.58, 0.95, 0.67}, Material::OldPlanks);
    for (const double x : {-0.60, 0.54}) {
        mesh.beam({x, -1.05, 0.56}, {x + 0.06, 1.95, 0.63}, Material::Beam);
        mesh.beam({x + 0.01, -1.04, 0.67}, {x + 0.05, 0.94, 1.0}, Material::OldPlanks);
    }
    mesh.beam({-0.55, -1.045, 0.67}, {0.55, -1.005, 0.92}, Material::OldPlanks);
    mesh.beam({-0.55, 0.90, 0.67}, {0.55, 0.938, 0.96}, Material::OldPlanks);
    mesh.beam({-0.54, 1.86, 0.645}, {0.54, 1.93, 0.715}, Material::Oak);
    for (const double y : {-0.62, 0.0, 0.55}) {
        mesh.cylinder({.base = {y == 0.0 ? 0.22 : -0.18, y, 0.67},
                       .lower = 0.24,
                       .upper = 0.15,
                       .height = 0.48,
                       .sides = 10,
                       .side = Material::Sacking,
                       .cap = Material::Sacking});
    }
    mesh.box({0.05, 0.30, 0.67}, {0.50, 0.80, 1.02}, Material::OldPlanks);
    return mesh;
}

/// The arm with the lantern does not move: the emitter in `world.json` is at the lantern's fixed position.
dat::RecordId addWatchman(ModelWriter& writer, dat::RecordId shadow) {
    std::vector<SetupPart> parts =
        person(writer, {.coat = Material::BlueCloth, .legs = Material::BrownCloth, .hat = true}, {0.2, 0.35});
    parts.push_back({writer.addMesh(lanternMesh(), false), {kLantern, 0.0}});
    parts.push_back({shadow, {}});
    const std::vector<Role> roles{Role::Body,    Role::Head,     Role::LeftArm, Role::Held,
                                  Role::LeftLeg, Role::RightLeg, Role::Held,    Role::Held};
    return writer.addSetup(parts, {}, addGaits(writer, parts, roles, longStrides()));
}

/// Both hands hold the cart.
dat::RecordId addCarter(ModelWriter& writer, dat::RecordId shadow) {
    constexpr double kAxle = -2.1;
    std::vector<SetupPart> parts =
        person(writer, {.coat = Material::RedCloth, .legs = Material::GreenCloth, .hat = true}, {-0.3, -0.3});
    const dat::RecordId wheel = writer.addMesh(wheelMesh(), false);
    parts.push_back({writer.addMesh(cartMesh(), false), {{0.0, kAxle, 0.0}, 0.0}});
    parts.push_back({wheel, {{-0.70, kAxle, kWheelRadius}, 0.0}});
    parts.push_back({wheel, {{0.70, kAxle, kWheelRadius}, 0.0}});
    parts.push_back({shadow, {}});
    parts.push_back({writer.addMesh(shadowMesh({0.9, 1.0}), false), {{0.0, kAxle, 0.0}, 0.0}});
    const std::vector<Role> roles{Role::Body,    Role::Head,     Role::Held, Role::Held,
                                  Role::LeftLeg, Role::RightLeg, Role::Held, Role::Wheel,
                                  Role::Wheel,   Role::Held,     Role::Held};
    return writer.addSetup(parts, {}, addGaits(writer, parts, roles, longStrides()));
}

} // namespace

FolkModels addFolkModels(ModelWriter& writer, const Effects& effects) {
    const std::vector<Role> bare{Role::Body,    Role::Head,     Role::LeftArm, Role::RightArm,
                                 Role::LeftLeg, Role::RightLeg, Role::Held};
    const dat::RecordId shadow = writer.addMesh(shadowMesh({0.45, 0.40}), false);
    std::vector<SetupPart> farmer =
        person(writer, {.coat = Material::GreenCloth, .legs = Material::BrownCloth, .hat = true}, {0.2, 0.3});
    std::vector<SetupPart> shaded = farmer;
    shaded.push_back({shadow, {}});
    const dat::RecordId free = addGaits(writer, shaded, bare, longStrides(), effects.dust);
    const dat::RecordId gowned = addGaits(writer, shaded, bare, shortStrides());
    FolkModels m;
    m.innkeeper = addPerson(
        writer,
        person(writer, {.coat = Material::BrownCloth, .legs = Material::Hair, .apron = true}, {0.9, 0.5}),
        shadow, gowned);
    m.maid = addPerson(
        writer,
        person(writer, {.coat = Material::BlueCloth, .legs = Material::Hair, .gown = true, .apron = true},
               {0.6, 0.6}),
        shadow, gowned);
    m.farmer = addPerson(writer, std::move(farmer), shadow, free);
    m.elder = addPerson(
        writer,
        person(writer, {.coat = Material::RedCloth, .legs = Material::Hair, .gown = true}, {1.0, 1.0}),
        shadow, gowned);
    m.watchman = addWatchman(writer, shadow);
    writer.setEffects(m.watchman, {.scriptTable = effects.watchmansScripts});
    m.carter = addCarter(writer, shadow);
    writer.setEffects(m.carter, {.script = effects.cartScript});
    m.traveller =
        addPerson(writer,
                  person(writer, {.coat = Material::BrownCloth, .legs = Material::BlueCloth, .hat = true},
                         {0.25, 0.25}),
                  shadow, free);
    const dat::RecordId cloaked =
        writer.addMesh(bodyMesh({.coat = Material::Rug, .legs = Material::BrownCloth}), false);
    m.cloak = addCloak(writer, {m.farmer, m.traveller}, cloaked);
    return m;
}

} // namespace limen::worlds
