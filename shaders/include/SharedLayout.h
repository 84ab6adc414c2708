// Contract between C++ and GLSL, to the byte: binding numbers, flag bits and the structs of every storage buffer
// (std430). C++ sees glm types in namespace limen::frame::gpu, GLSL sees its own. Sizes are asserted in
// src/frame/GpuLayout.h, offsets in src/frame/GpuLayoutOffsets.cpp.
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

// Storage buffer bindings, but for the first, a uniform block. "Static": written when a scene is uploaded. "GPU":
// written by cull.comp in each frame.
LIMEN_CONST kBindFrame = 0;       // FrameConstants, one (std140)
LIMEN_CONST kBindLightSets = 1;   // LightSet (static)
LIMEN_CONST kBindLampRefs = 2;    // uint (static)
LIMEN_CONST kBindOwnership = 3;   // OwnershipVertex
LIMEN_CONST kBindClipSets = 4;    // ClipSet
LIMEN_CONST kBindSky = 5;         // SkyInstance
LIMEN_CONST kBindCommands = 6;    // DrawCommand as words (GPU)
LIMEN_CONST kBindIndices = 7;     // uint (static)
LIMEN_CONST kBindKeptIndices = 8; // uint, the indices of the triangles that culling kept (GPU)
LIMEN_CONST kBindTiles = 9;       // float, the farthest depth of each tile after walls and ground (GPU)
LIMEN_CONST kBindLevels = 10;     // Level (static)
LIMEN_CONST kStorageBindings = 11;

// Texture units. Several are buffers read as texels of four words: software drivers read a storage buffer lane by lane,
// and texels several times faster. Array pages are last (none in bindless mode).
LIMEN_CONST kUnitOwnership = 0;    // the ownership target
LIMEN_CONST kUnitRing = 1;         // this frame's arrays; DeviceConstants has the first texel of each
LIMEN_CONST kUnitDepth = 2;        // the target's depth; sampled only between draws
LIMEN_CONST kUnitVertices = 3;     // Vertex (static); the vertex fetch reads the same buffer
LIMEN_CONST kUnitInstances = 4;    // Instance (static)
LIMEN_CONST kUnitMembers = 5;      // Member, two a texel (static)
LIMEN_CONST kUnitPieces = 6;       // DrawPiece (static)
LIMEN_CONST kUnitMaterials = 7;    // Material (static)
LIMEN_CONST kUnitMaterialRefs = 8; // uint, four a texel (static)
LIMEN_CONST kUnitTextures = 9;     // TextureRef (static)
LIMEN_CONST kUnitTerrain = 10;     // TerrainCell or PackedCell (static)
LIMEN_CONST kUnitFirstPage = 11;
LIMEN_CONST kUnitPicture = 0; // of upscale.frag: the drawn picture
// The target's images, in place of arrays that the fast way of drawing does not read.
LIMEN_CONST kUnitColour = kUnitVertices;
LIMEN_CONST kUnitId = kUnitPieces;
LIMEN_CONST kVertexTexels = 4u; // texels of one record
LIMEN_CONST kInstanceTexels = 5u;
LIMEN_CONST kVisitTexels = 2u;
LIMEN_CONST kLampTexels = 2u;
LIMEN_CONST kMaterialTexels = 2u;
LIMEN_CONST kMaterialRefsPerTexel = 4u;

// Fragment outputs. Blended colour has an output of its own. Blending stays enabled for its draw buffer and disabled
// for the others, so that no stage has to switch it.
LIMEN_CONST kOutputColour = 0;
LIMEN_CONST kOutputId = 1;
LIMEN_CONST kOutputBlended = 2;
LIMEN_CONST kOutputVisit = 0; // of the ownership stage, which has no other output

// Vertex attribute locations: members of Vertex (GpuLayout.h).
LIMEN_CONST kAttributePosition = 0;
LIMEN_CONST kAttributeNormal = 1;
LIMEN_CONST kAttributeUv = 2;
LIMEN_CONST kAttributePolygonSurface = 3;
LIMEN_CONST kAttributeFacet = 4;
LIMEN_CONST kAttributeRest = 5;
LIMEN_CONST kAttributeRow0 = 6; // members of DrawRecord, one record a draw
LIMEN_CONST kAttributeRow1 = 7;
LIMEN_CONST kAttributeRow2 = 8;
LIMEN_CONST kAttributeOffsetRest = 9;
LIMEN_CONST kAttributeAmbient = 10;
LIMEN_CONST kAttributeSun = 11;
LIMEN_CONST kAttributeLook = 12;
LIMEN_CONST kAttributeMembers = 13;

