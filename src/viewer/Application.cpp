#include "viewer/Application.h"

#include "viewer/open/PathCompletion.h"
#include "viewer/pages/HintBar.h"
#include "viewer/panel/PanelParts.h"

#include <fmt/format.h>
#include <utility>

// The frame loop: events, world, overlay. ApplicationWorlds.cpp opens worlds, ApplicationFiles.cpp saves files.
namespace limen::viewer {

Application::Application(Window& window, gpu::GlDevice& device, ApplicationOptions options)
    : window_(window), device_(device), options_(std::move(options)), overlay_(window),
      keys_(std::move(options_.keys)) {
    takeSettings();
    lastSeconds_ = window_.seconds();
    device_.restoreState(); // ImGui's setup changed GL state
}

Application::~Application() = default;

Result<void> Application::frame() {
    constexpr double kPageFrame = 1.0 / 60.0; // seconds: a page leaves the processor to the loading threads
    window_.poll(overlay_.takes(), keys_.bindings, factsOf(pages_.page).pausesWorld ? kPageFrame : 0.0);
    const double now = window_.seconds();
    frameSeconds_ = now - lastSeconds_;
    lastSeconds_ = now;
    takeKeys();
    takePointer();
    if (opening_)
        stepOpening();
    std::erase_if(cancelled_, [](const auto& opening) { return opening->isIdle(); });
    if (pages_.page != Page::Photo)
        photo_.reset();
    isMapShown_ = isMapShown_ && pages_.page == Page::Map;
    if (world_)
        if (Result<void> drawn = pages_.page == Page::Photo ? framePhoto() : frameWorld(); !drawn)
            return drawn;
    if (wantsPicture_)
        keepPicture();
    if (window_.isLost()) // its image must not be used any more
        return {};
    if (world_)
        present();
    else
        overlay_.clear();
    if (!window_.isLost()) // GLFW reports arbitrary sizes of a lost window
        drawOverlay();
    return {};
}

void Application::rest() {
    window_.rest();
    lastSeconds_ = window_.seconds();
}

void Application::takeKeys() {
    if (rebinding_ && !window_.pressedKeys().empty()) {
        rebind(window_.pressedKeys().front());
        return;
    }
    if (window_.isPadBack() && pages_.page != Page::World && pages_.page != Page::Photo) {
        go({PageEvent::Kind::Back, Page::World, {}});
        return;
    }
    for (const Action action : window_.pressed())
        press(action);
}

void Application::press(Action action) {
    const bool isInWorld = world_ != nullptr && !factsOf(pages_.page).pausesWorld;
    const auto toggle = [&](Page page) {
        go({PageEvent::Kind::Go, pages_.page == page ? Page::World : page, {}});
    };
    switch (action) {
    case Action::Menu:
        return go({PageEvent::Kind::Back, Page::World, {}});
    case Action::FullScreen:
        window_.switchFullScreen();
        settings_.isFullScreen = window_.isFullScreen();
        return;
    case Action::Help:
        return toggle(Page::Controls);
    case Action::Map:
        return toggle(Page::Map);
    case Action::Photo:
        return toggle(Page::Photo);
    case Action::Search:
        return toggle(Page::Places);
    case Action::Screenshot:
        if (photo_)
            photo_->take();
        else
            wantsPicture_ = world_ != nullptr;
        return;
    case Action::Capture:
        if (isInWorld)
            setCapture(!window_.isCaptured());
        return;
    default:
        if (!isInWorld)
            return;
        static_cast<void>(world_->press(action));
        if (action == Action::Panel && world_->switches().panel)
            setCapture(false); // the panel needs the mouse
    }
}

void Application::rebind(KeyCode key) {
    const Rebinding wanted = *std::exchange(rebinding_, std::nullopt);
    if (key == keyNamed("Escape"))
        return;
    KeyBindings changed = keys_.bindings;
    changed.bind(wanted.action, key, wanted.adds);
    keepBindings(std::move(changed));
}

void Application::takePointer() {
    if (!window_.dropped().empty())
        open(directoryOfDrop(window_.dropped().front()));
    const bool isPanel = world_ != nullptr && world_->switches().panel;
    // With the panel a click inspects an object; without it, it captures the mouse.
    if (window_.clicked() && world_ != nullptr && pages_.page == Page::World && !isPanel &&
        settings_.mouse == MouseMode::Capture)
        setCapture(true);
}

void Application::go(const PageEvent& event) {
    const bool wasPointer = factsOf(pages_.page).usesPointer;
    if (event.kind == PageEvent::Kind::Back || event.kind == PageEvent::Kind::Cancelled)
        dropOpening();
    pages_ = after(std::move(pages_), event);
    const bool isPointer = factsOf(pages_.page).usesPointer;
    if (isPointer && !wasPointer)
        capturesAgain_ = window_.isCaptured();
    if (isPointer)
        window_.capture(false);
    else if (wasPointer)
        window_.capture(std::exchange(capturesAgain_, false));
    if (isPointer != wasPointer && !isPointer)
        rebinding_.reset();
}

void Application::setCapture(bool isCaptured) {
    window_.capture(isCaptured && !factsOf(pages_.page).usesPointer);
}

Result<void> Application::frameWorld() {
    const bool isPaused = factsOf(pages_.page).pausesWorld;
    WorldInput input{.held = window_.held(),
                     .size = window_.size(),
                     .percent = chooseScale(world_->verdict().has_value()),
                     .clicked = {},
                     .seconds = options_.step > 0.0 ? options_.step : frameSeconds_,
                     .now = lastSeconds_,
                     .frameSeconds = frameSeconds_,
                     .isPaused = isPaused};
    applyLookSettings(input.held, settings_.sensitivity, settings_.invertY);
    if (!isPaused && (world_->switches().panel || settings_.mouse == MouseMode::Drag))
        input.clicked = window_.clicked();
    if (Result<void> drawn = world_->frame(input); !drawn)
        return drawn;
    if (world_->hasStepped())
        scale_.note(world_->sceneMs());
    if (pages_.page == Page::World)
        hintSeconds_ += input.seconds;
    if (world_->stream().hasRefused())
        notice("This place cannot be loaded; choose another one.");
    if (const std::string fault = world_->stream().takeFault(); !fault.empty())
        notes_.push_back("cannot load nearby blocks: " + fault);
    if (world_->hasStepped())
        record();
    return {};
}

ScaleWish Application::scaleWanted() const {
    return {options_.scale.value_or(settings_.scale.percent),
            options_.frameRate.value_or(settings_.scale.frameRate)};
}

std::uint32_t Application::chooseScale(bool isHeld) {
    return scale_.choose({.wish = scaleWanted(),
                          .isSoftware = device_.capabilities().software,
                          .displayRate = window_.displayRate(),
                          .quality = world_->session().options().quality,
                          .frameMs = frameSeconds_ * 1e3,
                          .isHeld = isHeld});
}

std::string Application::noticeText() const {
    if (lastSeconds_ < notice_.until)
        return notice_.text;
    return world_ == nullptr || world_->goingTo().empty() ? std::string()
                                                          : fmt::format("Loading {} ...", world_->goingTo());
}

void Application::notice(std::string text) {
    constexpr double kShown = 5.0; // seconds
    notice_ = {std::move(text), lastSeconds_ + kShown};
}

void Application::drawOverlay() {
    const PageFacts& page = factsOf(pages_.page);
    overlay_.begin(uiScaleWanted(), page.usesPointer && !photo_); // keys move the camera in photo mode
    ui_.begin();
    if (world_ && !page.usesPointer)
        if (const auto wish = world_->drawOverlay(ui_, overlay_, keys_.bindings, scale_.facts()))
            takeScale(*wish);
    if (world_ && page.pausesWorld && !photo_)
        dimPicture();
    const LoadingFacts loading = this->loading();
    std::vector<world::Place> none;
    const PagesFacts facts{.state = pages_,
                           .settings = settings_,
                           .bindings = keys_.bindings,
                           .rebinding = rebinding_,
                           .loading = loading,
                           .gameDirectories = options_.gameDirectories,
                           .places =
                               world_ ? std::span(world_->session().source().file.places) : std::span(none),
                           .objects = objects_,
                           .hasObjects = world_ && world_->session().source().placed != nullptr,
                           .eye = world_ ? world_->request().camera.eye : Vec3(0.0),
                           .worldName = world_ ? nameOfWorld(directory_) : std::string(),
                           .version = options_.version,
                           .driver = world_ ? world_->session().driver() : std::string(),
                           .fontNote = overlay_.fontNote(),
                           .scale = scale_.facts(),
                           .uiScale = uiScaleWanted(),
                           .hasGamepad = window_.hasGamepad()};
    const PageChoice choice = drawnPages_.draw(ui_, facts);
    if (world_ && pages_.page == Page::Map)
        drawMap();
    else if (photo_)
        drawPhoto();
    hintOpacity_ =
        world_ && pages_.page == Page::World && !world_->switches().panel ? hintOpacity(hintSeconds_) : 0.0;
    drawHintBar(hints(keys_.bindings, settings_.mouse == MouseMode::Capture), hintOpacity_);
    panel::drawNotice(noticeText());
    overlay_.end();
    device_.restoreState();
    take(choice);
}

void Application::take(const PageChoice& choice) {
    if (choice.rebinding)
        rebinding_ = choice.rebinding;
    if (choice.resetsKeys)
        keepBindings(KeyBindings());
    if (choice.settings)
        takeNew(*choice.settings);
    if (choice.scale)
        takeScale(*choice.scale);
    if (choice.uiScale)
        takeUiScale(*choice.uiScale);
    if (choice.place && world_)
        world_->act({play::PlayActKind::Place, static_cast<double>(*choice.place)});
    if (choice.object && world_)
        world_->act({play::PlayActKind::Object, static_cast<double>(*choice.object)});
    if (choice.searches)
        searchObjects(*choice.searches);
    if (choice.event)
        go(*choice.event);
    if (choice.opens)
        open(*choice.opens);
}

void Application::searchObjects(const std::string& text) {
    constexpr std::size_t kMostShown = 50;
    objects_.clear();
    const engine::PlacedObjects* placed = world_ ? world_->session().source().placed.get() : nullptr;
    if (placed == nullptr || text.size() < kLeastSearched)
        return;
    Result<std::vector<engine::FoundObject>> found =
        placed->search(text, world_->request().camera.eye, kMostShown);
    if (found)
        objects_ = std::move(*found);
    else
        notes_.push_back(found.error().message());
}

/// A choice in the window wins over the command line.
void Application::takeScale(const ScaleWish& wish) {
    settings_.scale = wish;
    options_.scale.reset();
    options_.frameRate.reset();
}

void Application::takeNew(const Settings& settings) {
    const Settings before = std::exchange(settings_, settings);
    if (world_ && settings_.quality != before.quality)
        if (const auto quality = engine::qualityNamed(settings_.quality))
            world_->act({play::PlayActKind::Quality, static_cast<double>(*quality)});
    if (world_ && settings_.look != before.look)
        showLook();
    if (world_ && settings_.fieldOfView != before.fieldOfView)
        world_->act({play::PlayActKind::Fov, settings_.fieldOfView});
    if (settings_.isFullScreen != window_.isFullScreen())
        window_.switchFullScreen();
}

void Application::showLook() {
    world_->act({play::PlayActKind::Look, settings_.look == world::Look::Enhanced ? 1.0 : 0.0});
}

void Application::takeUiScale(double scale) {
    settings_.uiScale = scale;
    options_.uiScale.reset(); // a choice in the window wins over the command line
}

} // namespace limen::viewer
