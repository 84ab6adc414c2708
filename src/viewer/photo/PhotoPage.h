#pragma once

#include "viewer/pages/Ui.h"
#include "viewer/photo/PhotoMode.h"

#include <span>
#include <string>
#include <vector>

namespace limen::viewer {

/// The input of the photo page for one frame.
struct PhotoFacts {
    const PhotoSettings& settings;
    engine::PixelSize window;           ///< pixels
    engine::PixelSize picture;          ///< pixels
    std::vector<std::string> dayGroups; ///< names, of the Region
    bool hasBody = false;
    std::uint32_t samples = 0; ///< as SessionOptions::samples
    double progress = 0.0;     ///< of the picture that is being taken
    bool isBusy = false;       ///< a picture is being taken
    std::string saved;         ///< full path of the last picture; empty: none
    std::string fault;         ///< the reason why there is no picture; empty: none
    std::string takeKeys;      ///< the keys that take a picture, as text
};

struct PhotoChoice {
    PhotoSettings settings;
    bool takes = false;   ///< take a picture
    bool cancels = false; ///< drop the picture that is being taken
    bool isBack = false;  ///< leave photo mode
};

/// Draws the controls of photo mode in a window at the right edge, and dims the parts of the window that the
/// picture will not have. Inside a Dear ImGui frame.
[[nodiscard]] PhotoChoice drawPhotoPage(Ui& ui, const PhotoFacts& facts);

} // namespace limen::viewer
