#include "visibility/Flood.h"

#include "visibility/Admission.h"
#include "visibility/CellFlood.h"
#include "visibility/EyeSpace.h"
#include "visibility/Region.h"
#include "visibility/SiblingOrder.h"

#include <algorithm>
#include <string>

namespace limen::visibility {

/// Buffers, kept between floods for their capacity.
struct FloodScratch::Data {
    ScreenOpenings openings;
    CellFlood cells;
    SiblingOrder order;
    CandidateList pending;  ///< a stack: the top is the next visit in drawing order
    CandidateList children; ///< of the current visit
    Admission::Scratch admission;
    std::vector<std::uint32_t> nodes;
};

FloodScratch::FloodScratch() : data_(std::make_unique<Data>()) {}
FloodScratch::~FloodScratch() = default;
FloodScratch::FloodScratch(FloodScratch&&) noexcept = default;
FloodScratch& FloodScratch::operator=(FloodScratch&&) noexcept = default;

namespace {

/// The depth-first traversal over the visits of one flood.
template <bool kTraced>
class VisitTraversal {
public:
    VisitTraversal(const FloodInput& input, double smallest, FloodScratch::Data& scratch, VisibleSet& out)
        : in_(input), admission_(input, smallest, scratch.openings, scratch.admission, out), s_(scratch),
          out_(out) {}

    /// False if more than `maxVisits` visits are needed; `out` is then incomplete.
    bool run(std::uint32_t maxVisits) {
        addRoot();
        visitSpaces(0);
        while (!s_.pending.items.empty()) {
            if (out_.visits.size() + s_.pending.items.size() > maxVisits) // each item becomes a visit
                return false;
            const std::uint32_t next = popPending();
            if (!out_.visits[next].hole)
                visitSpaces(next);
        }
        return true;
    }

private:
    void addRoot() {
        Visit root;
        root.space = spaceOfEye(in_.graph, in_.view.eye, in_.view.root);
        root.zone = in_.graph.spaces()[root.space].zone;
        root.vertexCount = 4;
        root.inPlane =
            true; // all rays begin at the eye: the in-plane rule applies to the portals out of this space
        out_.visits.push_back(root);
        out_.regionVertices.insert(out_.regionVertices.end(),
                                   {{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}});
        admission_.summarise(0, boundsOf(out_.region(root)));
    }

    std::uint32_t popPending() {
        const Candidate c = s_.pending.items.back();
        const Graph::Portal& portal = in_.graph.portals()[c.portal];
        Visit visit;
        visit.space = c.hole ? kNone : portal.destination;
        visit.zone = c.hole ? kNoZone : in_.graph.spaces()[portal.destination].zone;
        visit.parent = c.parent;
        visit.portal = c.portal;
        visit.entryPlane = c.entryPlane;
        visit.firstVertex = static_cast<std::uint32_t>(out_.regionVertices.size());
        visit.vertexCount = c.vertexCount;
        visit.depth = out_.visits[c.parent].depth + 1;
        visit.inPlane = c.inPlane;
        visit.hole = c.hole;
        visit.shut = c.shut;
        visit.narrowed = c.narrowed;
        visit.split = c.split;
        const auto region = s_.pending.region(c);
        out_.regionVertices.insert(out_.regionVertices.end(), region.begin(), region.end());
        s_.pending.vertices.resize(c.firstVertex);
        s_.pending.items.pop_back();
        out_.visits.push_back(visit);
        admission_.summarise(static_cast<std::uint32_t>(out_.visits.size() - 1), c.rect);
        note<kTraced>(in_.trace, c.parent, c.portal, fateOf(c, portal));
        return static_cast<std::uint32_t>(out_.visits.size() - 1);
    }

    /// The fate of a portal whose candidate has become a visit or a hole.
    static PortalFate fateOf(const Candidate& c, const Graph::Portal& portal) {
        if (!c.hole)
            return PortalFate::Admitted;
        if (c.shut)
            return PortalFate::Shut;
        return portal.destination == kNone ? PortalFate::LeadsNowhere : PortalFate::PairMissed;
    }

