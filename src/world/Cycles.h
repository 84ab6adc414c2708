#pragma once

#include "world/Records.h"

#include <optional>

namespace limen::world {

/// Reads what models do while they stand, walk and run into a world's arrays: each Setup's cycles and each Animation's frames
/// once. What is missing or damaged is said in the records' findings, and is left out of the cycle that names it; a cycle
/// of which nothing is left is none.
class Cycles {
public:
    Cycles(Records& records, World& world) : records_(records), world_(world) {}

    /// By Gait, as in MovingBody::cycles. Standing is the default substate of its motion table's default style, else the
    /// Setup's own animation; walking and running are of the same style. All kNone for what is no Setup or has neither.
    [[nodiscard]] std::array<std::uint32_t, kGaits> of(dat::RecordId model);

    /// How a model turns as a whole while it stands: radians a second, about an axis in its own frame; zero for most.
    [[nodiscard]] Vec3 spinOf(dat::RecordId model);

    /// A hook of a frame, and when a cycle comes by it.
    struct Hook {
        const dat::AnimationHook* hook = nullptr; ///< of a record
        double seconds = 0.0;                     ///< since the cycle's first frame
        double period = 0.0;                      ///< again every so many seconds; 0: once
    };
    /// The hooks that a cycle passes in their direction, in the order it does.
    [[nodiscard]] std::vector<Hook> hooksOf(std::uint32_t cycle) const;

private:
    /// Frames of an Animation in World::partFrames.
    struct Frames {
        std::uint32_t first = 0, partCount = 0, frameCount = 0;
    };
    [[nodiscard]] std::array<std::uint32_t, kGaits> read(const dat::Setup& setup);
    /// kNone if there is nothing to play.
    [[nodiscard]] std::uint32_t addCycle(std::span<const dat::AnimationRange> ranges, const Vec3& velocity);
    [[nodiscard]] std::uint32_t addCycle(const dat::MotionTable& table, std::uint32_t substate);
    [[nodiscard]] std::optional<Stretch> stretchOf(const dat::AnimationRange& range);
    [[nodiscard]] const Frames& framesOf(dat::RecordId animation);
    void addHooks(std::uint32_t stretch, double begin, double period, std::vector<Hook>& out) const;

    Records& records_;
    World& world_;
    std::unordered_map<dat::RecordId, std::array<std::uint32_t, kGaits>> bySetup_;
    std::unordered_map<dat::RecordId, Frames> byAnimation_;
    struct Source {
        const dat::Animation* animation = nullptr;
        std::uint32_t low = 0; ///< its first frame
    };
    std::vector<Source> sources_; ///< by World::stretches
};

/// Whether a body of a cycle stands as it rests at every moment, within what nobody sees.
[[nodiscard]] bool isAtRest(const World& world, const MovingBody& body, std::uint32_t cycle);

/// The ball around a body in all its poses, in its own frame: around `body.bounds` as given, which is of its parts as they
/// rest, and around the ball of each part at every moment of every cycle. Requires: parts, what they show, and cycles are in the world.
[[nodiscard]] Sphere boundsInMotion(const World& world, const MovingBody& body);

} // namespace limen::world
