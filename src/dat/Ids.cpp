#include "dat/Ids.h"

#include <fmt/format.h>

namespace limen::dat {
namespace {

RecordKind cellKind(RecordId id) {
    const std::uint32_t low = id & 0xFFFFu;
    if (low == 0xFFFF)
        return RecordKind::LandBlock;
    if (low == 0xFFFE)
        return RecordKind::LandBlockInfo;
    return low >= kFirstCell ? RecordKind::EnvCell : RecordKind::Other;
}

RecordKind portalKind(RecordId id) {
    const std::uint32_t high = id >> 24;
    if (high == 0x05)
        return RecordKind::SurfaceTexture;
    if (high == 0x06 || high == 0x07)
        return RecordKind::RenderSurface;
    if ((id & 0x00FF0000u) != 0)
        return RecordKind::Other;
    switch (high) {
    case 0x01:
        return RecordKind::GfxObj;
    case 0x02:
        return RecordKind::Setup;
    case 0x03:
        return RecordKind::Animation;
    case 0x04:
        return RecordKind::Palette;
    case 0x08:
        return RecordKind::Surface;
    case 0x09:
        return RecordKind::MotionTable;
    case 0x0D:
        return RecordKind::Environment;
    case 0x0F:
        return RecordKind::PaletteSet;
    case 0x10:
        return RecordKind::ClothingTable;
    case 0x11:
        return RecordKind::DegradeInfo;
    case 0x12:
        return RecordKind::Scene;
    case 0x13:
        return RecordKind::Region;
    case 0x32:
        return RecordKind::ParticleEmitter;
    case 0x33:
        return RecordKind::PhysicsScript;
    case 0x34:
        return RecordKind::PhysicsScriptTable;
    default:
        return RecordKind::Other;
    }
}

} // namespace

RecordKind kindOf(FileRole role, RecordId id) {
    if (id == kIterationId)
        return RecordKind::Iteration;
    switch (role) {
    case FileRole::Cell:
        return cellKind(id);
    case FileRole::Portal:
    case FileRole::Highres:
        return portalKind(id);
    case FileRole::Local:
        break;
    }
    return RecordKind::Other;
}

const char* nameOf(RecordKind kind) {
    switch (kind) {
    case RecordKind::GfxObj:
        return "GfxObj";
    case RecordKind::Setup:
        return "Setup";
    case RecordKind::Animation:
        return "Animation";
    case RecordKind::Palette:
        return "Palette";
    case RecordKind::SurfaceTexture:
        return "SurfaceTexture";
    case RecordKind::RenderSurface:
        return "RenderSurface";
    case RecordKind::Surface:
        return "Surface";
    case RecordKind::MotionTable:
        return "MotionTable";
    case RecordKind::Environment:
        return "Environment";
    case RecordKind::PaletteSet:
        return "PaletteSet";
    case RecordKind::ClothingTable:
        return "ClothingTable";
    case RecordKind::DegradeInfo:
        return "DegradeInfo";
    case RecordKind::Scene:
        return "Scene";
    case RecordKind::Region:
        return "Region";
    case RecordKind::ParticleEmitter:
        return "ParticleEmitter";
    case RecordKind::PhysicsScript:
        return "PhysicsScript";
    case RecordKind::PhysicsScriptTable:
        return "PhysicsScriptTable";
    case RecordKind::LandBlock:
        return "LandBlock";
    case RecordKind::LandBlockInfo:
        return "LandBlockInfo";
    case RecordKind::EnvCell:
        return "EnvCell";
    case RecordKind::Iteration:
        return "Iteration";
    case RecordKind::Other:
        return "Other";
    }
    return "Other";
}

std::string idText(RecordId id) {
    return fmt::format("0x{:08X}", id);
}

} // namespace limen::dat
