#include "motion/PartPoses.h"
#include "worlds/Loaded.h"
#include "worlds/builtin/people/FolkGaits.h"
#include "worlds/builtin/people/FolkModels.h"

#include <gtest/gtest.h>
#include <optional>

// The villagers' motions (standing, walking, running) as the engine plays them.
namespace limen::worlds::test {
namespace {

using world::Gait;

/// Indices of parts in every villager's Setup; higher ones are held objects.
enum : std::uint32_t { kBody, kHead, kLeftArm, kRightArm, kLeftLeg, kRightLeg, kHeld };

/// A villager in one gait.
struct Actor {
    const world::Villager& villager;
    Gait gait;

    [[nodiscard]] const world::MovingBody& body() const { return villager.body; }
    [[nodiscard]] const world::Cycle& cycle() const {
        return loaded().cycles.at(body().cycles[static_cast<std::size_t>(gait)]);
    }
    /// Length of the cycle: metres of walking or running, seconds of standing.
    [[nodiscard]] double round() const {
        const world::Stretch& stretch = loaded().stretches.at(cycle().firstStretch);
        return stretch.frameCount / stretch.rate *
               (gait == Gait::Stand ? 1.0 : glm::length(cycle().velocity));
    }
    [[nodiscard]] motion::PartPose pose(std::uint32_t part, double at) const {
        for (std::uint32_t i = 0; i < body().partCount; ++i) {
            if (loaded().posedParts.at(body().firstPosed + i).part == part)
                return motion::PartPoses(loaded(), body(), motion::cyclePoint(loaded(), body(), gait, at, at),
                                         motion::BetweenFrames::Interpolated)
                    .of(i);
        }
        ADD_FAILURE() << villager.name << " has no part " << part;
        return {};
    }
    /// A part's corners in the villager's frame.
    [[nodiscard]] std::vector<Vec3> corners(std::uint32_t part, double at) const {
        const motion::PartPose posed = pose(part, at);
        std::vector<Vec3> out;
        for (std::uint32_t i = 0; i < body().partCount; ++i) {
            if (loaded().posedParts.at(body().firstPosed + i).part != part)
                continue;
            const world::Mesh& mesh = loaded().meshes.at(loaded().movingParts.at(body().firstPart + i).mesh);
            for (std::uint32_t v = 0; v < mesh.vertexCount; ++v) {
                out.push_back(posed.origin +
                              posed.linear * loaded().vertices.at(mesh.firstVertex + v).corner());
            }
        }
        return out;
    }
    /// The forward turn (radians) of a part that hangs down.
    [[nodiscard]] double swing(std::uint32_t part, double at) const {
        const Vec3 down = pose(part, at).linear * Vec3(0, 0, -1);
        return std::atan2(down.y, -down.z);
    }
};

double lowest(const std::vector<Vec3>& points) {
    double z = 1e300;
    for (const Vec3& p : points)
        z = std::min(z, p.z);
    return z;
}

std::vector<Actor> everyone(Gait gait) {
    std::vector<Actor> out;
    for (const world::Villager& villager : loaded().villagers)
        out.push_back({villager, gait});
    EXPECT_GE(out.size(), 5u);
    return out;
}
std::optional<Actor> actor(const std::string& name, Gait gait) {
    for (const Actor& a : everyone(gait))
        if (a.villager.name == name)
            return a;
    return std::nullopt;
}

TEST(VillagersGaits, areThereForEveryone) {
    for (const Actor& a : everyone(Gait::Stand)) {
        for (const std::uint32_t cycle : a.body().cycles)
            EXPECT_NE(cycle, world::kNone) << a.villager.name;
        EXPECT_EQ(motion::gaitAt(loaded(), a.body(), a.villager.speed), Gait::Walk) << a.villager.name;
    }
    for (const world::Finding& finding : loaded().findings)
        ADD_FAILURE() << finding.what;
}

/// True if the point is in the convex hull of the others, or at most `beyond` metres outside; up to the spacing of the tested
/// directions.
bool isInHull(const Vec3& point, const std::vector<Vec3>& hull, double beyond) {
    constexpr int kDirections = 400;
    for (int k = 0; k < kDirections; ++k) {
        const double z = 1.0 - 2.0 * (k + 0.5) / kDirections, a = 2.39996323 * k;
        const Vec3 d(std::sqrt(1.0 - z * z) * std::cos(a), std::sqrt(1.0 - z * z) * std::sin(a), z);
        double most = -1e300;
        for (const Vec3& p : hull)
            most = std::max(most, glm::dot(p, d));
        if (glm::dot(point, d) > most + beyond)
            return false;
    }
    return true;
}

TEST(VillagersGaits, keepTheJointsOfArmsAndHeadInTheBody) {
    for (const Gait gait : {Gait::Stand, Gait::Walk, Gait::Run}) {
        for (const Actor& a : everyone(gait)) {
            for (int k = 0; k < 12; ++k) {
                const double at = a.round() * k / 12.0;
                const std::vector<Vec3> body = a.corners(kBody, at);
                for (const std::uint32_t part : {kHead, kLeftArm, kRightArm}) {
                    // A neck ends at the joint. An arm that holds something does not follow the body's turns.
                    const Vec3 joint = a.pose(part, at).origin - Vec3(0.0, 0.0, 0.005);
                    const bool holds = a.villager.name == "watchman" || a.villager.name == "carter";
                    EXPECT_TRUE(isInHull(joint, body, holds && part != kHead ? 0.03 : 0.0))
                        << a.villager.name << " part " << part << " at " << at;
                }
            }
        }
    }
}

TEST(VillagersGaits, keepFeetOnTheGroundWhileStanding) {
    for (const Actor& a : everyone(Gait::Stand)) {
        for (int k = 0; k < 97; ++k)
            for (const std::uint32_t leg : {kLeftLeg, kRightLeg})
                EXPECT_NEAR(lowest(a.corners(leg, a.round() * k / 97.0)), 0.0, 1e-6) << a.villager.name;
    }
}

TEST(VillagersGaits, moveHeadAndArmsABitWhileStanding) {
    for (const Actor& a : everyone(Gait::Stand)) {
        double head = 0.0;
        for (int k = 1; k < 50; ++k) {
            const double at = a.round() * k / 50.0;
            head = std::max(head, glm::length(a.pose(kHead, at).linear[1] - a.pose(kHead, 0.0).linear[1]));
            for (const std::uint32_t part : {kBody, kHead, kLeftArm, kRightArm}) {
                EXPECT_LT(glm::length(a.pose(part, at).origin - a.pose(part, 0.0).origin), 0.04);
                EXPECT_LT(std::abs(a.swing(part, at) - a.swing(part, 0.0)), 0.1);
            }
        }
        EXPECT_GT(head, 0.05) << a.villager.name;
    }
}

TEST(VillagersGaits, haveOneFootOnTheGroundWhileWalkingAndNoneBelow) {
    for (const Actor& a : everyone(Gait::Walk)) {
        double lifted = 0.0;
        for (int k = 0; k < 301; ++k) {
            const double at = a.round() * k / 301.0;
            const double left = lowest(a.corners(kLeftLeg, at)), right = lowest(a.corners(kRightLeg, at));
            EXPECT_GT(std::min(left, right), -0.003) << a.villager.name << " after " << at << " m";
            EXPECT_LT(std::min(left, right), 0.003) << a.villager.name << " after " << at << " m";
            lifted = std::max({lifted, left, right});
        }
        EXPECT_GT(lifted, 0.02) << a.villager.name;
        EXPECT_LT(lifted, 0.15) << a.villager.name;
    }
}

TEST(VillagersGaits, leaveTheGroundWhileRunning) {
    for (const Actor& a : everyone(Gait::Run)) {
        int inTheAir = 0;
        for (int k = 0; k < 200; ++k) {
            const double at = a.round() * k / 200.0;
            const double low = std::min(lowest(a.corners(kLeftLeg, at)), lowest(a.corners(kRightLeg, at)));
            EXPECT_GT(low, -0.005) << a.villager.name;
            inTheAir += low > 0.005 ? 1 : 0;
        }
        EXPECT_GT(inTheAir, 10) << a.villager.name;
        EXPECT_LT(inTheAir, 100) << a.villager.name;
    }
}

/// Follows each corner of a foot over the ground while it is within 3 mm of the ground.
TEST(VillagersGaits, keepFeetWhereTheyAreSetDown) {
    for (const Gait gait : {Gait::Walk, Gait::Run}) {
        for (const Actor& a : everyone(gait)) {
            double worst = 0.0;
            std::vector<std::optional<double>> setDown;
            constexpr int kSteps = 400;
            for (int k = 0; k < kSteps; ++k) {
                const double at = a.round() * k / kSteps;
                const std::vector<Vec3> foot = a.corners(kLeftLeg, at);
                setDown.resize(foot.size());
                for (std::size_t i = 0; i < foot.size(); ++i) {
                    if (foot[i].z > 0.003) {
                        setDown[i].reset();
                        continue;
                    }
                    const double ahead = foot[i].y + at; // position over the ground
                    setDown[i] = setDown[i].value_or(ahead);
                    worst = std::max(worst, std::abs(ahead - *setDown[i]));
                }
            }
            EXPECT_LT(worst, 0.012) << a.villager.name;
        }
    }
}

TEST(VillagersGaits, swingLegsAndArmsInOpposition) {
    for (const Actor& a : everyone(Gait::Walk)) {
        double most = 0.0;
        for (int k = 0; k < 100; ++k) {
            const double at = a.round() * k / 100.0;
            const double left = a.swing(kLeftLeg, at), right = a.swing(kRightLeg, at);
            most = std::max(most, left);
            EXPECT_LT(std::abs(left + right), 0.3) << a.villager.name;
            if (left - right > 0.3) {
                EXPECT_LE(a.swing(kLeftArm, at), 1e-6) << a.villager.name;
                EXPECT_GE(a.swing(kRightArm, at), -1e-6) << a.villager.name;
            }
        }
        EXPECT_GT(most, 0.2) << a.villager.name;
        EXPECT_LT(most, 0.6) << a.villager.name;
    }
}

TEST(VillagersGaits, leaveTheCartAloneButForItsWheels) {
    for (const Gait gait : {Gait::Stand, Gait::Walk, Gait::Run}) {
        const std::optional<Actor> carter = actor("carter", gait);
        ASSERT_TRUE(carter.has_value());
        for (int k = 0; k < 50; ++k) {
            const double at = 0.37 * k;
            for (const std::uint32_t held : {std::uint32_t{kLeftArm}, std::uint32_t{kRightArm}, kHeld + 0u}) {
                const motion::PartPose then = carter->pose(held, at), first = carter->pose(held, 0.0);
                EXPECT_LT(glm::length(then.origin - first.origin), 1e-9);
                EXPECT_LT(glm::length(then.linear[1] - first.linear[1]), 1e-9);
            }
            for (const std::uint32_t wheel : {kHeld + 1u, kHeld + 2u}) {
                // A wheel rolls: the angle of a spoke matches the distance, with its upper end forwards.
                const double angle = gait == Gait::Stand ? 0.0 : at / kWheelRadius;
                const Vec3 spoke = carter->pose(wheel, at).linear * Vec3(0, 0, 1);
                EXPECT_NEAR(spoke.y, std::sin(angle), 2e-3) << at;
                EXPECT_NEAR(spoke.z, std::cos(angle), 2e-3) << at;
                EXPECT_NEAR(carter->pose(wheel, at).origin.z, kWheelRadius, 1e-6);
            }
        }
    }
}

TEST(VillagersGaits, leaveTheLanternWhereItsLightIs) {
    for (const Gait gait : {Gait::Stand, Gait::Walk, Gait::Run}) {
        const std::optional<Actor> watchman = actor("watchman", gait);
        ASSERT_TRUE(watchman.has_value());
        for (int k = 0; k < 50; ++k)
            EXPECT_LT(glm::length(watchman->pose(kHeld, 0.37 * k).origin - kLantern), 1e-6);
    }
}

/// Below a gown's hem only shoes are visible, and no shin intersects the cloth.
TEST(VillagersGaits, keepLegsInsideGowns) {
    for (const char* name : {"maid", "elder"}) {
        const std::optional<Actor> a = actor(name, Gait::Walk);
        ASSERT_TRUE(a.has_value());
        const std::vector<Vec3> gown = a->corners(kBody, 0.0);
        Vec2 hem(0.0);
        for (const Vec3& p : gown)
            hem = p.z < 0.12 ? glm::max(hem, Vec2(std::abs(p.x), std::abs(p.y))) : hem;
        ASSERT_GT(hem.y, 0.2);
        for (int k = 0; k < 100; ++k) {
            for (const std::uint32_t leg : {kLeftLeg, kRightLeg}) {
                const motion::PartPose pose = a->pose(leg, a->round() * k / 100.0);
                const Vec3 shin = pose.origin + pose.linear * Vec3(0.0, 0.0, -0.78); // at the hem
                EXPECT_LT(std::hypot(shin.x / hem.x, shin.y / hem.y) + 0.06 / hem.y, 1.0) << name;
            }
        }
    }
}

TEST(VillagersGaits, stayWithinTheBodysBounds) {
    for (const Gait gait : {Gait::Stand, Gait::Walk, Gait::Run}) {
        for (const Actor& a : everyone(gait)) {
            const Sphere& bounds = a.body().bounds;
            for (int k = 0; k < 60; ++k) {
                for (std::uint32_t part = kBody; part <= kRightLeg; ++part)
                    for (const Vec3& p : a.corners(part, a.round() * k / 60.0))
                        EXPECT_LE(glm::length(p - bounds.centre), bounds.radius) << a.villager.name;
            }
            EXPECT_LT(bounds.radius, a.villager.name == "carter" ? 3.0 : 1.25) << a.villager.name;
        }
    }
}

} // namespace
} // namespace limen::worlds::test
