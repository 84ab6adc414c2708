#include "dat/Describe.h"
#include "dat/describe/Json.h"

namespace limen::dat {
namespace {

Json building(const Building& b) {
    return {{"model", hexId(b.model)},
            {"frame", json(b.frame)},
            {"leaves", b.numLeaves},
            {"portals", listOf(b.portals, [](const BuildingPortal& p) {
                 return Json{{"flags", p.flags},
                             {"cell", hexHalf(p.otherCellId)},
                             {"portal", hexHalf(p.otherPortalId)},
                             {"stabs", hexIds(p.stabs)}};
             })}};
}

/// The 9x9 values of a landblock as rows from north to south, arranged like a map.
template <class Values, class Make>
Json mapRows(const Values& values, Make&& make) {
    Json rows = Json::array();
    for (std::size_t y = 9; y-- > 0;) {
        Json row = Json::array();
        for (std::size_t x = 0; x < 9; ++x)
            row.push_back(make(values[x * 9 + y]));
        rows.push_back(std::move(row));
    }
    return rows;
}

} // namespace

std::string describe(const EnvCell& c) {
    Json out = {{"kind", "EnvCell"},
                {"id", hexId(c.id)},
                {"flags", c.flags},
                {"seen_outside", (c.flags & EnvCell::kSeenOutside) != 0},
                {"surfaces", hexIds(c.surfaces)},
                {"environment", hexHalf(c.environment)},
                {"cell_structure", c.cellStructure},
                {"position", json(c.position)}};
    out["portals"] = listOf(c.portals, [](const CellPortal& p) {
        return Json{{"flags", p.flags},
                    {"polygon", p.polygonId},
                    {"cell", hexHalf(p.otherCellId)},
                    {"portal", hexHalf(p.otherPortalId)}};
    });
    out["visible_cells"] = hexIds(c.visibleCells);
    if (c.flags & EnvCell::kHasStatics)
        out["statics"] = listOf(c.statics, [](const Stab& s) { return json(s); });
    if (c.flags & EnvCell::kHasRestriction)
        out["restriction"] = hexId(c.restriction);
    return pretty(out);
}

std::string describe(const LandBlock& b) {
    return pretty({{"kind", "LandBlock"},
                   {"id", hexId(b.id)},
                   {"has_objects", b.hasObjects != 0},
                   {"rows", "north to south, each west to east"},
                   {"heights", mapRows(b.heights, [](std::uint8_t h) { return Json(h); })},
                   {"terrain_types", mapRows(b.terrain, [](std::uint16_t t) { return Json((t >> 2) & 31); })},
                   {"roads", mapRows(b.terrain, [](std::uint16_t t) { return Json(t & 3); })},
                   {"sceneries", mapRows(b.terrain, [](std::uint16_t t) { return Json(t >> 11); })}});
}

std::string describe(const LandBlockInfo& info) {
    Json out = {{"kind", "LandBlockInfo"},
                {"id", hexId(info.id)},
                {"cells", info.numCells},
                {"objects", listOf(info.objects, [](const Stab& s) { return json(s); })},
                {"buildings", listOf(info.buildings, building)}};
    if (info.hasRestrictions != 0)
        out["restrictions"] = listOf(info.restrictions, [](const auto& pair) {
            return Json{{"cell", hexId(pair.first)}, {"object", hexId(pair.second)}};
        });
    return pretty(out);
}

} // namespace limen::dat
