#include "viewer/Application.h"

#include <fmt/format.h>

// The pages that show the world in their own way: map and photo mode.
namespace limen::viewer {

/// Play is not stepped in photo mode, so that the world is as before when the mode ends.
Result<void> Application::framePhoto() {
    if (!photo_)
        photo_ = std::make_unique<PhotoView>(world_->session(), world_->request());
    HeldInput held = window_.held();
    applyLookSettings(held, settings_.sensitivity, settings_.invertY);
    play::PlayInput input = inputOf(held, options_.step > 0.0 ? options_.step : frameSeconds_);
    input.size = window_.size();
    for (const KeyCode key : window_.pressedKeys())
        if (key == keyNamed("Enter"))
            photo_->take();
    const bool isTaking = photo_->isBusy(); // its tiles are no part of the preview's time
    const Result<std::string> line = photo_->frame(input, chooseScale(isTaking));
    if (!line)
        return Failure(line.error());
    if (!isTaking)
        scale_.note(photo_->sceneMs());
    if (!line->empty())
        notes_.push_back(*line);
    return {};
}

void Application::present() {
    if (photo_)
        device_.presentToWindow(world_->session().target().handle(), photo_->window().width,
                                photo_->window().height);
    else
        world_->present();
}

void Application::drawPhoto() {
    const std::string keys = "Enter or " + keysText(keys_.bindings, Action::Screenshot);
    const bool leaves = photo_->drawOverlay(
        ui_, keys, options_.screenshots, [this](const auto& request) { return world_->commandOf(request); });
    if (leaves)
        go({PageEvent::Kind::Go, Page::World, {}});
}

void Application::drawMap() {
    MapFacts facts{.source = world_->session().shareSource(),
                   .eye = world_->request().camera.eye,
                   .yaw = world_->request().camera.heading.yaw,
                   .loaded = {}};
    for (const world::Block& block : world_->session().part().world.blocks)
        if (!block.isFar)
            facts.loaded.push_back(block.coord);
    const MapChoice choice = map_.draw(ui_, facts, !std::exchange(isMapShown_, true));
    if (choice.point)
        world_->act({play::PlayActKind::Go, choice.point->x, choice.point->y});
    if (choice.place)
        world_->act({play::PlayActKind::Place, static_cast<double>(*choice.place)});
    if (choice.point || choice.place || choice.isBack)
        go({PageEvent::Kind::Go, Page::World, {}});
}

} // namespace limen::viewer
