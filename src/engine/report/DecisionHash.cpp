#include "engine/report/DecisionHash.h"

#include "core/Hash.h"

namespace limen::engine {
namespace {

void add(Hash& hash, const Vec3& v) {
    hash.add(v.x);
    hash.add(v.y);
    hash.add(v.z);
}

} // namespace

std::uint64_t decisionHash(const FrameRequest& request, const visibility::VisibleSet& visible,
                           const world::DynamicState& dynamics) {
    Hash hash;
    add(hash, request.camera.eye);
    for (const double value : {request.camera.heading.yaw, request.camera.heading.pitch, request.scene.time,
                               request.scene.seconds})
        hash.add(value);
    hash.add(request.root);
    hash.add(request.scene.dayGroup);
    hash.add(request.scene.weather);
    hash.add(request.scene.look);
    for (const visibility::Visit& visit : visible.visits)
        for (const std::uint32_t value : {visit.space, visit.parent, visit.portal, visit.vertexCount})
            hash.add(value);
    for (const world::Instance& instance : dynamics.instances) {
        for (const std::uint32_t value : {instance.mesh, instance.block, std::uint32_t{instance.memberCount}})
            hash.add(value);
        hash.addWords(std::as_bytes(std::span(&instance.linear, 1)));
        hash.addWords(std::as_bytes(std::span(&instance.origin, 1)));
        hash.add(instance.opacity);
    }
    hash.addWords(std::as_bytes(std::span(dynamics.closed)));
    return hash.value();
}

} // namespace limen::engine