    /// Floods the visit's zone and pushes the openings out of it, so that the farthest is on top.
    void visitSpaces(std::uint32_t index) {
        const Visit visit = out_.visits[index];
        const std::size_t firstSeen = out_.seen.size();
        s_.cells.run({index, visit.space, s_.admission.summaries[index].rect, in_.trace}, in_.graph,
                     s_.openings, out_.seen, out_.counts);
        s_.children.clear();
        for (std::size_t i = firstSeen; i < out_.seen.size(); ++i)
            openingsOf(index, out_.seen[i]);
        if (in_.rules.siblingOrder)
            sortChildren(index);
        for (std::size_t i = s_.children.items.size(); i-- > 0;) {
            const Candidate& c = s_.children.items[i];
            s_.pending.add(c, s_.children.region(c));
        }
    }

    void sortChildren(std::uint32_t visit) {
        if constexpr (!kTraced) {
            s_.order.sort(s_.children, out_.counts);
        } else {
            const std::vector<Candidate> before = s_.children.items;
            s_.order.sort(s_.children, out_.counts);
            const std::vector<Candidate>& kept = s_.children.items;
            for (const Candidate& c : before)
                if (std::none_of(kept.begin(), kept.end(),
                                 [&](const auto& k) { return k.portal == c.portal; }))
                    note<kTraced>(in_.trace, visit, c.portal, PortalFate::Covered);
        }
    }

    /// Traces the portals below a node that no ray of the visit meets.
    void noteUnseen(std::uint32_t visit, const Graph::BoundsNode& node) {
        if (node.child == kNone) {
            note<kTraced>(in_.trace, visit, node.portal, admission_.whyUnseen(visit, node.portal));
            return;
        }
        for (const std::uint32_t child : {node.child, node.child + 1})
            noteUnseen(visit, in_.graph.boundsNodes()[child]);
    }

    void openingsOf(std::uint32_t visit, const SeenSpace& seen) {
        const Graph::Space& space = in_.graph.spaces()[seen.space];
        if constexpr (!kTraced) {
            const ScreenOpenings::Space& known = s_.openings.of(seen.space);
            for (const ScreenOpenings::Exit& exit : s_.openings.exits(known))
                admission_.template admit<kTraced>(visit, exit.portal, &exit, s_.children);
            if (space.root == kNone || !known.hasExits)
                return;
        } else if (space.root == kNone) {
            for (std::uint32_t p = space.firstPortal; p < space.firstPortal + space.portalCount; ++p)
                admission_.template admit<kTraced>(visit, p, nullptr, s_.children);
            return;
        }
        s_.nodes.assign(1, space.root);
        while (!s_.nodes.empty()) {
            const Graph::BoundsNode& node = in_.graph.boundsNodes()[s_.nodes.back()];
            s_.nodes.pop_back();
            if (!mayBeSeen(visit, node.box)) {
                if constexpr (kTraced)
                    noteUnseen(visit, node);
                continue;
            }
            if (node.child == kNone) {
                admission_.template admit<kTraced>(visit, node.portal, nullptr, s_.children);
            } else {
                s_.nodes.push_back(node.child);
                s_.nodes.push_back(node.child + 1);
            }
        }
    }

