#include "frame/Selection.h"

#include "core/Fetch.h"

#include <algorithm>

namespace limen::frame {

namespace {

using visibility::Containment;
using visibility::FourEdges;
using visibility::SeenSphere;

constexpr std::uint32_t kAtOnce = visibility::SphereBatch::kCount;
static_assert(kAtOnce <= world::ListedInstances::kSpare, "every block of what is listed can be read");
static_assert(world::ListedInstances::kMostOffset <= visibility::SphereBatch::kMostOffset);

bool isInOneZone(const world::World& world, const world::Instance& instance,
                 std::span<const world::SpaceIndex> members) {
    const auto own = members.subspan(instance.firstMember, instance.memberCount);
    return std::all_of(own.begin(), own.end(), [&](world::SpaceIndex space) {
        return world.spaces[space].zone == world.spaces[own.front()].zone;
    });
}

bool isWholeScreen(const visibility::Rect& rect) {
    return rect.minX <= -1.0 && rect.minY <= -1.0 && rect.maxX >= 1.0 && rect.maxY >= 1.0;
}

} // namespace

Selection::Selection(const world::World& world, const Clusters& clusters)
    : world_(world), clusters_(clusters), levels_(clusters), askedFrame_(world.spaces.size()),
      lastAsk_(world.spaces.size()) {
    for (std::size_t i = clusters.firstShared; i < clusters.order.size(); ++i) {
        sharedInOneZone_.push_back(isInOneZone(world, world.instances[clusters.order[i]], world.members) ? 1
                                                                                                         : 0);
    }
    sharedMarks_.resize(sharedInOneZone_.size());
}

void Selection::select(const FrameView& frame, const world::DynamicState& dynamics,
                       const visibility::VisibleSet& set) {
    ++frameNumber_;
    counts_ = {};
    ranges_.clear();
    moverCount_ = 0;
    movers_.resize(std::max(movers_.size(), dynamics.instances.size() + kAtOnce));
    sharedMet_.clear();
    moversMet_.clear();
    eye_ = frame.view.eye;
    forward_ = frame.view.forward;
    nearPlane_ = frame.nearPlane;
    several_ = set.visits.size() > 1;
    everyAsk_ = frame.rules.viewcone;
    moverMarks_.resize(dynamics.instances.size());
    const double pixel =
        2.0 * std::max(frame.view.tanHalfX / frame.width, frame.view.tanHalfY / frame.height);
    cones_.prepare(frame.view, set, pixel);
    gatherAsks(set);
    for (const Asked& asked : asked_) {
        zone_ = several_ ? world_.spaces[asked.space].zone : world::kNone;
        if (const std::uint32_t root = clusters_.roots[asked.space]; root != world::kNone)
            selectStanding(asked, root);
    }
    zone_ = world::kNone;
    for (const Ask& ask : asks_)
        selectListed(ask, dynamics);
    finishListed(dynamics);
}

void Selection::selectStanding(const Asked& asked, std::uint32_t root) {
    counts_.met += clusters_.clusters[root].end - clusters_.clusters[root].first;
    if (!several_ && !asks_[asked.firstAsk].narrow) {
        for (const PositionRange& range : levels_.select(asked.space, cones_, eye_, forward_, nearPlane_))
            draw(range.first, range.end, true);
        counts_.boundsTested += levels_.boundsTested();
        return;
    }
    active_.clear();
    for (std::uint32_t ask = asked.firstAsk; ask != world::kNone; ask = asks_[ask].next)
        active_.push_back(ask);
    descend(clusters_.clusters[root], 0);
}

void Selection::gatherAsks(const visibility::VisibleSet& set) {
    asks_.clear();
    asked_.clear();
    for (const visibility::SeenSpace& seen : set.seen) {
        const auto number = static_cast<std::uint32_t>(asks_.size());
        const bool first = askedFrame_[seen.space] != frameNumber_;
        askedFrame_[seen.space] = frameNumber_;
        // The root's region is the screen: it need not be asked for twice.
        const bool narrow = set.visits[seen.visit].depth > 0 || !isWholeScreen(seen.rect);
        asks_.push_back({seen.space, seen.visit, world::kNone, first, narrow,
                         narrow ? cones_.edgesOf(seen.rect) : visibility::FourEdges()});
        if (first)
            asked_.push_back({seen.space, number});
        else if (everyAsk_)
            asks_[lastAsk_[seen.space]].next = number;
        lastAsk_[seen.space] = number;
    }
    // So that what is drawn is in the same order from everywhere.
    std::sort(asked_.begin(), asked_.end(), [](const Asked& a, const Asked& b) { return a.space < b.space; });
}

Containment Selection::askCluster(const Ask& ask, const SeenSphere& sphere) {
    ++counts_.boundsTested;
    const Containment inVisit = cones_.classify(ask.visit, sphere);
    if (inVisit == Containment::Outside || !ask.narrow)
        return inVisit;
    const Containment inRect = visibility::Viewcones::classify(ask.rect, sphere);
    return inRect == Containment::Inside ? inVisit : inRect;
}

Containment Selection::askInstance(const Ask& ask, const SeenSphere& sphere) {
    ++counts_.boundsTested;
    const Containment inVisit = cones_.classify(ask.visit, sphere);
    if (inVisit == Containment::Outside || !ask.narrow ||
        visibility::Viewcones::classify(ask.rect, sphere) != Containment::Outside)
        return inVisit;
    return Containment::Outside;
}

void Selection::descend(const Cluster& cluster, std::size_t firstActive) {
    const SeenSphere sphere = sphereOf(cluster.bounds);
    const std::size_t endActive = active_.size();
    for (std::size_t i = firstActive; i < endActive; ++i) {
        const Containment here = askCluster(asks_[active_[i]], sphere);
        if (here == Containment::Inside) {
            draw(cluster.first, cluster.end, true);
            active_.resize(endActive);
            return;
        }
        if (here == Containment::Partial)
            active_.push_back(active_[i]);
    }
    if (active_.size() > endActive) {
        if (cluster.childCount == 0)
            selectLeaf(cluster, endActive);
        // What the parts are made of comes from memory while the parts are asked.
        for (std::uint32_t i = 0; i < cluster.childCount; ++i) {
            const Cluster& part = clusters_.clusters[cluster.firstChild + i];
            for (std::uint32_t j = 0; j < part.childCount; ++j)
                fetch(clusters_.clusters[part.firstChild + j]);
        }
        for (std::uint32_t i = 0; i < cluster.childCount; ++i)
            descend(clusters_.clusters[cluster.firstChild + i], endActive);
    }
    active_.resize(endActive);
}

void Selection::selectLeaf(const Cluster& leaf, std::size_t firstActive) {
    for (std::uint32_t position = leaf.first; position < leaf.end; ++position) {
        const SeenSphere sphere = sphereOf(clusters_.bounds[position]);
        Containment best = Containment::Outside;
        for (std::size_t i = firstActive; i < active_.size() && best != Containment::Inside; ++i)
            best = std::max(best, askInstance(asks_[active_[i]], sphere));
        if (best != Containment::Outside)
            draw(position, position + 1, best == Containment::Inside);
    }
}

void Selection::draw(std::uint32_t first, std::uint32_t end, bool inside) {
    const bool gated = several_ && !inside;
    counts_.drawn += end - first;
    counts_.ungated += gated ? 0 : end - first;
    SelectedRange* const last = ranges_.empty() ? nullptr : &ranges_.back();
    if (last != nullptr && last->end == first && last->gated == gated && last->zone == zone_)
        last->end = end;
    else
        ranges_.push_back({first, end, gated, zone_});
}

bool Selection::meet(const Ask& ask, const Sphere& bounds, Mark& mark) {
    const bool isFirst = mark.frame != frameNumber_;
    if (isFirst)
        mark = {frameNumber_, Containment::Outside};
    if (mark.seen != Containment::Inside && (isFirst || everyAsk_))
        mark.seen = std::max(mark.seen, askInstance(ask, sphereOf(bounds)));
    return isFirst;
}

void Selection::selectListed(const Ask& ask, const world::DynamicState& dynamics) {
    for (const std::uint32_t position : clusters_.sharedIn(ask.space)) {
        const std::uint32_t number = position - clusters_.firstShared;
        if (meet(ask, clusters_.bounds[position], sharedMarks_[number]))
            sharedMet_.push_back(number);
    }
    if (!several_) {
        selectMoversOf(ask, dynamics);
        return;
    }
    const world::DynamicState::Run run = dynamics.listedIn(ask.space);
    selectOneByOne(ask, dynamics, run.first, run.end);
}

void Selection::selectOneByOne(const Ask& ask, const world::DynamicState& dynamics, std::uint32_t first,
                               std::uint32_t end) {
    const world::ListedInstances& listed = dynamics.listed;
    for (std::uint32_t at = first; at < end; ++at) {
        if (listed.isListedAgain[at] != 0) {
            meetListed(ask, dynamics, at);
        } else if (ask.first) {
            ++counts_.met;
            const SeenSphere sphere = sphereOf(dynamics.instances[listed.instance[at]].bounds);
            Containment best = askInstance(ask, sphere);
            for (std::uint32_t i = ask.next; i != world::kNone && best != Containment::Inside;
                 i = asks_[i].next)
                best = std::max(best, askInstance(asks_[i], sphere));
            if (best != Containment::Outside)
                drawMover(at, best == Containment::Inside);
        }
    }
}

// With a single visit a space is asked about once.
void Selection::selectMoversOf(const Ask& ask, const world::DynamicState& dynamics) {
    const world::ListedInstances& listed = dynamics.listed;
    const auto [first, end] = dynamics.listedIn(ask.space);
    const Vec3 eye = eye_ - listed.origin;
    const bool areFar = listed.areFar || glm::length(eye) > visibility::SphereBatch::kMostOffset;
    for (std::uint32_t at = first; at < end; at += kAtOnce) {
        const std::uint32_t next = std::min(at + kAtOnce, end);
        const bool areAlone =
            !listed.anyListedAgain ||
            std::none_of(listed.isListedAgain.begin() + at, listed.isListedAgain.begin() + next,
                         [](std::uint8_t again) { return again != 0; });
        const std::uint32_t found =
            areFar || !areAlone
                ? visibility::Viewcones::kCannotTell
                : cones_.listWithin({&listed.x[at], &listed.y[at], &listed.z[at], &listed.radius[at]}, eye,
                                    ask.narrow ? &ask.rect : nullptr, at, next - at, &movers_[moverCount_]);
        if (found == visibility::Viewcones::kCannotTell) {
            selectOneByOne(ask, dynamics, at, next);
        } else {
            moverCount_ += found;
            counts_.met += next - at;
            counts_.boundsTested += next - at;
            counts_.drawn += found;
            counts_.ungated += found;
        }
    }
}
void Selection::meetListed(const Ask& ask, const world::DynamicState& dynamics, std::uint32_t at) {
    const world::InstanceIndex number = dynamics.listed.instance[at];
    if (meet(ask, dynamics.instances[number].bounds, moverMarks_[number]))
        moversMet_.push_back(at);
}

void Selection::drawMover(std::uint32_t at, bool inside) {
    const bool gated = several_ && !inside;
    ++counts_.drawn;
    counts_.ungated += gated ? 0 : 1;
    movers_[moverCount_++] = at | (gated ? gpu::kGated : 0);
}

void Selection::finishListed(const world::DynamicState& dynamics) {
    counts_.met += static_cast<std::uint32_t>(sharedMet_.size() + moversMet_.size());
    std::sort(sharedMet_.begin(), sharedMet_.end());
    for (const std::uint32_t number : sharedMet_) {
        if (const Containment seen = sharedMarks_[number].seen; seen != Containment::Outside) {
            const std::uint32_t position = clusters_.firstShared + number;
            // A member of several zones is lit by the zone that keeps each fragment, so it always takes the test.
            draw(position, position + 1, seen == Containment::Inside && sharedInOneZone_[number] != 0);
        }
    }
    const std::vector<world::InstanceIndex>& instance = dynamics.listed.instance;
    for (const std::uint32_t at : moversMet_) {
        const world::InstanceIndex number = instance[at];
        if (const Containment seen = moverMarks_[number].seen; seen != Containment::Outside) {
            drawMover(at, seen == Containment::Inside &&
                              isInOneZone(world_, dynamics.instances[number], dynamics.members));
        }
    }
    const auto before = [&instance](SelectedMover a, SelectedMover b) {
        return instance[a & ~gpu::kGated] < instance[b & ~gpu::kGated];
    };
    const auto drawn = std::span(movers_).first(moverCount_);
    const bool areOfOneRun = asks_.size() == 1 && moversMet_.empty();
    if (!areOfOneRun && !std::is_sorted(drawn.begin(), drawn.end(), before))
        std::sort(drawn.begin(), drawn.end(), before);
}

} // namespace limen::frame
