// Locations of the values passed from vertex to fragment stages, named for both.
const uint kVaryingEyeRelative = 0u; // mesh.vert
const uint kVaryingLight = 1u;
const uint kVaryingUv = 2u;
const uint kVaryingNumbers = 3u; // four, one in each component:
const uint kPartInstance = 0u;
const uint kPartSurface = 1u;
const uint kPartId = 2u;
const uint kPartTriangle = 3u;
const uint kVaryingRests = 4u;   // an array: three locations
const uint kVaryingFacet = 7u;
const uint kVaryingCorners = 8u;  // an array: three locations
const uint kVaryingOutline = 11u; // an array: three locations
const uint kVaryingNormal = 14u;

const uint kVaryingTimes = 0u; // fast.vert
const uint kVaryingPlus = 1u;
const uint kVaryingFastUv = 2u;
const uint kVaryingTexture = 3u;
const uint kVaryingAlpha = 4u;
const uint kVaryingCover = 5u;
const uint kVaryingMembers = 6u;
const uint kVaryingFastId = 7u;
const uint kVaryingPicture = 8u;
const uint kVaryingBeforePlane = 8u; // of transparent surfaces, which have no picture
const uint kVaryingLayers = 9u; // an array: three locations
const uint kVaryingShown = 12u;  // an array: three locations
const uint kVaryingDetail = 4u; // of surfaces without alpha
const uint kVaryingUnlit = 5u; // of the ground
const uint kVaryingFastLight = 9u; // of meshes, which have no layers
const uint kVaryingFastNormal = 10u;
const uint kVaryingWallLamps = 11u;

const uint kVaryingVisit = 0u; // ownership.vert
const uint kVaryingOpening = 1u;
const uint kVaryingPlane = 2u;
const uint kVaryingCovers = 3u;
const uint kVaryingClip = 4u;

const uint kVaryingSkyUv = 0u; // skyobjects.vert
const uint kVaryingSkyInstance = 1u;
const uint kVaryingSkyMaterial = 2u;
const uint kVaryingSkyLight = 3u;

const uint kVaryingDirection = 0u; // skyplain.vert

const uint kVaryingTexel = 0u; // upscale.vert
