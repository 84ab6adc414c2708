#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace limen::world {

/// The place of sun, moon and domes.
enum class SkyPlace : std::uint8_t {
    Eye,
    Block, ///< the south-west corner of the viewer's landblock, at height 0
    Cell   ///< the origin of the viewer's cell; outdoors the south-west corner of its landcell, at height 0
};
/// The particles of a sky object's script.
enum class SkyParticles : std::uint8_t {
    Around, ///< born evenly over the ground around the eye
    Eye,    ///< born around the eye as the emitter's record says: densest at the eye
    None
};
enum class CellFog : std::uint8_t { World, None };
/// The luminosity of surfaces of cells, beside light that is baked into their vertices.
enum class WallEmission : std::uint8_t { Added, Replaced };
/// The diffuse value of a Surface.
enum class SurfaceDiffuse : std::uint8_t {
    None,
    Sun ///< a factor of the sun's light
};
/// The normals of objects that are scaled, by the object's scale.
enum class ScaledNormals : std::uint8_t { Unit, Scaled, Divided };
enum class DetailPictures : std::uint8_t { On, Off };
enum class GroundGrain : std::uint8_t { Lit, Unlit };

/// The reading taken of each fact that the formats leave open (docs/uncertain.md).
struct Readings {
    SkyPlace skyPlace = SkyPlace::Eye;
    SkyParticles skyParticles = SkyParticles::Around;
    CellFog cellFog = CellFog::World;
    WallEmission wallEmission = WallEmission::Added;
    SurfaceDiffuse surfaceDiffuse = SurfaceDiffuse::None;
    double wallGrey = 1.0; ///< factor of ambient light and of the viewer's light on walls of cells, 0..1
    ScaledNormals normals = ScaledNormals::Unit;
    DetailPictures details = DetailPictures::On;
    GroundGrain grain = GroundGrain::Lit;
    double levelBias = 1.0; ///< quality bias of levels of detail, -1..1
    friend bool operator==(const Readings&, const Readings&) = default;
};

/// A reading as text: its name, and its values or limits.
struct ReadingFacts {
    std::string_view name;
    std::vector<std::string_view> values; ///< the first is the default; none: a number, by default `high`
    double low = 0.0, high = 0.0;         ///< of a number
};
[[nodiscard]] std::vector<ReadingFacts> readingFacts();

/// Sets one reading. False: `value` is not one of the reading. Requires a name of readingFacts.
[[nodiscard]] bool setReading(Readings& readings, std::string_view name, std::string_view value);

/// The readings that are not the default: "sky-place=block,wall-grey=0.5". Empty: all are.
[[nodiscard]] std::string textOf(const Readings& readings);

} // namespace limen::world
