#include "check/PolygonTable.h"

#include "world/PolygonDistance.h"

#include <algorithm>

namespace limen::check {

namespace {

/// Metres per metre of distance: more than a pixel of any usual picture.
constexpr double kPixelShare = 0.02;

} // namespace

PolygonTable::PolygonTable(const world::World& world, const world::DynamicState& dynamics)
    : world_(world), dynamics_(dynamics) {
    const auto add = [&](const world::Instance& instance) {
        if (instance.mesh != world::kNone && world.meshes[instance.mesh].polygonCount > 0)
            byId_.push_back(&instance);
    };
    std::for_each(world.instances.begin(), world.instances.end(), add);
    std::sort(byId_.begin(), byId_.end(), [](const auto* a, const auto* b) { return a->idBase < b->idBase; });
}

template <class Visit>
void PolygonTable::forTriangles(const world::Instance& instance, bool blended, Visit visit) const {
    if (instance.mesh == world::kNone)
        return;
    const world::Mesh& mesh = world_.meshes[instance.mesh];
    const Vec3 block = instance.block == world::kNone ? Vec3(0.0) : world_.blocks[instance.block].origin();
    const Vec3 origin = block + Vec3(instance.origin);
    const Mat3 linear(instance.linear);
    for (std::size_t s = 0; s < mesh.ranges.size(); ++s) {
        if (!blended && static_cast<world::SurfaceClass>(s) == world::SurfaceClass::Blended)
            continue;
        const world::Mesh::Range& range = mesh.ranges[s];
        for (std::uint32_t i = range.firstIndex; i + 2 < range.firstIndex + range.indexCount; i += 3) {
            const auto vertex = [&](std::uint32_t k) -> const world::MeshVertex& {
                return world_.vertices[mesh.firstVertex + world_.indices[i + k]];
            };
            const auto place = [&](std::uint32_t k) { return origin + linear * vertex(k).corner(); };
            visit(vertex(0).polygon, Triangle{{place(0), place(1), place(2)}});
        }
    }
}

const world::Instance* PolygonTable::instanceOf(std::uint32_t id) const {
    for (const world::Instance& moving : dynamics_.instances)
        if (id >= moving.idBase && id - moving.idBase < world_.meshes[moving.mesh].polygonCount)
            return &moving;
    const auto after =
        std::upper_bound(byId_.begin(), byId_.end(), id,
                         [](std::uint32_t wanted, const auto* i) { return wanted < i->idBase; });
    return after == byId_.begin() ? nullptr : *(after - 1);
}

void PolygonTable::trianglesOf(std::uint32_t id, std::vector<Triangle>& out) const {
    out.clear();
    const world::Instance* found = instanceOf(id);
    if (id < 2 || found == nullptr)
        return;
    const world::Instance& instance = *found;
    forTriangles(instance, true, [&](std::uint32_t polygon, const Triangle& triangle) {
        if (instance.idBase + polygon == id)
            out.push_back(triangle);
    });
}

void PolygonTable::addTrianglesAround(const world::Instance& instance, const Vec3& point, double reach,
                                      std::vector<Triangle>& out) const {
    if (glm::length(point - instance.bounds.centre) > instance.bounds.radius + reach)
        return;
    forTriangles(instance, false, [&](std::uint32_t, const Triangle& triangle) {
        if (world::distanceToPolygon(triangle.corners, planeOf(triangle.corners), point) <= reach)
            out.push_back(triangle);
    });
}

void PolygonTable::trianglesAround(world::SpaceIndex index, const Vec3& point, double reach,
                                   std::vector<Triangle>& out) const {
    out.clear();
    const world::Space& space = world_.spaces[index];
    for (std::uint32_t i = space.firstInstance; i < space.firstInstance + space.instanceCount; ++i)
        addTrianglesAround(world_.instances[world_.spaceInstances[i]], point, reach, out);
    for (const world::InstanceIndex i : dynamics_.instancesIn(index))
        addTrianglesAround(dynamics_.instances[i], point, reach, out);
}

void PolygonTable::wallsAround(world::SpaceIndex space, const Vec3& point, double reach,
                               std::vector<Triangle>& out) const {
    out.clear();
    if (const world::InstanceIndex shell = world_.spaces[space].shell; shell != world::kNone)
        addTrianglesAround(world_.instances[shell], point, reach, out);
}

void PolygonTable::polygonsAlong(const Vec3& eye, const Vec3& direction,
                                 std::vector<std::uint32_t>& out) const {
    out.clear();
    const Vec3 way = glm::normalize(direction);
    const auto add = [&](const world::Instance& instance) {
        const Vec3 offset = instance.bounds.centre - eye;
        const double along = glm::dot(offset, way), radius = instance.bounds.radius;
        const double margin = radius + kPixelShare * (std::abs(along) + radius);
        if (along < -margin || glm::length(offset - way * along) > margin)
            return;
        for (std::uint32_t p = 0; p < world_.meshes[instance.mesh].polygonCount; ++p)
            out.push_back(instance.idBase + p);
    };
    std::for_each(byId_.begin(), byId_.end(), [&](const world::Instance* instance) { add(*instance); });
    for (const world::Instance& moving : dynamics_.instances)
        if (moving.mesh != world::kNone)
            add(moving);
}

} // namespace limen::check
