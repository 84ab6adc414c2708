#include "frame/Selection.h"

#include "core/Fetch.h"

#include <algorithm>

namespace limen::frame {

namespace {

using visibility::Containment;
using visibility::SeenBall;

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
    : world_(world), clusters_(clusters), askedFrame_(world.spaces.size()), lastAsk_(world.spaces.size()) {
    for (std::size_t i = clusters.firstShared; i < clusters.order.size(); ++i) {
        sharedInOneZone_.push_back(isInOneZone(world, world.instances[clusters.order[i]], world.members) ? 1
                                                                                                         : 0);
    }
    sharedMarks_.resize(sharedInOneZone_.size());
}

void Selection::select(const FrameView& frame, const world::Moment& moment,
                       const visibility::VisibleSet& set) {
    ++frameNumber_;
    counts_ = {};
    ranges_.clear();
    movers_.clear();
    sharedMet_.clear();
    moversMet_.clear();
    eye_ = frame.view.eye;
    forward_ = frame.view.forward;
    nearPlane_ = frame.nearPlane;
    several_ = set.visits.size() > 1;
    everyAsk_ = frame.rules.viewcone;
    moverMarks_.resize(moment.instances.size());
    const double pixel =
        2.0 * std::max(frame.view.tanHalfX / frame.width, frame.view.tanHalfY / frame.height);
    cones_.prepare(frame.view, set, pixel);
    gatherAsks(set);
    for (const Asked& asked : asked_) {
        if (const std::uint32_t root = clusters_.roots[asked.space]; root != world::kNone) {
            active_.clear();
            for (std::uint32_t ask = asked.firstAsk; ask != world::kNone; ask = asks_[ask].next) {
                active_.push_back(ask);
            }
            counts_.met += clusters_.clusters[root].end - clusters_.clusters[root].first;
            descend(clusters_.clusters[root], 0);
        }
    }
    for (const Ask& ask : asks_) {
        selectListed(ask, moment);
    }
    finishListed(moment);
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
        if (first) {
            asked_.push_back({seen.space, number});
        } else if (everyAsk_) {
            asks_[lastAsk_[seen.space]].next = number;
        }
        lastAsk_[seen.space] = number;
    }
    // So that what is drawn is in the same order from everywhere.
    std::sort(asked_.begin(), asked_.end(), [](const Asked& a, const Asked& b) { return a.space < b.space; });
}

Containment Selection::askCluster(const Ask& ask, const SeenBall& ball) {
    ++counts_.boundsTested;
    const Containment inVisit = cones_.classify(ask.visit, ball);
    if (inVisit == Containment::Outside || !ask.narrow) {
        return inVisit;
    }
    const Containment inRect = visibility::Viewcones::classify(ask.rect, ball);
    return inRect == Containment::Inside ? inVisit : inRect;
}

Containment Selection::askInstance(const Ask& ask, const SeenBall& ball) {
    ++counts_.boundsTested;
    const Containment inVisit = cones_.classify(ask.visit, ball);
    if (inVisit == Containment::Outside || !ask.narrow ||
        visibility::Viewcones::classify(ask.rect, ball) != Containment::Outside) {
        return inVisit;
    }
    return Containment::Outside;
}

void Selection::descend(const Cluster& cluster, std::size_t firstActive) {
    const SeenBall ball = ballOf(cluster.bounds);
    const std::size_t endActive = active_.size();
    for (std::size_t i = firstActive; i < endActive; ++i) {
        const Containment here = askCluster(asks_[active_[i]], ball);
        if (here == Containment::Inside) {
            draw(cluster.first, cluster.end, true);
            active_.resize(endActive);
            return;
        }
        if (here == Containment::Partial) {
            active_.push_back(active_[i]);
        }
    }
    if (active_.size() > endActive) {
        if (cluster.childCount == 0) {
            selectLeaf(cluster, endActive);
        }
        // What the parts are made of comes from memory while the parts are asked.
        for (std::uint32_t i = 0; i < cluster.childCount; ++i) {
            const Cluster& part = clusters_.clusters[cluster.firstChild + i];
            for (std::uint32_t j = 0; j < part.childCount; ++j) {
                fetch(clusters_.clusters[part.firstChild + j]);
            }
        }
        for (std::uint32_t i = 0; i < cluster.childCount; ++i) {
            descend(clusters_.clusters[cluster.firstChild + i], endActive);
        }
    }
    active_.resize(endActive);
}

void Selection::selectLeaf(const Cluster& leaf, std::size_t firstActive) {
    // Where only the picture's edges cut it, what lies beyond shows nothing, and to ask costs more than to draw. But for what reaches
    // behind the eye: of that triangles are kept and drawn around the whole window.
    const Vec3 offset = leaf.bounds.centre - eye_;
    const bool isAhead = glm::dot(offset, forward_) > leaf.bounds.radius + nearPlane_;
    if (!several_ && isAhead && !asks_[active_[firstActive]].narrow) {
        draw(leaf.first, leaf.end, false);
        return;
    }
    for (std::uint32_t position = leaf.first; position < leaf.end; ++position) {
        const SeenBall ball = ballOf(clusters_.bounds[position]);
        Containment best = Containment::Outside;
        for (std::size_t i = firstActive; i < active_.size() && best != Containment::Inside; ++i) {
            best = std::max(best, askInstance(asks_[active_[i]], ball));
        }
        if (best != Containment::Outside) {
            draw(position, position + 1, best == Containment::Inside);
        }
    }
}

void Selection::draw(std::uint32_t first, std::uint32_t end, bool inside) {
    const bool gated = several_ && !inside;
    counts_.drawn += end - first;
    counts_.ungated += gated ? 0 : end - first;
    if (!ranges_.empty() && ranges_.back().end == first && ranges_.back().gated == gated) {
        ranges_.back().end = end;
    } else {
        ranges_.push_back({first, end, gated});
    }
}

void Selection::meet(const Ask& ask, const Sphere& bounds, Mark& mark, std::uint32_t number,
                     std::vector<std::uint32_t>& met) {
    const bool again = mark.frame == frameNumber_;
    if (!again) {
        mark = {frameNumber_, Containment::Outside};
        met.push_back(number);
    }
    if (mark.seen == Containment::Inside || (again && !everyAsk_)) {
        return;
    }
    mark.seen = std::max(mark.seen, askInstance(ask, ballOf(bounds)));
}

void Selection::selectListed(const Ask& ask, const world::Moment& moment) {
    for (const std::uint32_t position : clusters_.sharedIn(ask.space)) {
        const std::uint32_t number = position - clusters_.firstShared;
        meet(ask, clusters_.bounds[position], sharedMarks_[number], number, sharedMet_);
    }
    if (!several_) {
        selectMoversOf(ask, moment);
        return;
    }
    for (const world::ListedInstance& moving : moment.instancesIn(ask.space)) {
        if (moving.isListedAgain) {
            meet(ask, moving.bounds, moverMarks_[moving.instance], moving.instance, moversMet_);
        } else if (ask.first) {
            ++counts_.met;
            const SeenBall ball = ballOf(moving.bounds);
            Containment best = askInstance(ask, ball);
            for (std::uint32_t i = ask.next; i != world::kNone && best != Containment::Inside;
                 i = asks_[i].next) {
                best = std::max(best, askInstance(asks_[i], ball));
            }
            if (best != Containment::Outside) {
                drawMover(moving.instance, best == Containment::Inside);
            }
        }
    }
}

// With a single visit a space is asked about once. Half of many that move are seen, and nobody can foretell which: what is found is
// written either way, and counts or does not.
void Selection::selectMoversOf(const Ask& ask, const world::Moment& moment) {
    const std::span<const world::ListedInstance> members = moment.instancesIn(ask.space);
    std::size_t end = movers_.size();
    movers_.resize(end + members.size());
    for (const world::ListedInstance& moving : members) {
        if (moving.isListedAgain) {
            meet(ask, moving.bounds, moverMarks_[moving.instance], moving.instance, moversMet_);
            continue;
        }
        const SeenBall ball = ballOf(moving.bounds);
        bool isSeen = cones_.touches(ask.visit, ball);
        isSeen &= !ask.narrow || visibility::Viewcones::touches(ask.rect, ball);
        movers_[end] = {moving.instance, false};
        end += isSeen ? 1 : 0;
        ++counts_.met;
        ++counts_.boundsTested;
    }
    const auto seen = static_cast<std::uint32_t>(end - (movers_.size() - members.size()));
    counts_.drawn += seen;
    counts_.ungated += seen;
    movers_.resize(end);
}

void Selection::drawMover(std::uint32_t index, bool inside) {
    const bool gated = several_ && !inside;
    ++counts_.drawn;
    counts_.ungated += gated ? 0 : 1;
    movers_.push_back({index, gated});
}

void Selection::finishListed(const world::Moment& moment) {
    counts_.met += static_cast<std::uint32_t>(sharedMet_.size() + moversMet_.size());
    std::sort(sharedMet_.begin(), sharedMet_.end());
    for (const std::uint32_t number : sharedMet_) {
        if (const Containment seen = sharedMarks_[number].seen; seen != Containment::Outside) {
            const std::uint32_t position = clusters_.firstShared + number;
            // A member of several zones is lit by the zone that keeps each fragment, so it always takes the test.
            draw(position, position + 1, seen == Containment::Inside && sharedInOneZone_[number] != 0);
        }
    }
    for (const std::uint32_t number : moversMet_) {
        if (const Containment seen = moverMarks_[number].seen; seen != Containment::Outside) {
            drawMover(number, seen == Containment::Inside &&
                                  isInOneZone(world_, moment.instances[number], moment.members));
        }
    }
    const auto before = [](const SelectedMover& a, const SelectedMover& b) { return a.index < b.index; };
    if (!std::is_sorted(movers_.begin(), movers_.end(), before)) {
        std::sort(movers_.begin(), movers_.end(), before);
    }
}

} // namespace limen::frame
