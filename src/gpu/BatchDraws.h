#pragma once

#include "gpu/BatchSlots.h"
#include "gpu/RenderOptions.h"
#include "gpu/RendererOptions.h"
#include "gpu/scene/Programs.h"

#include <array>

namespace limen::gpu {

/// Properties of a frame that its program variants depend on.
struct FrameKind {
    Drawing drawing = Drawing::Exact;
    bool exactOutlines =
        true; ///< triangles are culled one by one: no culling of back faces by the rasteriser
    bool multisampled = false;
    bool several = false;                            ///< visits
    bool grainedMeshes = false, grainedLand = false; ///< detail pictures
    bool pixelLamps = false;                         ///< lamps light walls in fragments
    bool clipped = false;                            ///< FramePlan::clips
    bool facesOpenings = false; ///< triangles of openings are counter-clockwise (FrameView::coverageDecides)
    /// DriverChoices::overlaps, in a frame with colour and depth alone. Its solid pass clears both in one call.
    bool overlaps = false;
    /// FramePlan::plainSky, in a fast frame with the objects of the sky and without ids.
    frame::RectRun plainSky{};
    bool manyVisits = false; ///< more than frame::VisitBits has bits for
    RenderOptions options{};

    /// Whether the rasteriser culls back faces. Exact outlines cull them per triangle (cull.comp).
    [[nodiscard]] bool cullsBackFaces() const { return drawing == Drawing::Fast || !exactOutlines; }
};

/// One draw call of a batch: a program variant and its draw commands.
struct BatchDraw {
    ProgramVariant variant;
    std::uint32_t firstSlot = 0, count = 0; ///< of indexed programs
};

/// The draw calls of a batch: one, or for Drawing::Fast two in a frame with several visits, of which only the
/// second takes the ownership test; of the plain sky the first does, and draws voids alone. A transparent batch has one, so
/// that its draws stay in order; a batch with a frame::Turn has one, too. Their number depends on the batch's program, `gated`, `turn` and, of the plain sky, `draws` alone.
struct BatchDraws {
    std::array<BatchDraw, 2> draws;
    std::size_t count = 0;
    [[nodiscard]] const BatchDraw* begin() const { return draws.data(); }
    [[nodiscard]] const BatchDraw* end() const { return draws.data() + count; }
};
[[nodiscard]] BatchDraws drawsOf(const frame::Batch& batch, const BatchSlots& slots, const FrameKind& frame);

/// Pipeline state of a draw of a batch's program, without the program.
[[nodiscard]] DrawState stateOf(frame::Program program, const ProgramVariant& variant,
                                const FrameKind& frame);

} // namespace limen::gpu