LIMEN_CONST kOutside = 0u; // the outdoor zone

// LightSet.kind: world::LightSet::Kind
LIMEN_CONST kLitOutdoors = 0u;
LIMEN_CONST kLitMoving = 1u;
LIMEN_CONST kLitThing = 2u;
LIMEN_CONST kLitWalls = 3u;
LIMEN_CONST kMostLampsOfAThing = 8u; // the viewer's light among them

LIMEN_CONST kKindShell = 0u;    // InstanceKind::Shell: a cell's own walls
LIMEN_CONST kKindExterior = 2u; // InstanceKind::Exterior: a building seen from outside
LIMEN_CONST kKindFilling =
    6u; // InstanceKind::Filling: a surface in an opening, such as a door leaf or a pane

// Sample position in a pixel, relative to its centre, in units of 1/kPartsOfAPixel pixel, y upwards. Eyes stand in the
// planes of walls and above edges, and geometry on a grid has edges at angles where pixel centres line up. A ray
// through a centre would then run along several edges at once, and rounding would decide its side at each of them
// separately. No such line passes through this position. 1/4,096 pixel is the resolution of a float coordinate in a
// window 4,096 pixels wide.
LIMEN_CONST kBesideX = 7u;
LIMEN_CONST kBesideY = 3u;
LIMEN_CONST kPartsOfAPixel = 4096u;

// Stored depth is near plane / view depth. A fragment just outside its polygon's outline, by no more than rounding,
// fills only pixels that nothing else covers: its depth is multiplied by 2^-kFringeExponent. The sky, at
// 2^-kSkyExponent (ten million kilometres), covers such fragments and nothing else. A void of the fast way has
// 2^-kVoidExponent, so that no sky covers it.
LIMEN_CONST kFringeExponent = 60u;
LIMEN_CONST kSkyExponent = 59u;
LIMEN_CONST kVoidExponent = 58u;

// Level-of-detail ranges (world/LevelRange.h): steps per metre, and the limits to which distances from the eye and from
// the block's origin are clamped, in steps.
LIMEN_CONST kRangeSteps = 16u;
LIMEN_CONST kMostRangeSteps = 37000u;
LIMEN_CONST kMostLocalSteps = 1048576u;
LIMEN_CONST kLandcellSteps = 384u;  // per side
LIMEN_CONST kLandcellBeyond = 800u; // steps: world::kLandcellBeyond

LIMEN_CONST kSamples = 4u; // per pixel of a multisampled frame

LIMEN_CONST kNoVisit = 0xFFFFFFFFu;
LIMEN_CONST kOwnedOutside =
    1u << 31; // of the ownership target, beside the visit's number: its zone is the outside
LIMEN_CONST kSkyRectVertices =
    1u << 20; // the first vertex number of the plain sky's rectangles: more than 3 per clip set
LIMEN_CONST kShutByNothing = 1u; // Visit.shutBy: closed by a filling that has no surface
LIMEN_CONST kNoTexture = 0xFFFFFFFFu;
LIMEN_CONST kSkyId = 1u;
LIMEN_CONST kVoidId = 0u;

// ViewConstants.flags
LIMEN_CONST kFrameExactCutOuts = 1u; // cut-outs are tested at mip level 0, nearest texel (for ids and depth)

LIMEN_CONST kFramePixelLamps = 8u; // lamps light walls in fragments; selects program variants
LIMEN_CONST kFrameRootFirst =
    16u; // draws with the ownership test lose to those of the same surface without it

// DeviceConstants.flags
LIMEN_CONST kFrameStaticIndices = 2u; // draws use the static indices, uncompacted
LIMEN_CONST kFrameSplits = 4u;        // nearly opaque texels of kMaterialSplit surfaces are drawn as cut-outs
LIMEN_CONST kFrameWide = 32u;         // the viewport is twice as wide as the picture, with the same middle
LIMEN_CONST kFrameHigh = 64u;         // twice as high

