#include "frame/Selection.h"

#include "core/Prefetch.h"

#include <algorithm>

namespace limen::frame {

namespace {

using visibility::Containment;
using visibility::FourEdges;
using visibility::SeenSphere;

constexpr std::uint32_t kSpheresAtOnce = visibility::SphereBatch::kCount;
static_assert(kSpheresAtOnce <= world::ListedInstances::kSpare, "a batch may begin at any listed instance");
static_assert(world::ListedInstances::kMostOffset <= visibility::SphereBatch::kMostOffset);

/// Of an instance that one visit shows.
Turn turnOf(std::uint32_t visit) {
    return visit == 0 ? Turn::Before : Turn::After;
}

bool isWholeScreen(const visibility::Rect& rect) {
    return rect.minX <= -1.0 && rect.minY <= -1.0 && rect.maxX >= 1.0 && rect.maxY >= 1.0;
}

} // namespace

Selection::Selection(const StaticScene& scene)
    : world_(scene.world()), clusters_(scene.clusters()), levels_(clusters_, scene.clusterBatches()),
      inRange_(world_, scene.levels()), exits_(world_), occluders_(scene), testedFrame_(world_.spaces.size()),
      lastTest_(world_.spaces.size()), sharedResults_(clusters_.sharedIsInOneZone.size()) {}

void Selection::select(const FrameView& frame, const world::DynamicState& dynamics,
                       const visibility::VisibleSet& set, bool rootFirst) {
    ++frameNumber_;
    counts_ = {};
    ranges_.clear();
    dynamicCount_ = 0;
    dynamic_.resize(std::max(dynamic_.size(), dynamics.instances.size() + kSpheresAtOnce));
    sharedTested_.clear();
    dynamicTested_.clear();
    eye_ = frame.view.eye;
    forward_ = frame.view.forward;
    nearPlane_ = frame.nearPlane;
    hasSeveralVisits_ = set.visits.size() > 1;
    hasFewTests_ = frame.fewTests;
    hasTurns_ = rootFirst;
    inRange_.prepare(frame.view.eye, frame.levels);
    levelShare_ = frame.levels;
    testsEveryVisit_ = frame.rules.viewcone;
    dynamicResults_.resize(dynamics.instances.size());
    const double pixel =
        2.0 * std::max(frame.view.tanHalfX / frame.width, frame.view.tanHalfY / frame.height);
    cones_.prepare(frame.view, set, pixel);
    exits_.prepare(set);
    occluders_.prepare(frame, set.visits.front().space, cones_);
    gatherTests(set);
    for (const TestedSpace& tested : testedSpaces_) {
        zone_ = hasSeveralVisits_ ? world_.spaces[tested.space].zone : world::kNone;
        if (const std::uint32_t root = clusters_.roots[tested.space]; root != world::kNone)
            selectStatic(tested, root);
    }
    zone_ = world::kNone;
    for (const SpaceTest& test : tests_)
        selectListed(test, dynamics);
    finishListed(dynamics);
    occluders_.finish(counts_.drawn, counts_.hidden);
}

void Selection::gatherTests(const visibility::VisibleSet& set) {
    tests_.clear();
    testedSpaces_.clear();
    for (const visibility::SeenSpace& seen : set.seen) {
        const auto number = static_cast<std::uint32_t>(tests_.size());
        const bool isFirst = testedFrame_[seen.space] != frameNumber_;
        testedFrame_[seen.space] = frameNumber_;
        // The root's region is the screen, so a rectangle of the whole screen excludes nothing there.
        const bool isNarrow = set.visits[seen.visit].depth > 0 || !isWholeScreen(seen.rect);
        tests_.push_back({seen.space, seen.visit, world::kNone, isFirst, isNarrow,
                          isNarrow ? cones_.edgesOf(seen.rect) : FourEdges()});
        if (isFirst)
            testedSpaces_.push_back({seen.space, number});
        else if (testsEveryVisit_)
            tests_[lastTest_[seen.space]].next = number;
        lastTest_[seen.space] = number;
    }
    // The order of draws must not depend on the view.
    std::sort(testedSpaces_.begin(), testedSpaces_.end(),
              [](const TestedSpace& a, const TestedSpace& b) { return a.space < b.space; });
}

void Selection::selectStatic(const TestedSpace& tested, std::uint32_t root) {
    counts_.tested += clusters_.clusters[root].end - clusters_.clusters[root].first;
    if (!hasSeveralVisits_ && !tests_[tested.firstTest].isNarrow && !occluders_.areReady()) {
        for (const PositionRange& range :
             levels_.select(tested.space, cones_, eye_, forward_, nearPlane_, levelShare_))
            draw(range, true, Turn::Before, false);
        counts_.boundsTested += levels_.boundsTested();
        return;
    }
    active_.clear();
    for (std::uint32_t test = tested.firstTest; test != world::kNone; test = tests_[test].next)
        active_.push_back(test);
    descend(clusters_.clusters[root], 0);
}

Containment Selection::testCluster(const SpaceTest& test, const SeenSphere& sphere) {
    ++counts_.boundsTested;
    const Containment inVisit =
        hasTurns_ && test.visit == 0 ? cones_.classifyInRoot(sphere) : cones_.classify(test.visit, sphere);
    if (inVisit == Containment::Outside || !test.isNarrow)
        return inVisit;
    const Containment inRect = visibility::Viewcones::classify(test.rect, sphere);
    return inRect == Containment::Inside ? inVisit : inRect;
}

Containment Selection::testInstance(const SpaceTest& test, const SeenSphere& sphere) {
    ++counts_.boundsTested;
    const Containment inVisit = cones_.classify(test.visit, sphere);
    if (inVisit != Containment::Outside && test.visit == 0 && occluders_.hide(sphere)) {
        ++counts_.hidden;
        return Containment::Outside;
    }
    if (inVisit == Containment::Outside || !test.isNarrow ||
        visibility::Viewcones::classify(test.rect, sphere) != Containment::Outside)
        return inVisit == Containment::Partial && hasFewTests_ && test.visit == 0 &&
                       !cones_.isCoveredInRoot(sphere)
                   ? Containment::Inside
                   : inVisit;
    return Containment::Outside;
}

Containment Selection::testInRoot(const SpaceTest& test, std::uint32_t position, const SeenSphere& sphere) {
    ++counts_.boundsTested;
    if (cones_.classifyInRoot(sphere) == Containment::Outside ||
        (test.isNarrow && visibility::Viewcones::classify(test.rect, sphere) == Containment::Outside))
        return Containment::Outside;
    if (!occluders_.hideAt(position))
        return Containment::Inside;
    ++counts_.hidden;
    return Containment::Outside;
}

Containment Selection::testStatic(const SpaceTest& test, std::uint32_t position, const SeenSphere& sphere) {
    const Containment found = testInstance(test, sphere);
    if (found != Containment::Outside && test.visit == 0 && occluders_.hideAt(position)) {
        ++counts_.hidden;
        return Containment::Outside;
    }
    const world::InstanceIndex instance = clusters_.order[position];
    const bool isAsked = found == Containment::Partial && hasFewTests_ && test.visit == 0 &&
                         world_.instances[instance].kind == world::InstanceKind::Shell;
    return isAsked && exits_.areBeyond(instance) ? Containment::Inside : found;
}

void Selection::drawInRange(const Cluster& cluster, Turn turn) {
    const Containment levels = cluster.detail.at(cluster.bounds.centre - eye_, levelShare_);
    if (levels == Containment::Inside)
        draw(PositionRange{cluster.first, cluster.end}, true, turn);
    if (levels != Containment::Partial)
        return;
    for (std::uint32_t i = 0; i < cluster.childCount; ++i)
        drawInRange(clusters_.clusters[cluster.firstChild + i], turn);
    for (std::uint32_t position = cluster.first; cluster.childCount == 0 && position < cluster.end;
         ++position)
        if (inRange_.isInRange(position))
            draw(position, true, turn);
}

void Selection::drawUnhidden(const Cluster& cluster) {
    if (cluster.detail.at(cluster.bounds.centre - eye_, levelShare_) == Containment::Outside)
        return;
    for (std::uint32_t i = 0; i < cluster.childCount; ++i) {
        const Cluster& child = clusters_.clusters[cluster.firstChild + i];
        if (occluders_.hide(sphereOf(child.bounds)))
            counts_.hidden += child.end - child.first;
        else
            drawUnhidden(child);
    }
    if (cluster.childCount > 0)
        return;
    for (std::uint32_t position = cluster.first; position < cluster.end; ++position) {
        if (!inRange_.isInRange(position))
            continue;
        if (occluders_.hideAt(position))
            ++counts_.hidden;
        else
            draw(position, true, Turn::Before);
    }
}

void Selection::descend(const Cluster& cluster, std::size_t firstActive) {
    if (cluster.detail.at(cluster.bounds.centre - eye_, levelShare_) == Containment::Outside)
        return;
    const SeenSphere sphere = sphereOf(cluster.bounds);
    const std::size_t endActive = active_.size();
    for (std::size_t i = firstActive; i < endActive; ++i) {
        const SpaceTest& test = tests_[active_[i]];
        const Containment here = testCluster(test, sphere);
        if (here != Containment::Outside && test.visit == 0 && occluders_.hide(sphere)) {
            counts_.hidden += cluster.end - cluster.first;
            continue;
        }
        const bool isOfRoot = hasTurns_ && test.visit == 0;
        if (here == Containment::Inside && !(isOfRoot && othersReach(i + 1, endActive, sphere))) {
            if (test.visit == 0 && occluders_.areReady())
                drawUnhidden(cluster);
            else
                drawInRange(cluster, turnOf(test.visit));
            active_.resize(endActive);
            return;
        }
        if (here != Containment::Outside)
            active_.push_back(active_[i]);
    }
    if (active_.size() > endActive) {
        if (cluster.childCount == 0)
            selectLeaf(cluster, endActive);
        // Prefetch the grandchildren while the children are tested.
        for (std::uint32_t i = 0; i < cluster.childCount; ++i) {
            const Cluster& child = clusters_.clusters[cluster.firstChild + i];
            for (std::uint32_t j = 0; j < child.childCount; ++j)
                prefetch(clusters_.clusters[child.firstChild + j]);
        }
        for (std::uint32_t i = 0; i < cluster.childCount; ++i)
            descend(clusters_.clusters[cluster.firstChild + i], endActive);
    }
    active_.resize(endActive);
}

bool Selection::othersReach(std::size_t begin, std::size_t end, const SeenSphere& sphere) {
    return active_.size() > end ||
           std::any_of(active_.begin() + static_cast<std::ptrdiff_t>(begin),
                       active_.begin() + static_cast<std::ptrdiff_t>(end), [&](std::uint32_t test) {
                           return testCluster(tests_[test], sphere) != Containment::Outside;
                       });
}

Selection::Showing Selection::showingOf(std::uint32_t position, std::size_t firstActive) {
    const SeenSphere sphere = sphereOf(clusters_.bounds[position]);
    Containment best = Containment::Outside;
    for (std::size_t i = firstActive; i < active_.size() && best != Containment::Inside; ++i)
        best = std::max(best, testStatic(tests_[active_[i]], position, sphere));
    return {best, Turn::After};
}

// An instance that other visits show, too, takes their test, unless one of them shows it all.
Selection::Showing Selection::showingBesideRoot(std::uint32_t position, std::size_t firstActive) {
    const SeenSphere sphere = sphereOf(clusters_.bounds[position]);
    bool inRoot = false, inOthers = false;
    for (std::size_t i = firstActive; i < active_.size(); ++i) {
        const SpaceTest& test = tests_[active_[i]];
        if (test.visit == 0) {
            inRoot = testInRoot(test, position, sphere) != Containment::Outside;
            continue;
        }
        const Containment here = testStatic(test, position, sphere);
        if (here == Containment::Inside)
            return {here, Turn::After};
        inOthers = inOthers || here != Containment::Outside;
    }
    if (inOthers)
        return {Containment::Partial, inRoot ? Turn::Both : Turn::After};
    return {inRoot ? Containment::Inside : Containment::Outside, Turn::Before};
}

void Selection::selectLeaf(const Cluster& leaf, std::size_t firstActive) {
    for (std::uint32_t position = leaf.first; position < leaf.end; ++position) {
        if (!inRange_.isInRange(position))
            continue;
        const Showing showing =
            hasTurns_ ? showingBesideRoot(position, firstActive) : showingOf(position, firstActive);
        if (showing.best != Containment::Outside)
            draw(position, showing.best == Containment::Inside, showing.turn);
    }
}

void Selection::draw(const PositionRange& range, bool inside, Turn turn, bool inRange) {
    const auto [first, end] = range;
    const bool gated = hasSeveralVisits_ && !inside;
    counts_.drawn += end - first;
    counts_.ungated += gated ? 0 : end - first;
    SelectedRange* const last = ranges_.empty() ? nullptr : &ranges_.back();
    if (last != nullptr && last->end == first && last->gated == gated && last->zone == zone_ &&
        last->inRange == inRange && (last->turn == turn || !hasTurns_))
        last->end = end;
    else
        ranges_.push_back({first, end, gated, inRange, turn, zone_});
}

bool Selection::testShared(const SpaceTest& test, const Sphere& bounds, SharedResult& result) {
    const bool isFirst = result.frame != frameNumber_;
    if (isFirst)
        result = {frameNumber_, Containment::Outside};
    if (result.seen != Containment::Inside && (isFirst || testsEveryVisit_))
        result.seen = std::max(result.seen, testInstance(test, sphereOf(bounds)));
    return isFirst;
}

void Selection::selectListed(const SpaceTest& test, const world::DynamicState& dynamics) {
    for (const std::uint32_t position : clusters_.sharedIn(test.space)) {
        const std::uint32_t number = position - clusters_.firstShared;
        if (testShared(test, clusters_.bounds[position], sharedResults_[number]))
            sharedTested_.push_back(number);
    }
    if (!hasSeveralVisits_ && !occluders_.areReady()) {
        selectBatches(test, dynamics);
        return;
    }
    const world::DynamicState::Run run = dynamics.listedIn(test.space);
    selectOneByOne(test, dynamics, run.first, run.end);
}

void Selection::selectOneByOne(const SpaceTest& test, const world::DynamicState& dynamics,
                               std::uint32_t first, std::uint32_t end) {
    const world::ListedInstances& listed = dynamics.listed;
    for (std::uint32_t at = first; at < end; ++at) {
        if (listed.isListedAgain[at] != 0) {
            testSharedDynamic(test, dynamics, at);
        } else if (test.isFirst) {
            ++counts_.tested;
            const SeenSphere sphere = sphereOf(dynamics.instances[listed.instance[at]].bounds);
            Containment best = testInstance(test, sphere);
            for (std::uint32_t i = test.next; i != world::kNone && best != Containment::Inside;
                 i = tests_[i].next)
                best = std::max(best, testInstance(tests_[i], sphere));
            if (best != Containment::Outside)
                drawDynamic(at, best == Containment::Inside);
        }
    }
}

// With a single visit a space has one test.
void Selection::selectBatches(const SpaceTest& test, const world::DynamicState& dynamics) {
    const world::ListedInstances& listed = dynamics.listed;
    const auto [first, end] = dynamics.listedIn(test.space);
    const Vec3 eye = eye_ - listed.origin;
    const bool areFar = listed.areFar || glm::length(eye) > visibility::SphereBatch::kMostOffset;
    for (std::uint32_t at = first; at < end; at += kSpheresAtOnce) {
        const std::uint32_t next = std::min(at + kSpheresAtOnce, end);
        const bool areListedOnce =
            !listed.anyListedAgain ||
            std::none_of(listed.isListedAgain.begin() + at, listed.isListedAgain.begin() + next,
                         [](std::uint8_t again) { return again != 0; });
        const std::uint32_t found =
            areFar || !areListedOnce
                ? visibility::Viewcones::kUndecided
                : cones_.listWithin({&listed.x[at], &listed.y[at], &listed.z[at], &listed.radius[at]}, eye,
                                    test.isNarrow ? &test.rect : nullptr, at, next - at,
                                    &dynamic_[dynamicCount_]);
        if (found == visibility::Viewcones::kUndecided) {
            selectOneByOne(test, dynamics, at, next);
        } else {
            dynamicCount_ += found;
            counts_.tested += next - at;
            counts_.boundsTested += next - at;
            counts_.drawn += found;
            counts_.ungated += found;
        }
    }
}

void Selection::testSharedDynamic(const SpaceTest& test, const world::DynamicState& dynamics,
                                  std::uint32_t at) {
    const world::InstanceIndex number = dynamics.listed.instance[at];
    if (testShared(test, dynamics.instances[number].bounds, dynamicResults_[number]))
        dynamicTested_.push_back(at);
}

void Selection::drawDynamic(std::uint32_t at, bool inside) {
    const bool gated = hasSeveralVisits_ && !inside;
    ++counts_.drawn;
    counts_.ungated += gated ? 0 : 1;
    dynamic_[dynamicCount_++] = at | (gated ? gpu::kGated : 0);
}

void Selection::finishListed(const world::DynamicState& dynamics) {
    counts_.tested += static_cast<std::uint32_t>(sharedTested_.size() + dynamicTested_.size());
    std::sort(sharedTested_.begin(), sharedTested_.end());
    for (const std::uint32_t number : sharedTested_) {
        const Containment seen = sharedResults_[number].seen;
        const std::uint32_t position = clusters_.firstShared + number;
        // A member of several zones always takes the test, because the zone of each fragment also selects its light.
        if (seen != Containment::Outside && inRange_.isInRange(position))
            draw(position, seen == Containment::Inside && clusters_.sharedIsInOneZone[number] != 0,
                 Turn::After);
    }
    const std::vector<world::InstanceIndex>& instance = dynamics.listed.instance;
    for (const std::uint32_t at : dynamicTested_) {
        const world::InstanceIndex number = instance[at];
        if (const Containment seen = dynamicResults_[number].seen; seen != Containment::Outside) {
            drawDynamic(at, seen == Containment::Inside &&
                                isInOneZone(world_, dynamics.instances[number], dynamics.members));
        }
    }
    const auto isBefore = [&instance](SelectedDynamic a, SelectedDynamic b) {
        return instance[a & ~gpu::kGated] < instance[b & ~gpu::kGated];
    };
    const auto drawn = std::span(dynamic_).first(dynamicCount_);
    const bool areOfOneRun = tests_.size() == 1 && dynamicTested_.empty();
    if (!areOfOneRun && !std::is_sorted(drawn.begin(), drawn.end(), isBefore))
        std::sort(drawn.begin(), drawn.end(), isBefore);
}

} // namespace limen::frame
