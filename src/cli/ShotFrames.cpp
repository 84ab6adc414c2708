#include "cli/ShotFrames.h"

#include "engine/CheckView.h"
#include "engine/picture/LargePicture.h"
#include "output/FrameJson.h"
#include "output/Npy.h"
#include "output/OutputFile.h"
#include "output/RegionOverlay.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>

namespace limen::cli {
namespace {

/// Distances for depth.npy: infinite only for sky, NaN for holes.
std::vector<float> depthOf(const engine::Session& session, std::span<const std::uint32_t> ids) {
    std::vector<float> depth = session.target().readDistances(session.plan().constants);
    for (std::size_t i = 0; i < depth.size(); ++i)
        if (ids[i] == engine::kVoidPixel)
            depth[i] = std::numeric_limits<float>::quiet_NaN();
        else if (ids[i] == engine::kSkyPixel)
            depth[i] = std::numeric_limits<float>::infinity();
    return depth;
}

/// Draws a large or supersampled picture in tiles.
Result<output::Picture> drawInTiles(engine::Session& session, const engine::FrameRequest& request,
                                    std::uint32_t supersample, const Console& console) {
    Result<engine::LargePicture> large =
        engine::LargePicture::begin(session, request, {.supersample = supersample});
    if (!large)
        return Failure(large.error());
    Progress progress(console, "tiles", large->tiles());
    while (!large->isDone()) {
        if (Result<void> drawn = large->drawNext(session); !drawn)
            return Failure(drawn.error());
        progress.step(large->drawn());
    }
    output::Picture picture;
    picture.width = request.size.width;
    picture.height = request.size.height;
    picture.rgb = large->takeRgb();
    return picture;
}

Result<output::Picture> drawPicture(engine::Session& session, const engine::FrameRequest& request,
                                    std::uint32_t supersample, const Console& console) {
    constexpr std::uint32_t kInOnePiece = 4096; ///< pixels a side; larger targets need gigabytes
    if (supersample > 1 || std::max(request.size.width, request.size.height) > kInOnePiece)
        return drawInTiles(session, request, supersample, console);
    if (Result<void> drawn = session.draw(request, {.ids = false}); !drawn)
        return Failure(drawn.error());
    return output::pictureFromRgba(request.size.width, request.size.height, session.target().readColour());
}

/// Writes the picture, and the picture with outlined visits.
Result<void> writePictures(engine::Session& session, const engine::FrameRequest& request,
                           const OutputPaths& outputs, std::uint32_t supersample, const Console& console) {
    Result<output::Picture> drawn = drawPicture(session, request, supersample, console);
    if (!drawn)
        return Failure(drawn.error());
    output::Picture& picture = *drawn;
    if (!outputs.frame.empty()) {
        if (Result<void> written = output::writePicture(outputs.frame, picture); !written)
            return written;
    }
    if (outputs.overlay.empty())
        return {};
    output::drawRegions(picture, session.visible());
    return output::writePicture(outputs.overlay, picture);
}

/// Writes ids, depth and JSON from a separate frame, in which cut-outs are tested at the finest mip level.
Result<void> writeMeasurements(engine::Session& session, const engine::FrameRequest& request,
                               const OutputPaths& outputs) {
    if (Result<void> drawn = session.draw(request, {.ids = true}); !drawn)
        return drawn;
    const std::vector<std::uint32_t> ids = session.target().readIds();
    if (!outputs.ids.empty()) {
        if (Result<void> written = output::writeFile(
                outputs.ids, output::encodeNpy(request.size.width, request.size.height, std::span(ids)));
            !written)
            return written;
    }
    if (!outputs.depth.empty()) {
        const std::vector<float> depth = depthOf(session, ids);
        if (Result<void> written = output::writeFile(
                outputs.depth, output::encodeNpy(request.size.width, request.size.height, std::span(depth)));
            !written)
            return written;
    }
    if (outputs.json.empty())
        return {};
    nlohmann::ordered_json json =
        output::frameJson(session.part().world, session.part().ids, request, session.dynamics(),
                          session.visible(), session.plan(), session.figures(), ids);
    json["command"] = engine::reproduction(session.part().world, request, session.source().datOption);
    return output::writeFile(outputs.json,
                             json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

} // namespace

Result<engine::FrameRequest> requestOf(const engine::LoadedPart& part, const world::WorldFile& file,
                                       const engine::ViewRequest& view, const Console& console) {
    Result<engine::FrameRequest> request = engine::frameRequest(part.world, file, view);
    if (request && request->isRootAmbiguous)
        console.note(fmt::format("limen: several cells contain the eye; using {}; choose another with --root",
                                 engine::spaceName(part.world, request->root)));
    return request;
}

Result<void> shoot(engine::Session& session, const ListedView& listed, std::uint32_t supersample,
                   const Console& console) {
    const Result<engine::FrameRequest> request =
        requestOf(session.part(), session.source().file, listed.view, console);
    if (!request)
        return Failure(request.error());
    const OutputPaths& outputs = listed.outputs;
    const bool measure = !outputs.ids.empty() || !outputs.depth.empty() || !outputs.json.empty();
    const bool paint = !outputs.frame.empty() || !outputs.overlay.empty() || !measure;
    if (paint) {
        if (Result<void> written = writePictures(session, *request, outputs, supersample, console); !written)
            return written;
    }
    return measure ? writeMeasurements(session, *request, outputs) : Result<void>{};
}

} // namespace limen::cli
