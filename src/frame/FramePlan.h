#pragma once

#include "frame/Gate.h"
#include "frame/GpuLayout.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

// A frame's draws as plain data: made by frame/Planner.h, executed by gpu (or recorded by its null device).
namespace limen::frame {

/// The stages of a frame. With Gate::Ownership a frame has each once, in this order, for any root
/// (docs/architecture.md). With Gate::Depth, Ownership draws the depths of openings, and kinds repeat.
enum class StageKind : std::uint8_t { Ownership, Solid, Sky, Transparent, Overlay };
inline constexpr std::size_t kStageCount = 5;
[[nodiscard]] constexpr const char* nameOf(StageKind kind) {
    constexpr std::array<const char*, kStageCount> kNames{"ownership", "solid", "sky", "transparent",
                                                          "overlay"};
    return kNames[static_cast<std::size_t>(kind)];
}

/// The shader program of a batch.
enum class Program : std::uint8_t {
    Ownership,  ///< triangles of ownershipVertices, no indices
    Opaque,     ///< meshes, no discard except the gate's
    CutOut,     ///< meshes, alpha tested
    Terrain,    ///< landblocks
    Clearing,   ///< rectangles: clears pixels whose ray leaves the root before the surface that was drawn
    SkyPlain,   ///< the plain sky and its id, and the voids around it
    SkyObjects, ///< sky meshes; baseInstance indexes skyInstances
    Blended,    ///< meshes of the transparent stage
    Stamp,      ///< depth of openings at the far plane, in front of everything; vertices as Ownership
    Fence       ///< depth of openings where they are; vertices as Ownership
};
inline constexpr std::size_t kProgramCount = 10;
/// Programs that draw triangles of ownershipVertices.
[[nodiscard]] constexpr bool drawsOpenings(Program program) {
    return program == Program::Ownership || program == Program::Stamp || program == Program::Fence;
}

/// A run of FramePlan::rects. Count 0: the whole window.
struct RectRun {
    std::uint16_t first = 0, count = 0;
    friend bool operator==(const RectRun&, const RectRun&) = default;
};

/// The batches that draw an instance in a plan with FrameView::rootFirst: those before the openings are cleared take no
/// ownership test and show the root visit alone, those after it show any visit.
enum class Turn : std::uint8_t { Before, After, Both };

/// Consecutive pieces; each is a draw command.
struct PieceRun {
    std::uint32_t firstPiece = 0, pieceCount = 0; ///< the scene's pieces; numbers beyond them are the plan's
    std::uint32_t indicesBefore = 0;              ///< of the first piece
    std::uint32_t indexCount = 0;                 ///< of all pieces
    bool gated = false;                           ///< their fragments take the ownership test
    RectRun rects{};                              ///< no fragment outside these rectangles is visible
    Turn turn = Turn::After;                      ///< counts in batches that have one
    bool inRange = false;                         ///< the eye is known to be in range of all levels of detail
};

/// Runs of pieces of one program: one GL draw call.
struct Batch {
    Program program = Program::Opaque;
    bool gated = false; ///< the program variant with the ownership test, which some of the runs may take
    /// Runs; of openings: vertices; of SkyPlain: rectangles that contain all voids (0: anywhere), or the first clip set
    /// and 0.
    std::uint32_t first = 0, count = 0;
    /// Pieces of all its runs. For openings: 1 if they draw anything. For SkyPlain: 0 if no ray ends outside, else
    /// triangles, one for each clip set.
    std::uint32_t draws = 0;
    bool shells = true;     ///< a draw may be the shell of a cell
    Turn turn = Turn::Both; ///< the share of the runs that it draws: those of this turn; Both: all
};

/// Makes the device records of dynamic instances when the plan is drawn. The instances stay in the dynamic
/// state, in the world's layout, and must stay unchanged until then. So each visible one is read once: fetching
/// scattered instances is most of a frame in which everything moves.
struct DynamicRecords {
    const void* instances = nullptr; ///< of the dynamic state
    /// Writes the records of the instances with these numbers; `records` has as many elements, at a multiple
    /// of 16 bytes.
    void (*write)(const void* instances, std::span<const std::uint32_t> numbers,
                  std::span<gpu::Instance> records) = nullptr;
};

/// The members and highlight of a dynamic instance whose record needs more than its own data.
struct DynamicChange {
    std::uint32_t instance = 0; ///< index into FramePlan::dynamicInstances
    std::uint32_t firstMember = 0, membersAndKind = 0, highlight = 0; ///< of gpu::Instance
    void applyTo(gpu::Instance& record) const {
        record.firstMember = firstMember;
        record.membersAndKind = membersAndKind;
        record.highlight = highlight;
    }
};

struct Stage {
    StageKind kind = StageKind::Solid;
    std::uint32_t firstBatch = 0, batchCount = 0;
    bool clearsDepth = false; ///< before its batches
};

/// Counts of one plan, for frame.json and the panel. They include draws and triangles that the device culls
/// later.
struct PlanCounts {
    std::uint32_t visits = 0, cellsSeen = 0, ownershipTriangles = 0;
    std::uint32_t instancesTested = 0;                     ///< members of spaces that are seen, each once
    std::uint32_t instancesCulled = 0, instancesDrawn = 0; ///< shares of instancesTested
    std::uint32_t drawsUngated = 0, triangles = 0;         ///< of the drawn instances
    std::uint32_t boundsTested = 0; ///< tests of a bounding sphere against a visit, of clusters and instances
};

/// A space as another gate than Gate::Ownership draws it.
struct GatedSpace {
    std::uint32_t space = 0;
    std::uint32_t regions = 0;   ///< convex regions on the screen
    std::uint32_t planes = 0;    ///< clip planes of all of them
    std::uint32_t fallbacks = 0; ///< regions with too many edges, which are drawn in their bounding rectangle
    friend bool operator==(const GatedSpace&, const GatedSpace&) = default;
};

/// One frame. Reused from frame to frame: `clear` keeps every capacity, so that a steady frame allocates
/// nothing.
///
/// Numbers of instances, members and pieces beyond the scene's arrays are those of the plan's. The plan's
/// instances are `dynamicInstances`, then `records`.
struct FramePlan {
    gpu::ViewConstants constants;
    std::vector<gpu::vec4>
        blocks; ///< origin of each block minus that of the eye's block, metres: whole multiples of 192
    std::vector<gpu::Visit>
        visits; ///< fragments follow the first constants.visitCount; openings take their plane from any
    std::vector<gpu::OwnershipVertex> ownershipVertices;
    std::vector<gpu::ClipSet> clipSets;
    std::vector<gpu::vec4> rects; ///< minimum x and y, maximum x and y; NDC
    std::vector<gpu::SkyInstance> skyInstances;
    std::vector<gpu::Lamp> lamps; ///< the scene's, by number
    DynamicRecords dynamicRecords;
    std::vector<std::uint32_t> dynamicInstances; ///< the visible ones, by their numbers in the dynamic state
    std::vector<DynamicChange> dynamicChanges;   ///< members of several zones, and highlights; ascending
    std::vector<gpu::Instance> records;          ///< more instances of this frame
    std::uint32_t levelSixteenths = 16;          ///< FrameView::levels
    std::vector<gpu::Replacement> replacements; ///< instances of the scene that are drawn by one of `records`
    std::vector<gpu::Member> members;
    std::vector<gpu::DrawPiece> pieces; ///< of dynamic instances and of the sky
    std::vector<PieceRun> runs;
    std::vector<Batch> batches;
    std::vector<Stage> stages;   ///< in order
    Gate gate = Gate::Ownership; ///< that this plan was made for
    RectRun plainSky{};          ///< the plain sky beside these rectangles is covered by objects of the sky
    bool clips = false;          ///< clipSets are clip distances; the programs have no ownership test
    std::vector<GatedSpace> spaces; ///< of other gates: in drawing order, far to near, each once
    /// The first batch that occlusion culling applies to. The batches before it are walls and ground, its
    /// occluders.
    std::uint32_t firstOccludee = 0;
    PlanCounts counts;

    void clear();
};

} // namespace limen::frame
