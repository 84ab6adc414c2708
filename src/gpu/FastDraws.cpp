#include "gpu/FastDraws.h"

#include "core/Assert.h"

#include <algorithm>
#include <limits>

namespace limen::gpu {

namespace {

namespace layout = frame::gpu;

bool isOfSky(const layout::DrawPiece& piece) {
    return (piece.triangles & layout::kNeverCulled) != 0;
}

std::uint64_t meshOf(const layout::DrawPiece& piece) {
    return std::uint64_t{~piece.triangles} << 32 | piece.firstIndex;
}

void setVisits(std::uint64_t visits, layout::DrawRecord& record) {
    record.members.x = static_cast<std::uint32_t>(visits);
    record.members.y = static_cast<std::uint32_t>(visits >> 32) | layout::kGated;
}

/// The other batch of opaque surfaces of a stage, walls or not, if both take the same gate; else kAlone.
constexpr std::size_t kAlone = std::numeric_limits<std::size_t>::max();
std::size_t partnerOf(const frame::FramePlan& plan, const frame::Stage& stage, std::size_t batch) {
    const frame::Batch& of = plan.batches[batch];
    // Other gates draw the spaces one after another.
    if (of.program != frame::Program::Opaque || plan.gate != frame::Gate::Ownership)
        return kAlone;
    for (std::size_t i = stage.firstBatch; i < stage.firstBatch + stage.batchCount; ++i)
        if (i != batch && plan.batches[i].program == of.program && plan.batches[i].gated == of.gated &&
            plan.batches[i].turn == of.turn)
            return i;
    return kAlone;
}

/// Whether depth alone decides between the batch's surfaces.
bool hasAnyOrder(const frame::FramePlan& plan, const frame::Batch& batch) {
    return plan.gate == frame::Gate::Ownership &&
           (batch.program == frame::Program::Opaque || batch.program == frame::Program::CutOut);
}

/// Whether a batch of `share` draws something of `turn`.
bool takes(frame::Turn share, frame::Turn turn) {
    return share == turn || share == frame::Turn::Both || turn == frame::Turn::Both;
}

/// The first run of cut-outs that are drawn before openings are cleared; after all runs if there is none.
std::uint32_t firstCutOutOf(const frame::FramePlan& plan) {
    for (const frame::Batch& batch : plan.batches)
        if (batch.program == frame::Program::CutOut && batch.turn == frame::Turn::Before)
            return batch.first;
    return static_cast<std::uint32_t>(plan.runs.size());
}

bool takesLamps(const frame::Batch& batch) {
    return batch.program != frame::Program::Terrain; // its corners are too far apart
}

} // namespace

void FastDraws::prepare(const frame::FramePlan& plan, const RenderOptions& options,
                        const frame::RecordTables& tables) {
    own_.resize(plan.dynamicInstances.size() + plan.records.size());
    writeInstances(plan, own_);
    slots_.assign(plan.batches.size(), {}); // a batch without a stage is not drawn
    draws_.clear();
    commands_.clear();
    firstCutOut_ = firstCutOutOf(plan);
    late_.clear();
    const frame::DrawRecords makes(tables, plan, own_);
    for (const frame::Stage& stage : plan.stages) {
        for (std::size_t i = stage.firstBatch; i < stage.firstBatch + stage.batchCount; ++i) {
            const std::size_t partner = partnerOf(plan, stage, i);
            const auto first = static_cast<std::uint32_t>(commands_.size());
            BatchSlots& slots = slots_[i] = {first, first, first};
            slots.isJoined = partner < i;
            if (slots.isJoined || !hasSlots(plan.batches[i], options))
                continue;
            part_.clear();
            second_.clear();
            addRuns(plan, plan.batches[i], makes, slots);
            if (partner != kAlone)
                addRuns(plan, plan.batches[partner], makes, slots);
            const bool anyOrder = hasAnyOrder(plan, plan.batches[i]);
            addPart(part_, anyOrder);
            slots.second = static_cast<std::uint32_t>(commands_.size());
            addPart(second_, anyOrder);
            slots.end = static_cast<std::uint32_t>(commands_.size());
        }
    }
    LIMEN_ASSERT(late_.empty(), "meshes are drawn after the clearing, with the program of cut-outs");
}

void FastDraws::addRuns(const frame::FramePlan& plan, const frame::Batch& batch,
                        const frame::DrawRecords& makes, BatchSlots& slots) {
    const bool fromOutside = plan.constants.rootZone == layout::kOutside;
    known_ = {};
    for (std::uint32_t i = batch.first; i < batch.first + batch.count; ++i) {
        const frame::PieceRun& run = plan.runs[i];
        if (!takes(batch.turn, run.turn))
            continue;
        for (std::uint32_t number = run.firstPiece; number < run.firstPiece + run.pieceCount; ++number) {
            if (isOfSky(makes.piece(number))) {
                part_.push_back({meshOf(makes.piece(number)), number, false});
                continue;
            }
            find(makes.piece(number).instance, run.inRange, takesLamps(batch), makes);
            const bool isLate = batch.turn == frame::Turn::Before && i >= firstCutOut_ && known_.hasLamps;
            if (known_.isHere && !isLate)
                addPiece(batch, number, run.gated, fromOutside, makes, slots);
            else if (known_.isHere && run.turn == frame::Turn::Before)
                late_.push_back(number);
        }
    }
    if (batch.turn != frame::Turn::After || batch.program != frame::Program::CutOut)
        return;
    for (const std::uint32_t number : late_) {
        find(makes.piece(number).instance, true, true, makes);
        addPiece(batch, number, true, fromOutside, makes, slots);
    }
    late_.clear();
}

void FastDraws::find(std::uint32_t instance, bool inRange, bool takesLamps, const frame::DrawRecords& makes) {
    if (instance == known_.number)
        return;
    const bool isHere = inRange || makes.isInRange(instance);
    known_ = {instance, isHere, isHere && takesLamps && makes.hasLamps(instance)};
}

void FastDraws::addPiece(const frame::Batch& batch, std::uint32_t number, bool gated, bool fromOutside,
                         const frame::DrawRecords& makes, BatchSlots& slots) {
    const bool isWhole = batch.program == frame::Program::Blended; // back to front
    const bool isLit = fromOutside && known_.hasLamps;
    const bool inSecond = batch.gated && (isWhole || gated || isLit || batch.turn == frame::Turn::After);
    (inSecond ? second_ : part_).push_back({meshOf(makes.piece(number)), number, gated && batch.gated});
    bool& lamps = inSecond ? slots.lampsInSecond : slots.lampsInFirst;
    lamps = lamps || known_.hasLamps;
}

void FastDraws::addPart(std::vector<Draw>& part, bool anyOrder) {
    if (anyOrder)
        std::sort(part.begin(), part.end(), [](const Draw& a, const Draw& b) {
            return a.mesh != b.mesh ? a.mesh < b.mesh : a.piece < b.piece;
        });
    for (std::size_t i = 0; i < part.size(); ++i)
        if (!anyOrder || i == 0 || part[i].mesh != part[i - 1].mesh)
            commands_.push_back(static_cast<std::uint32_t>(draws_.size() + i));
    draws_.insert(draws_.end(), part.begin(), part.end());
}

void FastDraws::write(const frame::FramePlan& plan, const frame::RecordTables& tables, const FrameRing& ring,
                      std::span<std::byte> memory, std::uint32_t firstRecord) {
    const std::span<layout::DrawCommand> commands = ring.commands(memory);
    const std::span<layout::DrawRecord> records = ring.records(memory);
    LIMEN_ASSERT(commands.size() == draws_.size() && records.size() == draws_.size(),
                 "a record for each draw, and room for as many commands");
    const frame::DrawRecords makes(tables, plan, own_);
    for (std::size_t slot = 0; slot < commands_.size(); ++slot) {
        const std::uint32_t first = commands_[slot];
        const std::uint32_t end = slot + 1 < commands_.size() ? commands_[slot + 1] : drawCount();
        const layout::DrawPiece& piece = makes.piece(draws_[first].piece);
        // The record is an instanced attribute, found by the base instance. Sky objects have none.
        commands[slot] = {3 * (piece.triangles & ~layout::kNeverCulled), end - first, piece.firstIndex, 0,
                          isOfSky(piece) ? piece.instance : firstRecord + first};
    }
    const bool hasBits = !listsMembers(plan);
    if (hasBits)
        visits_.prepare(plan);
    std::uint32_t last = 0xFFFFFFFFu;
    layout::DrawRecord record;
    for (std::size_t i = 0; i < draws_.size(); ++i) {
        const layout::DrawPiece& piece = makes.piece(draws_[i].piece);
        if (isOfSky(piece))
            continue;
        if (piece.instance != last) {
            last = piece.instance;
            record = makes.of(last);
        }
        records[i] = record;
        if (!draws_[i].gated)
            records[i].members.y = 0;
        else if (hasBits)
            setVisits(makes.visitsTo(last, visits_), records[i]);
    }
}

} // namespace limen::gpu
