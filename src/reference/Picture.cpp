#include "reference/Picture.h"

#include <algorithm>
#include <atomic>
#include <thread>

namespace limen::reference {
namespace {

/// Pixels of one side of a task's square: near rays meet near things, which are then in the cache.
constexpr std::uint32_t kTile = 8;

void traceTile(const Scene& scene, const Camera& camera, const Vec2& place, std::uint32_t left,
               std::uint32_t top, Picture& out) {
    const std::uint32_t width = camera.width + 2, height = camera.height + 2;
    for (std::uint32_t y = top; y < std::min(top + kTile, height); ++y) {
        for (std::uint32_t x = left; x < std::min(left + kTile, width); ++x) {
            // Row and column 0 are the border.
            const Ray ray = rayThrough(camera, static_cast<double>(x) - 1.0 + place.x,
                                       static_cast<double>(y) - 1.0 + place.y);
            out.answers[static_cast<std::size_t>(y) * width + x] = scene.trace(camera.root, ray);
        }
    }
}

} // namespace

Ray rayThrough(const Camera& camera, double x, double y) {
    const double across = ((x + 0.5) / camera.width * 2.0 - 1.0) * camera.tanHalfX;
    const double up = (1.0 - (y + 0.5) / camera.height * 2.0) * camera.tanHalfY;
    return {camera.eye, camera.forward + camera.right * across + camera.up * up, camera.nearPlane};
}

void tracePicture(const Scene& scene, const Camera& camera, unsigned threads, Picture& out, Vec2 place) {
    out.width = camera.width;
    out.height = camera.height;
    out.answers.assign((std::size_t{camera.width} + 2) * (std::size_t{camera.height} + 2), Answer{});
    const std::uint32_t columns = (camera.width + 2 + kTile - 1) / kTile;
    const std::uint32_t rows = (camera.height + 2 + kTile - 1) / kTile;
    std::atomic<std::uint32_t> next{0};
    const auto work = [&] {
        for (std::uint32_t tile = next++; tile < columns * rows; tile = next++)
            traceTile(scene, camera, place, tile % columns * kTile, tile / columns * kTile, out);
    };
    std::vector<std::thread> helpers;
    for (unsigned i = 1; i < threads; ++i)
        helpers.emplace_back(work);
    work();
    for (std::thread& helper : helpers)
        helper.join();
}

} // namespace limen::reference
