#include "viewer/Application.h"

#include "engine/CheckView.h"
#include "engine/report/DecisionHash.h"
#include "play/WalkRecord.h"

#include <fmt/format.h>

namespace limen::viewer {

void Application::takeSettings() {
    settings_ = std::move(options_.settings.settings);
    for (const std::string& note : options_.settings.notes)
        notes_.push_back(fmt::format("{}: {}", options_.settingsFile.string(), note));
    if (settings_.isFullScreen)
        window_.switchFullScreen();
}

void Application::keepSettings() {
    if (options_.settingsFile.empty())
        return;
    const Result<void> written = writeSettings(options_.settingsFile, settings_);
    if (!written && !std::exchange(hasSaveFailed_, true)) // said once
        notes_.push_back(written.error().message());
}

void Application::keepBindings(KeyBindings bindings) {
    keys_.bindings = std::move(bindings);
    const Result<void> written = writeKeyBindings(keys_.file, keys_.bindings);
    notice(written ? "Keys are saved in " + keys_.file.string() : written.error().message());
}

void Application::keepPicture() {
    wantsPicture_ = false;
    const Result<std::filesystem::path> kept = world_->keepPicture(options_.screenshots);
    notice(kept ? "Saved " + kept->string() : kept.error().message()); // a full disk does not end the program
    notes_.push_back(kept ? "saved " + kept->string() : kept.error().message());
}

void Application::beginRecording() {
    if (const Result<void> opened = recording_.open(options_.record); !opened) {
        recordError_ = opened.error();
        return;
    }
    const engine::Session& session = world_->session();
    const std::string start = check::shotOptions(engine::viewOf(world_->request(), session.part().world));
    static_cast<void>(recording_.add(play::beginningLine(start, session.options().load)));
}

void Application::record() {
    if (!recording_.isOpen())
        return;
    const engine::Session& session = world_->session();
    const std::uint64_t decided =
        engine::decisionHash(world_->request(), session.visible(), session.dynamics());
    const Result<void> added = recording_.add(
        play::frameLine({world_->input(), decided, world_->stream().shown(), world_->stream().hasRefused()}));
    if (!added)
        notice(added.error().message() + "; the rest waits in memory");
}

void Application::endRecording() {
    if (!recording_.isOpen())
        return;
    const Result<void> closed = recording_.close();
    if (!closed)
        recordError_ = closed.error();
    const std::size_t frames = recording_.savedLines() - std::min<std::size_t>(recording_.savedLines(), 1);
    if (closed)
        notes_.push_back(fmt::format("saved a walk of {} frames in {}", frames, recording_.file().string()));
}

Result<void> Application::save() {
    noteLastPlace();
    if (!window_.isLost() && !window_.isFullScreen()) {
        settings_.width = window_.size().width;
        settings_.height = window_.size().height;
    }
    keepSettings();
    endRecording();
    if (recordError_)
        return Failure(*recordError_);
    return {};
}

} // namespace limen::viewer
