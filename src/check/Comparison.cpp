#include "check/Comparison.h"

#include "check/FinerRays.h"

#include "core/Assert.h"
#include "core/Hash.h"
#include "geometry/Tolerances.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <span>

namespace limen::check {

namespace {

using reference::Answer;

/// Compares one picture, pixel by pixel.
class Judge {
public:
    Judge(const DrawnImages& drawn, const reference::Picture& traced, Retracer& retracer,
          std::size_t mostSecondLooks)
        : drawn_(drawn), traced_(traced), retracer_(retracer),
          mostSecondLooks_(mostSecondLooks), exact_{retracer}, byZone_{retracer} {}

    Verdict verdictAt(int x, int y) {
        const std::size_t i = indexOf(x, y);
        const std::uint32_t id = drawn_.ids[i];
        const Answer& own = traced_.at(x, y);
        if (own.id != id && !anyAround(x, y, [&](const Answer& a) { return a.id == id; }))
            return secondLook(x, y, id);
        if (id == 0)
            return excused(x, y) ? Verdict::Unjudged : Verdict::Hole;
        if (own.id == id && !hasRightDepth(x, y))
            return excused(x, y) ? Verdict::Unjudged : Verdict::Depth;
        return layersVerdict(x, y);
    }

private:
    struct Exact {
        Retracer& retracer;
        Answer operator()(double x, double y) const { return retracer.exact(x, y); }
    };
    struct ByZone {
        Retracer& retracer;
        Answer operator()(double x, double y) const { return retracer.byZone(x, y); }
    };

    [[nodiscard]] std::size_t indexOf(int x, int y) const {
        return static_cast<std::size_t>(y) * drawn_.width + static_cast<std::size_t>(x);
    }

    template <class Test>
    [[nodiscard]] bool anyAround(int x, int y, Test test) const {
        for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx)
                if (test(traced_.at(x + dx, y + dy)))
                    return true;
        }
        return false;
    }

    /// The verdict on a pixel whose id is none of the nine traced ones.
    Verdict secondLook(int x, int y, std::uint32_t id) {
        const Verdict worst = id == 0 ? Verdict::Void : Verdict::Disagrees;
        if (excused(x, y))
            return Verdict::Unjudged;
        if (inVain_ >= mostSecondLooks_)
            return worst;
        const auto showsIt = [&](const Answer& a) { return a.id == id; };
        if (anyFiner(x, y, 1.0, 1, byZone_, showsIt))
            return Verdict::ByZone;
        if (onFinerRays(x, y, exact_, showsIt))
            return id == 0 ? Verdict::Hole : Verdict::Sliver;
        if (onFinerRays(x, y, byZone_, showsIt))
            return Verdict::ByZone;
        ++inVain_;
        if (id > 1 && retracer_.isEdgeOn(x, y, id, traced_.at(x, y).t))
            return Verdict::EdgeOn;
        return worst;
    }

