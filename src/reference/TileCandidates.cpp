#include "reference/TileCandidates.h"

#include "core/Assert.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace limen::reference {
namespace {

/// Triangles for each pixel that a body may cover; with more, each ray searches the body by itself. Measured:
/// the walk of a ray costs about as much as testing this many triangles against the whole tile.
constexpr std::size_t kFewTriangles = 8;

constexpr auto isFarther = [](const auto& a, const auto& b) { return a.least > b.least; };

} // namespace

void TileSurfaces::begin(const SceneData& scene, const Pyramid& pyramid, const world::RangeSteps& eye,
                         world::SpaceIndex space, SurfaceKind kind) {
    pyramid_ = &pyramid;
    eye_ = eye;
    kind_ = kind;
    lists_.clear();
    pending_.clear();
    found_.clear();
    bits_.clear();
    scene.forLists(space, [&](const Bodies& bodies, const BodyLists::ListPair& lists) {
        const BodyLists::List& list = kind == SurfaceKind::Solid ? lists.solid : lists.blended;
        if (list.empty())
            return;
        const auto index = static_cast<std::uint16_t>(lists_.size());
        lists_.push_back({&bodies, &list, kind == SurfaceKind::Blended && &bodies == &scene.moving});
        open(list.tree, {.list = index});
    });
}

bool TileSurfaces::gather(double farthest) {
    const std::size_t before = found_.size();
    while (found_.size() == before) {
        if (pending_.empty() || static_cast<double>(pending_.front().least) > farthest)
            return false;
        std::pop_heap(pending_.begin(), pending_.end(), isFarther);
        const Pending next = pending_.back();
        pending_.pop_back();
        if (next.set)
            next.count > 0 ? find(next) : open(next.set->tree(), next);
        else if (next.count == 0)
            open(lists_[next.list].list->tree, next);
        else
            for (std::uint32_t i = next.child; i < next.child + next.count; ++i)
                openBody(next, lists_[next.list].list->bodies[i]);
    }
    return true;
}

void TileSurfaces::open(const Hierarchy& tree, const Pending& node) {
    if (tree.empty())
        return;
    tree.open(
        node.child, [&](const auto& sides, auto& least) { return pyramid_->meetsBoxes(sides, least); },
        [&](std::uint32_t child, std::uint32_t count, float least) {
            Pending part = node;
            part.child = child;
            part.count = count;
            if (!lists_[node.list].isEager)
                part.least = std::max(node.least,
                                      least); // both are bounds, and a child is never nearer than its parent
            pending_.push_back(part);
            std::push_heap(pending_.begin(), pending_.end(), isFarther);
        });
}

void TileSurfaces::openBody(const Pending& leaf, std::uint32_t body) {
    const Bodies& bodies = *lists_[leaf.list].bodies;
    if (!bodies.isInLevelRange(body, eye_))
        return;
    const Surfaces& surfaces = bodies.surfacesOf(body);
    Pending root;
    root.least = leaf.least;
    root.list = leaf.list;
    root.isFilling = bodies.isFilling(body);
    root.set = kind_ == SurfaceKind::Solid ? &surfaces.solid : &surfaces.blended;
    const std::size_t triangles = root.set->triangles().size();
    if (triangles > kFewTriangles) {
        const PixelMask pixels = pyramid_->pixelsOf(root.set->box());
        if (triangles > kFewTriangles * static_cast<std::size_t>(std::popcount(pixels))) {
            if (pixels != 0)
                add({root.least, root.isFilling, root.least, std::numeric_limits<double>::infinity(),
                     root.set},
                    pixels);
            return;
        }
    }
    open(root.set->tree(), root);
}

void TileSurfaces::find(const Pending& leaf) {
    for (const Triangle& triangle : leaf.set->triangles().subspan(leaf.child, leaf.count)) {
        const Pyramid::Cover cover = pyramid_->coverOf(triangle);
        if (cover.pixels != 0)
            add({leaf.least, leaf.isFilling, cover.least, cover.most, leaf.set, &triangle}, cover.pixels);
    }
}

void TileSurfaces::add(const Found& found, PixelMask pixels) {
    const std::size_t bit = found_.size() % kBlock;
    if (bit == 0)
        bits_.emplace_back();
    found_.push_back(found);
    for (; pixels != 0; pixels &= pixels - 1)
        bits_.back()[static_cast<std::size_t>(__builtin_ctzll(pixels))] |= std::uint64_t{1} << bit;
}

void TileCandidates::begin(const Tile& tile) {
    pyramid_.emplace(tile, scene_.origin);
    eye_ = world::rangeStepsOf(tile.camera.eye);
    used_ = 0;
}

TileCandidates::Space& TileCandidates::in(world::SpaceIndex space) {
    LIMEN_ASSERT(pyramid_, "a tile has begun");
    for (std::size_t i = 0; i < used_; ++i)
        if (spaces_[i]->space == space)
            return *spaces_[i];
    if (used_ == spaces_.size())
        spaces_.push_back(std::make_unique<Space>());
    Space& here = *spaces_[used_++];
    here.space = space;
    here.solid.begin(scene_, *pyramid_, eye_, space, TileSurfaces::SurfaceKind::Solid);
    here.blended.begin(scene_, *pyramid_, eye_, space, TileSurfaces::SurfaceKind::Blended);
    here.portals.clear();
    scene_.openings.gather(space, *pyramid_, here.portals);
    return here;
}

} // namespace limen::reference
