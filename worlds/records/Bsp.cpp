#include "worlds/records/Bsp.h"

#include "core/Assert.h"
#include "geometry/ConvexPolygon.h"

namespace limen::worlds {

namespace {

/// Metres: a fragment of a wall within this of a splitting plane is in the plane. Used by this builder alone.
constexpr double kInSplitPlane = 1e-3;
/// How many faces are tried as the next splitting plane.
constexpr std::size_t kCandidates = 24;

struct Fragment {
    std::vector<Vec3> points;
    Plane plane;
    std::uint16_t polygon = 0;
    std::int32_t portal = -1;
    bool attached = false; ///< a node above already splits by its plane; it goes down to a leaf unsplit
};

enum class Where { Front, Back, Across, InPlane };

Where classify(const Fragment& f, const Plane& plane) {
    bool front = false;
    bool back = false;
    for (const Vec3& p : f.points) {
        const double d = plane.signedDistance(p);
        front = front || d > kInSplitPlane;
        back = back || d < -kInSplitPlane;
    }
    return front && back ? Where::Across : front ? Where::Front : back ? Where::Back : Where::InPlane;
}

dat::SphereF sphereOf(const std::vector<Fragment>& fragments) {
    std::vector<Vec3> points;
    for (const Fragment& f : fragments)
        points.insert(points.end(), f.points.begin(), f.points.end());
    const Sphere s = boundingSphere(points);
    return {Vec3f(s.centre), points.empty() ? 0.0f : static_cast<float>(s.radius)};
}

dat::PlaneF toRecord(const Plane& plane) {
    return {Vec3f(plane.n), static_cast<float>(plane.d)};
}

/// Prefers few cuts, then equal numbers on both sides.
std::size_t chooseSplitter(const std::vector<Fragment>& fragments) {
    std::vector<std::size_t> candidates;
    for (std::size_t i = 0; i < fragments.size(); ++i)
        if (!fragments[i].attached)
            candidates.push_back(i);
    const std::size_t step = std::max<std::size_t>(1, candidates.size() / kCandidates);
    std::size_t best = candidates.front();
    long bestCost = -1;
    for (std::size_t c = 0; c < candidates.size(); c += step) {
        long front = 0;
        long back = 0;
        long across = 0;
        for (const Fragment& f : fragments) {
            const Where where = classify(f, fragments[candidates[c]].plane);
            front += where == Where::Front;
            back += where == Where::Back;
            across += where == Where::Across;
        }
        const long cost = 4 * across + std::abs(front - back);
        if (bestCost < 0 || cost < bestCost) {
            bestCost = cost;
            best = candidates[c];
        }
    }
    return best;
}

struct Split {
    std::vector<Fragment> front, back, inPlane;
};

/// Splits by the plane of one fragment. That fragment counts as in the plane even if it is bent; otherwise it
/// would be cut again at every level.
Split splitBy(std::size_t splitter, std::vector<Fragment>&& fragments) {
    const Plane plane = fragments[splitter].plane;
    Split out;
    std::vector<Vec3> part;
    for (std::size_t i = 0; i < fragments.size(); ++i) {
        Fragment& f = fragments[i];
        switch (i == splitter ? Where::InPlane : classify(f, plane)) {
        case Where::Front:
            out.front.push_back(std::move(f));
            break;
        case Where::Back:
            out.back.push_back(std::move(f));
            break;
        case Where::InPlane:
            out.inPlane.push_back(std::move(f));
            break;
        case Where::Across: {
            Fragment other = f;
            clipPolygon(f.points, plane, 0.0, part);
            other.points = part;
            clipPolygon(f.points, plane.flipped(), 0.0, part);
            f.points = part;
            if (other.points.size() >= 3)
                out.front.push_back(std::move(other));
            if (f.points.size() >= 3)
                out.back.push_back(std::move(f));
        }
        }
    }
    return out;
}

std::vector<Fragment> fragmentsOf(std::span<const Face> faces) {
    std::vector<Fragment> out;
    std::int32_t portal = 0;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        Fragment f;
        f.points = faces[i].points;
        f.plane = planeOf(f.points);
        f.polygon = static_cast<std::uint16_t>(i);
        f.portal = faces[i].portal ? portal++ : -1;
        out.push_back(std::move(f));
    }
    return out;
}

template <class Ids>
void addOnce(Ids& ids, std::uint16_t id) {
    if (std::find(ids.begin(), ids.end(), id) == ids.end())
        ids.push_back(id);
}

class DrawingBuilder {
public:
    dat::BspTree build(std::vector<Fragment> fragments) {
        node(std::move(fragments));
        return std::move(tree_);
    }

private:
    std::int32_t node(std::vector<Fragment> fragments) {
        const auto index = static_cast<std::int32_t>(tree_.nodes.size());
        tree_.nodes.emplace_back();
        if (fragments.empty()) {
            tree_.nodes.back().leafIndex = leaves_++;
            return index;
        }
        dat::BspNode n;
        n.tag = dat::BspTag::BPIN;
        n.sphere = sphereOf(fragments);
        const std::size_t splitter = chooseSplitter(fragments);
        n.plane = toRecord(fragments[splitter].plane);
        Split split = splitBy(splitter, std::move(fragments));
        for (const Fragment& f : split.inPlane) {
            if (f.portal < 0) {
                addOnce(n.polygonIds, f.polygon);
                continue;
            }
            n.tag = dat::BspTag::Port;
            const dat::PortalRef ref{f.polygon, static_cast<std::uint16_t>(f.portal)};
            if (std::none_of(n.portals.begin(), n.portals.end(),
                             [&](const auto& p) { return p.polygonId == ref.polygonId; }))
                n.portals.push_back(ref);
        }
        n.positive = node(std::move(split.front));
        n.negative = node(std::move(split.back));
        tree_.nodes[static_cast<std::size_t>(index)] = std::move(n);
        return index;
    }

