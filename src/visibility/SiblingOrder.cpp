#include "visibility/SiblingOrder.h"

#include "visibility/Region.h"

#include <algorithm>
#include <numeric>

namespace limen::visibility {

namespace {

/// Overlaps with a smaller coneSize result from rounding of a shared edge and contain no pixel.
constexpr double kTouching = 1e-11;

/// Maximum number of parts per opening when cycles are cut. Flat openings need few. For bent ones, whose
/// regions may not be convex, cutting might never end.
constexpr std::size_t kMostParts = 8;

Vec3 centroid(std::span<const Vec3> region) {
    Vec3 sum(0.0);
    for (const Vec3& v : region)
        sum += v;
    return sum;
}

/// Distance along direction `d` (x, y, w; its length is the unit of the result) to the candidate's plane. 0
/// for an eye in the plane, also if it is a little before or behind it.
double distanceAlong(const Candidate& c, const Vec3& d) {
    if (c.inPlane)
        return 0.0;
    const double speed = glm::dot(c.planeOnScreen, d);
    return speed > 0.0 ? -c.entryPlane.d / speed : 0.0;
}

bool contains(std::span<const Vec3> outer, std::span<const Vec3> inner) {
    for (std::size_t i = 0; i < outer.size(); ++i) {
        const Vec3 edge = glm::cross(outer[i], outer[(i + 1) % outer.size()]);
        for (const Vec3& v : inner)
            if (glm::dot(edge, v) < 0.0)
                return false;
    }
    return true;
}

} // namespace

SiblingOrder::Relation SiblingOrder::compare(const CandidateList& list, const Candidate& a,
                                             const Candidate& b) {
    if (intersection(a.rect, b.rect).empty())
        return Relation::None;
    clipByRegion(list.region(a), list.region(b), overlap_, swap_);
    if (overlap_.empty() || coneSize(overlap_) < kTouching)
        return Relation::None;
    const auto before = [&] {
        return contains(list.region(b), list.region(a)) ? Relation::Covered : Relation::Before;
    };
    if (a.portal == b.portal &&
        a.hole != b.hole) // the pair and its hole are in one plane: the pair is drawn over the hole
        return a.hole ? before() : Relation::After;
    const Vec3 direction = centroid(overlap_);
    const double da = distanceAlong(a, direction);
    const double db = distanceAlong(b, direction);
    const bool isFarther =
        da != db ? da > db : a.portal > b.portal; // at equal distance the rays take the first portal
    return isFarther ? before() : Relation::After;
}

void SiblingOrder::relate(const CandidateList& list) {
    const std::size_t n = list.items.size();
    relations_.assign(n * n, Relation::None);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i + 1; j < n; ++j) {
            const Relation r = compare(list, list.items[i], list.items[j]);
            if (r == Relation::After && contains(list.region(list.items[i]), list.region(list.items[j]))) {
                relations_[j * n + i] = Relation::Covered;
            } else if (r == Relation::Covered) {
                relations_[i * n + j] = Relation::Covered;
            } else if (r != Relation::None) {
                relations_[i * n + j] = r;
                relations_[j * n + i] = r == Relation::Before ? Relation::After : Relation::Before;
            }
        }
    }
}

bool SiblingOrder::place(const CandidateList& list) {
    const std::size_t n = list.items.size();
    order_.clear();
    done_.assign(n, 0);
    std::size_t left = n;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            if (done_[i] == 0 && relations_[i * n + j] == Relation::Covered) {
                done_[i] = 1;
                --left;
            }
        }
    }
    while (left > 0) {
        bool placed = false;
        for (const std::uint32_t i : byDistance_) {
            const auto waits = [&](std::uint32_t j) {
                return done_[j] == 0 && relations_[i * n + j] == Relation::After;
            };
            if (done_[i] != 0 || std::any_of(byDistance_.begin(), byDistance_.end(), waits))
                continue;
            order_.push_back(i);
            done_[i] = 1;
            --left;
            placed = true;
            break;
        }
        if (!placed)
            return false;
    }
    return true;
}

bool SiblingOrder::split(CandidateList& list) {
    const std::size_t n = list.items.size();
    for (const std::uint32_t cut : byDistance_) {
        for (const std::uint32_t by : byDistance_) {
            if (done_[cut] == 0 && done_[by] == 0 && relations_[cut * n + by] == Relation::After &&
                cutInto(list, cut, by)) {
                std::swap(list, next_);
                return true;
            }
        }
    }
    return false;
}

void SiblingOrder::placeRest() {
    std::copy_if(byDistance_.begin(), byDistance_.end(), std::back_inserter(order_),
                 [&](std::uint32_t i) { return done_[i] == 0; });
}

bool SiblingOrder::cutInto(const CandidateList& list, std::uint32_t cut, std::uint32_t by) {
    next_.clear();
    for (std::uint32_t i = 0; i < list.items.size(); ++i)
        if (i != cut)
            next_.add(list.items[i], list.region(list.items[i]));
    const auto edges = list.region(list.items[by]);
    Candidate part = list.items[cut];
    part.split = true;
    const auto original = list.region(list.items[cut]);
    rest_.assign(original.begin(), original.end());
    const auto add = [&](std::vector<Vec3>& region) {
        tidyRegion(region);
        if (!region.empty() && coneSize(region) >= kTouching) {
            part.rect = boundsOf(region);
            next_.add(part, region);
        }
    };
    for (std::size_t e = 0; e < edges.size() && !rest_.empty(); ++e) {
        const Vec3 edge = glm::cross(edges[e], edges[(e + 1) % edges.size()]);
        clipByEyePlane(rest_, -edge, overlap_);
        add(overlap_);
        clipByEyePlane(rest_, edge, overlap_);
        rest_.swap(overlap_);
    }
    add(rest_);
    return next_.items.size() > list.items.size();
}

void SiblingOrder::sort(CandidateList& list, FloodCounts& counts) {
    if (list.items.size() < 2)
        return;
    const std::size_t most = kMostParts * list.items.size();
    for (;;) {
        distance_.clear();
        for (const Candidate& c : list.items) {
            const Vec3 direction = glm::normalize(centroid(list.region(c)));
            distance_.push_back(distanceAlong(c, direction));
        }
        byDistance_.resize(list.items.size());
        std::iota(byDistance_.begin(), byDistance_.end(), 0u);
        std::sort(byDistance_.begin(), byDistance_.end(), [&](std::uint32_t a, std::uint32_t b) {
            return distance_[a] != distance_[b] ? distance_[a] > distance_[b]
                   : list.items[a].portal != list.items[b].portal
                       ? list.items[a].portal < list.items[b].portal
                       : list.items[a].hole && !list.items[b].hole;
        });
        relate(list);
        if (place(list))
            break;
        if (list.items.size() > most || !split(list)) { // bent, intersecting, or equal but for rounding
            ++counts.cyclesLeft;
            placeRest();
            break;
        }
        ++counts.cyclesSplit;
    }
    next_.clear();
    for (const std::uint32_t i : order_)
        next_.add(list.items[i], list.region(list.items[i]));
    std::swap(list, next_);
}

} // namespace limen::visibility
