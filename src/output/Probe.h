#pragma once

#include "engine/FrameReport.h"

#include <string>
#include <vector>

namespace limen::output {

/// What a probe looks at: one frame's decisions.
struct ProbeFacts {
    std::uint64_t frame = 0;
    double seconds = 0.0; ///< since the first
    const world::World& world;
    const engine::FrameRequest& eye;
    const visibility::VisibleSet& visible;
    const frame::FramePlan& plan;
    std::uint32_t glCalls = 0;
};

/// Tells what changed from one frame to the next in what was decided: root, the camera's way from the body, visits, cells seen, whether outside is, stages, what is
/// loaded, budgets. A frame like the one before costs a comparison and no memory.
class Probe {
public:
    /// One JSON object a line, each ended; empty if nothing changed. The first frame tells everything.
    [[nodiscard]] std::string see(const ProbeFacts& facts);

private:
    /// What a frame decided, in the world's own numbers.
    struct Decisions {
        std::vector<std::uint32_t> blocks; ///< their coordinates
        std::vector<std::uint32_t> tree;   ///< of each visit: portal, parent, what it is
        std::vector<std::uint32_t> seen;   ///< spaces
        std::vector<std::uint32_t> stages; ///< of each batch: stage and program
        world::SpaceIndex root = world::kOutside;
        world::SpaceIndex body = world::kNone;
        bool isHeld = false;
        std::uint32_t visitsCut = 0;
        friend bool operator==(const Decisions&, const Decisions&) = default;
    };
    /// The same by names that hold when another part of the world is loaded.
    struct Names {
        std::string root, stages, centre, camera;
        std::vector<std::string> visits, cells; ///< sorted
        std::uint32_t visitsCut = 0;
    };
    static void take(const ProbeFacts& facts, Decisions& out);
    static Names name(const ProbeFacts& facts);

    bool isFirst_ = true;
    Decisions last_, now_;
    Names told_;
    Vec3 lastEye_{0.0};
};

} // namespace limen::output
