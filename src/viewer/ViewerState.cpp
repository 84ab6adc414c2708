#include "viewer/ViewerState.h"

#include "output/FrameJson.h"

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

} // namespace

std::string stateJson(const engine::Session& session, const Viewer& viewer, std::size_t frames) {
    const engine::FrameRequest& request = viewer.request();
    const nlohmann::ordered_json json{
        {"frames", frames},
        {"eye", {request.camera.eye.x, request.camera.eye.y, request.camera.eye.z}},
        {"yaw", request.camera.heading.yaw},
        {"pitch", request.camera.heading.pitch},
        {"root", engine::spaceName(session.part().world, request.root)},
        {"seconds", request.scene.seconds},
        {"time", request.scene.time},
        {"day", request.scene.dayGroup},
        {"weather", request.scene.weather == engine::Weather::Rain ? "rain" : "clear"},
        {"doors", request.scene.doors ? nlohmann::ordered_json(*request.scene.doors)
                                      : nlohmann::ordered_json(nullptr)},
        {"open_doors", viewer.openDoors()},
        {"visits", session.visible().visits.size()},
        {"overlays",
         {{"help", viewer.switches().help},
          {"ids", viewer.switches().ids},
          {"depth", viewer.switches().depth},
          {"regions", viewer.switches().regions},
          {"portals", viewer.switches().portals},
          {"panel", viewer.switches().panel}}},
        {"walking", viewer.walk().isOn()},
        {"chased", viewer.walk().isChased()},
        {"frozen_visits", viewer.frozenVisits()},
        {"portals", fatesJson(viewer.portals())},
        {"ui_scale", uiScaleOf(viewer.sizes()).units},
        {"body", output::bodyJson(session.part().world, request.scene.body)},
        {"on_ground", viewer.walk().isOn() && viewer.walk().body().isOnGround},
        {"picked", pickedJson(viewer.picked())},
        {"checked", verdictJson(viewer.verdict())},
        {"size", {request.size.width, request.size.height}},
        {"distance", viewer.walk().distance()},
        {"loaded", {session.part().target.centre.x, session.part().target.centre.y}},
        {"going_to", viewer.goingTo()},
        {"door", viewer.doorInReach()},
        {"notice", viewer.noticeText()},
        {"rebinding", viewer.rebinding() ? nlohmann::ordered_json(factsOf(viewer.rebinding()->action).name)
                                         : nlohmann::ordered_json(nullptr)},
        {"keys", nlohmann::ordered_json::parse(keyBindingsJson(viewer.bindings()))},
        {"gl_calls", session.figures().glCalls}};
    // Paths can hold any bytes: invalid UTF-8 is replaced.
    return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

} // namespace limen::viewer
