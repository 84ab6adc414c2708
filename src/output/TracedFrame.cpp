#include "output/TracedFrame.h"

#include "engine/CheckView.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <thread>

namespace limen::output {
namespace {

constexpr Rgb kSky{150, 190, 230}, kVoid{128, 0, 128}; ///< the drawn frame's void colour

Vec3 pointAt(const TracedFrame& frame, int x, int y) {
    const reference::Ray ray = reference::rayThrough(frame.camera, x, y);
    return ray.eye + ray.direction * frame.picture.at(x, y).t;
}

/// The step in space to the next or previous pixel if that is on the same polygon; 0 if neither is.
Vec3 stepAlong(const TracedFrame& frame, int x, int y, int dx, int dy) {
    const std::uint32_t id = frame.picture.at(x, y).id;
    if (frame.picture.at(x + dx, y + dy).id == id)
        return pointAt(frame, x + dx, y + dy) - pointAt(frame, x, y);
    if (frame.picture.at(x - dx, y - dy).id == id)
        return pointAt(frame, x, y) - pointAt(frame, x - dx, y - dy);
    return Vec3(0.0);
}

/// Cosine of the angle between the ray and the normal of the polygon at a pixel, 0..1, from the points that
/// neighbouring pixels meet. 1 if no neighbour is on the polygon.
double facingAt(const TracedFrame& frame, int x, int y) {
    const Vec3 normal = glm::cross(stepAlong(frame, x, y, 1, 0), stepAlong(frame, x, y, 0, 1));
    const double length = glm::length(normal);
    if (!(length > 0.0))
        return 1.0;
    const Vec3 along = glm::normalize(reference::rayThrough(frame.camera, x, y).direction);
    return std::min(std::abs(glm::dot(normal, along)) / length, 1.0);
}

Rgb colourAt(const TracedFrame& frame, int x, int y) {
    const std::uint32_t id = frame.picture.at(x, y).id;
    if (id == engine::kVoidPixel || id == engine::kSkyPixel)
        return id == engine::kSkyPixel ? kSky : kVoid;
    const double shade = 0.45 + 0.55 * facingAt(frame, x, y);
    Rgb colour = distinctColour(id);
    for (std::uint8_t& channel : colour)
        channel = static_cast<std::uint8_t>(std::lround(channel * shade));
    return colour;
}

/// Calls act(x, y, answer) for each pixel, row by row from the top.
template <class Do>
void forPixels(const TracedFrame& frame, Do&& act) {
    for (int y = 0; y < static_cast<int>(frame.camera.height); ++y)
        for (int x = 0; x < static_cast<int>(frame.camera.width); ++x)
            act(x, y, frame.picture.at(x, y));
}

} // namespace

TracedFrame traceFrame(const reference::Scene& scene, const engine::FrameRequest& request) {
    TracedFrame frame;
    frame.camera = engine::tracedCamera(request);
    reference::tracePicture(scene, frame.camera, std::max(1u, std::thread::hardware_concurrency()),
                            frame.picture);
    return frame;
}

std::vector<std::uint32_t> TracedFrame::ids() const {
    std::vector<std::uint32_t> ids;
    forPixels(*this, [&](int, int, const reference::Answer& answer) { ids.push_back(answer.id); });
    return ids;
}

std::vector<float> TracedFrame::depth() const {
    std::vector<float> depth;
    forPixels(*this, [&](int x, int y, const reference::Answer& answer) {
        // Distance = view depth * length of the ray's direction, which has unit depth. Infinity and NaN stay
        // so.
        depth.push_back(
            static_cast<float>(answer.t * glm::length(reference::rayThrough(camera, x, y).direction)));
    });
    return depth;
}

Picture TracedFrame::painting() const {
    Picture painting(camera.width, camera.height, kVoid);
    forPixels(*this,
              [&](int x, int y, const reference::Answer&) { painting.set(x, y, colourAt(*this, x, y)); });
    return painting;
}

nlohmann::ordered_json tracedJson(const world::World& world, const engine::IdTable& table,
                                  const engine::FrameRequest& request, const world::DynamicState& dynamics,
                                  const TracedFrame& frame, const std::string& datOption) {
    visibility::VisibleSet visible;
    std::vector<std::uint8_t> seen(world.spaces.size(), 0);
    forPixels(frame, [&](int, int, const reference::Answer& answer) { seen[answer.space] = 1; });
    for (world::SpaceIndex s = 0; s < seen.size(); ++s)
        if (seen[s] != 0)
            visible.seen.push_back({s, 0, {}});
    engine::FrameFigures figures;
    figures.driver = "reference";
    figures.drawing = "traced";
    figures.textures = "none";
    figures.floodMs = figures.planMs = figures.submitMs = figures.gpuMs =
        std::numeric_limits<double>::quiet_NaN();
    const std::vector<std::uint32_t> ids = frame.ids();
    nlohmann::ordered_json json = frameJson(world, table, request, dynamics, visible, {}, figures, ids);
    json["command"] = engine::reproduction(world, request, datOption) + " --reference";
    return json;
}

} // namespace limen::output
