#pragma once

#include "motion/PartPoses.h"
#include "motion/Particles.h"
#include "world/DynamicState.h"
#include "world/Membership.h"
#include "world/World.h"

#include <optional>
#include <span>
#include <vector>

namespace limen::motion {

/// Where the player's body stands, and how much of it is seen.
struct PlayerBody {
    Vec3 feet{0.0};                            ///< global
    double yaw = 0.0;                          ///< compass direction that it faces, degrees
    world::SpaceIndex space = world::kOutside; ///< that its middle is in
    double opacity = 1.0;                      ///< 0: not seen .. 1: solid
    double speed = 0.0;                        ///< metres a second that it walks or runs; 0: it stands
    double metres = 0.0;                       ///< that it has walked: where it is in its stride
    friend bool operator==(const PlayerBody&, const PlayerBody&) = default;
};

/// What a moment depends on.
struct DynamicStateInput {
    double seconds = 0.0; ///< since the world began; routes and sprites follow it
    /// How far the doors are open, 0..1, by World::doors; doors beyond its end stand as they rest.
    std::span<const double> doors;
    std::optional<double> allDoors; ///< for all of them alike; before `doors`
    bool rain = false;              ///< it rains and the player is outside (docs/ray-rule.md)
    std::optional<world::SkyHour>
        weather;                      ///< the Region's weather falls as at that hour: the player is outside
    std::optional<PlayerBody> player; ///< none: nobody is there
    Vec3 eye{0.0};                    ///< global; weather falls around it
    Vec3 right{1, 0, 0}, up{0, 0, 1}, forward{0, 1, 0}; ///< what sprites face
};

/// Where everything that moves is, to which spaces it belongs, and what is shut. A pure function of world and input;
/// keeps memory so that steady frames allocate nothing. The world must outlive it.
class DynamicStateBuilder {
public:
    explicit DynamicStateBuilder(const world::World& world);

    /// `out` is overwritten.
    void at(const DynamicStateInput& input, world::DynamicState& out);

    /// Where a villager stands: feet, compass direction it faces, and the space its feet are in, found by walking the
    /// way from the last point of its route.
    struct Standing {
        Vec3 position{0.0};
        double yaw = 0.0;
        world::SpaceIndex space = world::kOutside;
    };
    [[nodiscard]] Standing standing(const world::Villager& villager, double seconds) const;

private:
    struct Pose {
        Mat3 linear{1.0};
        Vec3 origin{0.0}; ///< global
    };
    /// Where what carries a particle source, or the part of it, is: global.
    struct Carrier {
        Vec3 origin{0.0};
        Quat orientation{1.0, 0.0, 0.0, 0.0};
        world::SpaceIndex space = world::kOutside; ///< that the origin is in
    };
    [[nodiscard]] Carrier carrierOf(const world::ParticleSource& source, double seconds) const;
    [[nodiscard]] CyclePoint cyclePointOf(const world::ParticleSource& source, double seconds) const;
    /// A source with the times of its cycle turned into the world's; nothing if its carrier does not play that.
    [[nodiscard]] std::optional<world::ParticleSource> timed(const world::ParticleSource& source) const;
    /// What is left of one start of a source; `now`: where its carrier is.
    void addStarted(const DynamicStateInput& input, const world::ParticleSource& source, std::int64_t start,
                    const Carrier& now, world::DynamicState& out);
    /// `from`: the frame that it is seen from; its parts are stored in a block's.
    void addParticle(const DynamicStateInput& input, const world::ParticleSource& source, const Carrier& from,
                     const ParticleState& state, std::uint32_t block, world::DynamicState& out);
    void shut(const DynamicStateInput& input, world::DynamicState& out);
    /// What is block-local and stands as it is.
    void addInPlace(const world::MovingBody& body, world::DynamicState& out) const;
    void addDoors(const DynamicStateInput& input, world::DynamicState& out);
    void addVillagers(double seconds, world::DynamicState& out);
    void addPlayer(const PlayerBody& player, double seconds, world::DynamicState& out);
    void addLoose(world::DynamicState& out);
    void addSprites(const DynamicStateInput& input, const world::Emitter& emitter, world::DynamicState& out);
    void addIdle(double seconds, world::DynamicState& out);
    void addParticles(const DynamicStateInput& input, const world::ParticleSource& source,
                      world::DynamicState& out);
    void addRain(const DynamicStateInput& input, world::DynamicState& out);
    void addWeather(const DynamicStateInput& input, world::DynamicState& out);
    /// `side`: of the square around `middle` that it is born over, metres; 0: it goes with the eye, which is there.
    void addFalling(const DynamicStateInput& input, const world::SkyWeather& weather, const Vec3& middle,
                    double side, std::uint64_t seed, world::DynamicState& out);
    /// `point`: what its parts are at; {}: as they rest.
    void addBody(const world::MovingBody& body, const Pose& pose, const CyclePoint& point,
                 world::SpaceIndex placedIn, world::DynamicState& out);
    void addSprite(const DynamicStateInput& input, std::uint32_t part, const Vec3& at, Vec2 size,
                   double opacity, world::DynamicState& out);
    void giveMembers(std::size_t firstInstance, world::DynamicState& out) const;
    [[nodiscard]] double openness(const DynamicStateInput& input, std::size_t door) const;
    [[nodiscard]] std::uint32_t blockFor(const Vec3& position) const;

    const world::World& world_;
    world::Membership membership_;
    std::vector<world::SpaceIndex> reached_;
    std::uint32_t sprites_ = 0;
};

} // namespace limen::motion
