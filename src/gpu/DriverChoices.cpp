#include "gpu/DriverChoices.h"

#include <algorithm>
#include <fmt/format.h>

namespace limen::gpu {
namespace {

const char* nameOf(Culling culling) {
    switch (culling) {
    case Culling::None:
        return "off";
    case Culling::Unseen:
        return "unseen triangles";
    case Culling::Hidden:
        break;
    }
    return "unseen and hidden triangles";
}

DriverChoice rasteriserOf(const DriverChoices& choices) {
    return {"rasteriser", choices.software ? "software" : "graphics card",
            choices.software ? "the driver draws on the processor"
                             : "the driver names no software rasteriser"};
}

DriverChoice drawingOf(const DriverChoices& choices) {
    return {"drawing", choices.drawing == Drawing::Fast ? "fast" : "exact",
            "as the options say, on every driver"};
}

DriverChoice texturesOf(const DriverChoices& choices) {
    return {"textures", choices.bindless ? "bindless" : "array pages",
            choices.bindless ? "the driver has ARB_bindless_texture"
                             : "the driver lacks ARB_bindless_texture, or the options say so"};
}

DriverChoice pagesOf(const DriverChoices& choices) {
    return {"pages_by_index", choices.pagesByIndex ? "on" : "off",
            choices.pagesByIndex
                ? "a software rasteriser shades one triangle at a time, and would sample every page"
            : choices.bindless ? "textures have handles"
                               : "a card needs constant indices"};
}

DriverChoice atlasOf(const DriverChoices& choices) {
    return {"atlas", choices.atlas ? "meshes and sky" : "off",
            choices.atlas          ? "one page for textures of all sizes, if they fit: no choice of a page"
            : choices.pagesByIndex ? "drawn exact, or the options say so"
                                   : "only with pages by index"};
}

DriverChoice terrainOf(const DriverChoices& choices) {
    return {"packed_landcells", choices.packsTerrain ? "on" : "off",
            choices.packsTerrain ? "pages are selected by index, and layers that a cell lacks are not sampled"
                                 : "only drawn fast with pages by index"};
}

DriverChoice levelsOf(const DriverChoices& choices) {
    return {"mip_levels", choices.nearestLevel ? "nearest" : "mean of two",
            choices.nearestLevel ? "half the time of a mean of two on the processor"
            : choices.software   ? "drawn exact"
                                 : "a card blends two at no cost"};
}

DriverChoice anisotropyOf(const DriverChoices& choices) {
    return {"anisotropy", choices.anisotropy > 1.0f ? fmt::format("up to {:g}", choices.anisotropy) : "off",
            choices.software ? "too slow on the processor" : "as the options and the driver allow"};
}

DriverChoice samplesOf(const DriverChoices& choices) {
    return {"multisampling", choices.samples > 1 ? fmt::format("{} samples", choices.samples) : "off",
            choices.samples > 1 ? "as the options say"
            : choices.software  ? "only --msaa turns it on without a graphics card"
                                : "as the options say"};
}

DriverChoice commandsOf(const DriverChoices& choices) {
    return {"draw_commands", choices.computes ? "compute pass" : "processor",
            choices.computes ? "drawn exact" : "drawn fast: the compute passes are skipped"};
}

DriverChoice overlapOf(const DriverChoices& choices) {
    return {"early_start", choices.overlaps ? "walls and ground" : "off",
            choices.overlaps   ? "the processor rasterises them while it transforms the rest"
            : choices.software ? "drawn exact"
                               : "a card begins by itself"};
}

DriverChoice openingsOf(const DriverChoices& choices) {
    return {"openings", choices.rootFirst ? "cleared" : "tested",
            choices.rootFirst  ? "from outside, most fragments then take no ownership test"
            : choices.software ? "drawn exact"
                               : "a card tests fragments at little cost"};
}

DriverChoice occlusionOf(const DriverChoices& choices) {
    return {"hidden_instances", choices.occludes ? "left out" : "drawn",
            choices.occludes   ? "from outside, land and buildings hide many, and the processor tells which"
            : choices.software ? "drawn exact"
                               : "a card draws them at little cost"};
}

DriverChoice cullingOf(const DriverChoices& choices) {
    return {"triangle_culling", nameOf(choices.culling),
            choices.drawing == Drawing::Fast ? "drawn fast: early depth tests do its work"
            : choices.samples > 1            ? "not with several samples"
                                             : "as the options say"};
}

} // namespace

DriverChoices driverChoices(const RendererOptions& options, const Capabilities& capabilities,
                            std::uint32_t samples) {
    const bool isFast = options.drawing == Drawing::Fast;
    DriverChoices choices;
    choices.software = capabilities.software;
    choices.drawing = options.drawing;
    choices.bindless = options.textures.mode != TextureMode::ArrayPages && capabilities.bindless;
    choices.pagesByIndex = !choices.bindless && options.textures.pagesByIndex && capabilities.software;
    choices.atlas = isFast && choices.pagesByIndex && options.textures.atlas;
    choices.packsTerrain = isFast && choices.pagesByIndex;
    choices.nearestLevel = capabilities.software && options.textures.nearestLevel;
    choices.anisotropy = capabilities.software ? 1.0f : options.textures.anisotropy;
    choices.samples = std::max(samples, 1u);
    choices.computes = !isFast;
    choices.overlaps = isFast && capabilities.software;
    choices.rootFirst = isFast && capabilities.software && options.rootFirst;
    choices.occludes = isFast && capabilities.software;
    if (!isFast && options.exactOutlines && choices.samples == 1)
        choices.culling = options.culling;
    return choices;
}

std::vector<DriverChoice> describe(const DriverChoices& choices) {
    return {rasteriserOf(choices), drawingOf(choices), texturesOf(choices),   pagesOf(choices),
            terrainOf(choices),    levelsOf(choices),  anisotropyOf(choices), samplesOf(choices),
            commandsOf(choices),   overlapOf(choices), openingsOf(choices),   occlusionOf(choices),
            cullingOf(choices),    atlasOf(choices)};
}

} // namespace limen::gpu
