#pragma once

#include "worlds/pictures/Canvas.h"

// The pictures of the built-in world, painted from noise and strokes. All tile unless the comment says
// otherwise.
namespace limen::worlds {

/// The look of a set of boards. Boards are parallel to u.
struct BoardStyle {
    int boards = 8;
    Vec3f light{0.62f, 0.45f, 0.28f}, dark{0.36f, 0.24f, 0.14f};
    double weathering = 0.2; ///< 0 fresh .. 1 grey
    bool endJoints = true;
    std::uint32_t seed = 1;
};
[[nodiscard]] Canvas paintBoards(const BoardStyle& style);
[[nodiscard]] Canvas paintBeam();
[[nodiscard]] Canvas paintBark();
[[nodiscard]] Canvas paintBarrelStaves();
[[nodiscard]] Canvas paintLogEnds();

[[nodiscard]] Canvas paintPlaster(Vec3f colour, double stains, std::uint32_t seed);
[[nodiscard]] Canvas paintStoneWall();
[[nodiscard]] Canvas paintFlagstones();
[[nodiscard]] Canvas paintBricks();
[[nodiscard]] Canvas paintThatch();
[[nodiscard]] Canvas paintRock(int size);

[[nodiscard]] Canvas paintRug();
[[nodiscard]] Canvas paintBlanket();
/// Woven cloth; `threads`: along each side of the picture.
[[nodiscard]] Canvas paintLinen(const Vec3f& colour, int threads);
[[nodiscard]] Canvas paintBooks();
[[nodiscard]] Canvas paintEmbers();
[[nodiscard]] Canvas paintFlame(); ///< does not tile; alpha is the glow
[[nodiscard]] Canvas paintWater();

/// Cut-outs: alpha is 0 or 1 except at soft edges; do not tile.
[[nodiscard]] Canvas paintLeaves(Vec3f light, Vec3f dark, int count, std::uint32_t seed);
[[nodiscard]] Canvas paintPineBranch();
[[nodiscard]] Canvas paintGrassTuft();
[[nodiscard]] Canvas paintFlowers();

/// Diamonds of glass in lead; alpha is opacity.
[[nodiscard]] Canvas paintGlass();
/// Sprites: alpha falls to 0 before the border; do not tile.
[[nodiscard]] Canvas paintSmoke();
[[nodiscard]] Canvas paintFire();
[[nodiscard]] Canvas paintFirefly();
[[nodiscard]] Canvas paintSnowflake();
[[nodiscard]] Canvas paintSwirl();
[[nodiscard]] Canvas paintShadow();

/// Grass from thousands of strokes over mottled earth. `bare` 0..1 is the share of earth that shows.
struct GrassStyle {
    Vec3f light{0.43f, 0.46f, 0.20f}, dark{0.20f, 0.24f, 0.10f}, earth{0.33f, 0.26f, 0.17f};
    double bare = 0.0;
    std::uint32_t seed = 1;
};
[[nodiscard]] Canvas paintGrass(const GrassStyle& style);
[[nodiscard]] Canvas paintDirt();
[[nodiscard]] Canvas paintForestFloor();
[[nodiscard]] Canvas paintStream(); ///< ripples over a dark bed
[[nodiscard]] Canvas paintRoad();   ///< trodden earth without a direction; blend maps make the lane

/// Blend maps: alpha 1 shows the lower layer. A corner for code 8 (north-west), a side for code 9 (the west
/// edge), and the same for lanes, an eighth of a landcell to each side, with patches of grass along the middle.
enum class BlendShape : std::uint8_t { Corner, Side, RoadCorner, RoadSide, RoadDiagonal };
[[nodiscard]] Canvas paintBlend(BlendShape shape, std::uint32_t seed);

/// Detail pictures. The grain of walls adds its colour minus its alpha, as shares of the colour beneath it; that
/// of the ground covers by its alpha.
[[nodiscard]] Canvas paintWallGrain();
[[nodiscard]] Canvas paintGroundGrain();

/// Sky pictures: u goes around the horizon, v from the zenith (0) past the horizon (kHorizonV) to below it
/// (1).
inline constexpr double kHorizonV = 0.8;
[[nodiscard]] Canvas paintDaySky();
[[nodiscard]] Canvas paintSnowSky(); ///< overcast
[[nodiscard]] Canvas paintRain();    ///< streaks that fall down v
[[nodiscard]] Canvas paintNightSky();
[[nodiscard]] Canvas paintDuskSky(); ///< alpha: strongest at the horizon
[[nodiscard]] Canvas paintSun();     ///< alpha is the glow
[[nodiscard]] Canvas paintMoon();    ///< alpha is the disc
[[nodiscard]] Canvas paintClouds();  ///< alpha is the cover

} // namespace limen::worlds
