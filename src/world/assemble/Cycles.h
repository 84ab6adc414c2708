#pragma once

#include "world/records/Records.h"

#include <map>
#include <optional>

namespace limen::world {

/// Adds the cycles of Setups to a World: the animations of standing, walking and running. Each Setup and each
/// Animation is added once. A missing or damaged animation is reported and left out of its cycle; a cycle
/// without any is kNone.
class Cycles {
public:
    Cycles(Records& records, World& world) : records_(records), world_(world) {}

    /// By Gait, as in MovingBody::cycles. Stand is the default substate of the motion table's default style,
    /// else the Setup's own animation. Walk and Run are of the same style. All kNone for a GfxObj and for a
    /// Setup without motion table and animation. `motionTable`: in place of the Setup's own; 0: that one.
    [[nodiscard]] std::array<std::uint32_t, kGaits> of(dat::RecordId model, dat::RecordId motionTable = 0);

    /// The rotation of a whole model while it stands: radians a second, about an axis in its own frame. Zero
    /// for most models.
    [[nodiscard]] Vec3 spinOf(dat::RecordId model, dat::RecordId motionTable = 0);

    /// A hook of a frame, and the times at which a cycle passes it.
    struct Hook {
        const dat::AnimationHook* hook = nullptr; ///< owned by Records
        double seconds = 0.0;                     ///< since the cycle's first frame
        double period = 0.0;                      ///< seconds between repetitions; 0: once
    };
    /// The hooks that a cycle passes in their direction, in order of time.
    [[nodiscard]] std::vector<Hook> hooksOf(std::uint32_t cycle) const;

private:
    /// Frames of an Animation in World::partFrames.
    struct Frames {
        std::uint32_t first = 0, partCount = 0, frameCount = 0;
    };
    [[nodiscard]] std::array<std::uint32_t, kGaits> read(const dat::Setup& setup, dat::RecordId motionTable);
    /// kNone if no range has frames.
    [[nodiscard]] std::uint32_t addCycle(std::span<const dat::AnimationRange> ranges, const Vec3& velocity);
    [[nodiscard]] std::uint32_t addCycle(const dat::MotionTable& table, std::uint32_t substate);
    [[nodiscard]] std::optional<Stretch> stretchOf(const dat::AnimationRange& range);
    [[nodiscard]] const Frames& framesOf(dat::RecordId animation);
    void addHooks(std::uint32_t stretch, double begin, double period, std::vector<Hook>& out) const;

    Records& records_;
    World& world_;
    /// By Setup and motion table.
    std::map<std::pair<dat::RecordId, dat::RecordId>, std::array<std::uint32_t, kGaits>> bySetup_;
    std::unordered_map<dat::RecordId, Frames> byAnimation_;
    struct Source {
        const dat::Animation* animation = nullptr;
        std::uint32_t low = 0; ///< its first frame
    };
    std::vector<Source> sources_; ///< by World::stretches
};

/// True if a cycle keeps all parts of a body in their resting poses, within 0.1 mm.
[[nodiscard]] bool isAtRest(const World& world, const MovingBody& body, std::uint32_t cycle);

/// The sphere around a body in all its poses, in its own frame. It contains `body.bounds`, which holds the
/// resting pose, and the sphere of each part at every time of every cycle. Requires: the body's parts, meshes
/// and cycles are in the world.
[[nodiscard]] Sphere boundsInMotion(const World& world, const MovingBody& body);

} // namespace limen::world
