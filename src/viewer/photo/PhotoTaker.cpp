#include "viewer/photo/PhotoTaker.h"

#include "core/AbsolutePath.h"
#include "core/Assert.h"
#include "output/Picture.h"
#include "viewer/Screenshots.h"

#include <chrono>

namespace limen::viewer {

PhotoTaker::~PhotoTaker() {
    if (file_.valid())
        file_.wait();
}

Result<void> PhotoTaker::begin(engine::Session& session, const engine::FrameRequest& request,
                               std::uint32_t supersample, std::filesystem::path directory,
                               std::string command) {
    LIMEN_ASSERT(!isBusy(), "one picture at a time");
    Result<engine::LargePicture> picture =
        engine::LargePicture::begin(session, request, {.supersample = supersample});
    if (!picture)
        return Failure(picture.error());
    picture_ = std::make_unique<engine::LargePicture>(std::move(*picture));
    directory_ = std::move(directory);
    command_ = std::move(command);
    return {};
}

Result<std::optional<std::filesystem::path>> PhotoTaker::step(engine::Session& session) {
    if (picture_ != nullptr) {
        if (Result<void> drawn = picture_->drawNext(session); !drawn) {
            picture_.reset();
            return Failure(drawn.error());
        }
        if (picture_->isDone()) {
            output::Picture whole;
            whole.width = picture_->size().width;
            whole.height = picture_->size().height;
            whole.rgb = picture_->takeRgb();
            picture_.reset();
            file_ = std::async(std::launch::async,
                               [directory = directory_, command = command_, whole = std::move(whole)] {
                                   return keepScreenshot(directory, whole, command);
                               });
        }
        return std::nullopt;
    }
    if (!file_.valid() || file_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return std::nullopt;
    Result<std::filesystem::path> saved = file_.get();
    if (!saved)
        return Failure(saved.error());
    return absolutePath(*saved);
}

double PhotoTaker::progress() const {
    if (picture_ == nullptr)
        return file_.valid() ? 1.0 : 0.0;
    return static_cast<double>(picture_->drawn()) / static_cast<double>(picture_->tiles());
}

} // namespace limen::viewer
