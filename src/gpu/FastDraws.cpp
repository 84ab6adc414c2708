#include "gpu/FastDraws.h"

#include "core/Assert.h"

namespace limen::gpu {

namespace {

namespace layout = frame::gpu;

bool isOfSky(const layout::DrawPiece& piece) {
    return (piece.triangles & layout::kNeverCulled) != 0;
}

} // namespace

void FastDraws::prepare(const frame::FramePlan& plan, const RenderOptions& options,
                        const frame::RecordTables& tables) {
    own_.resize(plan.dynamicInstances.size() + plan.records.size());
    writeInstances(plan, own_);
    slots_.clear();
    draws_.clear();
    const frame::DrawRecords makes(tables, plan, own_);
    for (const frame::Batch& batch : plan.batches) {
        const auto first = static_cast<std::uint32_t>(draws_.size());
        slots_.push_back({first, first, first});
        if (hasSlots(batch, options))
            addBatch(plan, batch, makes);
    }
}

void FastDraws::addBatch(const frame::FramePlan& plan, const frame::Batch& batch,
                         const frame::DrawRecords& makes) {
    const bool fromOutside = plan.constants.rootZone == layout::kOutside;
    const bool takesLamps = batch.program != frame::Program::Terrain; // its corners are too far apart
    const bool isWhole = batch.program == frame::Program::Blended;    // back to front
    BatchSlots& slots = slots_.back();
    second_.clear();
    std::uint32_t last = 0xFFFFFFFFu; // pieces of one instance often follow each other
    bool isHere = false, hasLamps = false;
    for (const frame::PieceRun& run : std::span(plan.runs).subspan(batch.first, batch.count)) {
        for (std::uint32_t number = run.firstPiece; number < run.firstPiece + run.pieceCount; ++number) {
            const layout::DrawPiece& piece = makes.piece(number);
            if (isOfSky(piece)) {
                draws_.push_back({number, false});
                continue;
            }
            if (piece.instance != last) {
                last = piece.instance;
                isHere = makes.isInRange(last);
                hasLamps = isHere && takesLamps && makes.hasLamps(last);
            }
            if (!isHere)
                continue;
            const bool inSecond = batch.gated && (isWhole || run.gated || (hasLamps && fromOutside));
            (inSecond ? second_ : draws_).push_back({number, run.gated});
            bool& lamps = inSecond ? slots.lampsInSecond : slots.lampsInFirst;
            lamps = lamps || hasLamps;
        }
    }
    slots.second = static_cast<std::uint32_t>(draws_.size());
    draws_.insert(draws_.end(), second_.begin(), second_.end());
    slots.end = static_cast<std::uint32_t>(draws_.size());
}

void FastDraws::write(const frame::FramePlan& plan, const frame::RecordTables& tables, const FrameRing& ring,
                      std::span<std::byte> memory) {
    const std::span<layout::DrawCommand> commands = ring.commands(memory);
    const std::span<layout::DrawRecord> records = ring.records(memory);
    LIMEN_ASSERT(commands.size() == draws_.size() && records.size() == draws_.size(),
                 "a record for each slot");
    const frame::DrawRecords makes(tables, plan, own_);
    std::uint32_t last = 0xFFFFFFFFu;
    layout::DrawRecord record;
    for (std::uint32_t slot = 0; slot < draws_.size(); ++slot) {
        const layout::DrawPiece& piece = makes.piece(draws_[slot].piece);
        const bool ofSky = isOfSky(piece);
        // The record is an instanced attribute, found by the base instance. Sky objects have none.
        commands[slot] = {3 * (piece.triangles & ~layout::kNeverCulled), 1, piece.firstIndex, 0,
                          ofSky ? piece.instance : slot};
        if (ofSky)
            continue;
        if (piece.instance != last) {
            last = piece.instance;
            record = makes.of(last);
        }
        records[slot] = record;
        if (!draws_[slot].gated)
            records[slot].members.y = 0;
    }
}

} // namespace limen::gpu
