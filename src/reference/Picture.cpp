#include "reference/Picture.h"

#include "reference/Follower.h"

#include <algorithm>
#include <atomic>
#include <thread>

namespace limen::reference {
namespace {

constexpr std::uint32_t kTile = Tile::kSide;

/// `left` and `top` count from the border.
void traceTile(const SceneData& scene, TileCandidates& candidates, const Camera& camera, std::uint32_t left,
               std::uint32_t top, world::SpaceIndex root, Picture& out) {
    const std::uint32_t width = camera.width + 2, height = camera.height + 2;
    const Tile tile{camera, static_cast<int>(left) - 1, static_cast<int>(top) - 1};
    candidates.begin(tile);
    for (std::uint32_t row = 0; row < std::min(kTile, height - top); ++row) {
        for (std::uint32_t column = 0; column < std::min(kTile, width - left); ++column) {
            Answer& answer = out.answers[std::size_t{top + row} * width + left + column];
            answer = Follower(scene, tile.ray(column, row), candidates, row * kTile + column).follow(root);
        }
    }
}

} // namespace

Ray rayThrough(const Camera& camera, double x, double y) {
    const double across = ((x + camera.place.x + 0.5) / camera.width * 2.0 - 1.0) * camera.tanHalfX;
    const double up = (1.0 - (y + camera.place.y + 0.5) / camera.height * 2.0) * camera.tanHalfY;
    return {camera.eye, camera.forward + camera.right * across + camera.up * up, camera.nearPlane};
}

void tracePicture(const Scene& scene, const Camera& camera, unsigned threads, Picture& out) {
    out.width = camera.width;
    out.height = camera.height;
    out.answers.assign((std::size_t{camera.width} + 2) * (std::size_t{camera.height} + 2), Answer{});
    const std::uint32_t columns = (camera.width + 2 + kTile - 1) / kTile;
    const std::uint32_t rows = (camera.height + 2 + kTile - 1) / kTile;
    const world::SpaceIndex root = scene.spaceOfEye(camera.root, camera.eye);
    std::atomic<std::uint32_t> next{0};
    const auto work = [&] {
        TileCandidates candidates(scene.data());
        for (std::uint32_t tile = next++; tile < columns * rows; tile = next++)
            traceTile(scene.data(), candidates, camera, tile % columns * kTile, tile / columns * kTile, root,
                      out);
    };
    std::vector<std::thread> helpers;
    for (unsigned i = 1; i < threads; ++i)
        helpers.emplace_back(work);
    work();
    for (std::thread& helper : helpers)
        helper.join();
}

} // namespace limen::reference
