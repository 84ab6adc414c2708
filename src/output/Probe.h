#pragma once

#include "engine/FrameRequest.h"
#include "frame/FramePlan.h"
#include "visibility/VisibleSet.h"

#include <string>
#include <vector>

namespace limen::output {

/// One frame's decisions, the input of a probe. Valid during the call only.
struct ProbeFacts {
    std::uint64_t frame = 0;
    double seconds = 0.0; ///< since the first frame
    const world::World& world;
    const engine::FrameRequest& eye;
    const visibility::VisibleSet& visible;
    const frame::FramePlan& plan;
    std::uint32_t glCalls = 0;
};

/// Reports changes of the decisions from frame to frame: root, the camera's spaces on its way from the body,
/// visits, cells seen, whether the outside is seen, stages, the gate with its spaces in order, the loaded blocks,
/// visits cut by the budget. A frame without a change costs one comparison and no allocation.
class Probe {
public:
    /// One JSON object a line, each with a newline; empty if nothing changed. The first frame reports all
    /// decisions.
    [[nodiscard]] std::string see(const ProbeFacts& facts);

private:
    /// A frame's decisions as indices of the loaded part, for the comparison.
    struct Decisions {
        std::vector<std::uint32_t> blocks; ///< their coordinates
        std::vector<std::uint32_t> tree;   ///< of each visit: portal, parent, and its flags
        std::vector<std::uint32_t> seen;   ///< spaces
        std::vector<std::uint32_t> stages; ///< number of batches, by stage
        std::vector<frame::GatedSpace> gated;
        frame::Gate gate = frame::Gate::Ownership;
        world::SpaceIndex root = world::kOutside;
        world::SpaceIndex body = world::kNone;
        bool isHeld = false;
        std::uint32_t visitsCut = 0;
        friend bool operator==(const Decisions&, const Decisions&) = default;
    };
    /// The decisions by names that stay valid when another part of the world is loaded.
    struct Names {
        std::string root, stages, centre, camera;
        std::vector<std::string> visits, cells; ///< sorted
        std::uint32_t visitsCut = 0;
    };
    static void take(const ProbeFacts& facts, Decisions& out);
    static Names name(const ProbeFacts& facts);

    bool isFirst_ = true;
    Decisions last_, now_;
    Names reported_;
    Vec3 lastEye_{0.0};
};

} // namespace limen::output
