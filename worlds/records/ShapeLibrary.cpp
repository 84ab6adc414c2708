#include "worlds/records/ShapeLibrary.h"

#include "worlds/records/Bsp.h"
#include "worlds/records/EncodedMesh.h"

namespace limen::worlds {

namespace {

constexpr dat::RecordId kFirstEnvironment = 0x0D000100u;

void windPortals(std::vector<Face>& faces, const std::vector<bool>& outward) {
    std::size_t k = 0;
    for (Face& face : faces) {
        if (face.portal) {
            if (k < outward.size() && outward[k])
                face = flipped(std::move(face));
            ++k;
        }
    }
}

} // namespace

StoredShape ShapeLibrary::add(std::vector<Face> faces, dat::BspTree cellTree,
                              const std::vector<bool>& outwardPortals) {
    windPortals(faces, outwardPortals);
    EncodedMesh mesh = encodeMesh(faces);
    dat::CellStruct shape;
    shape.cellBsp = std::move(cellTree);
    for (std::size_t i = 0; i < faces.size(); ++i)
        if (faces[i].portal)
            shape.portalPolygons.push_back(static_cast<std::uint16_t>(i)); // polygon ids are face indices
    PhysicsMesh physics = physicsOf(faces, mesh.polygons);
    shape.physicsPolygons = std::move(physics.polygons);
    shape.physicsBsp = std::move(physics.tree);
    shape.drawingBsp = buildDrawingBsp(faces);
    shape.vertexArray = std::move(mesh.vertexArray);
    shape.polygons = std::move(mesh.polygons);
    dat::Environment& record = environment();
    StoredShape stored;
    stored.environment = static_cast<std::uint16_t>(record.id & 0xFFFF);
    stored.structure = static_cast<std::uint16_t>(record.cells.size());
    stored.portalPolygons.assign(shape.portalPolygons.begin(), shape.portalPolygons.end());
    for (const dat::RecordId surface : mesh.surfaces)
        stored.surfaces.push_back(static_cast<std::uint16_t>(surface & 0xFFFF));
    record.cells.emplace_back(stored.structure, std::move(shape));
    return stored;
}

dat::Environment& ShapeLibrary::environment() {
    std::vector<dat::Environment>& all = records_.environments;
    if (starts_ || all.empty() || all.back().cells.size() >= perEnvironment_) {
        dat::Environment next;
        next.id = kFirstEnvironment + static_cast<dat::RecordId>(all.size());
        all.push_back(std::move(next));
        starts_ = false;
    }
    return all.back();
}

} // namespace limen::worlds
