#include "CardBench.h"

#include "BuiltInFiles.h"
#include "HeadlessDriver.h"
#include "card/CardRows.h"

#include <fmt/format.h>

namespace limen::bench {

namespace {

constexpr std::size_t kCardPlaces = 64;

/// The row of a machine without a card.
BenchRow noCardRow(const std::string& reason) {
    return {"card", "needs a graphics card: " + reason, kNotMeasured, kNotMeasured, "ms"};
}

gpu::RendererOptions optionsOf(gpu::Drawing drawing, gpu::TextureMode textures) {
    gpu::RendererOptions options;
    options.drawing = drawing;
    options.textures.mode = textures;
    return options;
}

/// Both ways of drawing with each binding of textures that the driver has.
std::vector<CardWay> cardWays(const gpu::Capabilities& capabilities) {
    std::vector<CardWay> ways;
    for (const gpu::TextureMode mode : {gpu::TextureMode::Bindless, gpu::TextureMode::ArrayPages}) {
        if (mode == gpu::TextureMode::Bindless && !capabilities.bindless)
            continue;
        const char* binding = mode == gpu::TextureMode::Bindless ? "bindless" : "pages";
        ways.push_back({fmt::format("fast/{}", binding), optionsOf(gpu::Drawing::Fast, mode)});
        ways.push_back({fmt::format("exact/{}", binding), optionsOf(gpu::Drawing::Exact, mode)});
    }
    // The cost of parts of the proof: outlines decided by fragments, which write depth; culling by compute passes.
    gpu::RendererOptions hardware, unculled;
    hardware.exactOutlines = false;
    unculled.culling = gpu::Culling::None;
    ways.push_back({"exact with hardware outlines", hardware});
    ways.push_back({"exact without culling", unculled});
    return ways;
}

} // namespace

std::vector<BenchRow> benchCard(AllocationCounter) {
    const std::optional<HeadlessDriver> driver = openDriver();
    if (!driver)
        return {noCardRow("no driver with OpenGL 4.5")};
    const gpu::Capabilities& capabilities = driver->device->capabilities();
    if (capabilities.software)
        return {noCardRow("this driver draws on the processor")};
    BuiltInFiles files;
    if (Result<void> opened = files.open(); !opened)
        return {failedRow("card", opened.error().message(), "ms")};
    const Result<std::vector<CardTimes>> times =
        timeOnCard(*driver->device, *files.archive, files.world, spreadEvenly(files.world.tour, kCardPlaces),
                   cardWays(capabilities), {{1280, 720}, {2560, 1440}, {3840, 2160}});
    if (!times)
        return {failedRow("card", times.error().message(), "ms")};
    return cardRows(*times);
}

} // namespace limen::bench