// Material.flags
LIMEN_CONST kMaterialClamp = 1u;
LIMEN_CONST kMaterialAdditive = 2u;
LIMEN_CONST kMaterialInvAlpha = 4u;
LIMEN_CONST kMaterialAlpha = 8u;
LIMEN_CONST kMaterialSplit = 16u;   // also drawn as a cut-out: see surface.glsl
LIMEN_CONST kMaterialIndexed = 32u; // its picture has a palette

// Constants of a frame that follow from its view and its scene. Written by frame (frame/Planner.h).
LIMEN_STRUCT(ViewConstants) {
    mat4 clipFromEye LIMEN_ZERO; // clip from eye-relative; reversed depth, infinite far plane
    vec4 eyeHigh LIMEN_ZERO;     // xyz: the eye relative to the eye's block, rounded to float
    vec4 eyeLow LIMEN_ZERO;      // xyz: the residual of that rounding
    vec4 eyeSteps
        LIMEN_ZERO; // xyz: the eye relative to the eye's block in steps of 1 / kRangeSteps, rounded down: whole numbers
    vec4 sunDirection LIMEN_ZERO;  // xyz towards the sun
    vec4 sunColour LIMEN_ZERO;     // times its brightness
    vec4 landAmbient LIMEN_ZERO;   // of the ground
    vec4 skyAmbient LIMEN_ZERO;    // of everything else but sealed cells
    vec4 sealedAmbient LIMEN_ZERO; // of cells that do not see the outside
    vec4 viewerLight LIMEN_ZERO;   // xyz eye-relative, w intensity; 0: none
    vec4 fogColour LIMEN_ZERO;     // rgb
    vec4 fogRange LIMEN_ZERO;      // near, far in metres
    vec4 voidColour LIMEN_ZERO;
    vec4 skyZenith LIMEN_ZERO; // rgb: plain sky overhead; the horizon is fogColour
    // Detail pictures (details.glsl) by kDetailOf...: indices into textures, and repeats for each repeat of the uv; 0
    // repeats: no such picture.
    uvec4 detailTextures LIMEN_ZERO;
    vec4 detailTiling LIMEN_ZERO;
    uint rootZone LIMEN_ZERO;
    uint visitCount LIMEN_ZERO;
    uint flags LIMEN_ZERO; // kFrameExactCutOuts, kFramePixelLamps, kFrameRootFirst
    float nearPlane LIMEN_ZERO;
    uint staticInstances LIMEN_ZERO; // numbers from here on are the frame's instances
    uint staticMembers LIMEN_ZERO;   // numbers from here on are the frame's members
    uint staticPieces LIMEN_ZERO;    // numbers from here on are the frame's pieces
    uint replacementCount LIMEN_ZERO;
};

// Constants of a frame that follow from its target, its place in the ring memory and its culling. Written by gpu.
LIMEN_STRUCT(DeviceConstants) {
    vec4 viewport LIMEN_ZERO; // of the whole picture: width, height, 1/width, 1/height
    vec4 rayCorner
        LIMEN_ZERO; // xyz: eye-relative, where the view depth is one metre: the window's lower left corner,
    vec4 rayRight LIMEN_ZERO; // and the steps of one pixel
    vec4 rayUp LIMEN_ZERO;
    uint flags LIMEN_ZERO;  // kFrameStaticIndices, kFrameSplits, kFrameWide, kFrameHigh
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
    uint firstOccludee LIMEN_ZERO; // slots from here on are culled against the draws of those before
    uint windowOrigin
        LIMEN_ZERO;            // of a tile: its lower left corner in the whole picture, pixels; x | y << 16
    uint firstLamp LIMEN_ZERO; // Lamp
    uint reserved0 LIMEN_ZERO;
    uint reserved1 LIMEN_ZERO;
    uint reserved2 LIMEN_ZERO;
};

// The two, one behind the other, so that each has one writer.
LIMEN_STRUCT(FrameConstants) {
    ViewConstants view LIMEN_ZERO;
    DeviceConstants device LIMEN_ZERO;
};

LIMEN_STRUCT(Visit) {
    // eye-relative, positive beyond; the root's is (0,0,0,1), so that everything is beyond it
    vec4 entryPlane LIMEN_ZERO;
    uint zone LIMEN_ZERO;
    uint parent LIMEN_ZERO; // kNoVisit for the root
    uint shutBy LIMEN_ZERO; // 0: open; else the idBase of the filling, or kShutByNothing
    uint reserved LIMEN_ZERO;
};

