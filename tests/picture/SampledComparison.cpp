#include "picture/SampledComparison.h"

#include "frame/IdColour.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace limen::test {

namespace {

/// Pixels: how far from a sample the rasteriser's rounding may move an edge, and the grid of rays within that.
constexpr double kReach = 1.0 / 128.0;
constexpr int kSteps = 2; ///< to each side
/// Of 255: what rounding the mean of four colours may differ by.
constexpr int kRounding = 1;

using Ids = std::vector<std::uint32_t>;

void addOnce(Ids& ids, std::uint32_t id) {
    if (std::find(ids.begin(), ids.end(), id) == ids.end()) {
        ids.push_back(id);
    }
}

/// One pixel's samples, each with the ids that rays at and around it meet.
class Pixel {
public:
    Pixel(const PictureWorld& pictures, const Picture& picture, std::uint32_t x, std::uint32_t y)
        : pictures_(pictures), picture_(picture), x_(x), y_(y) {
        const std::size_t at = (std::size_t{y} * picture.frame.width + x) * 4;
        drawn_ = {picture.colour[at], picture.colour[at + 1], picture.colour[at + 2]};
        for (const glm::vec2& sample : picture.samples) {
            samples_.push_back({traced(sample, 0.0, 0.0)});
        }
    }

    [[nodiscard]] bool isMixed() const {
        return std::any_of(samples_.begin(), samples_.end(),
                           [&](const Ids& ids) { return ids[0] != samples_[0][0]; });
    }
    [[nodiscard]] bool isExplained() const { return anyMean(0, glm::ivec3(0)); }
    void lookAround() {
        for (std::size_t i = 0; i < samples_.size(); ++i) {
            for (int dy = -kSteps; dy <= kSteps; ++dy) {
                for (int dx = -kSteps; dx <= kSteps; ++dx) {
                    addOnce(samples_[i],
                            traced(picture_.samples[i], dx * kReach / kSteps, dy * kReach / kSteps));
                }
            }
        }
    }
    void lookForTies() {
        const world::World& world = pictures_.world();
        for (std::uint32_t i = 0; i < world.instances.size(); ++i) {
            const world::Instance& in = world.instances[i];
            for (std::uint32_t p = 0; p < world.meshes[in.mesh].polygonCount; ++p) {
                for (std::size_t s = 0; s < samples_.size(); ++s) {
                    if (isTied(i, in.idBase + p, picture_.samples[s])) {
                        addOnce(samples_[s], in.idBase + p);
                    }
                }
            }
        }
    }
    [[nodiscard]] std::string describe() const {
        std::string text =
            fmt::format("pixel ({}, {}): drawn {} {} {}", x_, y_, drawn_.x, drawn_.y, drawn_.z);
        for (const Ids& ids : samples_) {
            text += ";";
            for (const std::uint32_t id : ids) {
                const auto [r, g, b] = frame::colourOfId(id);
                text += fmt::format(" {} ({} {} {})", describeId(pictures_.world(), id), r, g, b);
            }
        }
        return text;
    }

private:
    [[nodiscard]] NaiveTracer::Ray rayAt(const glm::vec2& sample, double dx, double dy) const {
        return rayThrough(picture_.frame, x_ + double{sample.x} + dx, y_ + double{sample.y} + dy);
    }
    [[nodiscard]] std::uint32_t traced(const glm::vec2& sample, double dx, double dy) const {
        return pictures_.tracer().trace(picture_.frame.view.root, rayAt(sample, dx, dy)).id;
    }
    [[nodiscard]] bool isTied(std::uint32_t instance, std::uint32_t id, const glm::vec2& sample) const {
        const double shown = pictures_.tracer().trace(picture_.frame.view.root, rayAt(sample, 0.0, 0.0)).t;
        bool covered = false;
        double nearest = std::numeric_limits<double>::infinity();
        for (int dy = -kSteps; dy <= kSteps; ++dy) {
            for (int dx = -kSteps; dx <= kSteps; ++dx) {
                const auto alone = pictures_.tracer().traceAlone(
                    instance, id, rayAt(sample, dx * kReach / kSteps, dy * kReach / kSteps));
                covered = covered || alone.met;
                nearest = std::min(nearest, alone.planeT);
            }
        }
        return covered && nearest <= shown;
    }
    /// Whether a choice of one id for each sample from `from` on gives the drawn colour.
    [[nodiscard]] bool anyMean(std::size_t from, const glm::ivec3& sum) const {
        const auto count = static_cast<int>(samples_.size());
        if (from == samples_.size()) {
            const glm::ivec3 off = glm::abs(sum - drawn_ * count);
            const bool same = std::all_of(samples_.begin(), samples_.end(), [&](const Ids& ids) {
                return ids.size() == 1 && ids[0] == samples_[0][0];
            });
            return std::max({off.x, off.y, off.z}) <= (same ? 0 : kRounding * count);
        }
        return std::any_of(samples_[from].begin(), samples_[from].end(), [&](std::uint32_t id) {
            const auto [r, g, b] = frame::colourOfId(id);
            return anyMean(from + 1, sum + glm::ivec3(r, g, b));
        });
    }

    const PictureWorld& pictures_;
    const Picture& picture_;
    std::uint32_t x_, y_;
    glm::ivec3 drawn_{0};
    std::vector<Ids> samples_;
};

} // namespace

SampledComparison& SampledComparison::operator+=(const SampledComparison& other) {
    pixels += other.pixels;
    mixed += other.mixed;
    snapped += other.snapped;
    tied += other.tied;
    wrong += other.wrong;
    first = first.empty() ? other.first : first;
    return *this;
}

SampledComparison compareSampled(const PictureWorld& pictures, const Picture& picture) {
    SampledComparison result;
    for (std::uint32_t y = 0; y < picture.frame.height; ++y) {
        for (std::uint32_t x = 0; x < picture.frame.width; ++x) {
            Pixel pixel(pictures, picture, x, y);
            ++result.pixels;
            result.mixed += pixel.isMixed() ? 1 : 0;
            if (pixel.isExplained()) {
                continue;
            }
            pixel.lookAround();
            if (pixel.isExplained()) {
                ++result.snapped;
                continue;
            }
            pixel.lookForTies();
            if (pixel.isExplained()) {
                ++result.tied;
            } else if (result.wrong++ == 0) {
                result.first = pixel.describe();
            }
        }
    }
    return result;
}

} // namespace limen::test
