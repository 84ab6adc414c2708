#include "dat/Describe.h"
#include "dat/describe/Json.h"

namespace limen::dat {
namespace {

Json vertices(const VertexArray& array) {
    return listOf(array.vertices, [](const auto& keyed) {
        const Vertex& v = keyed.second;
        return Json{{"key", keyed.first},
                    {"position", json(v.position)},
                    {"normal", json(v.normal)},
                    {"uvs", listOf(v.uvs, [](const Vec2f& uv) { return json(uv); })}};
    });
}

Json polygons(const PolygonList& list) {
    return listOf(list, [](const auto& keyed) {
        const Polygon& p = keyed.second;
        Json out = {{"id", keyed.first},
                    {"stippling", p.stippling},
                    {"sides", p.sides},
                    {"pos_surface", p.posSurface},
                    {"neg_surface", p.negSurface},
                    {"vertices", listOf(p.vertexKeys, [](auto k) { return Json(k); })}};
        if (!p.posUv.empty())
            out["pos_uv"] = listOf(p.posUv, [](auto uv) { return Json(uv); });
        if (!p.negUv.empty())
            out["neg_uv"] = listOf(p.negUv, [](auto uv) { return Json(uv); });
        return out;
    });
}

std::string tagName(BspTag tag) {
    const auto word = static_cast<std::uint32_t>(tag);
    std::string out;
    for (int shift = 24; shift >= 0; shift -= 8)
        out += static_cast<char>((word >> shift) & 0x7F);
    return out;
}

/// The nodes in file order. Children are given by index, so that deep trees do not make deep JSON.
Json bsp(const BspTree& tree, BspKind kind) {
    Json out = Json::array();
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const BspNode& node = tree.nodes[i];
        Json one = {{"node", i}, {"tag", tagName(node.tag)}};
        const bool isLeaf = node.tag == BspTag::Leaf;
        if (isLeaf)
            one["leaf"] = node.leafIndex;
        else
            one["plane"] = json(node.plane);
        if (node.positive >= 0)
            one["positive"] = node.positive;
        if (node.negative >= 0)
            one["negative"] = node.negative;
        if (isLeaf && kind == BspKind::Physics)
            one["solid"] = node.solid;
        const bool hasSphere =
            kind == BspKind::Physics ? node.tag != BspTag::Port : kind == BspKind::Drawing && !isLeaf;
        if (hasSphere)
            one["sphere"] = json(node.sphere);
        if (!node.polygonIds.empty())
            one["polygons"] = listOf(node.polygonIds, [](auto id) { return Json(id); });
        if (!node.portals.empty())
            one["portals"] = listOf(node.portals, [](const PortalRef& ref) {
                return Json{{"polygon", ref.polygonId}, {"portal", ref.portalIndex}};
            });
        out.push_back(std::move(one));
    }
    return out;
}

Json cellStruct(std::uint32_t key, const CellStruct& cell) {
    Json out = {{"key", key},
                {"vertices", vertices(cell.vertexArray)},
                {"polygons", polygons(cell.polygons)},
                {"portal_polygons", listOf(cell.portalPolygons, [](auto id) { return Json(id); })},
                {"cell_bsp", bsp(cell.cellBsp, BspKind::Cell)},
                {"physics_polygons", polygons(cell.physicsPolygons)},
                {"physics_bsp", bsp(cell.physicsBsp, BspKind::Physics)}};
    if (cell.drawingBsp)
        out["drawing_bsp"] = bsp(*cell.drawingBsp, BspKind::Drawing);
    return out;
}

Json location(const Location& l) {
    return {{"location", l.key}, {"part", l.part}, {"frame", json(l.frame)}};
}

Json placement(const std::pair<std::uint32_t, AnimationFrame>& keyed) {
    Json out = {{"placement", keyed.first}};
    out.update(json(keyed.second));
    return out;
}

Json light(const std::pair<std::int32_t, LightInfo>& keyed) {
    const LightInfo& l = keyed.second;
    return {{"index", keyed.first},         {"frame", json(l.frame)},
            {"colour", json(l.colour)},     {"intensity", number(l.intensity)},
            {"falloff", number(l.falloff)}, {"cone_angle", number(l.coneAngle)}};
}

} // namespace

std::string describe(const GfxObj& g) {
    Json out = {{"kind", "GfxObj"},
                {"id", hexId(g.id)},
                {"flags", g.flags},
                {"surfaces", hexIds(g.surfaces)},
                {"sort_center", json(g.sortCenter)},
                {"vertices", vertices(g.vertexArray)}};
    if (g.flags & GfxObj::kPhysics) {
        out["physics_polygons"] = polygons(g.physicsPolygons);
        out["physics_bsp"] = bsp(g.physicsBsp, BspKind::Physics);
    }
    if (g.flags & GfxObj::kDrawing) {
        out["polygons"] = polygons(g.polygons);
        out["drawing_bsp"] = bsp(g.drawingBsp, BspKind::Drawing);
    }
    if (g.flags & GfxObj::kHasDegrade)
        out["degrade"] = hexId(g.degradeId);
    return pretty(out);
}

std::string describe(const Environment& e) {
    return pretty(
        {{"kind", "Environment"}, {"id", hexId(e.id)}, {"cells", listOf(e.cells, [](const auto& keyed) {
                                                            return cellStruct(keyed.first, keyed.second);
                                                        })}});
}

std::string describe(const DegradeInfo& d) {
    return pretty(
        {{"kind", "DegradeInfo"}, {"id", hexId(d.id)}, {"levels", listOf(d.levels, [](const auto& l) {
                                                            return Json{{"gfx_obj", hexId(l.gfxObj)},
                                                                        {"mode", l.mode},
                                                                        {"min", number(l.minDistance)},
                                                                        {"ideal", number(l.idealDistance)},
                                                                        {"max", number(l.maxDistance)}};
                                                        })}});
}

std::string describe(const Setup& s) {
    Json out = {{"kind", "Setup"}, {"id", hexId(s.id)}, {"flags", s.flags}, {"parts", hexIds(s.parts)}};
    if (s.flags & Setup::kParents)
        out["parents"] = hexIds(s.parents);
    if (s.flags & Setup::kScales)
        out["scales"] = listOf(s.scales, [](const Vec3f& v) { return json(v); });
    out["holding_locations"] = listOf(s.holdingLocations, location);
    out["connection_points"] = listOf(s.connectionPoints, location);
    out["placement_frames"] = listOf(s.placementFrames, placement);
    out["cyl_spheres"] = listOf(s.cylSpheres, [](const CylSphere& c) {
        return Json{{"low", json(c.low)}, {"radius", number(c.radius)}, {"height", number(c.height)}};
    });
    out["spheres"] = listOf(s.spheres, [](const SphereF& one) { return json(one); });
    out["height"] = number(s.height);
    out["radius"] = number(s.radius);
    out["step_up"] = number(s.stepUp);
    out["step_down"] = number(s.stepDown);
    out["sorting_sphere"] = json(s.sortingSphere);
    out["selection_sphere"] = json(s.selectionSphere);
    out["lights"] = listOf(s.lights, light);
    out["animation"] = hexId(s.animation);
    out["script"] = hexId(s.script);
    out["motion_table"] = hexId(s.motionTable);
    out["sound_table"] = hexId(s.soundTable);
    out["script_table"] = hexId(s.scriptTable);
    return pretty(out);
}

} // namespace limen::dat