LIMEN_STRUCT(Instance) {
    // block-local from model, 12 floats: the columns of the linear part, then the origin
    vec4 pose0 LIMEN_ZERO;
    vec4 pose1 LIMEN_ZERO;
    vec4 pose2 LIMEN_ZERO;
    uint block
        LIMEN_ZERO; // in the low half; the high half: a clip set (kClipSetShift), only of the plan's records
    uint idBase LIMEN_ZERO;
    uint firstMaterial LIMEN_ZERO; // into material refs; for terrain: into terrain cells
    uint firstMember LIMEN_ZERO;
    uint membersAndKind LIMEN_ZERO; // member count; the high half is the instance's kind
    uint level LIMEN_ZERO;          // index into levels, or kFromAnywhere
    uint highlight LIMEN_ZERO;      // RGBA8, alpha = strength; 0 none
    float opacity LIMEN_ZERO;       // factor for the opacity of its blended surfaces
};

// Distances at which a static instance is drawn: one level of detail of several. Instances of a frame are all within
// range: the CPU has left out the others.
LIMEN_STRUCT(Level) {
    int originX LIMEN_ZERO; // of the object, block-local steps
    int originY LIMEN_ZERO;
    int originZ LIMEN_ZERO; // times kMeasures, plus the measure: one of kMeasure...
    uint range
        LIMEN_ZERO; // drawn if distance >= low half and (distance < high half or that is kEndlessRange)
};
LIMEN_CONST kEndlessRange = 0xFFFFu;
LIMEN_CONST kFromAnywhere = 0xFFFFFFFFu;
LIMEN_CONST kMeasureObject = 0u; // world::LevelMeasure
LIMEN_CONST kMeasureLandcell = 1u;
LIMEN_CONST kMeasures = 4u;       // a power of two
LIMEN_CONST kBlockMask = 0xFFFFu; // of Instance.block
LIMEN_CONST kClipSetShift = 16u;
LIMEN_CONST kMostMembers = 0xFFFFu;
LIMEN_CONST kMostVisitBits = 63u;  // of DrawRecord.members
LIMEN_CONST kOneMember = 0x10000u; // of DrawRecord.members, in place of the count

// A zone that an instance belongs to, and its light set there.
struct Member {
    uint zone LIMEN_ZERO;
    uint lightSet LIMEN_ZERO;
};

LIMEN_STRUCT(Material) {
    vec4 colour LIMEN_ZERO;
    uint texture LIMEN_ZERO; // index into textures, or kNoTexture
    uint flags LIMEN_ZERO;
    float luminosity LIMEN_ZERO;
    float diffuse LIMEN_ZERO; // factor of the sun's light; read with SURFACE_DIFFUSE
};

// Location of a texture, filled in by TextureStore. x: layer of an array page, or low half of the 64-bit bindless
// handle. y: page, or high half. z, w: width and height in texels; z also has kTextureClamp.
LIMEN_CONST kTextureClamp = 0x80000000u;
LIMEN_STRUCT(TextureRef) {
    uvec4 place LIMEN_ZERO;
};

// One texture of a landcell; texture == kNoTexture: absent. `alpha`: blend map, read from its alpha channel (1 keeps
// the layer below), turned by `rotation` quarter turns; kNoTexture: none. `tiling`: repeats across the cell.
struct TerrainLayer {
    uint texture LIMEN_ZERO;
    uint alpha LIMEN_ZERO;
    uint rotation LIMEN_ZERO;
    float tiling LIMEN_ZERO;
};

// Six consecutive layers; the shaders read all cells as one array of layers.
LIMEN_CONST kLayersPerCell = 6u;
struct TerrainCell {
    TerrainLayer base LIMEN_ZERO;
    TerrainLayer overlays[3] LIMEN_ZERO;
    TerrainLayer roads[2] LIMEN_ZERO;
};

