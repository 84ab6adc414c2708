#include "world/block/BuildingReader.h"

#include "world/mesh/PolygonMesher.h"
#include "world/records/PolygonSource.h"
#include "world/records/Pose.h"

namespace limen::world {
namespace {

std::vector<Vec3> placed(const SourcePolygon& polygon, const Placement& placement) {
    std::vector<Vec3> points;
    for (const SourcePolygon::Corner& corner : polygon.corners)
        points.push_back(placement.origin + placement.linear * corner.position);
    return points;
}

BuildingDraft::PortalPolygon portalPolygon(const SourcePolygon& polygon, const Placement& placement,
                                           std::span<const SurfaceList> lists) {
    const auto isOpaque = [&](std::int32_t slot) {
        return slot >= 0 && lists[static_cast<std::size_t>(slot)] == SurfaceList::Opaque;
    };
    return {placed(polygon, placement), isOpaque(polygon.frontSlot), isOpaque(polygon.backSlot)};
}

void draftPart(const dat::GfxObj& model, const Placement& placement, Records& records,
               BakedGeometry& geometry, BuildingDraft& draft, std::vector<Finding>& findings) {
    const std::size_t portalCount = draft.portalPolygons.size();
    const std::vector<SurfaceList> lists = listsOf(model.surfaces, records);
    const std::vector<PortalPolygonRef> refs = portalRefs(model, portalCount);
    std::set<std::uint16_t> portals;
    for (const PortalPolygonRef& ref : refs)
        portals.insert(ref.polygonId);
    BuildingDraft::Part part;
    part.gfxObj = model.id;
    part.surfaces = model.surfaces;
    for (SourcePolygon& polygon : readPolygons(model.vertexArray, model.polygons,
                                               drawnSlots(model.surfaces, MeshOwner::Structure, records),
                                               portals, model.id, findings)) {
        for (const PortalPolygonRef& ref : refs)
            if (ref.polygonId == polygon.id)
                draft.portalPolygons[ref.portalIndex] = portalPolygon(polygon, placement, lists);
        if (!polygon.isDrawn())
            continue;
        const std::uint32_t handle = geometry.add(std::move(polygon), placement);
        if (handle != kNone)
            part.polygons.push_back(handle);
    }
    draft.parts.push_back(std::move(part));
}

} // namespace

BuildingDraft draftBuilding(const dat::Building& building, std::uint64_t object, Records& records,
                            Models& models, BakedGeometry& geometry, std::vector<Finding>& findings) {
    BuildingDraft draft;
    draft.object = object;
    draft.portalPolygons.resize(building.portals.size());
    const Pose pose = poseOf(building.frame);
    const Mat3 rotation = glm::mat3_cast(pose.orientation);
    for (const ModelPart& part : models.model(building.model).parts) {
        if (const dat::GfxObj* model = records.gfxObj(part.gfxObj))
            draftPart(*model, {rotation * part.linear, pose.apply(part.origin)}, records, geometry, draft,
                      findings);
    }
    return draft;
}

void finishBuilding(const BuildingDraft& draft, const BakedGeometry& geometry, Records& records,
                    BlockContent& block) {
    for (const BuildingDraft::Part& part : draft.parts) {
        PolygonMesher mesher(listsOf(part.surfaces, records));
        for (const std::uint32_t handle : part.polygons)
            mesher.add(geometry, handle);
        std::vector<bool> clamp = mesher.clamped();
        block.exteriors.push_back(
            {part.gfxObj, draft.object, mesher.finish(), part.surfaces, std::move(clamp)});
    }
}

} // namespace limen::world
