#include "gpu/PassSelection.h"

namespace limen::gpu {

bool isDrawn(frame::Program program, const RenderOptions& options) {
    const bool isFlat = options.shading != Shading::Lit;
    switch (program) {
    case frame::Program::SkyObjects:
        return !isFlat && !options.wantLayers;
    case frame::Program::Blended:
        return !isFlat || options.wantLayers;
    default:
        return true;
    }
}

Pass passOf(frame::Program program, const RenderOptions& options) {
    switch (program) {
    case frame::Program::Ownership:
        return Pass::Ownership;
    case frame::Program::Blended:
        return options.wantLayers ? Pass::Layers : Pass::Blended;
    case frame::Program::SkyObjects:
        return Pass::Blended;
    case frame::Program::Stamp:
    case frame::Program::Fence:
        return Pass::Depth;
    case frame::Program::Opaque:
    case frame::Program::CutOut:
    case frame::Program::Terrain:
    case frame::Program::SkyPlain:
    case frame::Program::Clearing:
        break;
    }
    if (options.shading == Shading::IdsOnly)
        return Pass::SolidIds;
    return options.wantIds ? Pass::Solid : Pass::SolidNoIds;
}

} // namespace limen::gpu
