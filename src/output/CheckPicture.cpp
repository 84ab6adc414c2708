#include "output/CheckPicture.h"

#include "output/RegionOverlay.h"

#include <algorithm>

namespace limen::output {
namespace {

constexpr std::uint32_t kPanelWidth = 480; ///< pixels; smaller pictures are enlarged towards it
constexpr std::uint32_t kGap = 4;          ///< pixels between panels

Rgb colourOf(check::Verdict verdict) {
    switch (verdict) {
    case check::Verdict::Agrees:
        return {24, 24, 24};
    case check::Verdict::ByZone:
        return {40, 90, 40};
    case check::Verdict::Hole:
        return {90, 20, 20};
    case check::Verdict::Unjudged:
        return {110, 110, 110};
    case check::Verdict::Sliver:
        return {250, 240, 60};
    case check::Verdict::EdgeOn:
        return {255, 150, 0};
    case check::Verdict::Disagrees:
        return {255, 30, 30};
    case check::Verdict::Void:
        return {255, 0, 255};
    case check::Verdict::Depth:
        return {70, 110, 255};
    case check::Verdict::Layers:
        return {0, 230, 230};
    }
    return {255, 255, 255};
}

Picture enlarged(const Picture& picture, std::uint32_t factor) {
    Picture large(picture.width * factor, picture.height * factor);
    for (std::uint32_t y = 0; y < large.height; ++y)
        for (std::uint32_t x = 0; x < large.width; ++x)
            large.set(x, y, picture.at(x / factor, y / factor));
    return large;
}

void paste(Picture& onto, const Picture& picture, std::uint32_t left) {
    for (std::uint32_t y = 0; y < picture.height; ++y)
        for (std::uint32_t x = 0; x < picture.width; ++x)
            onto.set(left + x, y, picture.at(x, y));
}

std::vector<std::uint32_t> tracedIds(const reference::Picture& traced) {
    std::vector<std::uint32_t> ids;
    for (int y = 0; y < static_cast<int>(traced.height); ++y)
        for (int x = 0; x < static_cast<int>(traced.width); ++x)
            ids.push_back(traced.at(x, y).id);
    return ids;
}

} // namespace

Picture pictureOfVerdicts(std::uint32_t width, std::uint32_t height, const check::Comparison& comparison) {
    Picture picture(width, height);
    for (std::size_t i = 0; i < comparison.verdicts.size(); ++i)
        picture.set(static_cast<std::int64_t>(i % width), static_cast<std::int64_t>(i / width),
                    colourOf(comparison.verdicts[i]));
    return picture;
}

FindingPanels panelsOfFinding(const check::FindingPicture& finding) {
    const std::uint32_t width = finding.drawn.width, height = finding.drawn.height;
    const std::uint32_t factor = std::max(1u, kPanelWidth / std::max(1u, width));
    FindingPanels panels;
    panels.drawn =
        enlarged(finding.drawn.samples.empty() ? pictureOfIds(width, height, finding.drawn.ids)
                                               : pictureFromRgba(width, height, finding.drawn.colour),
                 factor);
    drawOutlines(panels.drawn, finding.drawn.outlines);
    panels.traced = enlarged(pictureOfIds(width, height, tracedIds(finding.traced)), factor);
    panels.verdicts = enlarged(pictureOfVerdicts(width, height, finding.comparison), factor);
    return panels;
}

Picture pictureOfFinding(const check::FindingPicture& finding) {
    const FindingPanels panels = panelsOfFinding(finding);
    const std::uint32_t width = panels.drawn.width;
    Picture all(3 * width + 2 * kGap, panels.drawn.height, {255, 255, 255});
    paste(all, panels.drawn, 0);
    paste(all, panels.traced, width + kGap);
    paste(all, panels.verdicts, 2 * (width + kGap));
    return all;
}

} // namespace limen::output
