#include "frame/gates/GateViews.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

namespace limen::frame {

namespace {

using visibility::Visit;

/// Squared metres from a point to the nearest vertex of a baked mesh, block-local.
double squaredToNearest(const world::World& world, const world::Mesh& mesh, const Vec3& local) {
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t v = mesh.firstVertex; v < mesh.firstVertex + mesh.vertexCount; ++v) {
        const Vec3 offset = world.vertices[v].corner() - local;
        least = std::min(least, glm::dot(offset, offset));
    }
    return least;
}

/// Sum over an opening's corners.
double squaredToOpening(const world::World& world, const world::Instance& exterior,
                        const world::Portal& portal) {
    double sum = 0.0;
    for (const Vec3& corner : cornersOf(world, portal))
        sum += squaredToNearest(world, world.meshes[exterior.mesh],
                                corner - world.blocks[exterior.block].origin());
    return sum;
}

/// The part that a visit is drawn in.
struct Part {
    enum class Kind : std::uint8_t { Nowhere, Landscape, Building, Inside } kind = Kind::Nowhere;
    std::uint32_t building = 0;
};

/// Squared metres from the eye to a block's nearest point, horizontally.
double squaredToBlock(const world::Block& block, const Vec3& eye) {
    const Vec3 low = block.origin();
    const double x = std::max({low.x - eye.x, 0.0, eye.x - low.x - world::kBlockSize});
    const double y = std::max({low.y - eye.y, 0.0, eye.y - low.y - world::kBlockSize});
    return x * x + y * y;
}

double metresTo(const Sphere& bounds, const Vec3& eye) {
    const Vec3 offset = bounds.centre - eye;
    return std::sqrt(glm::dot(offset, offset)) - bounds.radius;
}

class DepthDivision {
public:
    DepthDivision(const world::World& world, const Exteriors& exteriors, std::span<const Visit> visits)
        : world_(world), exteriors_(exteriors), visits_(visits), parts_(visits.size()) {}

    DepthViews divide(const Vec3& eye) {
        for (std::size_t i = 0; i < visits_.size(); ++i)
            parts_[i] = partOf(visits_[i]);
        for (const std::uint32_t i : farToNear(visits_))
            add(i);
        addSteps(eye);
        return std::move(views_);
    }

private:
    [[nodiscard]] Part partOf(const Visit& visit) {
        if (visit.hole)
            return {};
        const bool isOutside = visit.space == world::kOutside;
        if (visit.depth == 0)
            return {isOutside ? Part::Kind::Landscape : Part::Kind::Inside};
        const Part& parent = parts_[visit.parent];
        if (isOutside)
            return {parent.kind == Part::Kind::Inside ? Part::Kind::Landscape : Part::Kind::Nowhere};
        if (parent.kind != Part::Kind::Landscape)
            return parent;
        return {Part::Kind::Building, buildingOf(visit.portal)};
    }

    /// Openings of one exterior lead into one building; an opening without an exterior is a building of its own.
    [[nodiscard]] std::uint32_t buildingOf(std::uint32_t portal) {
        const world::InstanceIndex exterior = exteriors_.ofOpening[portal];
        const auto key = exterior != world::kNone ? std::pair(0u, exterior) : std::pair(1u, portal);
        const auto [found, isNew] =
            numbers_.emplace(key, static_cast<std::uint32_t>(views_.buildings.size()));
        if (isNew)
            views_.buildings.push_back({exterior, world_.portals[portal].block, {}, {}});
        return found->second;
    }

    /// Adds a visit unless one through its portal is there. A cut opening has several visits: their polygon is drawn
    /// once.
    void addOpening(std::uint32_t visit, std::vector<std::uint32_t>& openings) const {
        const bool isThere = std::any_of(openings.begin(), openings.end(), [&](std::uint32_t other) {
            return visits_[other].portal == visits_[visit].portal;
        });
        if (!isThere)
            openings.push_back(visit);
    }

    void add(std::uint32_t i) {
        const Visit& visit = visits_[i];
        switch (parts_[i].kind) {
        case Part::Kind::Landscape:
            views_.landscape.push_back(i);
            if (visit.depth > 0)
                addOpening(i, views_.fences);
            break;
        case Part::Kind::Building: {
            SeenBuilding& building = views_.buildings[parts_[i].building];
            building.visits.push_back(i);
            if (visits_[visit.parent].space == world::kOutside)
                addOpening(i, building.openings);
            break;
        }
        case Part::Kind::Inside:
            views_.inside.push_back(i);
            break;
        case Part::Kind::Nowhere:
            break;
        }
    }