// The layers of a landcell that exist, in order, packed for drivers that shade one triangle at a time: base, overlays,
// roads; two a vector. First word: page of the texture, its array layer << 8, repeats << 24. Second word, 0 for no more
// layers: page of the blend map, its array layer << 8, and the bits below. A second road has the texture of the first, so that
// blending one over the other makes one road of both maps.
//
// `shown`: for each layer after the base 64 bits, which say in which parts of the cell it shows: kShownParts columns and rows,
// from the corner where the texture coordinates are 0, in the order of the layers, two words each.
LIMEN_CONST kShownParts = 8u;
LIMEN_CONST kShownVectors = 3u; // two words for each of five layers
LIMEN_CONST kPackedPlace = 0x00FFFFFFu;
LIMEN_CONST kPackedTurns = 24u;      // shift of the quarter turns
LIMEN_CONST kPackedTiling = 24u;     // shift of the repeats
LIMEN_CONST kPackedLayer = 1u << 26; // always set
LIMEN_CONST kPackedMap = 1u << 27;   // there is a blend map
LIMEN_CONST kPackedVectors = 3u;
LIMEN_STRUCT(PackedCell) {
    uvec4 layers[3] LIMEN_ZERO;
    uvec4 shown[3] LIMEN_ZERO;
};

LIMEN_STRUCT(LightSet) {
    uint kind LIMEN_ZERO;      // kLit...
    uint firstLamp LIMEN_ZERO; // run of the lamp references
    uint lampCount LIMEN_ZERO;
    uint sealed LIMEN_ZERO; // 1: in cells that do not see the outside
};

// One corner of the ownership stage's triangles, in tree order. An opening is a triangle fan around its middle; each
// triangle has the middle and two corners of the outline. With kCoverWindow the fan is drawn as one triangle around the
// window, and outline and clip set decide per fragment; without an outline the clip set alone. With kOnScreen it is a
// region of the flood, and the rasteriser's coverage decides.
LIMEN_CONST kCoverWindow = 0x80000000u;
LIMEN_CONST kOnScreen = 0x40000000u;
LIMEN_STRUCT(OwnershipVertex) {
    vec3 position LIMEN_ZERO; // block-local; with kOnScreen (x, y, w), in clip coordinates
    uint block LIMEN_ZERO;
    uint visit LIMEN_ZERO;
    uint clipSet LIMEN_ZERO;
    uint outlineFirst LIMEN_ZERO; // the fan's first vertex
    uint outlineCount
        LIMEN_ZERO; // corners of the outline, which is also the fan's triangles; kCoverWindow; kOnScreen
    vec3 rest LIMEN_ZERO; // exact corner minus `position`
    uint clipEdges
        LIMEN_ZERO; // planes of the clip set in use before its last; 1 for set 0, which keeps everything
};

// Triangles of one instance: drawn by one draw command, culled by one work group. One vector, because software drivers
// are faster with fewer loads.
LIMEN_CONST kCullThreads = 32u;         // per work group
LIMEN_CONST kTrianglesPerThread = 32u;  // at most: one bit each
LIMEN_CONST kTrianglesPerPiece = 1024u; // at most
LIMEN_CONST kNeverCulled =
    0x80000000u; // in DrawPiece.triangles: not culled, because the piece is a SkyInstance's
LIMEN_CONST kWordsPerCommand = 5u;
LIMEN_STRUCT(DrawPiece) {
    uint firstIndex LIMEN_ZERO;
    uint triangles LIMEN_ZERO;     // also has kNeverCulled
    uint instance LIMEN_ZERO;      // a SkyInstance with kNeverCulled
    uint indicesBefore LIMEN_ZERO; // of all earlier pieces of its array
};

// Modes of cull.comp, a uniform that is set once for each of its two program objects.
LIMEN_CONST kUniformCullMode = 0;
LIMEN_CONST kCullOccluders = 0u; // slots before firstOccludee: walls and ground; without occlusion all slots
LIMEN_CONST kCullOccludees = 1u; // slots from firstOccludee on, also tested against the depth tiles
LIMEN_CONST kCullModes = 2u;
// Layers of a grid of work groups that finds the farthest depth of each tile, with the program for occludees. Only the first works.
LIMEN_CONST kTileLayers = 2u;

LIMEN_CONST kTileSize = 8u;   // pixels per side
LIMEN_CONST kMostTiles = 64u; // a triangle over more tiles is not tested for occlusion

// Ownership test required (gate.glsl). A bit of RunOffsets.piece and of the instance number in draw commands.
LIMEN_CONST kGated = 0x80000000u;

// Each draw command of a frame has a slot; the pieces of a run have consecutive slots. Both members are offsets to add,
// so they are equal for the whole run.
struct RunOffsets {
    uint piece LIMEN_ZERO; // slot number + this, modulo 2^31: the piece; and kGated
    uint kept LIMEN_ZERO;  // DrawPiece.indicesBefore + this, modulo 2^32: position in the kept indices
};
LIMEN_STRUCT(DrawRun) {
    RunOffsets offsets LIMEN_ZERO;
    uint firstSlot LIMEN_ZERO;
    // rectangles outside which the run is culled: first, count in the high half; 0: the whole window
    uint rects LIMEN_ZERO;
};

