#pragma once

#include "frame/GpuLayout.h"

#include <array>
#include <cstddef>
#include <cstring>
#include <vector>

// What a frame draws, as plain data: made by frame/Planner.h, executed by gpu (or recorded by its null
// device).
namespace limen::frame {

/// The stages of every frame, whatever the root (docs/architecture.md).
enum class StageKind : std::uint8_t { Ownership, Solid, Sky, Transparent, Overlay };
inline constexpr std::size_t kStageCount = 5;
[[nodiscard]] constexpr const char* nameOf(StageKind kind) {
    constexpr std::array<const char*, kStageCount> kNames{"ownership", "solid", "sky", "transparent",
                                                          "overlay"};
    return kNames[static_cast<std::size_t>(kind)];
}

/// Which program draws a batch.
enum class Program : std::uint8_t {
    Ownership,  ///< triangles of ownershipVertices, no indices
    Opaque,     ///< meshes, no discard but the gate's
    CutOut,     ///< meshes, alpha tested
    Terrain,    ///< landblocks
    SkyPlain,   ///< one screen-filling triangle: the plain sky and its id
    SkyObjects, ///< sky meshes; baseInstance indexes skyInstances
    Blended     ///< meshes of the late stage
};

/// Rectangles of FramePlan::rects; none: the whole window.
struct RectRun {
    std::uint16_t first = 0, count = 0;
    friend bool operator==(const RectRun&, const RectRun&) = default;
};

/// Pieces that follow one another, each a draw command.
struct PieceRun {
    std::uint32_t firstPiece = 0, pieceCount = 0; ///< the scene's, and on from there the plan's
    std::uint32_t indicesBefore = 0;              ///< of the first of them
    std::uint32_t indexCount = 0;                 ///< of all of them
    bool gated = false;                           ///< their fragments take the ownership test
    RectRun rects{};                              ///< nothing of them shows elsewhere
};

/// Runs of pieces that one program draws: one GL draw call.
struct Batch {
    Program program = Program::Opaque;
    bool gated = false; ///< the program's variant that has the ownership test: some of the runs may take it
    std::uint32_t first = 0, count = 0; ///< runs; for Ownership: vertices
    std::uint32_t draws = 0; ///< pieces of all its runs; for Ownership and SkyPlain: 1 if they draw anything
};

/// Things that move, as somebody else has them (world::DynamicState): each begins as the gpu::Instance of what is a member of the one space that
/// it is placed in, but for the highlight. A view and not a copy, for they lie here and there in memory, and to fetch them once is most of
/// what a frame costs in which all move. They must stay as they are until the plan has been drawn.
struct RecordArray {
    const std::byte* first = nullptr;
    std::size_t stride = 0; ///< bytes from one to the next
    [[nodiscard]] const std::byte* at(std::uint32_t i) const { return first + i * stride; }
    void copyTo(gpu::Instance& out, std::uint32_t i) const {
        std::memcpy(static_cast<void*>(&out), at(i), sizeof out);
        out.highlight = 0;
    }
};

/// What a mover has that its record does not say.
struct MoverChange {
    std::uint32_t mover = 0; ///< index into FramePlan::movers
    std::uint32_t firstMember = 0, membersAndKind = 0, highlight = 0;
    void applyTo(gpu::Instance& record) const {
        record.firstMember = firstMember;
        record.membersAndKind = membersAndKind;
        record.highlight = highlight;
    }
};

struct Stage {
    StageKind kind = StageKind::Solid;
    std::uint32_t firstBatch = 0, batchCount = 0;
};

/// What the planner saw and decided; goes to frame.json and the panel. What the device leaves out of it is not counted.
struct PlanCounts {
    std::uint32_t visits = 0, cellsSeen = 0, ownershipTriangles = 0;
    std::uint32_t instancesTested = 0;                     ///< members of spaces that are seen, each once
    std::uint32_t instancesCulled = 0, instancesDrawn = 0; ///< of these
    std::uint32_t drawsUngated = 0, triangles = 0;         ///< of what is drawn
    std::uint32_t boundsTested = 0; ///< balls that were held against a visit, of clusters and of instances
};

/// One frame. Reused from frame to frame: `clear` keeps every capacity, so that a steady frame allocates
/// nothing.
struct FramePlan {
    gpu::FrameConstants constants;
    std::vector<gpu::vec4>
        blocks; ///< offset of each block from the eye's block, metres: whole multiples of 192
    std::vector<gpu::Visit> visits;
    std::vector<gpu::OwnershipVertex> ownershipVertices;
    std::vector<gpu::ClipSet> clipSets;
    std::vector<gpu::vec4> rects; ///< least and most x and y, NDC
    std::vector<gpu::SkyInstance> skyInstances;
    RecordArray moving;                         ///< what `movers` are of
    std::vector<std::uint32_t> movers;          ///< those drawn; numbered on from the scene's instances
    std::vector<MoverChange> moverChanges;      ///< of few of them, in order
    std::vector<gpu::Instance> records;         ///< others of the frame's own; numbered on from the movers
    std::vector<gpu::Member> moverMembers;      ///< numbered on from the scene's members
    std::vector<gpu::Replacement> replacements; ///< of the scene's instances by some of `records`
    std::vector<gpu::DrawPiece> pieces; ///< of movers and of the sky; numbered on from the scene's pieces
    std::vector<PieceRun> runs;
    std::vector<Batch> batches;
    std::vector<Stage> stages; ///< in order, one of each kind
    std::uint32_t firstOccludee =
        0; ///< batch: those before it are walls and ground, behind which those from it on may be hidden
    PlanCounts counts;

    void clear();
};

} // namespace limen::frame
