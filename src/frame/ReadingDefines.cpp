#include "frame/ReadingDefines.h"

#include <fmt/format.h>

namespace limen::frame {

std::vector<std::string> definesOf(const world::Readings& readings) {
    std::vector<std::string> defines;
    const auto add = [&defines](bool isTaken, const char* name) {
        if (isTaken)
            defines.emplace_back(name);
    };
    add(readings.cellFog == world::CellFog::None, "NO_CELL_FOG");
    add(readings.wallEmission == world::WallEmission::Replaced, "BAKED_LIGHT_REPLACES");
    add(readings.surfaceDiffuse == world::SurfaceDiffuse::Sun, "SURFACE_DIFFUSE");
    add(readings.normals == world::ScaledNormals::Scaled, "NORMALS_SCALED");
    add(readings.normals == world::ScaledNormals::Divided, "NORMALS_DIVIDED");
    add(readings.grain == world::GroundGrain::Unlit, "GRAIN_UNLIT");
    if (readings.wallGrey != 1.0)
        defines.push_back(fmt::format("WALL_GREY {:.6f}", readings.wallGrey));
    return defines;
}

} // namespace limen::frame
