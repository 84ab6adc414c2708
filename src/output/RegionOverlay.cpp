#include "output/RegionOverlay.h"

#include "engine/report/FrameReport.h"
#include "engine/report/IdTable.h"

#include <fmt/format.h>

namespace limen::output {
namespace {

/// Converts NDC to pixels: x right, y down, (0, 0) at the picture's upper left corner.
Vec2 pixelOf(const Picture& picture, const Vec2& ndc) {
    return {(ndc.x * 0.5 + 0.5) * picture.width, (0.5 - ndc.y * 0.5) * picture.height};
}

} // namespace

void drawRegions(Picture& picture, const visibility::VisibleSet& visible) {
    drawOutlines(picture, engine::regionOutlines(visible));
}

void drawOutlines(Picture& picture, std::span<const std::vector<Vec2>> outlines) {
    for (std::uint32_t i = 0; i < outlines.size(); ++i) {
        const std::vector<Vec2>& corners = outlines[i];
        if (corners.empty())
            continue;
        const Rgb colour = distinctColour(i);
        Vec2 centre{0.0};
        for (std::size_t c = 0; c < corners.size(); ++c) {
            const Vec2 from = pixelOf(picture, corners[c]),
                       to = pixelOf(picture, corners[(c + 1) % corners.size()]);
            drawLine(picture, from.x, from.y, to.x, to.y, colour);
            centre += from / static_cast<double>(corners.size());
        }
        const auto clamped = [](double v, std::uint32_t side) {
            return static_cast<std::uint32_t>(glm::clamp(v, 0.0, side - 1.0));
        };
        drawText(picture, clamped(centre.x, picture.width), clamped(centre.y, picture.height), 2,
                 fmt::format("{}", i), colour);
    }
}

Picture pictureOfIds(std::uint32_t width, std::uint32_t height, std::span<const std::uint32_t> ids) {
    Picture picture(width, height);
    for (std::size_t i = 0; i < ids.size() && i < picture.rgb.size() / 3; ++i) {
        Rgb colour = distinctColour(ids[i] * 7919u % 104729u);
        if (ids[i] == engine::kVoidPixel)
            colour = {255, 0, 0};
        else if (ids[i] == engine::kSkyPixel)
            colour = {170, 210, 255};
        picture.set(static_cast<std::int64_t>(i % width), static_cast<std::int64_t>(i / width), colour);
    }
    return picture;
}

Picture pictureOfDistances(std::uint32_t width, std::uint32_t height, std::span<const float> distances) {
    constexpr float kNearest = 0.1f, kDecades = 5.0f;
    Picture picture(width, height);
    for (std::size_t i = 0; i < distances.size() && i < picture.rgb.size() / 3; ++i) {
        Rgb colour{170, 210, 255};
        if (std::isfinite(distances[i])) {
            const float decades = std::log10(std::max(distances[i], kNearest) / kNearest);
            const auto grey =
                static_cast<std::uint8_t>(std::lround(255.0f * std::max(1.0f - decades / kDecades, 0.0f)));
            colour = {grey, grey, grey};
        }
        picture.set(static_cast<std::int64_t>(i % width), static_cast<std::int64_t>(i / width), colour);
    }
    return picture;
}

} // namespace limen::output