    dat::BspTree tree_;
    std::int32_t leaves_ = 0;
};

class PhysicsBuilder {
public:
    dat::BspTree build(std::vector<Fragment> fragments) {
        node(std::move(fragments), false);
        return std::move(tree_);
    }

private:
    std::int32_t node(std::vector<Fragment> fragments, bool behind) {
        const auto index = static_cast<std::int32_t>(tree_.nodes.size());
        tree_.nodes.emplace_back();
        dat::BspNode n;
        n.sphere = sphereOf(fragments);
        if (std::all_of(fragments.begin(), fragments.end(), [](const Fragment& f) { return f.attached; })) {
            n.leafIndex = leaves_++;
            n.solid = behind && fragments.empty() ? 1 : 0;
            for (const Fragment& f : fragments)
                addOnce(n.polygonIds, f.polygon);
        } else {
            const std::size_t splitter = chooseSplitter(fragments);
            const Plane plane = fragments[splitter].plane;
            n.tag = dat::BspTag::BPIN;
            n.plane = toRecord(plane);
            Split split = splitBy(splitter, std::move(fragments));
            for (Fragment& f : split.inPlane) {
                f.attached = true;
                (glm::dot(f.plane.n, plane.n) >= 0.0 ? split.front : split.back).push_back(std::move(f));
            }
            n.positive = node(std::move(split.front), false);
            n.negative = node(std::move(split.back), true);
        }
        tree_.nodes[static_cast<std::size_t>(index)] = std::move(n);
        return index;
    }

    dat::BspTree tree_;
    std::int32_t leaves_ = 0;
};

} // namespace

dat::BspTree buildDrawingBsp(std::span<const Face> faces) {
    return DrawingBuilder().build(fragmentsOf(faces));
}

dat::BspTree buildPhysicsBsp(std::span<const Face> faces, std::span<const std::uint16_t> ids) {
    LIMEN_ASSERT(faces.size() == ids.size(), "one id per face");
    std::vector<Fragment> fragments = fragmentsOf(faces);
    for (Fragment& f : fragments)
        f.polygon = ids[f.polygon];
    return PhysicsBuilder().build(std::move(fragments));
}

dat::BspTree buildCellBsp(std::span<const Face> faces) {
    std::vector<Plane> planes;
    for (const Face& face : faces) {
        const Plane plane = planeOf(face.points);
        const bool known = std::any_of(planes.begin(), planes.end(), [&](const Plane& p) {
            return glm::dot(p.n, plane.n) > 1.0 - 1e-9 && std::abs(p.d - plane.d) < kInSplitPlane;
        });
        // Parts of the cell are behind a face of a recess.
        const bool outermost = std::all_of(faces.begin(), faces.end(), [&](const Face& other) {
            return std::all_of(other.points.begin(), other.points.end(),
                               [&](const Vec3& p) { return plane.signedDistance(p) > -kInSplitPlane; });
        });
        if (!known && outermost)
            planes.push_back(plane);
    }
    dat::BspTree tree;
    for (const Plane& plane : planes) {
        dat::BspNode n;
        n.tag = dat::BspTag::BPIn;
        n.plane = toRecord(plane);
        n.positive = static_cast<std::int32_t>(tree.nodes.size()) + 1;
        tree.nodes.push_back(std::move(n));
    }
    tree.nodes.emplace_back();
    return tree;
}

std::uint32_t leafCount(const dat::BspTree& tree) {
    return static_cast<std::uint32_t>(
        std::count_if(tree.nodes.begin(), tree.nodes.end(),
                      [](const dat::BspNode& n) { return n.tag == dat::BspTag::Leaf; }));
}

} // namespace limen::worlds
