#include "viewer/inspect/PortalTraces.h"

#include "engine/Projection.h"
#include "engine/report/IdTable.h"

#include <algorithm>
#include <fmt/format.h>

namespace limen::viewer {
namespace {

using visibility::PortalFate;

struct FateFacts {
    std::string_view name;
    output::Rgb colour;
};

constexpr std::array<FateFacts, visibility::kPortalFates> kFates{{
    {"without area", {255, 255, 255}},
    {"the way back", {0, 150, 160}},
    {"the eye is behind it", {120, 140, 190}},
    {"edge-on, or the eye is in it and it is shut", {190, 190, 60}},
    {"behind the eye", {130, 130, 130}},
    {"before the plane the rays came in by", {150, 100, 60}},
    {"no ray of the visit meets it", {205, 205, 205}},
    {"passed before", {150, 80, 200}},
    {"covered by nearer ones", {90, 130, 255}},
    {"left out: budget", {255, 0, 0}},
    {"the two polygons of the pair miss each other", {255, 120, 190}},
    {"leads to nothing that is loaded", {255, 0, 255}},
    {"shut", {255, 140, 0}},
    {"seen through, in the same zone", {160, 255, 160}},
    {"admitted", {0, 230, 0}},
}};

const FateFacts& factsOf(PortalFate fate) {
    return kFates[static_cast<std::size_t>(fate)];
}

} // namespace

std::vector<PortalTrace> portalTraces(const visibility::FloodTrace& trace) {
    std::vector<PortalTrace> traces;
    for (const visibility::FloodTrace::Entry& entry : trace.entries)
        traces.push_back({entry.portal, entry.fate, entry.visit});
    std::sort(traces.begin(), traces.end(), [](const PortalTrace& a, const PortalTrace& b) {
        if (a.portal != b.portal)
            return a.portal < b.portal;
        return a.fate != b.fate ? a.fate > b.fate : a.visit < b.visit;
    });
    const auto sameTwice = [](const PortalTrace& a, const PortalTrace& b) { return a.portal == b.portal; };
    traces.erase(std::unique(traces.begin(), traces.end(), sameTwice), traces.end());
    return traces;
}

std::array<std::size_t, visibility::kPortalFates> countFates(std::span<const PortalTrace> traces) {
    std::array<std::size_t, visibility::kPortalFates> counts{};
    for (const PortalTrace& trace : traces)
        ++counts[static_cast<std::size_t>(trace.fate)];
    return counts;
}

std::string_view nameOf(PortalFate fate) {
    return factsOf(fate).name;
}

output::Rgb colourOf(PortalFate fate) {
    return factsOf(fate).colour;
}

std::string portalLabel(const world::World& world, const PortalTrace& trace) {
    const world::Portal& portal = world.portals[trace.portal];
    const std::string towards =
        portal.destination == world::kNone ? "nothing" : engine::spaceName(world, portal.destination);
    return fmt::format("{} of {} to {}, visit {}", portal.recordIndex, engine::spaceName(world, portal.space),
                       towards, trace.visit);
}

std::vector<PortalLine> portalLines(const world::World& world, std::span<const PortalTrace> traces,
                                    const visibility::View& eye) {
    std::vector<PortalTrace> weakestFirst(traces.begin(), traces.end());
    std::stable_sort(weakestFirst.begin(), weakestFirst.end(),
                     [](const PortalTrace& a, const PortalTrace& b) { return a.fate < b.fate; });
    std::vector<PortalLine> lines;
    for (const PortalTrace& trace : weakestFirst) {
        const auto corners = cornersOf(world, world.portals[trace.portal]);
        for (std::size_t i = 0; i < corners.size(); ++i)
            if (const auto line = engine::projectLine(corners[i], corners[(i + 1) % corners.size()], eye))
                lines.push_back({line->first, line->second, trace.fate});
    }
    return lines;
}

} // namespace limen::viewer
