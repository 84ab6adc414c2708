#include "output/MapPicture.h"

#include <cmath>

namespace limen::output {
namespace {

constexpr Rgb kInk{255, 255, 255}, kOutline{0, 0, 0};

void drawOutlined(Picture& picture, std::int64_t x, std::int64_t y, std::uint32_t scale,
                  const std::string& text) {
    for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}})
        if (x + dx >= 0 && y + dy >= 0)
            drawText(picture, static_cast<std::uint32_t>(x + dx), static_cast<std::uint32_t>(y + dy), scale,
                     text, kOutline);
    drawText(picture, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), scale, text, kInk);
}

void drawDot(Picture& picture, std::int64_t x, std::int64_t y, std::int64_t radius) {
    for (std::int64_t dy = -radius - 1; dy <= radius + 1; ++dy)
        for (std::int64_t dx = -radius - 1; dx <= radius + 1; ++dx)
            if (dx * dx + dy * dy <= (radius + 1) * (radius + 1))
                picture.set(x + dx, y + dy, dx * dx + dy * dy <= radius * radius ? kInk : kOutline);
}

} // namespace

Picture pictureOfMap(const engine::LandscapeMap& map) {
    Picture picture(map.width(), map.height());
    picture.rgb = map.rgb;
    return picture;
}

void drawPlaces(Picture& picture, const engine::LandscapeMap& map, std::span<const world::Place> places,
                double pixelsPerTexel) {
    const std::uint32_t scale = std::max(picture.width, picture.height) > 1600 ? 2 : 1;
    const double letter = 6.0 * scale, line = 9.0 * scale; // pixels of stb_easy_font, about
    std::vector<engine::LabelBox> boxes;
    std::vector<std::size_t> named;
    for (const engine::PlaceOnMap& at : engine::placesOnMap(places, map)) {
        if (at.isDungeon)
            continue;
        const Vec2 pixel = map.texelAt(at.point) * pixelsPerTexel;
        if (!(pixel.x >= 0.0 && pixel.y >= 0.0 && pixel.x < picture.width && pixel.y < picture.height))
            continue;
        drawDot(picture, std::llround(std::floor(pixel.x)), std::llround(std::floor(pixel.y)), scale);
        const double width = letter * static_cast<double>(places[at.place].name.size());
        const double gap = 4.0 * scale;
        const bool isLeft = pixel.x + gap + width > picture.width && pixel.x - gap - width >= 0.0;
        boxes.push_back(
            {isLeft ? pixel.x - gap - width : pixel.x + gap, std::max(1.0, pixel.y - line / 2), width, line});
        named.push_back(at.place);
    }
    for (const std::size_t i : engine::labelsWithoutOverlap(boxes))
        drawOutlined(picture, std::llround(boxes[i].x), std::llround(boxes[i].y), scale,
                     places[named[i]].name);
}

} // namespace limen::output
