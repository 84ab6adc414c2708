#include "gpu/BatchDraws.h"

namespace limen::gpu {

namespace {

bool isSky(frame::Program program) {
    return program == frame::Program::SkyPlain || program == frame::Program::SkyObjects;
}

ProgramVariant variantOf(const frame::Batch& batch, const FrameKind& frame) {
    const bool blended = batch.program == frame::Program::Blended;
    const bool flat = frame.options.shading != Shading::Lit;
    return {.gated = batch.gated,
            .flat = blended ? frame.options.wantLayers : flat,
            .multisampled = frame.multisampled,
            .details = batch.program == frame::Program::Terrain ? frame.grainedLand : frame.grainedMeshes,
            .pixelLamps = frame.pixelLamps,
            .ids = frame.options.wantIds,
            .clipped = frame.clipped,
            .memberLists = frame.manyVisits,
            .shells = batch.shells};
}

} // namespace

BatchDraws drawsOf(const frame::Batch& batch, const BatchSlots& slots, const FrameKind& frame) {
    const ProgramVariant variant = variantOf(batch, frame);
    BatchDraws out{{BatchDraw{variant, slots.first, slots.end - slots.first}}, 1};
    if (frame.drawing == Drawing::Exact)
        return out;
    if (drawsVoids(frame.drawing, batch.program, variant)) {
        out.draws[1] = out.draws[0];
        out.draws[1].variant.gated = false;
        out.count = batch.draws > 0 ? 2 : 1;
    } else if (isSky(batch.program)) {
        out.draws[0].variant.gated = batch.gated;
    } else if (batch.gated &&
               (batch.program == frame::Program::Blended || batch.turn == frame::Turn::After)) {
        out.draws[0].variant.lamps = slots.lampsInSecond; // the only part (BatchDraws.h)
        return out;
    } else if (batch.gated) {
        out.draws[0] = {variant, slots.first, slots.second - slots.first};
        out.draws[0].variant.gated = false;
        out.draws[1] = {variant, slots.second, slots.end - slots.second};
        out.draws[1].variant.lamps = slots.lampsInSecond;
        out.count = 2;
    }
    out.draws[0].variant.lamps = slots.lampsInFirst;
    return out;
}

DrawState stateOf(frame::Program program, const ProgramVariant& variant, const FrameKind& frame) {
    const bool fast = frame.drawing == Drawing::Fast;
    DrawState state;
    // A portal polygon counts from both sides.
    state.cullBackFaces = frame.cullsBackFaces() && (!drawsOpenings(program) || frame.facesOpenings);
    // A fast sky needs no depth: nothing but its objects is drawn over it. Sky objects have the depth of the plain sky, or none.
    const bool isVoids = drawsVoids(frame.drawing, program, variant);
    state.writeDepth = program != frame::Program::Blended && program != frame::Program::SkyObjects &&
                       !(fast && isSky(program) && !isVoids);
    state.depthTest = program == frame::Program::Stamp || program == frame::Program::Clearing
                          ? DepthTest::Always
                          : DepthTest::Nearer;
    state.clips = frame.clipped && !drawsOpenings(program);
    return state;
}

} // namespace limen::gpu
