#include "output/FrameJson.h"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace limen::output {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::uint32_t kNoIndex = 0xFFFFFFFFu;

/// Null for infinity and NaN, which JSON has no numbers for.
Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}
Json vector(const Vec3& v) {
    return {number(v.x), number(v.y), number(v.z)};
}

Json visitsJson(const world::World& world, const visibility::VisibleSet& visible) {
    Json list = Json::array();
    for (const visibility::Visit& visit : visible.visits) {
        Json region = Json::array();
        for (const Vec2& corner : engine::regionNdc(visible, visit))
            region.push_back({number(corner.x), number(corner.y)});
        Json portal = nullptr;
        if (visit.portal != kNoIndex && visit.portal < world.portals.size()) {
            const world::Portal& through = world.portals[visit.portal];
            portal = {{"space", engine::spaceName(world, through.space)}, {"index", through.recordIndex}};
        }
        list.push_back({{"zone", visit.hole ? Json(nullptr) : Json(visit.zone)},
                        {"space", engine::spaceName(world, visit.space)},
                        {"parent", visit.parent == kNoIndex ? -1 : static_cast<std::int64_t>(visit.parent)},
                        {"portal", std::move(portal)},
                        {"hole", visit.hole},
                        {"shut", visit.shut},
                        {"depth", visit.depth},
                        {"region", std::move(region)}});
    }
    return list;
}

Json idsJson(const engine::IdTable& table, const world::DynamicState& dynamics,
             std::span<const std::uint32_t> ids) {
    std::vector<std::uint32_t> distinct(ids.begin(), ids.end());
    std::sort(distinct.begin(), distinct.end());
    distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
    Json map = Json::object();
    for (const std::uint32_t id : distinct) {
        const engine::IdMeaning meaning = table.meaning(id, dynamics);
        map[std::to_string(id)] = {{"space", meaning.space},
                                   {"kind", meaning.kind},
                                   {"record", meaning.record},
                                   {"object", meaning.object},
                                   {"polygon", meaning.polygon}};
    }
    return map;
}

Json countsJson(const visibility::VisibleSet& visible, const frame::PlanCounts& plan) {
    const visibility::FloodCounts& flood = visible.counts;
    return {{"visits", visible.visits.size()},
            {"visits_cut", flood.visitsCut},
            {"portals_tested", flood.portalsTested},
            {"portals_admitted", flood.portalsAdmitted},
            {"cycles_split", flood.cyclesSplit},
            {"cells_seen", plan.cellsSeen},
            {"ownership_triangles", plan.ownershipTriangles},
            {"tested", plan.instancesTested},
            {"culled", plan.instancesCulled},
            {"drawn", plan.instancesDrawn},
            {"drawn_ungated", plan.drawsUngated},
            {"triangles", plan.triangles}};
}

Json figuresJson(const engine::FrameFigures& figures) {
    Json stages = Json::array();
    for (const engine::StageFigures& stage : figures.stages)
        stages.push_back({{"name", stage.name},
                          {"draws", stage.draws},
                          {"cpu_ms", number(stage.cpuMs)},
                          {"gpu_ms", number(stage.gpuMs)}});
    return stages;
}

Json choicesJson(const gpu::DriverChoices& choices) {
    Json json = Json::object();
    for (const gpu::DriverChoice& choice : gpu::describe(choices))
        json[choice.name] = {{"value", choice.value}, {"reason", choice.reason}};
    return json;
}

Json residentJson(const gpu::DeviceObjects& resident) {
    return {{"buffers", resident.buffers},
            {"buffer_bytes", resident.bufferBytes},
            {"ring_bytes", resident.ringBytes},
            {"textures", resident.textures},
            {"texture_handles", resident.residentHandles},
            {"programs", resident.programs},
            {"targets", resident.targets}};
}

} // namespace

Json bodyJson(const world::World& world, const std::optional<motion::PlayerBody>& body) {
    if (!body)
        return nullptr;
    return {{"feet", vector(body->feet)},
            {"yaw", number(body->yaw)},
            {"space", engine::spaceName(world, body->space)},
            {"opacity", number(body->opacity)}};
}

Json frameJson(const world::World& world, const engine::IdTable& table, const engine::FrameRequest& request,
               const world::DynamicState& dynamics, const visibility::VisibleSet& visible,
               const frame::FramePlan& plan, const engine::FrameFigures& figures,
               std::span<const std::uint32_t> ids) {
    Json cells = Json::array();
    for (const dat::RecordId cell : engine::cellsSeen(world, visible))
        cells.push_back(dat::idText(cell));
    const auto voids = std::count(ids.begin(), ids.end(), engine::kVoidPixel);
    Json report{{"eye", vector(request.camera.eye)},
                {"yaw", number(request.camera.heading.yaw)},
                {"pitch", number(request.camera.heading.pitch)},
                {"fov", number(request.camera.fovDegrees)},
                {"size", {request.size.width, request.size.height}},
                {"player", vector(request.scene.player)},
                {"body", bodyJson(world, request.scene.body)},
                {"time", number(request.scene.time)},
                {"day", request.scene.dayGroup},
                {"weather", request.scene.weather == engine::Weather::Rain ? "rain" : "clear"},
                {"look", world::nameOf(request.scene.look)},
                {"seconds", number(request.scene.seconds)},
                {"doors", request.scene.doors ? number(*request.scene.doors) : Json()},
                {"root", engine::spaceName(world, request.root)},
                {"root_ambiguous", request.isRootAmbiguous},
                {"cells", std::move(cells)},
                {"visits", visitsJson(world, visible)},
                {"counts", countsJson(visible, plan.counts)},
                {"stages", figuresJson(figures)},
                {"gl_calls", figures.glCalls},
                {"timings",
                 {{"flood_ms", number(figures.floodMs)},
                  {"plan_ms", number(figures.planMs)},
                  {"submit_ms", number(figures.submitMs)},
                  {"gpu_ms", number(figures.gpuMs)}}},
                {"driver", figures.driver},
                {"drawing", figures.drawing},
                {"driver_choices", figures.choices ? choicesJson(*figures.choices) : Json::object()},
                {"textures", figures.textures},
                {"bytes_written", figures.bytesWritten},
                {"ring_stalls", figures.ringStalls},
                {"resident", residentJson(figures.resident)}};
    if (!figures.trouble.empty())
        report["trouble"] = figures.trouble;
    if (!ids.empty()) {
        report["void_pixels"] = voids;
        report["ids"] = idsJson(table, dynamics, ids);
    }
    return report;
}

} // namespace limen::output
