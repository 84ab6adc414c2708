#include "frame/Occluders.h"

#include <algorithm>

namespace limen::frame {

namespace {

constexpr double kLeastSize = 0.02;            ///< radius by distance of an occluder
constexpr std::size_t kMostTriangles = 12000;  ///< of a frame, about
constexpr std::uint64_t kMostPixels = 1 << 22; ///< of a picture; larger ones are drawn without a frame rate

} // namespace

void Occluders::prepare(const FrameView& frame, world::SpaceIndex root, const visibility::Viewcones& cones) {
    areReady_ = false;
    if (frame.occlusion == Occlusion::Off || !frame.rules.viewcone || root != world::kOutside ||
        std::uint64_t{frame.width} * frame.height > kMostPixels)
        return;
    if (pause_ > 0 && frame.occlusion == Occlusion::IfWorthwhile) {
        --pause_;
        return;
    }
    areReady_ = true;
    eye_ = frame.view.eye;
    const world::RangeSteps steps = world::rangeStepsOf(eye_);
    seen_.clear();
    for (std::uint32_t number = 0; number < shapes_.occluders().size(); ++number) {
        const world::Instance& instance = world_.instances[shapes_.occluders()[number].instance];
        const Vec3 offset = instance.bounds.centre - eye_;
        const double distance = std::max(glm::length(offset), 1e-3), size = instance.bounds.radius / distance;
        if (size >= kLeastSize &&
            cones.classify(0, cones.sphereOf({offset, instance.bounds.radius})) !=
                visibility::Containment::Outside &&
            world::isInLevelRange(world_, instance, steps, frame.levels))
            seen_.push_back({size, number});
    }
    std::sort(seen_.begin(), seen_.end(), [](const Seen& a, const Seen& b) {
        return a.size != b.size ? a.size > b.size : a.occluder < b.occluder;
    });
    buffer_.begin(frame.view, frame.width, frame.height, frame.nearPlane);
    std::size_t triangles = 0;
    for (std::size_t i = 0; i < seen_.size() && triangles < kMostTriangles; ++i) {
        const OccluderShapes::Occluder& occluder = shapes_.occluders()[seen_[i].occluder];
        cover(occluder);
        triangles += shapes_.shape(occluder.shape).triangles.size() / 3;
    }
    buffer_.finish();
}

void Occluders::cover(const OccluderShapes::Occluder& occluder) {
    const world::Instance& instance = world_.instances[occluder.instance];
    const OccluderShapes::Shape& shape = shapes_.shape(occluder.shape);
    const Mat3 linear(instance.linear);
    const Vec3 origin = world_.blocks[instance.block].origin() + Vec3(instance.origin) - eye_;
    corners_.clear();
    for (const Vec3f& corner : shape.corners)
        corners_.push_back(origin + linear * Vec3(corner));
    buffer_.cover(corners_, shape.triangles);
}

void Occluders::finish(std::uint32_t drawn, std::uint32_t hidden) {
    // Where a seventh of the draws was hidden, nothing was gained; where a fifth was, 1 % (decision 214).
    constexpr std::uint32_t kWorthwhile = 6, kPause = 15;
    pause_ = areReady_ && hidden * kWorthwhile < drawn ? kPause : pause_;
}

} // namespace limen::frame
