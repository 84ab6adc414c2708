#include "worlds/Standing.h"

#include <fmt/format.h>

namespace limen::worlds::test {
namespace {

class Collector {
public:
    void mesh(SurfaceKind kind, const std::string& name, const dat::VertexArray& vertices,
              const dat::PolygonList& polygons, const std::vector<dat::Frame>& frames) {
        for (const auto& [id, polygon] : polygons) {
            Standing s;
            s.kind = (polygon.stippling & dat::kNoPositiveUv) != 0 ? SurfaceKind::Portal : kind;
            s.name = fmt::format("{} polygon {}", name, id);
            s.points = pointsOf(vertices, polygon, {});
            for (const dat::Frame& frame : frames)
                for (Vec3& p : s.points)
                    p = apply(frame, p);
            for (Vec3& p : s.points)
                p += origin_;
            s.plane = planeOf(s.points);
            for (const Vec3& p : s.points)
                s.box.include(p);
            s.twoSided = polygon.sides == static_cast<std::int32_t>(dat::Sides::Double);
            out.push_back(std::move(s));
        }
    }
    void gfxObj(SurfaceKind kind, const std::string& where, dat::RecordId id,
                const std::vector<dat::Frame>& frames) {
        for (const dat::GfxObj& g : world().gfxObjs)
            if (g.id == id)
                mesh(kind, fmt::format("{} 0x{:08X}", where, id), g.vertexArray, g.polygons, frames);
    }
    void object(const std::string& where, dat::RecordId id, const dat::Frame& at) {
        if (id >> 24 == 0x01)
            gfxObj(SurfaceKind::Object, where, id, {at});
        for (const dat::Setup& setup : world().setups) {
            for (std::size_t k = 0; setup.id == id && k < setup.parts.size(); ++k) {
                gfxObj(SurfaceKind::Object, fmt::format("{} 0x{:08X}", where, id), setup.parts[k],
                       {setup.placementFrames.front().second.parts.at(k), at});
            }
        }
    }

    /// Sets the landblock of frames.
    void enter(std::uint32_t id) { origin_ = Vec3((id >> 24) * 192.0, (id >> 16 & 0xFF) * 192.0, 0.0); }

    std::vector<Standing> out;

private:
    Vec3 origin_{0.0};
};

} // namespace

std::vector<Standing> standingPolygons() {
    Collector collect;
    for (const dat::EnvCell& cell : world().envCells) {
        const std::string where = fmt::format("cell 0x{:08X}", cell.id);
        const dat::CellStruct& shape = shapeOf(cell);
        collect.enter(cell.id);
        collect.mesh(SurfaceKind::Shell, where, shape.vertexArray, shape.polygons, {cell.position});
        for (std::size_t k = 0; k < cell.statics.size(); ++k) {
            collect.object(fmt::format("{} static {}", where, k), cell.statics[k].model,
                           cell.statics[k].frame);
        }
    }
    for (const dat::LandBlockInfo& info : world().landBlockInfos) {
        collect.enter(info.id);
        for (std::size_t k = 0; k < info.buildings.size(); ++k) {
            collect.gfxObj(SurfaceKind::Exterior, fmt::format("building {}", k), info.buildings[k].model,
                           {info.buildings[k].frame});
        }
        for (std::size_t k = 0; k < info.objects.size(); ++k)
            collect.object(fmt::format("object {}", k), info.objects[k].model, info.objects[k].frame);
    }
    return std::move(collect.out);
}

Overlap overlapOf(const Standing& a, const Standing& b) {
    std::vector<Vec3> rest = b.points;
    std::vector<Vec3> clipped;
    for (std::size_t i = 0; i < a.points.size(); ++i) {
        const Vec3 along = a.points[(i + 1) % a.points.size()] - a.points[i];
        if (glm::length(along) < 1e-9)
            continue;
        const Vec3 inwards = glm::normalize(glm::cross(a.plane.n, along));
        clipPolygon(rest, {inwards, -glm::dot(inwards, a.points[i])}, 0.0, clipped);
        rest.swap(clipped);
    }
    Overlap out;
    if (rest.size() >= 3) {
        out.area = 0.5 * std::abs(glm::dot(newellNormal(rest), a.plane.n));
        for (const Vec3& p : rest)
            out.apart = std::max(out.apart, std::abs(a.plane.signedDistance(p)));
    }
    return out;
}

} // namespace limen::worlds::test
