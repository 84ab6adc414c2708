#pragma once

#include "frame/DrawRecords.h"
#include "gpu/BatchSlots.h"
#include "gpu/FrameRing.h"

namespace limen::gpu {

/// Writes a plan's draw commands and draw records on the CPU, for Drawing::Fast. A batch of a frame with
/// several visits has two parts: the second takes the ownership test. Seen from outside, draws that lamps light
/// are in the second part, too, so that the programs of the first part, which draws trees, have no lamps.
/// The plan has two batches of opaque surfaces, walls and others, with the ground between them. They are drawn as one,
/// which saves four calls; the exact way needs the walls first, to leave out what they hide.
/// Draws of one mesh in a part are one command, with an instance for each; large meshes come first (decision 212). A command is
/// a slot.
/// With FrameView::rootFirst a batch has one part. Cut-outs that lamps light are drawn after the clearing, for the same reason.
/// Reuse it: steady frames allocate nothing.
class FastDraws {
public:
    /// Assigns slots to the plan's indexed draws. `tables`: of the scene that the plan was made for.
    void prepare(const frame::FramePlan& plan, const RenderOptions& options,
                 const frame::RecordTables& tables);
    /// Whether draws with the ownership test have lists of members, because the plan has more visits than bits.
    [[nodiscard]] static bool listsMembers(const frame::FramePlan& plan) {
        return !frame::VisitBits::suffice(plan);
    }
    /// Draws, each with a record. There are at most as many slots.
    [[nodiscard]] std::uint32_t drawCount() const { return static_cast<std::uint32_t>(draws_.size()); }
    [[nodiscard]] const BatchSlots& slotsOf(std::size_t batch) const { return slots_[batch]; }
    /// Writes the commands and records of all slots into the frame's ring memory. Arguments as in `prepare`.
    /// `firstRecord`: the base instance of the ring's first record.
    void write(const frame::FramePlan& plan, const frame::RecordTables& tables, const FrameRing& ring,
               std::span<std::byte> memory, std::uint32_t firstRecord);

private:
    /// One draw: a piece of a run.
    struct Draw {
        std::uint64_t mesh = 0; ///< the same for all pieces with the same triangles, less for more triangles
        std::uint32_t piece = 0;
        bool gated = false;
    };
    /// Adds a part's draws and their commands. `anyOrder`: draws of one mesh are joined.
    void addPart(std::vector<Draw>& part, bool anyOrder);
    void addRuns(const frame::FramePlan& plan, const frame::Batch& batch, const frame::DrawRecords& makes,
                 BatchSlots& slots);
    /// Adds a piece of the known instance to one of both parts.
    void addPiece(const frame::Batch& batch, std::uint32_t number, bool gated, bool fromOutside,
                  const frame::DrawRecords& makes, BatchSlots& slots);
    /// Looks an instance up. `inRange`: PieceRun::inRange.
    void find(std::uint32_t instance, bool inRange, bool takesLamps, const frame::DrawRecords& makes);

    /// The instance that was looked at last: pieces of one instance often follow each other.
    struct Known {
        std::uint32_t number = 0xFFFFFFFFu;
        bool isHere = false, hasLamps = false;
    };
    Known known_;
    std::vector<std::uint32_t> late_; ///< pieces of the root's cut-outs that are drawn after the clearing
    std::uint32_t firstCutOut_ = 0;   ///< FrameView::rootFirst: the first run of cut-outs
    std::vector<BatchSlots> slots_;
    std::vector<Draw> draws_;               ///< by record
    std::vector<std::uint32_t> commands_;   ///< by slot: its first draw
    std::vector<Draw> part_, second_;       ///< both parts of the batch being added
    std::vector<frame::gpu::Instance> own_; ///< the plan's instances
    frame::VisitBits visits_;
};

} // namespace limen::gpu
