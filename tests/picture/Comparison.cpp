#include "picture/Comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

namespace limen::test {

namespace {

/// Traces pixels of one view, each at most once.
class TracedView {
public:
    TracedView(const NaiveTracer& tracer, const frame::FrameView& frame)
        : tracer_(tracer), frame_(frame), answers_((frame.width + 2) * (frame.height + 2)) {}

    const NaiveTracer::Answer& at(int x, int y) {
        auto& answer =
            answers_[static_cast<std::size_t>(y + 1) * (frame_.width + 2) + static_cast<std::size_t>(x + 1)];
        if (!answer) {
            answer = tracer_.trace(frame_.view.root, rayThrough(frame_, x, y));
        }
        return *answer;
    }

    template <class Test>
    bool anyAround(int x, int y, Test test) {
        for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx) {
                if (test(at(x + dx, y + dy))) {
                    return true;
                }
            }
        }
        return false;
    }

    /// True if a ray between those of the 3×3 pixels meets `id`: first on a fine grid around the middle, finer than the
    /// rasteriser's own 1/256 of a pixel, then over the whole.
    bool explainedByFinerRays(int x, int y, std::uint32_t id) const {
        return onGrid(x, y, id, 1.0 / 2048.0, 16) || onGrid(x, y, id, 1.0 / 64.0, 8) ||
               onGrid(x, y, id, 1.0 / 16.0, 24);
    }

    /// True if the rasteriser's own rounding explains `id`: it snaps corners to 1/256 of a pixel, so a polygon whose
    /// edge passes within that of the pixel's centre may cover it; and it takes the depth there from the triangle's
    /// plane, which for a polygon seen edge-on may lie far before the polygon and before what hides it.
    bool explainedBySnapping(const world::World& world, int x, int y, std::uint32_t id) {
        const std::uint32_t instance = instanceOfId(world, id);
        bool covered = false;
        double nearest = std::numeric_limits<double>::infinity();
        for (int dy = -16; dy <= 16; ++dy) {
            for (int dx = -16; dx <= 16; ++dx) {
                const auto alone =
                    tracer_.traceAlone(instance, id, rayThrough(frame_, x + dx / 2048.0, y + dy / 2048.0));
                covered = covered || alone.met;
                nearest = std::min(nearest, alone.planeT);
            }
        }
        const double shown = at(x, y).t;
        return covered && (nearest <= shown || !std::isfinite(shown));
    }

private:
    bool onGrid(int x, int y, std::uint32_t id, double step, int reach) const {
        for (int dy = -reach; dy <= reach; ++dy) {
            for (int dx = -reach; dx <= reach; ++dx) {
                if (tracer_.trace(frame_.view.root, rayThrough(frame_, x + dx * step, y + dy * step)).id ==
                    id) {
                    return true;
                }
            }
        }
        return false;
    }

    const NaiveTracer& tracer_;
    const frame::FrameView& frame_;
    std::vector<std::optional<NaiveTracer::Answer>> answers_;
};

bool belongsOutside(const world::World& world, std::uint32_t id) {
    const std::uint32_t instance = instanceOfId(world, id);
    return id == 1 || (instance != world::kNone && world.instances[instance].placedIn == world::kOutside &&
                       world.instances[instance].memberCount == 1);
}

} // namespace

NaiveTracer::Ray rayThrough(const frame::FrameView& frame, double x, double y) {
    const double sx = ((x + 0.5) / frame.width * 2.0 - 1.0) * frame.view.tanHalfX;
    const double sy = (1.0 - (y + 0.5) / frame.height * 2.0) * frame.view.tanHalfY;
    return {frame.view.eye, frame.view.forward + frame.view.right * sx + frame.view.up * sy, frame.nearPlane};
}

std::uint32_t instanceOfId(const world::World& world, std::uint32_t id) {
    for (std::uint32_t i = 0; i < world.instances.size(); ++i) {
        const world::Instance& in = world.instances[i];
        if (id >= in.idBase && id - in.idBase < world.meshes[in.mesh].polygonCount) {
            return i;
        }
    }
    return world::kNone;
}

std::string describeId(const world::World& world, std::uint32_t id) {
    constexpr const char* kNames[] = {"shell",  "terrain", "exterior", "scenery",
                                      "static", "dynamic", "filling",  "sky"};
    const std::uint32_t index = instanceOfId(world, id);
    if (index == world::kNone) {
        return id == 0 ? "void" : id == 1 ? "sky" : fmt::format("unknown id {}", id);
    }
    const world::Instance& in = world.instances[index];
    return fmt::format("{} 0x{:08X} polygon {}", kNames[static_cast<std::size_t>(in.kind)], in.record,
                       id - in.idBase);
}

Comparison compare(const world::World& world, const NaiveTracer& tracer, const frame::FrameView& frame,
                   const std::vector<std::uint32_t>& ids) {
    Comparison result;
    TracedView traced(tracer, frame);
    for (int y = 0; y < static_cast<int>(frame.height); ++y) {
        for (int x = 0; x < static_cast<int>(frame.width); ++x) {
            const std::uint32_t id =
                ids[static_cast<std::size_t>(y) * frame.width + static_cast<std::size_t>(x)];
            ++result.pixels;
            result.voids += id == 0 ? 1 : 0;
            if (traced.at(x, y).id == id) {
                continue;
            }
            if (belongsOutside(world, id) &&
                !traced.anyAround(x, y, [](const auto& a) { return a.reachedOutside; })) {
                ++result.outsideWithoutRay;
            }
            if (!traced.anyAround(x, y, [&](const auto& a) { return a.id == id; })) {
                if (traced.explainedByFinerRays(x, y, id) ||
                    (id > 1 && traced.explainedBySnapping(world, x, y, id))) {
                    ++result.slivers;
                } else if (result.disagreeing++ == 0) {
                    result.first = fmt::format("pixel ({}, {}): drawn {}, traced {}", x, y,
                                               describeId(world, id), describeId(world, traced.at(x, y).id));
                }
            }
        }
    }
    return result;
}

} // namespace limen::test
