#include "viewer/inspect/NameTags.h"

#include "engine/Projection.h"
#include "engine/placed/PlacedObjects.h"
#include "engine/report/FrameReport.h"

#include <algorithm>
#include <map>
#include <span>

namespace limen::viewer {
namespace {

constexpr double kFarthestName = 40.0; // metres
constexpr double kAboveTop = 0.15;     // metres between an object and its name

/// The drawn parts of one object.
struct ObjectParts {
    std::vector<const world::Instance*> parts;
    double top = 0.0; ///< global height
};

std::map<std::uint64_t, ObjectParts> partsOf(const world::DynamicState& dynamics) {
    std::map<std::uint64_t, ObjectParts> objects;
    for (const world::Instance& part : dynamics.instances) {
        const double top = part.bounds.centre.z + part.bounds.radius;
        const auto [entry, isNew] = objects.try_emplace(part.object);
        entry->second.top = isNew ? top : std::max(entry->second.top, top);
        entry->second.parts.push_back(&part);
    }
    return objects;
}

bool contains(const std::vector<Vec2>& polygon, const Vec2& point) {
    bool inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        if ((a.y > point.y) != (b.y > point.y) && point.x < a.x + (b.x - a.x) * (point.y - a.y) / (b.y - a.y))
            inside = !inside;
    }
    return inside;
}

/// Whether a visit to one of the part's spaces has a region that contains the part's centre.
bool isSeen(const world::Instance& part, std::span<const world::SpaceIndex> members,
            const visibility::VisibleSet& visible, const std::vector<std::vector<Vec2>>& regions,
            const visibility::View& eye) {
    const auto point = engine::projectLine(part.bounds.centre, part.bounds.centre, eye);
    return point &&
           std::any_of(visible.seen.begin(), visible.seen.end(), [&](const visibility::SeenSpace& seen) {
               return std::find(members.begin(), members.end(), seen.space) != members.end() &&
                      contains(regions[seen.visit], point->first);
           });
}

} // namespace

std::vector<NameTag> nameTags(const world::World& world, const world::DynamicState& dynamics,
                              const visibility::VisibleSet& visible, const visibility::View& eye) {
    const std::map<std::uint64_t, ObjectParts> objects = partsOf(dynamics);
    const std::span<const world::SpaceIndex> members(dynamics.members);
    const std::vector<std::vector<Vec2>> regions = engine::regionOutlines(visible);
    std::vector<NameTag> tags;
    for (const world::PlacedObject& object : world.placed) {
        const double distance = glm::distance(object.origin, eye.eye);
        const auto drawn = objects.find(object.object);
        if (distance > kFarthestName || drawn == objects.end())
            continue;
        const Vec3 above(object.origin.x, object.origin.y, drawn->second.top + kAboveTop);
        const auto point = engine::projectLine(above, above, eye);
        const auto isPartSeen = [&](const world::Instance* part) {
            return isSeen(*part, members.subspan(part->firstMember, part->memberCount), visible, regions,
                          eye);
        };
        if (point && std::any_of(drawn->second.parts.begin(), drawn->second.parts.end(), isPartSeen))
            tags.push_back({point->first, engine::nameWithoutGuid(object.name), distance});
    }
    std::sort(tags.begin(), tags.end(),
              [](const NameTag& a, const NameTag& b) { return a.distance < b.distance; });
    return tags;
}

} // namespace limen::viewer
