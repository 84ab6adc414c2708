#include "worlds/records/EncodedMesh.h"

#include "core/Assert.h"
#include "worlds/records/Bsp.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace limen::worlds {

namespace {

bool canWalkThrough(const Face& face) {
    switch (face.material) {
    case Material::Leaves:
    case Material::BirchLeaves:
    case Material::PineBranch:
    case Material::GrassTuft:
    case Material::Flowers:
    case Material::FarPlants:
    case Material::Flame:
    case Material::LampGlass:
    case Material::Glass:
        return true;
    default:
        return face.portal;
    }
}

/// Assigns vertex keys: one vertex for each position and normal, with all UVs that its polygons use.
class VertexTable {
public:
    std::pair<std::uint16_t, std::uint8_t> find(const Vec3& point, const Vec3& normal, const Vec2* uv) {
        const Vec3f p(point);
        const Vec3f n(normal);
        const auto [slot, isNew] = slots_.try_emplace({p.x, p.y, p.z, n.x, n.y, n.z}, array_.vertices.size());
        if (isNew) {
            LIMEN_ASSERT(array_.vertices.size() < 32768, "too many vertices for one mesh");
            dat::Vertex vertex;
            vertex.position = p;
            vertex.normal = n;
            array_.vertices.emplace_back(static_cast<std::uint16_t>(slot->second), std::move(vertex));
        }
        return {static_cast<std::uint16_t>(slot->second),
                uv != nullptr ? uvIndex(slot->second, Vec2f(*uv)) : std::uint8_t{0}};
    }
    dat::VertexArray take() { return std::move(array_); }

private:
    std::uint8_t uvIndex(std::size_t slot, const Vec2f& uv) {
        auto& uvs = array_.vertices[slot].second.uvs;
        for (std::size_t k = 0; k < uvs.size(); ++k)
            if (uvs[k] == uv)
                return static_cast<std::uint8_t>(k);
        LIMEN_ASSERT(uvs.size() < 255, "too many UVs for one vertex");
        uvs.push_back(uv);
        return static_cast<std::uint8_t>(uvs.size() - 1);
    }

    std::map<std::tuple<float, float, float, float, float, float>, std::size_t> slots_;
    dat::VertexArray array_;
};

/// A picture repeats unless each of its faces shows a part of it.
bool repeats(const Face& face) {
    constexpr double kSlack = 0.001;
    return !isCard(face.material) || std::any_of(face.uvs.begin(), face.uvs.end(), [](const Vec2& uv) {
        return std::min(uv.x, uv.y) < -kSlack || std::max(uv.x, uv.y) > 1.0 + kSlack;
    });
}

std::int16_t surfaceIndex(std::vector<dat::RecordId>& surfaces, Material material) {
    const dat::RecordId id = surfaceId(material);
    const auto found = std::find(surfaces.begin(), surfaces.end(), id);
    if (found == surfaces.end()) {
        surfaces.push_back(id);
        return static_cast<std::int16_t>(surfaces.size() - 1);
    }
    return static_cast<std::int16_t>(found - surfaces.begin());
}

} // namespace

EncodedMesh encodeMesh(const std::vector<Face>& faces) {
    LIMEN_ASSERT(faces.size() < 32768, "too many faces for one mesh");
    EncodedMesh mesh;
    VertexTable table;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const Face& face = faces[i];
        LIMEN_ASSERT(face.points.size() >= 3 && face.points.size() < 256, "a polygon has 3 to 255 corners");
        dat::Polygon polygon;
        polygon.sides = static_cast<std::int32_t>(face.twoSided ? dat::Sides::Double : dat::Sides::Single);
        const bool bare = face.portal && !face.pictured;
        polygon.stippling = bare            ? dat::kNoPositiveUv
                            : repeats(face) ? dat::kRepeatPositive
                                            : std::uint8_t{0};
        polygon.posSurface = bare ? std::int16_t{-1} : surfaceIndex(mesh.surfaces, face.material);
        const Vec3 flat = faceNormal(face);
        for (std::size_t k = 0; k < face.points.size(); ++k) {
            const Vec3 normal = face.normals.empty() ? flat : face.normals[k];
            const auto [key, uv] = table.find(face.points[k], normal, bare ? nullptr : &face.uvs[k]);
            polygon.vertexKeys.push_back(key);
            if (!bare)
                polygon.posUv.push_back(uv);
        }
        mesh.polygons.emplace_back(static_cast<std::uint16_t>(i), std::move(polygon));
    }
    mesh.vertexArray = table.take();
    return mesh;
}

PhysicsMesh physicsOf(const std::vector<Face>& faces, const dat::PolygonList& polygons) {
    PhysicsMesh out;
    std::vector<Face> solid;
    std::vector<std::uint16_t> ids;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        if (!canWalkThrough(faces[i])) {
            solid.push_back(faces[i]);
            ids.push_back(polygons[i].first);
            out.polygons.push_back(polygons[i]);
        }
    }
    out.tree = buildPhysicsBsp(solid, ids);
    return out;
}

} // namespace limen::worlds
