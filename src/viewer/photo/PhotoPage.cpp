#include "viewer/photo/PhotoPage.h"

#include "engine/picture/LargePicture.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace limen::viewer {
namespace {

/// Dims the window outside of the picture.
void drawFrame(const PhotoFacts& facts) {
    constexpr ImU32 kDim = IM_COL32(0, 0, 0, 150);
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const Vec2 share = shownShare(facts.picture, facts.window);
    const float across = size.x * static_cast<float>(1.0 - share.x) * 0.5f;
    const float down = size.y * static_cast<float>(1.0 - share.y) * 0.5f;
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    if (across >= 1.0f) {
        list->AddRectFilled({0, 0}, {across, size.y}, kDim);
        list->AddRectFilled({size.x - across, 0}, size, kDim);
    }
    if (down >= 1.0f) {
        list->AddRectFilled({0, 0}, {size.x, down}, kDim);
        list->AddRectFilled({0, size.y - down}, size, kDim);
    }
}

bool slider(Ui& ui, const char* label, const char* name, double& value, double least, double most,
            const char* format) {
    auto number = static_cast<float>(value);
    uiText(label);
    ImGui::SetNextItemWidth(-1.0f);
    const bool isChanged = ImGui::SliderFloat(name, &number, static_cast<float>(least),
                                              static_cast<float>(most), format, ImGuiSliderFlags_AlwaysClamp);
    ui.note(label);
    if (isChanged)
        value = static_cast<double>(number);
    return isChanged;
}

/// A list to choose from. Yields the chosen index.
template <class NameOf>
std::size_t chooser(Ui& ui, const char* label, const char* name, std::size_t chosen, std::size_t count,
                    NameOf nameOf) {
    uiText(label);
    ImGui::SetNextItemWidth(-1.0f);
    const bool isOpen = ImGui::BeginCombo(name, nameOf(chosen).c_str());
    ui.note(label);
    if (!isOpen)
        return chosen;
    for (std::size_t i = 0; i < count; ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (ui.selectable(nameOf(i).c_str(), i == chosen))
            chosen = i;
        ImGui::PopID();
    }
    ImGui::EndCombo();
    return chosen;
}

void chooseWorld(Ui& ui, const PhotoFacts& facts, PhotoSettings& settings) {
    double hours = settings.time * 24.0;
    const int minutes = static_cast<int>(std::lround(hours * 60.0)) % (24 * 60);
    if (slider(ui, "Time of day", "##time", hours, 0.0, 24.0,
               fmt::format("{:02}:{:02}", minutes / 60, minutes % 60).c_str()))
        settings.time = hours / 24.0;
    bool rains = settings.weather == engine::Weather::Rain;
    if (facts.dayGroups.size() > 1)
        settings.dayGroup = static_cast<std::uint32_t>(
            chooser(ui, "Day", "##day", settings.dayGroup, facts.dayGroups.size(), [&](std::size_t i) {
                return i < facts.dayGroups.size() ? facts.dayGroups[i] : std::string("?");
            }));
    if (ui.checkbox("Rain", rains))
        settings.weather = rains ? engine::Weather::Rain : engine::Weather::Clear;
    if (facts.hasBody)
        ui.checkbox("Show the body", settings.showsBody);
}

void choosePicture(Ui& ui, PhotoSettings& settings) {
    slider(ui, "Field of view", "##fov", settings.fov, PhotoSettings::kLeastFov, PhotoSettings::kMostFov,
           "%.0f°");
    settings.size = chooser(ui, "Size", "##size", settings.size, kPhotoSizes.size(),
                            [](std::size_t i) { return std::string(kPhotoSizes[i].name); });
    constexpr std::array<std::uint32_t, 4> kNumbers{1, 2, 4, 8};
    const auto found = std::find(kNumbers.begin(), kNumbers.end(), settings.supersample);
    const auto number = found != kNumbers.end() ? static_cast<std::size_t>(found - kNumbers.begin()) : 0;
    settings.supersample =
        kNumbers[chooser(ui, "Samples a pixel", "##samples", number, kNumbers.size(), [&](std::size_t i) {
            return kNumbers[i] == 1 ? std::string("1") : fmt::format("{0} x {0}", kNumbers[i]);
        })];
}

/// The button that takes the picture, or the reason why there is none.
void drawTake(Ui& ui, const PhotoFacts& facts, PhotoChoice& choice) {
    if (facts.isBusy) {
        ImGui::ProgressBar(static_cast<float>(facts.progress), {-1.0f, 0.0f},
                           facts.progress < 1.0 ? "drawing" : "writing the file");
        choice.cancels = ui.button("Cancel", -1.0f);
        return;
    }
    const PhotoSettings& settings = choice.settings;
    if (const Result<void> fits = engine::checkLargePicture(facts.picture, settings.supersample); !fits) {
        uiNote(fits.error().message());
        return;
    }
    const double megabytes = static_cast<double>(engine::bytesOfLargePicture(
                                 facts.picture, {.supersample = settings.supersample}, facts.samples)) /
                             1e6;
    uiNote(fmt::format("{} x {} pixels, {:.0f} MB of memory", facts.picture.width, facts.picture.height,
                       megabytes));
    choice.takes = ui.mainButton("Take picture", -1.0f);
    uiHint("Also by key: " + facts.takeKeys);
}

} // namespace

PhotoChoice drawPhotoPage(Ui& ui, const PhotoFacts& facts) {
    PhotoChoice choice{.settings = facts.settings};
    drawFrame(facts);
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const ImGuiStyle& style = ImGui::GetStyle();
    const float least = ImGui::CalcTextSize("Leave photo mode").x +
                        2.0f * (style.FramePadding.x + style.WindowPadding.x) + style.ScrollbarSize;
    const float width = std::max(std::min(uiLength(240.0f), size.x * 0.42f), std::min(least, size.x));
    const float gap = uiLength(8.0f);
    ImGui::SetNextWindowPos({size.x - gap, gap}, ImGuiCond_Always, {1.0f, 0.0f});
    ImGui::SetNextWindowSizeConstraints({width, 0.0f}, {width, size.y - 2.0f * gap});
    ImGui::SetNextWindowBgAlpha(0.75f);
    ImGui::Begin("Photo mode", nullptr,
                 ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize);
    drawTake(ui, facts, choice); // first, with its result: visible without scrolling in a small window
    if (!facts.fault.empty())
        uiNote(facts.fault);
    if (!facts.saved.empty())
        uiNote("Saved: " + facts.saved);
    if (!facts.isBusy) {
        chooseWorld(ui, facts, choice.settings);
        choosePicture(ui, choice.settings);
    }
    choice.isBack = ui.button("Leave photo mode", -1.0f);
    ImGui::End();
    return choice;
}

} // namespace limen::viewer
