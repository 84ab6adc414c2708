#include "viewer/StateJson.h"

#include "engine/report/IdTable.h"
#include "output/FrameJson.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace limen::viewer {
namespace {

nlohmann::ordered_json pickedJson(const std::optional<engine::Picked>& picked) {
    if (!picked)
        return nullptr;
    const engine::IdMeaning& meaning = picked->meaning;
    return {{"kind", meaning.kind},       {"record", meaning.record}, {"object", meaning.object},
            {"polygon", meaning.polygon}, {"space", meaning.space},   {"chain", picked->chain}};
}

nlohmann::ordered_json verdictJson(const std::optional<ViewVerdict>& verdict) {
    if (!verdict)
        return nullptr;
    return {{"pixels", verdict->comparison.verdicts.size()}, {"wrong", verdict->comparison.findings()}};
}

/// The number of shown portals of each fate.
nlohmann::ordered_json fatesJson(std::span<const PortalTrace> portals) {
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    const auto counts = countFates(portals);
    for (std::size_t i = counts.size(); i-- > 0;)
        if (counts[i] > 0)
            json[std::string(nameOf(static_cast<visibility::PortalFate>(i)))] = counts[i];
    return json;
}

/// The shown names, the nearest first.
nlohmann::ordered_json namesJson(std::span<const NameTag> names) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const NameTag& tag : names)
        json.push_back(tag.name);
    return json;
}

nlohmann::ordered_json pageJson(const Application& application) {
    const LoadingFacts loading = application.loading();
    nlohmann::ordered_json items = nlohmann::ordered_json::object();
    nlohmann::ordered_json focused = nullptr;
    for (const UiItem& item : application.ui().items()) {
        items[item.name] = {item.x, item.y};
        if (item.isFocused)
            focused = item.name;
    }
    const PageState& state = application.pages();
    return {{"page", factsOf(state.page).name},
            {"error", state.error},
            {"opening", state.opening},
            {"loading",
             {{"step", loading.step},
              {"blocks_read", loading.blocksRead},
              {"blocks", loading.blocks},
              {"uploaded", loading.uploaded}}},
            {"items", std::move(items)},
            {"focused", std::move(focused)},
            {"world", state.hasWorld ? nlohmann::ordered_json(application.directory())
                                     : nlohmann::ordered_json(nullptr)},
            {"hint", application.hint()},
            {"captured", application.isCaptured()},
            {"ui_scale", application.uiScale()},
            {"size", {application.size().width, application.size().height}},
            {"notice", application.noticeText()},
            {"rebinding", application.rebinding()
                              ? nlohmann::ordered_json(factsOf(application.rebinding()->action).name)
                              : nlohmann::ordered_json(nullptr)},
            {"keys", nlohmann::ordered_json::parse(keyBindingsJson(application.bindings()))}};
}

nlohmann::ordered_json numberOrNull(double value) {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

/// The scale of the 3-D picture, and the times that decide it.
nlohmann::ordered_json scaleJson(const ScaleFacts& scale, const WorldView& view) {
    const engine::PixelSize drawn = view.drawn().size;
    return {{"percent", scale.percent},
            {"automatic", scale.wish.percent == 0},
            {"drawn", {drawn.width, drawn.height}},
            {"frame_rate", scale.frameRate},
            {"scene_ms", numberOrNull(scale.sceneMs)},
            {"scene_ms_median", numberOrNull(view.times().scene.median())},
            {"frames_a_second", numberOrNull(1e3 / view.times().frame.median())}};
}

nlohmann::ordered_json worldJson(const WorldView& view) {
    const engine::FrameRequest& request = view.request();
    const engine::Session& session = view.session();
    return {{"eye", {request.camera.eye.x, request.camera.eye.y, request.camera.eye.z}},
            {"yaw", request.camera.heading.yaw},
            {"pitch", request.camera.heading.pitch},
            {"root", engine::spaceName(session.part().world, request.root)},
            {"seconds", request.scene.seconds},
            {"time", request.scene.time},
            {"day", request.scene.dayGroup},
            {"weather", request.scene.weather == engine::Weather::Rain ? "rain" : "clear"},
            {"look", world::nameOf(request.scene.look)},
            {"doors", request.scene.doors ? nlohmann::ordered_json(*request.scene.doors)
                                          : nlohmann::ordered_json(nullptr)},
            {"open_doors", view.openDoors()},
            {"visits", session.visible().visits.size()},
            {"gate", nameOf(session.options().gate)},
            {"overlays",
             {{"ids", view.switches().ids},
              {"depth", view.switches().depth},
              {"regions", view.switches().regions},
              {"portals", view.switches().portals},
              {"names", view.switches().names},
              {"panel", view.switches().panel}}},
            {"walking", view.walk().isOn()},
            {"chased", view.walk().isChased()},
            {"frozen_visits", view.frozenVisits()},
            {"portals", fatesJson(view.portals())},
            {"body", output::bodyJson(session.part().world, request.scene.body)},
            {"on_ground", view.walk().isOn() && view.walk().body().isOnGround},
            {"picked", pickedJson(view.picked())},
            {"checked", verdictJson(view.verdict())},
            {"distance", view.walk().distance()},
            {"loaded", {session.part().target.centre.x, session.part().target.centre.y}},
            {"going_to", view.goingTo()},
            {"door", view.doorInReach()},
            {"door_refused", view.isRefused()},
            {"names", namesJson(view.names())},
            {"gl_calls", session.figures().glCalls}};
}

/// The map page: its view, and whether all blocks are painted.
nlohmann::ordered_json mapJson(const MapPage& map) {
    return {{"centre", {map.view().centre.x, map.view().centre.y}},
            {"metres_per_unit", map.view().metresPerUnit},
            {"pointed", map.pointed()},
            {"painted", map.isPainted()}};
}

nlohmann::ordered_json photoJson(const PhotoView* photo) {
    if (photo == nullptr)
        return nullptr;
    const PhotoSettings& settings = photo->mode().settings();
    const engine::FrameRequest picture = photo->mode().picture(photo->window());
    const Vec3& eye = picture.camera.eye;
    return {{"eye", {eye.x, eye.y, eye.z}},
            {"time", settings.time},
            {"fov", settings.fov},
            {"size", {picture.size.width, picture.size.height}},
            {"supersample", settings.supersample},
            {"busy", photo->isBusy()},
            {"saved", photo->saved()},
            {"fault", photo->fault()}};
}

} // namespace

std::string stateJson(const Application& application, std::size_t frames) {
    nlohmann::ordered_json json{{"frames", frames}};
    json.update(pageJson(application));
    if (application.world() != nullptr && application.world()->session().frames() > 0) {
        json.update(worldJson(*application.world()));
        json["scale"] = scaleJson(application.scale(), *application.world());
    }
    if (application.pages().page == Page::Map)
        json["map"] = mapJson(application.map());
    json["photo"] = photoJson(application.photo());
    // Paths can hold any bytes: invalid UTF-8 is replaced.
    return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

} // namespace limen::viewer
