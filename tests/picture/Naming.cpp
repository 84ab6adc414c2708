#include "picture/Naming.h"

#include "frame/GpuLayout.h"

#include <fmt/format.h>

namespace limen::test {

NaiveTracer::Ray rayThrough(const frame::FrameView& frame, double x, double y) {
    const double sx = ((x + frame::gpu::kPixelPlace.x + 0.5) / frame.width * 2.0 - 1.0) * frame.view.tanHalfX;
    const double sy =
        (1.0 - (y + frame::gpu::kPixelPlace.y + 0.5) / frame.height * 2.0) * frame.view.tanHalfY;
    return {frame.view.eye, frame.view.forward + frame.view.right * sx + frame.view.up * sy, frame.nearPlane};
}

std::uint32_t instanceOfId(const world::World& world, std::uint32_t id) {
    for (std::uint32_t i = 0; i < world.instances.size(); ++i) {
        const world::Instance& in = world.instances[i];
        if (id >= in.idBase && id - in.idBase < world.meshes[in.mesh].polygonCount)
            return i;
    }
    return world::kNone;
}

namespace {

const world::Instance* shownAs(const world::World& world, std::uint32_t id) {
    for (const auto* instances : {&world.instances, &world.movingParts}) {
        for (const world::Instance& in : *instances)
            if (id >= in.idBase && id - in.idBase < world.meshes[in.mesh].polygonCount)
                return &in;
    }
    return nullptr;
}

} // namespace

std::string describeId(const world::World& world, std::uint32_t id) {
    constexpr const char* kNames[] = {"shell",  "terrain", "exterior", "scenery",
                                      "static", "dynamic", "filling",  "sky"};
    const world::Instance* found = shownAs(world, id);
    if (found == nullptr)
        return id == 0 ? "void" : id == 1 ? "sky" : fmt::format("unknown id {}", id);
    const world::Instance& in = *found;
    return fmt::format("{} 0x{:08X} polygon {}", kNames[static_cast<std::size_t>(in.kind)], in.record,
                       id - in.idBase);
}

} // namespace limen::test
