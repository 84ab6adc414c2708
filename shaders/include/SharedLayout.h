// What C++ and GLSL must agree on to the byte: binding numbers, flag bits and the structs of every storage buffer
// (std430). Read by both: C++ sees glm types in namespace limen::frame::gpu, GLSL sees its own. Sizes and offsets are
// checked by static_assert in src/frame/GpuLayout.h.
//
// Space: "eye-relative" is world axes with the origin at the eye, metres.
#ifdef __cplusplus
#define LIMEN_STRUCT(name) struct alignas(16) name
#define LIMEN_ZERO                                                                                           \
    {}
namespace limen::frame::gpu {
using vec2 = glm::vec2;
using vec3 = glm::vec3;
using vec4 = glm::vec4;
using uvec2 = glm::uvec2;
using uvec4 = glm::uvec4;
using mat4 = glm::mat4;
using uint = std::uint32_t;
#define LIMEN_CONST inline constexpr uint
#else
#define LIMEN_STRUCT(name) struct name
#define LIMEN_ZERO
#define LIMEN_CONST const uint
#endif

// Storage buffer bindings.
LIMEN_CONST kBindFrame = 0;        // FrameConstants, one
LIMEN_CONST kBindMaterials = 1;    // Material (static)
LIMEN_CONST kBindMaterialRefs = 2; // uint (static)
LIMEN_CONST kBindTerrain = 3;      // TerrainCell (static)
LIMEN_CONST kBindLightSets = 4;    // LightSet (static)
LIMEN_CONST kBindLights = 5;       // Light (static)
LIMEN_CONST kBindTextures = 6;     // TextureRef (static)
LIMEN_CONST kBindOwnership = 7;    // OwnershipVertex
LIMEN_CONST kBindClipSets = 8;     // ClipSet
LIMEN_CONST kBindSky = 9;          // SkyInstance
LIMEN_CONST kBindCommands = 10;    // DrawCommand, as words: written on the device
LIMEN_CONST kBindIndices = 11;     // uint (static)
LIMEN_CONST kBindKeptIndices = 12; // uint: of the triangles that are kept, written likewise
LIMEN_CONST kBindTiles = 13;       // float: how far what was drawn first covers each tile, written likewise
LIMEN_CONST kStorageBindings = 14;

// Texture units. Of buffers, these are read as texels of four words: software drivers read a storage buffer lane by lane, and
// texels several times faster. Array pages come last (none in bindless mode).
LIMEN_CONST kUnitOwnership = 0; // the ownership target
LIMEN_CONST kUnitRing = 1;      // this frame's arrays; DeviceConstants has their first texels
LIMEN_CONST kUnitDepth = 2;     // the target's depth; not sampled while anything is drawn
LIMEN_CONST kUnitVertices = 3;  // Vertex: the arena that is also the vertex fetch (static)
LIMEN_CONST kUnitInstances = 4; // Instance (static)
LIMEN_CONST kUnitMembers = 5;   // Member, two a texel (static)
LIMEN_CONST kUnitPieces = 6;    // DrawPiece (static)
LIMEN_CONST kUnitFirstPage = 7;

// Fragment outputs. What is blended has a location of its own: blending stays switched on for that draw buffer and
// off for the others, and no stage has to change it.
LIMEN_CONST kOutputColour = 0;
LIMEN_CONST kOutputId = 1;
LIMEN_CONST kOutputBlended = 2;

LIMEN_CONST kOutside = 0u;   // the outdoor zone
LIMEN_CONST kMaxLights = 8u; // lamps per light set

LIMEN_CONST kKindShell = 0u; // kind of instance: a cell's own walls, world::InstanceKind::Shell
LIMEN_CONST kKindFilling =
    6u; // what stands in an opening: a door's leaf, a pane, world::InstanceKind::Filling

// Where in a pixel its ray passes, from the centre, in parts of a pixel, y upwards. Eyes stand in the planes of walls and over
// edges, and what is built on a grid lies at angles that pixels' centres lie at, too: rays through centres then pass along edges,
// one behind the other, and each decides for itself, by roundings, which side it is on. No such line passes here. The parts are
// what floats of a window 4,096 pixels wide can tell apart.
LIMEN_CONST kBesideX = 7u;
LIMEN_CONST kBesideY = 3u;
LIMEN_CONST kPartsOfAPixel = 4096u;

// Depths are the near plane's share of the view depth. What lies beyond the outline of its polygon, by no more than rounding makes of
// it, is kept where nothing else is: its depth is stored 2^-kFringeExponent of what it is. The sky covers that, and nothing more:
// it lies at 2^-kSkyExponent, which is ten million kilometres away.
LIMEN_CONST kFringeExponent = 40u;
LIMEN_CONST kSkyExponent = 39u;

// From how far away an instance is drawn (world/LevelRange.h): steps a metre, and what farther away, or from its block's origin, counts as.
LIMEN_CONST kRangeSteps = 16u;
LIMEN_CONST kMostRangeSteps = 37000u;
LIMEN_CONST kMostLocalSteps = 1048576u;

LIMEN_CONST kSamples = 4u; // per pixel, of multisampled frames

LIMEN_CONST kNoVisit = 0xFFFFFFFFu;
LIMEN_CONST kShutByNothing = 1u; // Visit.shutBy: a filling without a surface
LIMEN_CONST kNoTexture = 0xFFFFFFFFu;
LIMEN_CONST kSkyId = 1u;
LIMEN_CONST kVoidId = 0u;

// ViewConstants.flags
LIMEN_CONST kFrameExactCutOuts = 1u; // cut-outs tested at mip 0, nearest texel (ids and depth)

// DeviceConstants.flags
LIMEN_CONST kFrameKeepsTriangles = 2u; // draws read the static indices: no triangle is culled
LIMEN_CONST kFrameSplits =
    4u; // surfaces with kMaterialSplit are drawn as cut-outs where they are nearly opaque

// Material.flags
LIMEN_CONST kMaterialClamp = 1u;
LIMEN_CONST kMaterialAdditive = 2u;
LIMEN_CONST kMaterialInvAlpha = 4u;
LIMEN_CONST kMaterialAlpha = 8u;
LIMEN_CONST kMaterialSplit = 16u; // drawn as a cut-out, too: see surface.glsl

// Constants of a frame that follow from its view and its scene. Written by frame (frame/Planner.h).
LIMEN_STRUCT(ViewConstants) {
    mat4 clipFromEye LIMEN_ZERO; // clip from eye-relative; reversed depth, infinite far plane
    vec4 eyeHigh LIMEN_ZERO;     // xyz: the eye relative to the eye's block, rounded to float
    vec4 eyeLow LIMEN_ZERO;      // xyz: the residual of that rounding
    vec4 eyeSteps
        LIMEN_ZERO; // xyz: the eye relative to the eye's block in steps of 1 / kRangeSteps, rounded down: whole numbers
    vec4 sunDirection LIMEN_ZERO; // xyz towards the sun
    vec4 sunColour LIMEN_ZERO;
    vec4 skyAmbient LIMEN_ZERO;
    vec4 fogColour LIMEN_ZERO; // rgb
    vec4 fogRange LIMEN_ZERO;  // near, far in metres
    vec4 voidColour LIMEN_ZERO;
    vec4 skyZenith LIMEN_ZERO; // rgb: plain sky overhead; the horizon is fogColour
    uint rootZone LIMEN_ZERO;
    uint visitCount LIMEN_ZERO;
    uint flags LIMEN_ZERO; // kFrameExactCutOuts
    float nearPlane LIMEN_ZERO;
    uint staticInstances LIMEN_ZERO; // numbers from here on are the frame's instances
    uint staticMembers LIMEN_ZERO;   // numbers from here on are the frame's members
    uint staticPieces LIMEN_ZERO;    // numbers from here on are the frame's pieces
    uint replacementCount LIMEN_ZERO;
};

// Constants of a frame that follow from its target, its place in the ring memory and its culling. Written by gpu.
LIMEN_STRUCT(DeviceConstants) {
    vec4 viewport LIMEN_ZERO; // width, height, 1/width, 1/height
    vec4 rayCorner
        LIMEN_ZERO; // xyz: eye-relative, where the view depth is one metre: the window's lower left corner,
    vec4 rayRight LIMEN_ZERO; // and the steps of one pixel
    vec4 rayUp LIMEN_ZERO;
    uint flags LIMEN_ZERO;  // kFrameKeepsTriangles, kFrameSplits
    float pixel LIMEN_ZERO; // metres that a pixel covers at a view depth of one metre
    uint samplesX
        LIMEN_ZERO; // sample positions of a multisampled target, a byte each: 1/256 of a pixel from the pixel's
    uint samplesY LIMEN_ZERO; // lower left corner
    // Texels of kUnitRing: the first of each array.
    uint firstBlock LIMEN_ZERO;       // vec4 per resident block: its origin from the eye's block
    uint firstVisit LIMEN_ZERO;       // Visit
    uint firstInstance LIMEN_ZERO;    // Instance, the frame's
    uint firstMember LIMEN_ZERO;      // Member, the frame's, two a texel
    uint firstPiece LIMEN_ZERO;       // DrawPiece, the frame's
    uint firstReplacement LIMEN_ZERO; // Replacement, two a texel
    uint firstRect LIMEN_ZERO;        // vec4 per rectangle: minimum x and y, maximum x and y, NDC
    uint firstSlotGroup LIMEN_ZERO;   // SlotGroup
    uint firstRun LIMEN_ZERO;         // DrawRun
    uint slotCount LIMEN_ZERO;
    uint firstHideable LIMEN_ZERO; // slots from here on are culled against the draws of those before
    uint reserved0 LIMEN_ZERO;
};

// The two, one behind the other, so that each has one writer.
LIMEN_STRUCT(FrameConstants) {
    ViewConstants view LIMEN_ZERO;
    DeviceConstants device LIMEN_ZERO;
};

LIMEN_STRUCT(Visit) {
    vec4 entryPlane
        LIMEN_ZERO; // eye-relative; beyond = positive; the root's is (0,0,0,1): everything is beyond it
    uint zone LIMEN_ZERO;
    uint parent LIMEN_ZERO; // kNoVisit for the root
    uint shutBy LIMEN_ZERO; // 0: not shut; else the idBase of what fills the opening, or kShutByNothing
    uint reserved LIMEN_ZERO;
};

LIMEN_STRUCT(Instance) {
    vec4 pose0
        LIMEN_ZERO; // block-local from model, 12 floats: the columns of the matrix that turns and scales, and the origin
    vec4 pose1 LIMEN_ZERO;
    vec4 pose2 LIMEN_ZERO;
    uint block LIMEN_ZERO;
    uint idBase LIMEN_ZERO;
    uint firstMaterial LIMEN_ZERO; // into material refs; for terrain: into terrain cells
    uint firstMember LIMEN_ZERO;
    uint membersAndKind LIMEN_ZERO; // the count of its members, and in the high half its kind
    uint levelRange
        LIMEN_ZERO; // steps: drawn if the eye is farther than the low half, or that is 0, and not farther than the
                    // high half, or that is kEndlessRange; kFromAnywhere
    uint highlight LIMEN_ZERO; // RGBA8, alpha = strength; 0 none
    float opacity LIMEN_ZERO;  // times its blended surfaces' own
};

LIMEN_CONST kEndlessRange = 0xFFFFu;
LIMEN_CONST kFromAnywhere = 0xFFFF0000u;
LIMEN_CONST kMostMembers = 0xFFFFu;

// A zone an instance belongs to, and the light it has there.
struct Member {
    uint zone LIMEN_ZERO;
    uint lightSet LIMEN_ZERO;
};

LIMEN_STRUCT(Material) {
    vec4 colour LIMEN_ZERO;
    uint texture LIMEN_ZERO; // index into textures, kNoTexture
    uint flags LIMEN_ZERO;
    float luminosity LIMEN_ZERO;
    float diffuse LIMEN_ZERO;
};

// Where a texture lives. x: array pages: the layer; bindless: the low half of the 64-bit handle. y: the page, or the
// high half. z, w: width and height in texels; z also carries kTextureClamp. Filled by TextureStore.
LIMEN_CONST kTextureClamp = 0x80000000u;
LIMEN_STRUCT(TextureRef) {
    uvec4 place LIMEN_ZERO;
};

// One texture of a landcell. Absent: texture == kNoTexture. `alpha`: blend map, read from its alpha channel (1 keeps
// what is underneath), kNoTexture for none; turned by `rotation` quarter turns. `tiling`: repeats across the cell.
struct TerrainLayer {
    uint texture LIMEN_ZERO;
    uint alpha LIMEN_ZERO;
    uint rotation LIMEN_ZERO;
    float tiling LIMEN_ZERO;
};

// Six layers on end; the shaders read them as one array.
LIMEN_CONST kLayersPerCell = 6u;
struct TerrainCell {
    TerrainLayer base LIMEN_ZERO;
    TerrainLayer overlays[3] LIMEN_ZERO;
    TerrainLayer roads[2] LIMEN_ZERO;
};

LIMEN_STRUCT(LightSet) {
    vec4 ambient LIMEN_ZERO; // rgb; w: share of the sky's ambient
    float sun LIMEN_ZERO;    // share of the sun
    uint firstLight LIMEN_ZERO;
    uint lightCount LIMEN_ZERO; // at most 8
    uint reserved0 LIMEN_ZERO;
};

LIMEN_STRUCT(Light) {
    vec4 position LIMEN_ZERO; // xyz block-local, w range in metres
    vec4 colour LIMEN_ZERO;   // rgb; w: bits of the block slot (uint)
};

// One corner of the ownership stage's triangles, in tree order. An opening is a fan around its middle; each of its triangles
// has the middle and two corners of the outline. With kCoverWindow the fan is drawn as one triangle around the window, and
// its outline and clip set decide; without an outline the clip set alone.
LIMEN_CONST kCoverWindow = 0x80000000u;
LIMEN_STRUCT(OwnershipVertex) {
    vec3 position LIMEN_ZERO; // block-local
    uint block LIMEN_ZERO;
    uint visit LIMEN_ZERO;
    uint clipSet LIMEN_ZERO;
    uint outlineFirst LIMEN_ZERO; // the fan's first vertex
    uint outlineCount LIMEN_ZERO; // corners of the outline, as many as triangles in the fan; and kCoverWindow
    vec3 rest LIMEN_ZERO;         // what `position` is short of the corner
    uint reserved0 LIMEN_ZERO;
};

// Triangles of one instance that one draw command draws, and one work group culls. In one vector: the fewer loads, the better
// for software drivers.
LIMEN_CONST kCullThreads = 32u;         // of a work group
LIMEN_CONST kTrianglesPerThread = 32u;  // at most: a bit each
LIMEN_CONST kTrianglesPerPiece = 1024u; // at most
LIMEN_CONST kKeepsAll =
    0x80000000u; // DrawPiece.triangles: none is ever left out, for they are not an Instance's
LIMEN_CONST kWordsPerCommand = 5u;
LIMEN_STRUCT(DrawPiece) {
    uint firstIndex LIMEN_ZERO;
    uint triangles LIMEN_ZERO;     // and kKeepsAll
    uint instance LIMEN_ZERO;      // with kKeepsAll a SkyInstance
    uint indicesBefore LIMEN_ZERO; // of all pieces before it in its array
};

// What a dispatch of cull.comp is for is how many layers of work groups it has: one program does all, and none is told apart from the
// next by an argument, which would be a call more.
LIMEN_CONST kCullFirst = 1u;  // the slots before firstHideable
LIMEN_CONST kCullTiles = 2u;  // how far what these draw covers each tile
LIMEN_CONST kCullBehind = 3u; // the other slots

LIMEN_CONST kTileSize = 8u;   // pixels a side
LIMEN_CONST kMostTiles = 64u; // that a triangle is looked up in

// What is drawn takes the ownership test (gate.glsl): of DrawRun.piece, and of what draw commands say as their instance.
LIMEN_CONST kGated = 0x80000000u;

// A frame's draw commands lie in slots, those of a run of pieces one behind the other. Both are what to add, and so the same for the
// whole run.
struct RunPlace {
    uint piece LIMEN_ZERO; // to the slot's number, modulo 2^31: the piece's; and kGated
    uint kept
        LIMEN_ZERO; // to the piece's indicesBefore, modulo 2^32: where those of its indices go that are kept
};
LIMEN_STRUCT(DrawRun) {
    RunPlace place LIMEN_ZERO;
    uint firstSlot LIMEN_ZERO;
    uint rects
        LIMEN_ZERO; // nothing of it shows but within these: the number of the first, and in the high half how many; 0: anywhere
};

// Which runs so many slots are of, from one that is a multiple of it: the run of a slot is looked up in few steps, mostly none, and
// what a frame writes grows with its runs and not with what is drawn.
LIMEN_CONST kSlotsPerGroup = 16u;
LIMEN_STRUCT(SlotGroup) {
    RunPlace place LIMEN_ZERO; // of the first
    uint firstRun LIMEN_ZERO;
    uint lastRun LIMEN_ZERO;
};

// Eight half-spaces, eye-relative: kept where dot(plane.xyz, p) + plane.w >= 0. All but the last pass through the eye.
// Unused ones are (0,0,0,1).
LIMEN_STRUCT(ClipSet) {
    vec4 planes[8] LIMEN_ZERO;
};

// An instance of the scene that a frame draws by a record of its own, numbered as movers are.
struct Replacement {
    uint instance LIMEN_ZERO;
    uint by LIMEN_ZERO;
};

// A sky object of this frame.
LIMEN_STRUCT(SkyInstance) {
    vec4 row0 LIMEN_ZERO; // world from model, rows
    vec4 row1 LIMEN_ZERO;
    vec4 row2 LIMEN_ZERO;
    uint firstMaterial LIMEN_ZERO;
    float opacity LIMEN_ZERO;
    float luminosity LIMEN_ZERO;
    float uvOffsetX LIMEN_ZERO;
    float uvOffsetY LIMEN_ZERO;
    uint reserved0 LIMEN_ZERO;
    uint reserved1 LIMEN_ZERO;
    uint reserved2 LIMEN_ZERO;
};

#ifdef __cplusplus
} // namespace limen::frame::gpu
#undef LIMEN_CONST
#endif
#undef LIMEN_STRUCT
#undef LIMEN_ZERO
