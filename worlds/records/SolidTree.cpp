#include "worlds/records/SolidTree.h"
#include "worlds/records/Carve.h"

namespace limen::worlds {

namespace {

struct Piece {
    Polygon points;
    Plane plane;
};

bool sameWay(const Plane& a, const Plane& b) {
    return glm::dot(a.n, b.n) > 0.0;
}

/// The other pieces in front of and behind the plane of one. A piece in the plane is dropped if it faces the same way; else
/// it bounds the region behind.
struct Parting {
    std::vector<Piece> front, back;
};

bool inPlane(const Piece& piece, const Plane& plane) {
    constexpr double kInCutPlane = 1e-3;
    return std::all_of(piece.points.begin(), piece.points.end(),
                       [&](const Vec3& p) { return std::abs(plane.signedDistance(p)) <= kInCutPlane; });
}

/// Metres. What is thinner bounds nothing.
constexpr double kSliverDepth = 0.005;

/// True for a strip. Rounded corners turn its plane so far that points far outside would be in front of it.
bool isStrip(const Polygon& points) {
    double longest = 0.0;
    for (const Vec3& a : points)
        for (const Vec3& b : points)
            longest = std::max(longest, glm::length(a - b));
    return areaOf(points) < kSliverDepth * longest;
}

/// False for slivers: rounded corners bend the faces of a convex solid. A sliver bounds nothing, and a
/// subtree behind it would contain points far outside.
bool isDeepBehind(const Polygon& piece, const Plane& plane) {
    return std::any_of(piece.begin(), piece.end(),
                       [&](const Vec3& p) { return plane.signedDistance(p) < -kSliverDepth; });
}

Parting part(const std::vector<Piece>& pieces, const Piece& by) {
    Parting out;
    const Plane& plane = by.plane;
    for (const Piece& piece : pieces) {
        if (&piece == &by) // a bent one may be off its own plane
            continue;
        if (inPlane(piece, plane)) {
            if (!sameWay(piece.plane, plane))
                out.back.push_back(piece);
            continue;
        }
        Halves halves = splitPolygon(piece.points, plane);
        if (!halves.front.empty())
            out.front.push_back({std::move(halves.front), piece.plane});
        if (isDeepBehind(halves.back, plane))
            out.back.push_back({std::move(halves.back), piece.plane});
    }
    return out;
}

class SolidTreeBuilder {
public:
    explicit SolidTreeBuilder(const Vec3& middle) : middle_(middle) {}

    dat::BspTree build(const std::vector<Piece>& pieces) {
        node(pieces);
        return std::move(tree_);
    }

private:
    /// Chooses planes with nothing behind them first: these form the chain.
    std::int32_t node(const std::vector<Piece>& pieces) {
        const auto index = static_cast<std::int32_t>(tree_.nodes.size());
        tree_.nodes.emplace_back();
        if (pieces.empty())
            return index;
        Parting best;
        std::size_t chosen = pieces.size();
        bool keepsMiddle = false;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            Parting parting = part(pieces, pieces[i]);
            const bool keeps = pieces[i].plane.signedDistance(middle_) >= 0.0;
            if (chosen == pieces.size() || (keeps && !keepsMiddle) ||
                (keeps == keepsMiddle && parting.back.size() < best.back.size())) {
                best = std::move(parting);
                chosen = i;
                keepsMiddle = keeps;
            }
            if (best.back.empty())
                break;
        }
        const Plane plane = pieces[chosen].plane;
        dat::BspNode n;
        n.tag = best.back.empty() ? dat::BspTag::BPIn : dat::BspTag::BPIN;
        n.plane = {Vec3f(plane.n), static_cast<float>(plane.d)};
        n.positive = node(best.front);
        if (!best.back.empty())
            n.negative = node(best.back);
        tree_.nodes[static_cast<std::size_t>(index)] = std::move(n);
        return index;
    }

    Vec3 middle_;
    dat::BspTree tree_;
};

} // namespace

dat::BspTree buildSolidCellBsp(const std::vector<Face>& faces, const Vec3& middle) {
    std::vector<Piece> pieces;
    for (const Face& face : faces)
        if (!isStrip(face.points))
            pieces.push_back({face.points, planeOf(face.points)});
    return SolidTreeBuilder(middle).build(pieces);
}

} // namespace limen::worlds
