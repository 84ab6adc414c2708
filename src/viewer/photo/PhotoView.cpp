#include "viewer/photo/PhotoView.h"

#include "core/AbsolutePath.h"

#include <fmt/format.h>

namespace limen::viewer {

Result<std::string> PhotoView::frame(const play::PlayInput& input, std::uint32_t percent) {
    window_ = input.size;
    std::string line;
    if (taker_.isBusy()) {
        const auto saved = taker_.step(session_);
        fault_ = saved ? std::string() : saved.error().message();
        if (saved && *saved)
            saved_ = (*saved)->string();
        if (!saved || *saved)
            line = saved ? "saved " + saved_ : fault_;
    } else {
        mode_.move(session_.part().world, input);
    }
    engine::scaleRequest(mode_.preview(window_), percent, drawn_);
    const Result<double> sceneMs = drawTimed(session_, drawn_, {});
    if (!sceneMs)
        return Failure(sceneMs.error());
    sceneMs_ = *sceneMs;
    return line;
}

PhotoFacts PhotoView::facts(const std::string& takeKeys) const {
    PhotoFacts facts{.settings = mode_.settings(),
                     .window = window_,
                     .picture = mode_.sizeIn(window_),
                     .dayGroups = {},
                     .hasBody = mode_.picture(window_).scene.body.has_value(),
                     .samples = session_.samples(),
                     .progress = taker_.progress(),
                     .isBusy = taker_.isBusy(),
                     .saved = saved_,
                     .fault = fault_,
                     .takeKeys = takeKeys};
    for (const auto& group : session_.part().world.sky.desc.dayGroups)
        facts.dayGroups.push_back(group.name);
    return facts;
}

bool PhotoView::drawOverlay(Ui& ui, const std::string& takeKeys, const std::filesystem::path& directory,
                            const CommandOf& commandOf) {
    const PhotoChoice choice = drawPhotoPage(ui, facts(takeKeys));
    mode_.set(choice.settings);
    if (choice.cancels)
        taker_.cancel();
    if ((choice.takes || std::exchange(wantsPicture_, false)) && !taker_.isBusy())
        begin(directory, commandOf);
    return choice.isBack;
}

void PhotoView::begin(const std::filesystem::path& directory, const CommandOf& commandOf) {
    const engine::FrameRequest picture = mode_.picture(window_);
    const std::uint32_t supersample = mode_.settings().supersample;
    std::string command = commandOf(picture);
    if (supersample > 1)
        command += fmt::format(" --supersample {}", supersample);
    saved_.clear();
    const Result<void> begun =
        taker_.begin(session_, picture, supersample, absolutePath(directory), std::move(command));
    fault_ = begun ? std::string() : begun.error().message();
}

} // namespace limen::viewer
