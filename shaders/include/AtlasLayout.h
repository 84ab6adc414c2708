// Places in an atlas of textures (src/gpu/texture/Atlas.h), read by C++ and by GLSL.
#ifdef __cplusplus
#define LIMEN_ATLAS inline constexpr std::uint32_t
namespace limen::gpu {
#else
#define LIMEN_ATLAS const uint
#endif

// TextureRef.place of a texture in the atlas. x: column and row of its border's corner, and layer. y: width and height in texels,
// last mip level, and kAtlasClamp. Each has the bits from the shift of its name on.
LIMEN_ATLAS kAtlasTexels = 0xFFFu; // of columns, rows, widths and heights
LIMEN_ATLAS kAtlasY = 12u;
LIMEN_ATLAS kAtlasLayer = 24u;
LIMEN_ATLAS kAtlasHeight = 12u;
LIMEN_ATLAS kAtlasLastLevel = 24u;
LIMEN_ATLAS kAtlasLevels = 0xFu;
LIMEN_ATLAS kAtlasClamp = 1u << 28;

// Grains of walls have kGrainSide texels a side. The grain of exteriors has its first texel at column 1 and row 1 of layer 0, that
// of shells kGrainRows below. The texel at column 1 and row kNoGrainRow is black and transparent.
LIMEN_ATLAS kGrainSide = 256u;
LIMEN_ATLAS kGrainLevels = 9u;
LIMEN_ATLAS kGrainRows = 278u;
LIMEN_ATLAS kNoGrainRow = 265u;

#ifdef __cplusplus
} // namespace limen::gpu
#endif
#undef LIMEN_ATLAS
