#include "reference/Bodies.h"

#include "core/Assert.h"

namespace limen::reference {
namespace {

/// Metres. The corners of box and triangles are the same sums in another order, in double.
constexpr double kBoxMargin = 1e-6;

bool has(const world::Mesh& mesh, world::SurfaceClass surfaces) {
    return mesh.ranges[static_cast<std::size_t>(surfaces)].indexCount > 0;
}

} // namespace

Bodies::Bodies(const world::World& world, const Vec3& origin)
    : world_(world), origin_(origin), groupings_(world.meshes.size()) {}

void Bodies::assign(std::span<const world::Instance> instances) {
    instances_ = instances;
    if (instances.size() > capacity_) {
        capacity_ = instances.size() + instances.size() / 2;
        slots_ = std::make_unique<Slot[]>(capacity_);
    }
    for (std::size_t i = 0; i < instances.size(); ++i)
        slots_[i].isPlaced.store(false, std::memory_order_relaxed);
}

const world::Mesh* Bodies::meshOf(std::uint32_t body) const {
    LIMEN_ASSERT(body < instances_.size(), "a body is one of those assigned");
    const std::uint32_t mesh = instances_[body].mesh;
    return mesh < world_.meshes.size() ? &world_.meshes[mesh] : nullptr;
}

bool Bodies::hasSolid(std::uint32_t body) const {
    const world::Mesh* mesh = meshOf(body);
    return mesh && (has(*mesh, world::SurfaceClass::Opaque) || has(*mesh, world::SurfaceClass::CutOut));
}

bool Bodies::hasBlended(std::uint32_t body) const {
    const world::Mesh* mesh = meshOf(body);
    return mesh && has(*mesh, world::SurfaceClass::Blended);
}

Box Bodies::boxOf(std::uint32_t body) const {
    const world::Instance& instance = instances_[body];
    const world::Mesh& mesh = world_.meshes[instance.mesh];
    const Mat3 linear(instance.linear);
    const Vec3 at = world_.blocks[instance.block].origin() + Vec3(instance.origin) - origin_;
    Extent extent;
    for (std::uint32_t v = mesh.firstVertex; v < mesh.firstVertex + mesh.vertexCount; ++v)
        extent.include(at + linear * world_.vertices[v].corner());
    Box box = extent.box();
    box.grow(kBoxMargin);
    return box;
}

void Bodies::place(std::uint32_t body, Slot& slot) const {
    const std::lock_guard guard(placing_);
    if (slot.isPlaced.load(std::memory_order_relaxed))
        return; // another thread was faster
    const world::Instance& instance = instances_[body];
    slot.surfaces.solid.clear();
    slot.surfaces.blended.clear();
    slot.surfaces.solid.add(world_, instance, world::SurfaceClass::Opaque, origin_);
    slot.surfaces.solid.add(world_, instance, world::SurfaceClass::CutOut, origin_);
    slot.surfaces.blended.add(world_, instance, world::SurfaceClass::Blended, origin_);
    slot.surfaces.solid.build(groupings_[instance.mesh].solid, scratch_);
    slot.surfaces.blended.build(groupings_[instance.mesh].blended, scratch_);
    slot.isPlaced.store(true, std::memory_order_release);
}

void BodyLists::clear() {
    for (const std::uint32_t index : used_) {
        for (List* list : {&pairs_[index].solid, &pairs_[index].blended}) {
            list->bodies.clear();
            list->tree.clear();
        }
    }
    used_.clear();
}

void BodyLists::add(const Bodies& bodies, std::uint32_t index, std::uint32_t body) {
    LIMEN_ASSERT(index < pairs_.size(), "a list is of a space or zone of the world");
    ListPair& here = pairs_[index];
    const bool solid = bodies.hasSolid(body), blended = bodies.hasBlended(body);
    if ((solid || blended) && here.solid.empty() && here.blended.empty())
        used_.push_back(index);
    if (solid)
        here.solid.bodies.push_back(body);
    if (blended)
        here.blended.bodies.push_back(body);
}

void BodyLists::build(const Bodies& bodies) {
    for (const std::uint32_t index : used_) {
        build(bodies, pairs_[index].solid);
        build(bodies, pairs_[index].blended);
    }
}

void BodyLists::build(const Bodies& bodies, List& list) {
    boxes_.clear();
    for (const std::uint32_t body : list.bodies)
        boxes_.push_back(bodies.boxOf(body));
    list.tree.build(boxes_, 1, order_); // one body a leaf: testing a body costs more than testing a node
    sorted_.clear();
    for (const std::uint32_t i : order_)
        sorted_.push_back(list.bodies[i]);
    list.bodies.assign(sorted_.begin(), sorted_.end());
}

} // namespace limen::reference
