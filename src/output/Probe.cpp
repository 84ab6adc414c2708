#include "output/Probe.h"

#include "engine/report/IdTable.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <nlohmann/json.hpp>

namespace limen::output {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint32_t kHole = 1, kShut = 2;

/// The spaces of a visit's chain, with the numbers of the portals between them:
/// "0xA9B40100 -0-> outside -1-> 0xA9B40106". If a visit leaves its zone from another cell than the one it
/// entered, that cell precedes the portal: "outside -3-> 0xA9B40106, 0xA9B40108 -1-> outside".
std::string chainOf(const ProbeFacts& facts, std::uint32_t visit) {
    const visibility::Visit& of = facts.visible.visits[visit];
    if (of.parent >= facts.visible.visits.size())
        return engine::spaceName(facts.world, of.space);
    const world::Portal& portal = facts.world.portals[of.portal];
    const std::string target = !of.hole  ? engine::spaceName(facts.world, of.space)
                               : of.shut ? "shut"
                                         : "nowhere";
    const bool isSameCell = portal.space == facts.visible.visits[of.parent].space;
    return fmt::format("{}{} -{}-> {}", chainOf(facts, of.parent),
                       isSameCell ? "" : ", " + engine::spaceName(facts.world, portal.space),
                       portal.recordIndex, target);
}

Json difference(const std::vector<std::string>& from, const std::vector<std::string>& without) {
    std::vector<std::string> rest;
    std::set_difference(from.begin(), from.end(), without.begin(), without.end(), std::back_inserter(rest));
    return rest;
}

Json position(const Vec3& at) {
    return {at.x, at.y, at.z};
}

bool seesOutside(const std::vector<std::string>& spaces) {
    return std::binary_search(spaces.begin(), spaces.end(), "outside");
}

/// The spaces that another gate than Gate::Ownership draws, far to near, each with its regions and planes.
Json gatedSpaces(const ProbeFacts& facts) {
    Json spaces = Json::array();
    for (const frame::GatedSpace& gated : facts.plan.spaces)
        spaces.push_back({{"space", engine::spaceName(facts.world, gated.space)},
                          {"regions", gated.regions},
                          {"planes", gated.planes},
                          {"fallbacks", gated.fallbacks}});
    return spaces;
}

std::uint32_t outsideRegions(const frame::FramePlan& plan) {
    for (const frame::GatedSpace& gated : plan.spaces)
        if (gated.space == world::kOutside)
            return gated.regions;
    return 0;
}

std::string stagesOf(const frame::FramePlan& plan) {
    std::vector<std::string> stages;
    for (const frame::Stage& stage : plan.stages)
        stages.push_back(fmt::format("{} {}", frame::nameOf(stage.kind), stage.batchCount));
    return fmt::format("{}", fmt::join(stages, ", "));
}

} // namespace

void Probe::take(const ProbeFacts& facts, Decisions& out) {
    out.blocks.clear();
    out.tree.clear();
    out.seen.clear();
    out.stages.clear();
    for (const world::Block& block : facts.world.blocks)
        out.blocks.push_back(dat::blockWord(block.coord));
    for (const visibility::Visit& visit : facts.visible.visits) {
        out.tree.insert(out.tree.end(), {visit.portal, visit.parent, visit.space,
                                         (visit.hole ? kHole : 0) | (visit.shut ? kShut : 0)});
    }
    for (const visibility::SeenSpace& seen : facts.visible.seen)
        out.seen.push_back(seen.space);
    for (const frame::Stage& stage : facts.plan.stages)
        out.stages.push_back(stage.batchCount);
    out.gate = facts.plan.gate;
    out.gated = facts.plan.spaces;
    out.root = facts.eye.root;
    out.body = facts.eye.scene.body ? facts.eye.scene.body->space : world::kNone;
    out.isHeld = facts.eye.isHeld;
    out.visitsCut = facts.visible.counts.visitsCut;
}