// Runs of kSlotsPerGroup consecutive slots. A shader finds a slot's run by a binary search within the group, usually
// without a step. The size of a frame's data then depends on its runs, not on its draws.
LIMEN_CONST kSlotsPerGroup = 16u;
LIMEN_STRUCT(SlotGroup) {
    RunOffsets offsets LIMEN_ZERO; // of the first run
    uint firstRun LIMEN_ZERO;
    uint lastRun LIMEN_ZERO;
};

LIMEN_CONST kLastClipPlane = 7u; // of ClipSet.planes
// Eight half-spaces, eye-relative. Inside: dot(plane.xyz, p) + plane.w >= 0. All but the last pass through the eye.
// Unused ones are (0,0,0,1). In plans that clip (FramePlan::clips) they are lines on the screen: p is (x, y, w) in clip
// space, the planes become clip distances, and the first set has no lines.
LIMEN_STRUCT(ClipSet) {
    vec4 planes[8] LIMEN_ZERO;
};

// A static instance that this frame draws with a record of its own; `by` is numbered like dynamic instances.
struct Replacement {
    uint instance LIMEN_ZERO;
    uint by LIMEN_ZERO;
};

// A world::Light in this frame.
LIMEN_STRUCT(Lamp) {
    vec4 position LIMEN_ZERO; // xyz eye-relative, w falloff in metres
    vec4 colour LIMEN_ZERO;   // rgb; w: intensity, 0 for lamps that do not shine in this frame
};

// Components of ViewConstants.detailTextures.
LIMEN_CONST kDetailOfLand = 0u;
LIMEN_CONST kDetailOfExteriors = 1u;
LIMEN_CONST kDetailOfShells = 2u;
LIMEN_CONST kNoDetail = 3u;        // has 0 repeats
LIMEN_CONST kRecordFilling = 128u; // flag in DrawRecord.members.w: of kKindFilling
LIMEN_CONST kRecordDetail = 8u;    // shift in DrawRecord.members.w

// Everything of an instance that fast.vert reads: an instanced attribute of each draw.
LIMEN_STRUCT(DrawRecord) {
    vec4 row0 LIMEN_ZERO; // eye-relative from model, by rows; w: the offset, rounded to float
    vec4 row1 LIMEN_ZERO;
    vec4 row2 LIMEN_ZERO;
    vec4 rest LIMEN_ZERO;    // xyz: residual of the offset; w: the clip set
    vec4 ambient LIMEN_ZERO; // rgb: light from everywhere; w: opacity
    vec4 sun LIMEN_ZERO;     // rgb: light of the sun at a surface that faces it
    uvec4 look LIMEN_ZERO;   // Instance.firstMaterial, Instance.highlight, LightSet.firstLamp and lampCount
    // Instance.firstMember, member count (0: no ownership test), Instance.idBase, LightSet.kind plus the component of
    // detailTextures that covers it << kRecordDetail, and kRecordFilling. An instance of one zone: the zone, kOneMember. In a frame of up to
    // kMostVisitBits visits x and y of a draw with the test are a bit for each visit to one of its zones, and kGated.
    uvec4 members LIMEN_ZERO;
};

// A sky object of this frame.
LIMEN_STRUCT(SkyInstance) {
    vec4 row0 LIMEN_ZERO; // eye-relative from model, by rows
    vec4 row1 LIMEN_ZERO;
    vec4 row2 LIMEN_ZERO;
    uint firstMaterial LIMEN_ZERO;
    float opacity LIMEN_ZERO;
    float luminosity LIMEN_ZERO; // of materials without one of their own
    float uvOffsetX LIMEN_ZERO;
    float uvOffsetY LIMEN_ZERO;
    float diffuse LIMEN_ZERO; // factor of the sun's light
    uint overLand LIMEN_ZERO; // 1: over everything outdoors, else behind it
    uint clipSet LIMEN_ZERO;  // in plans that clip
};

#ifdef __cplusplus
} // namespace limen::frame::gpu
#undef LIMEN_CONST
#endif
#undef LIMEN_STRUCT
#undef LIMEN_ZERO