    [[nodiscard]] double metresToBuilding(const SeenBuilding& building, const Vec3& eye) const {
        if (building.exterior != world::kNone)
            return metresTo(world_.instances[building.exterior].bounds, eye);
        const Visit& visit = visits_[building.visits.back()];
        return metresTo({world_.spaces[visit.space].bounds.centre(), 0.0}, eye);
    }

    /// A building of a block, and its distance from the eye.
    struct Placed {
        double metres = 0.0;
        std::uint32_t block = 0;
        LandscapeStep step;
    };
    /// Far to near.
    [[nodiscard]] std::vector<Placed> placedBuildings(const Vec3& eye) const {
        std::vector<Placed> placed;
        for (std::uint32_t b = 0; b < views_.buildings.size(); ++b)
            placed.push_back({metresToBuilding(views_.buildings[b], eye),
                              views_.buildings[b].block,
                              {LandscapeStep::Kind::Building, b}});
        for (const world::InstanceIndex exterior : exteriors_.all)
            if (!numbers_.contains({0u, exterior}))
                placed.push_back({metresTo(world_.instances[exterior].bounds, eye),
                                  world_.instances[exterior].block,
                                  {LandscapeStep::Kind::Exterior, exterior}});
        std::stable_sort(placed.begin(), placed.end(),
                         [](const Placed& a, const Placed& b) { return a.metres > b.metres; });
        return placed;
    }

    void addSteps(const Vec3& eye) {
        if (views_.landscape.empty())
            return;
        std::vector<std::uint32_t> blocks(world_.blocks.size());
        std::iota(blocks.begin(), blocks.end(), 0u);
        std::stable_sort(blocks.begin(), blocks.end(), [&](std::uint32_t a, std::uint32_t b) {
            return squaredToBlock(world_.blocks[a], eye) > squaredToBlock(world_.blocks[b], eye);
        });
        const std::vector<Placed> buildings = placedBuildings(eye);
        for (const std::uint32_t block : blocks) {
            views_.steps.push_back({LandscapeStep::Kind::Block, block});
            for (const Placed& placed : buildings)
                if (placed.block == block)
                    views_.steps.push_back(placed.step);
        }
    }

    const world::World& world_;
    const Exteriors& exteriors_;
    std::span<const Visit> visits_;
    std::vector<Part> parts_; ///< by visit
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> numbers_;
    DepthViews views_;
};

} // namespace

std::vector<std::uint32_t> farToNear(std::span<const Visit> visits) {
    // Visits are depth-first, far siblings first: a visit follows its descendants when it leaves the stack.
    std::vector<std::uint32_t> order, open;
    order.reserve(visits.size());
    for (std::uint32_t i = 0; i < visits.size(); ++i) {
        while (!open.empty() && visits[open.back()].depth >= visits[i].depth) {
            order.push_back(open.back());
            open.pop_back();
        }
        open.push_back(i);
    }
    order.insert(order.end(), open.rbegin(), open.rend());
    return order;
}

Exteriors exteriorsOf(const world::World& world) {
    Exteriors exteriors;
    exteriors.ofOpening.resize(world.portals.size(), world::kNone);
    for (world::InstanceIndex i = 0; i < world.instances.size(); ++i)
        if (world.instances[i].kind == world::InstanceKind::Exterior)
            exteriors.all.push_back(i);
    for (std::uint32_t p = 0; p < world.portals.size(); ++p) {
        const world::Portal& portal = world.portals[p];
        double least = std::numeric_limits<double>::infinity();
        for (const world::InstanceIndex exterior : exteriors.all) {
            const world::Instance& instance = world.instances[exterior];
            if (portal.space != world::kOutside || instance.block != portal.block)
                continue;
            const double squared = squaredToOpening(world, instance, portal);
            if (squared < least) {
                least = squared;
                exteriors.ofOpening[p] = exterior;
            }
        }
    }
    return exteriors;
}

DepthViews depthViews(const world::World& world, const Exteriors& exteriors, std::span<const Visit> visits,
                      const Vec3& eye) {
    return DepthDivision(world, exteriors, visits).divide(eye);
}

std::vector<std::uint32_t> spacesOf(std::span<const Visit> visits, std::span<const std::uint32_t> order) {
    std::vector<std::uint32_t> spaces;
    for (std::size_t i = order.size(); i-- > 0;) {
        const std::uint32_t space = visits[order[i]].space;
        if (std::find(spaces.begin(), spaces.end(), space) == spaces.end())
            spaces.push_back(space);
    }
    std::reverse(spaces.begin(), spaces.end());
    return spaces;
}

} // namespace limen::frame