Probe::Names Probe::name(const ProbeFacts& facts) {
    Names names;
    names.root = engine::spaceName(facts.world, facts.eye.root);
    names.stages = stagesOf(facts.plan);
    if (facts.eye.scene.body)
        names.camera = fmt::format("{} to {}{}", engine::spaceName(facts.world, facts.eye.scene.body->space),
                                   names.root, facts.eye.isHeld ? ", held" : "");
    if (!facts.world.blocks.empty())
        names.centre = fmt::format("{} blocks from {} to {}", facts.world.blocks.size(),
                                   dat::idText(dat::landBlockId(facts.world.blocks.front().coord)),
                                   dat::idText(dat::landBlockId(facts.world.blocks.back().coord)));
    for (std::uint32_t visit = 0; visit < facts.visible.visits.size(); ++visit)
        names.visits.push_back(chainOf(facts, visit));
    for (const visibility::SeenSpace& seen : facts.visible.seen)
        names.cells.push_back(engine::spaceName(facts.world, seen.space));
    for (std::vector<std::string>* list : {&names.visits, &names.cells}) {
        std::sort(list->begin(), list->end());
        list->erase(std::unique(list->begin(), list->end()), list->end());
    }
    names.visitsCut = facts.visible.counts.visitsCut;
    return names;
}

std::string Probe::see(const ProbeFacts& facts) {
    take(facts, now_);
    const Vec3 from = lastEye_;
    lastEye_ = facts.eye.camera.eye;
    if (!isFirst_ && now_ == last_)
        return {};
    std::swap(now_, last_);
    Names names = name(facts);
    const bool isGateNew = isFirst_ || last_.gate != now_.gate || last_.gated != now_.gated;
    std::string lines;
    const auto report = [&](const char* event, const Json& details) {
        Json line{{"frame", facts.frame}, {"seconds", facts.seconds}, {"event", event}};
        line.update(details);
        line.update(Json{{"visits", facts.visible.visits.size()},
                         {"cells", names.cells.size()},
                         {"drawn", facts.plan.counts.instancesDrawn},
                         {"gl_calls", facts.glCalls}});
        lines += line.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
    };
    const auto differs = [&](auto Names::*member) { return isFirst_ || names.*member != reported_.*member; };
    if (differs(&Names::centre))
        report("loaded", {{"blocks", names.centre}});
    if (differs(&Names::root))
        report("root", {{"root", names.root},
                        {"was", isFirst_ ? Json() : Json(reported_.root)},
                        {"from", isFirst_ ? Json() : position(from)},
                        {"to", position(lastEye_)}});
    if (names.camera != reported_.camera)
        report("camera", {{"body", facts.eye.scene.body
                                       ? Json(engine::spaceName(facts.world, facts.eye.scene.body->space))
                                       : Json()},
                          {"eye", names.root},
                          {"held", facts.eye.isHeld}});
    if (differs(&Names::visits))
        report("visits", {{"came", difference(names.visits, reported_.visits)},
                          {"went", difference(reported_.visits, names.visits)}});
    if (differs(&Names::cells))
        report("seen", {{"came", difference(names.cells, reported_.cells)},
                        {"went", difference(reported_.cells, names.cells)}});
    if (isFirst_ || seesOutside(names.cells) != seesOutside(reported_.cells))
        report("outside", {{"seen", seesOutside(names.cells)}});
    if (differs(&Names::stages))
        report("stages", {{"stages", names.stages}});
    // After the swap `last_` has this frame's decisions. Space numbers of two parts of the world differ, and then the
    // list is reported again.
    if (isGateNew && (last_.gate != frame::Gate::Ownership || now_.gate != frame::Gate::Ownership))
        report("vis", {{"gate", frame::nameOf(last_.gate)},
                       {"root", names.root},
                       {"spaces", gatedSpaces(facts)},
                       {"outside_regions", outsideRegions(facts.plan)}});
    if (names.visitsCut != reported_.visitsCut)
        report("budget", {{"visits_cut", names.visitsCut}});
    reported_ = std::move(names);
    isFirst_ = false;
    return lines;
}

} // namespace limen::output
