#include "world/Records.h"

namespace limen::world {

void note(std::vector<Finding>& findings, dat::RecordId record, std::string what) {
    findings.push_back({record, std::move(what)});
}

SurfaceClass surfaceClassOf(const dat::Surface& surface) {
    constexpr std::uint32_t kBlending =
        dat::Surface::kTranslucent | dat::Surface::kAlpha | dat::Surface::kInvAlpha | dat::Surface::kAdditive;
    if ((surface.type & kBlending) != 0 || (surface.translucency > 0.0f && surface.translucency < 1.0f))
        return SurfaceClass::Blended;
    return (surface.type & dat::Surface::kBase1ClipMap) != 0 ? SurfaceClass::CutOut : SurfaceClass::Opaque;
}

} // namespace limen::world
