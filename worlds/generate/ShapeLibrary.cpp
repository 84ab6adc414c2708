#include "worlds/generate/ShapeLibrary.h"

#include "worlds/Bsp.h"
#include "worlds/Models.h"

namespace limen::worlds {

namespace {

constexpr std::size_t kShapesPerEnvironment = 64;
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

StoredShape ShapeLibrary::add(std::vector<Face> faces, const Vec3& middle,
                              const std::vector<bool>& outwardPortals) {
    closeSeams(faces, finestGrid(faces));
    dat::CellStruct shape;
    shape.cellBsp = buildSolidCellBsp(faces, middle);
    windPortals(faces, outwardPortals);
    EncodedMesh mesh = encodeMesh(faces);
    for (std::size_t i = 0; i < faces.size(); ++i)
        if (faces[i].portal)
            shape.portalPolygons.push_back(static_cast<std::uint16_t>(i));
    PhysicsMesh physics = physicsOf(faces, mesh.polygons);
    shape.physicsPolygons = std::move(physics.polygons);
    shape.physicsBsp = std::move(physics.tree);
    shape.drawingBsp = buildDrawingBsp(faces);
    shape.vertexArray = std::move(mesh.vertexArray);
    shape.polygons = std::move(mesh.polygons);
    if (records_.environments.empty() || records_.environments.back().cells.size() >= kShapesPerEnvironment) {
        dat::Environment environment;
        environment.id = kFirstEnvironment + static_cast<dat::RecordId>(records_.environments.size());
        records_.environments.push_back(std::move(environment));
    }
    dat::Environment& environment = records_.environments.back();
    StoredShape stored;
    stored.environment = static_cast<std::uint16_t>(environment.id & 0xFFFF);
    stored.structure = static_cast<std::uint16_t>(environment.cells.size());
    stored.portalPolygons.assign(shape.portalPolygons.begin(), shape.portalPolygons.end());
    for (const dat::RecordId surface : mesh.surfaces)
        stored.surfaces.push_back(static_cast<std::uint16_t>(surface & 0xFFFF));
    environment.cells.emplace_back(stored.structure, std::move(shape));
    return stored;
}

} // namespace limen::worlds
