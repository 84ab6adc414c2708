#include "viewer/scale/ScaleControls.h"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace limen::viewer {
namespace {

constexpr std::array<double, 13> kRates{5, 10, 15, 20, 25, 30, 40, 50, 60, 75, 90, 120, 144};

std::string percentText(std::uint32_t percent) {
    return fmt::format("{} %", percent);
}

std::string rateText(double rate) {
    return fmt::format("{:.0f} a second", rate);
}

} // namespace

void chooseScale(Ui& ui, const char* name, const ScaleFacts& facts, ScaleWish& wish) {
    const std::string automatic = fmt::format("automatic: {}", percentText(facts.percent));
    const std::string shown = facts.wish.percent == 0 ? automatic : percentText(facts.wish.percent);
    const bool isOpen = ImGui::BeginCombo((std::string("##") + name).c_str(), shown.c_str());
    ui.note(name);
    if (!isOpen)
        return;
    if (ui.selectable("automatic", facts.wish.percent == 0))
        wish.percent = 0;
    for (std::uint32_t percent = kFullScale; percent >= kLeastScale; percent -= 10)
        if (ui.selectable(percentText(percent).c_str(), facts.wish.percent == percent))
            wish.percent = percent;
    ImGui::EndCombo();
}

void chooseFrameRate(Ui& ui, const char* name, const ScaleFacts& facts, ScaleWish& wish) {
    const std::string automatic = "automatic: " + rateText(facts.automaticRate);
    const std::string shown = facts.wish.frameRate > 0.0 ? rateText(facts.wish.frameRate) : automatic;
    const bool isOpen = ImGui::BeginCombo((std::string("##") + name).c_str(), shown.c_str());
    ui.note(name);
    if (!isOpen)
        return;
    if (ui.selectable(automatic.c_str(), facts.wish.frameRate == 0.0))
        wish.frameRate = 0.0;
    for (const double rate : kRates)
        if (ui.selectable(rateText(rate).c_str(), facts.wish.frameRate == rate))
            wish.frameRate = rate;
    ImGui::EndCombo();
}

std::string scaleText(const ScaleFacts& facts, engine::PixelSize window) {
    const engine::PixelSize drawn = engine::scaledSize(window, facts.percent);
    const std::string work =
        std::isfinite(facts.sceneMs) ? fmt::format(", {:.1f} ms", facts.sceneMs) : std::string();
    return fmt::format("3-D picture {}, {} x {}{}", percentText(facts.percent), drawn.width, drawn.height,
                       work);
}

} // namespace limen::viewer
