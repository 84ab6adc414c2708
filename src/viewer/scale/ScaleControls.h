#pragma once

#include "viewer/pages/Ui.h"
#include "viewer/scale/PictureScale.h"

#include <string>

// Controls of the scale, for panel and pages. Inside a Dear ImGui frame only.
namespace limen::viewer {

/// A list of scales, with the automatic one. `name`: of the control in the state.
void chooseScale(Ui& ui, const char* name, const ScaleFacts& facts, ScaleWish& wish);
/// A list of frame rates that the automatic scale keeps.
void chooseFrameRate(Ui& ui, const char* name, const ScaleFacts& facts, ScaleWish& wish);
/// The scale in one line of text, e.g. "3-D picture: 75 %, 960 x 540".
[[nodiscard]] std::string scaleText(const ScaleFacts& facts, engine::PixelSize window);

} // namespace limen::viewer