    /// True if the rule does not judge this pixel, because of one of the rays of the 3×3 pixels.
    [[nodiscard]] bool excused(int x, int y) {
        for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx)
                if (isRayExcused(x + dx, y + dy))
                    return true;
        }
        return false;
    }

    [[nodiscard]] bool isRayExcused(int x, int y) {
        if (excused_.empty())
            excused_.resize(traced_.answers.size());
        std::optional<bool>& known =
            excused_[static_cast<std::size_t>(y + 1) * (drawn_.width + 2) + static_cast<std::size_t>(x + 1)];
        if (!known)
            known = !retracer_.leadsIntoTheRoot(x, y);
        return *known;
    }

    [[nodiscard]] bool hasRightDepth(int x, int y) {
        if (drawn_.depth.empty())
            return true;
        const double stored = drawn_.depth[indexOf(x, y)];
        const double drawn =
            stored == 0.0 ? std::numeric_limits<double>::infinity() : drawn_.depthUnit / stored;
        const Answer& own = traced_.at(x, y);
        if (!std::isfinite(own.t) || !std::isfinite(drawn))
            return std::isinf(own.t) && std::isinf(drawn) && drawn > 0.0;
        if (std::abs(drawn - own.t) <= kDepthShareTolerance * own.t)
            return true;
        return retracer_.mayHaveDepth(x, y, own.id, drawn);
    }

    [[nodiscard]] Verdict layersVerdict(int x, int y) {
        if (drawn_.layers.empty())
            return Verdict::Agrees;
        const reference::Layers& layers = drawn_.layers[indexOf(x, y)];
        const std::uint32_t id = drawn_.ids[indexOf(x, y)];
        const auto same = [&](const Answer& a) { return a.id == id && a.layers == layers; };
        if (anyAround(x, y, same))
            return Verdict::Agrees;
        if (excused(x, y))
            return Verdict::Unjudged;
        if (inVain_ >= mostSecondLooks_)
            return Verdict::Layers;
        if (onFinerRays(x, y, exact_, same))
            return Verdict::Sliver;
        if (onFinerRays(x, y, byZone_, same))
            return Verdict::ByZone;
        ++inVain_;
        return Verdict::Layers;
    }

    const DrawnImages& drawn_;
    const reference::Picture& traced_;
    Retracer& retracer_;
    std::size_t mostSecondLooks_;
    Exact exact_;
    ByZone byZone_;
    std::size_t inVain_ = 0;                   ///< unsuccessful second looks
    std::vector<std::optional<bool>> excused_; ///< by pixel with border, filled on demand
};

} // namespace

std::uint64_t Comparison::findings() const {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < kVerdictCount; ++i)
        sum += isFinding(static_cast<Verdict>(i)) ? counts[i] : 0;
    return sum;
}

void compare(const DrawnImages& drawn, const reference::Picture& traced, Retracer& retracer,
             Comparison& result, std::size_t mostSecondLooks) {
    const std::size_t pixels = static_cast<std::size_t>(drawn.width) * drawn.height;
    LIMEN_ASSERT(traced.width == drawn.width && traced.height == drawn.height, "the pictures have one size");
    LIMEN_ASSERT(drawn.ids.size() == pixels, "an id for every pixel");
    LIMEN_ASSERT(drawn.depth.empty() || drawn.depth.size() == pixels, "a depth for every pixel");
    LIMEN_ASSERT(drawn.layers.empty() || drawn.layers.size() == pixels, "layers for every pixel");
    result.counts = {};
    result.verdicts.resize(pixels);
    Judge judge(drawn, traced, retracer, mostSecondLooks);
    std::size_t i = 0;
    for (int y = 0; y < static_cast<int>(drawn.height); ++y) {
        for (int x = 0; x < static_cast<int>(drawn.width); ++x, ++i) {
            const Verdict verdict = judge.verdictAt(x, y);
            result.verdicts[i] = verdict;
            ++result.counts[static_cast<std::size_t>(verdict)];
        }
    }
}

std::uint64_t hashOf(const DrawnImages& images) {
    Hash hash;
    const auto add = [&](const auto& image) { hash.addWords(std::as_bytes(std::span(image))); };
    add(images.ids);
    add(images.depth);
    add(images.layers);
    add(images.colour);
    return hash.value();
}

std::size_t pixelsThatMoved(const DrawnImages& first, const DrawnImages& second) {
    LIMEN_ASSERT(first.ids.size() == second.ids.size() && first.depth.size() == second.depth.size() &&
                     first.colour.size() == second.colour.size(),
                 "the pictures have one size");
    const auto same = [&](std::size_t i) {
        if (!first.ids.empty() && first.ids[i] != second.ids[i])
            return false;
        if (!first.depth.empty() &&
            std::bit_cast<std::uint32_t>(first.depth[i]) != std::bit_cast<std::uint32_t>(second.depth[i]))
            return false;
        return first.colour.empty() ||
               std::memcmp(first.colour.data() + 4 * i, second.colour.data() + 4 * i, 4) == 0;
    };
    std::size_t moved = 0;
    for (std::size_t i = 0; i < std::max(first.ids.size(), first.colour.size() / 4); ++i)
        moved += same(i) ? 0 : 1;
    return moved;
}

} // namespace limen::check