    /// False only if the box is outside one edge of the visit's region, or before its entry plane.
    [[nodiscard]] bool mayBeSeen(std::uint32_t index, const Aabb& box) const {
        const Visit& visit = out_.visits[index];
        const Vec3 centre = box.centre() - in_.view.eye;
        const Vec3 half = (box.max - box.min) * 0.5;
        const auto behind = [&](const Vec3& n, double d) {
            return glm::dot(n, centre) + d + glm::dot(glm::abs(n), half) < 0.0;
        };
        if (behind(visit.entryPlane.n, visit.entryPlane.d + kBeyondEntry))
            return false;
        const auto region = out_.region(visit);
        const Mat3 eyeFromScreenNormal = glm::transpose(in_.screen);
        for (std::size_t i = 0; i < region.size(); ++i) {
            const Vec3 edge = glm::cross(region[i], region[i + 1 == region.size() ? 0 : i + 1]);
            if (behind(eyeFromScreenNormal * edge, 0.0))
                return false;
        }
        return true;
    }

    const FloodInput& in_;
    Admission admission_;
    FloodScratch::Data& s_;
    VisibleSet& out_;
};

/// Deviation of a view's axes from orthonormal, as a sum over their dot products, that counts as rounding.
constexpr double kAxisTolerance = 1e-6;

bool isOrthonormal(const View& view) {
    const auto deviation = [](const Vec3& a, const Vec3& b, double expected) {
        return std::abs(glm::dot(a, b) - expected);
    };
    const Vec3 &right = view.right, &up = view.up, &forward = view.forward;
    const double sum = deviation(right, right, 1.0) + deviation(up, up, 1.0) +
                       deviation(forward, forward, 1.0) + deviation(right, up, 0.0) +
                       deviation(up, forward, 0.0) + deviation(forward, right, 0.0);
    return sum <= kAxisTolerance; // false for NaN
}

bool isTangent(double value) {
    return value > 0.0 && std::isfinite(value);
}

Result<void> checkInput(const Graph& graph, std::span<const std::uint8_t> closed, const View& view) {
    const auto refuse = [](std::string why) {
        return fail(ErrorCode::BadArgument, "view of a flood", std::move(why));
    };
    if (view.root >= graph.spaces().size())
        return refuse("root " + std::to_string(view.root) + " is not one of the " +
                      std::to_string(graph.spaces().size()) + " spaces");
    if (!isFinite(view.eye))
        return refuse("the eye is not finite");
    if (!isOrthonormal(view))
        return refuse("right, up and forward are not orthonormal");
    if (!isTangent(view.tanHalfX) || !isTangent(view.tanHalfY)) {
        return refuse("tangents of half the field of view must be positive and finite: " +
                      std::to_string(view.tanHalfX) + ", " + std::to_string(view.tanHalfY));
    }
    if (!closed.empty() && closed.size() != graph.portals().size()) {
        return refuse("there are " + std::to_string(closed.size()) + " states for " +
                      std::to_string(graph.portals().size()) + " portals");
    }
    return {};
}

} // namespace

Result<void> flood(const Graph& graph, std::span<const std::uint8_t> closed, const View& view,
                   const Limits& limits, FloodScratch& scratch, VisibleSet& out, FloodTrace* trace) {
    if (Result<void> checked = checkInput(graph, closed, view); !checked) {
        out.clear();
        return checked;
    }
    const Mat3 screen = view.screenFromEye();
    const FloodInput input{graph, closed, view, limits.rules, screen, glm::inverse(glm::transpose(screen)),
                           trace};
    scratch.data().openings.begin({&graph, closed, view.eye, screen, trace != nullptr});
    const std::uint32_t most = std::max(limits.maxVisits, 1u);
    const auto isWhole = [&](double smallest) {
        out.clear();
        scratch.data().pending.clear();
        if (trace == nullptr)
            return VisitTraversal<false>(input, smallest, scratch.data(), out).run(most);
        trace->clear();
        return VisitTraversal<true>(input, smallest, scratch.data(), out).run(most);
    };
    // If the visits exceed the budget, the smallest openings are left out, with a growing limit until the
    // rest fits. Regions shrink along a chain, so the rest is a tree, and has the largest regions.
    for (double smallest = 0.0; !isWhole(smallest);)
        smallest = smallest == 0.0 ? 1e-7 : smallest * 4.0;
    return {};
}

} // namespace limen::visibility
