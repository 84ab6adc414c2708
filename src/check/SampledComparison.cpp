#include "check/SampledComparison.h"

#include "core/Assert.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace limen::check {

namespace {

/// Radii in pixels of the rings of rays around a sample. Edges are computed in floats from corners that are
/// rounded to about 1e-5 of a pixel, and the surface seen there may be far narrower than that.
constexpr std::array<double, 4> kRings{1e-7, 1e-6, 1e-5, 1e-4};
constexpr int kSpokes = 16;
/// Of 255: the rounding of the mean of the samples' colours.
constexpr int kRounding = 1;
/// The most ids tried for one sample; more meet only in pixels that are noise.
constexpr std::size_t kMostIds = 12;

using Ids = std::vector<std::uint32_t>;

void addOnce(Ids& ids, std::uint32_t id) {
    if (ids.size() < kMostIds && std::find(ids.begin(), ids.end(), id) == ids.end())
        ids.push_back(id);
}

/// One pixel, and the ids that each of its samples may show.
class SampledPixel {
public:
    SampledPixel(const DrawnImages& drawn, std::span<const reference::Picture> traced, IdColour colourOf,
                 Retracer& retracer, int x, int y)
        : drawn_(drawn), traced_(traced), colourOf_(colourOf), retracer_(retracer), x_(x), y_(y) {
        const std::size_t at = (static_cast<std::size_t>(y) * drawn.width + static_cast<std::size_t>(x)) * 4;
        colour_ = {drawn.colour[at], drawn.colour[at + 1], drawn.colour[at + 2]};
        for (const reference::Picture& picture : traced)
            ids_.push_back({picture.at(x, y).id});
    }

    [[nodiscard]] Verdict verdict(bool mayLookAgain) {
        if (isExplained())
            return Verdict::Agrees;
        if (isExcused())
            return Verdict::Unjudged;
        if (!mayLookAgain)
            return Verdict::Disagrees;
        lookAround([&](double x, double y) { return retracer_.exact(x, y).id; });
        if (isExplained())
            return Verdict::Sliver;
        lookAround([&](double x, double y) { return retracer_.byZone(x, y).id; });
        if (isExplained())
            return Verdict::ByZone;
        Ids near;
        retracer_.polygonsAlong(x_, y_, near);
        lookAsFarAsRounded(near);
        if (isExplained())
            return Verdict::Sliver;
        addTied(near);
        return isExplained() ? Verdict::EdgeOn : Verdict::Disagrees;
    }

private:
    [[nodiscard]] bool isExplained() const {
        Ids chosen(ids_.size(), 0);
        return anyMean(0, glm::ivec3(0), chosen);
    }

    /// Whether a choice of one id for each sample from `from` on gives the drawn colour. `chosen`: the ids of
    /// the samples before, with the colour sum `sum`.
    [[nodiscard]] bool anyMean(std::size_t from, const glm::ivec3& sum, Ids& chosen) const {
        const auto count = static_cast<int>(ids_.size());
        if (from == ids_.size()) {
            const glm::ivec3 off = glm::abs(sum - colour_ * count);
            const bool same =
                std::all_of(chosen.begin(), chosen.end(), [&](std::uint32_t id) { return id == chosen[0]; });
            return std::max({off.x, off.y, off.z}) <= (same ? 0 : kRounding * count);
        }
        return std::any_of(ids_[from].begin(), ids_[from].end(), [&](std::uint32_t id) {
            const auto [r, g, b] = colourOf_(id);
            chosen[from] = id;
            return anyMean(from + 1, sum + glm::ivec3(r, g, b), chosen);
        });
    }

    /// As for pictures of one sample: by the rays of the 3×3 pixels.
    [[nodiscard]] bool isExcused() {
        for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx)
                if (!retracer_.leadsIntoTheRoot(x_ + dx, y_ + dy))
                    return true;
        }
        return false;
    }

    template <class Trace>
    void lookAround(Trace trace) {
        for (const double ring : kRings)
            for (std::size_t s = 0; s < ids_.size(); ++s)
                lookAround(s, ring, trace);
    }

    template <class Trace>
    void lookAround(std::size_t sample, double ring, Trace trace) {
        for (int i = 0; i < kSpokes; ++i) {
            const double turn = 2.0 * std::numbers::pi * i / kSpokes;
            addOnce(ids_[sample],
                    trace(sampleX(sample) + ring * std::cos(turn), sampleY(sample) + ring * std::sin(turn)));
        }
    }

    /// Adds ids from wider rings: outlines near the eye are rounded by more than kRings.
    void lookAsFarAsRounded(const Ids& near) {
        for (std::size_t s = 0; s < ids_.size(); ++s) {
            double reach = 0.0;
            for (const std::uint32_t id : near)
                reach = std::max(reach, retracer_.outlineRounding(sampleX(s), sampleY(s), id));
            for (double ring = kRings.back(); ring < reach;) {
                ring = std::min(4.0 * ring, reach);
                lookAround(s, ring, [&](double x, double y) { return retracer_.exact(x, y).id; });
            }
        }
    }

    /// Adds polygons that no ray near a sample meets, but that may have been drawn there.
    void addTied(const Ids& candidates) {
        for (const std::uint32_t id : candidates) {
            for (std::size_t s = 0; s < ids_.size(); ++s)
                if (retracer_.isEdgeOn(sampleX(s), sampleY(s), id, traced_[s].at(x_, y_).t))
                    addOnce(ids_[s], id);
        }
    }

    [[nodiscard]] double sampleX(std::size_t s) const { return x_ + double{drawn_.samples[s].x}; }
    [[nodiscard]] double sampleY(std::size_t s) const { return y_ + double{drawn_.samples[s].y}; }

    const DrawnImages& drawn_;
    std::span<const reference::Picture> traced_;
    IdColour colourOf_;
    Retracer& retracer_;
    int x_, y_;
    glm::ivec3 colour_{0};
    std::vector<Ids> ids_; ///< by sample
};

} // namespace

void compareSampled(const DrawnImages& drawn, std::span<const reference::Picture> traced, IdColour colourOf,
                    Retracer& retracer, Comparison& result) {
    const std::size_t pixels = static_cast<std::size_t>(drawn.width) * drawn.height;
    LIMEN_ASSERT(drawn.colour.size() == 4 * pixels, "a colour for every pixel");
    LIMEN_ASSERT(!traced.empty() && traced.size() == drawn.samples.size(),
                 "a traced picture for every sample");
    result.counts = {};
    result.verdicts.resize(pixels);
    std::size_t inVain = 0, i = 0;
    for (int y = 0; y < static_cast<int>(drawn.height); ++y) {
        for (int x = 0; x < static_cast<int>(drawn.width); ++x, ++i) {
            SampledPixel pixel(drawn, traced, colourOf, retracer, x, y);
            const Verdict verdict = pixel.verdict(inVain < kMostSecondLooks);
            inVain += isFinding(verdict) ? 1 : 0;
            result.verdicts[i] = verdict;
            ++result.counts[static_cast<std::size_t>(verdict)];
        }
    }
}

} // namespace limen::check
