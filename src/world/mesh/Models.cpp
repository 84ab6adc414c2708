#include "world/mesh/Models.h"

#include "core/Assert.h"
#include "world/mesh/ModelCache.h"
#include "world/mesh/PolygonMesher.h"
#include "world/records/PolygonSource.h"
#include "world/records/Pose.h"

#include <algorithm>
#include <cmath>

namespace limen::world {
namespace {

/// The value of `id`: from `map`, else from `cache` unless that is null, else from `make`. The findings of
/// its making are reported in every case, so that they do not depend on cache hits.
template <class Map, class Cache, class Key, class Make>
const auto& made(Map& map, dat::RecordId id, Cache* cache, const Key& key, Records& records, Make&& make) {
    auto& entry = map[id];
    if (entry == nullptr && cache != nullptr)
        entry = cache->find(key);
    if (entry == nullptr) {
        auto fresh = records.collect(make);
        const std::size_t bytes = bytesOf(fresh.value);
        auto shared = std::make_shared<const decltype(fresh)>(std::move(fresh));
        map[id] = cache != nullptr ? cache->keep(key, std::move(shared), bytes) : std::move(shared);
    }
    const auto& found = *map[id]; // looked up again: `make` may have added other entries
    records.report(found.findings);
    return found.value;
}

Vec3 scaleOf(const dat::Setup& setup, std::size_t part) {
    const Vec3 scale = part < setup.scales.size() ? Vec3(setup.scales[part]) : Vec3(1.0);
    return isFinite(scale) ? scale : Vec3(1.0);
}

std::vector<ModelLight> lightsOf(const dat::Setup& setup) {
    std::vector<ModelLight> lights;
    for (const auto& [index, info] : setup.lights) {
        if (!std::isfinite(info.intensity) || !(info.falloff > 0.0f) || !std::isfinite(info.falloff))
            continue;
        const std::uint32_t argb = info.colour.argb;
        const Vec3f colour(static_cast<float>(argb >> 16 & 255u), static_cast<float>(argb >> 8 & 255u),
                           static_cast<float>(argb & 255u));
        lights.push_back({poseOf(info.frame).origin, colour / 255.0f, info.intensity, info.falloff});
    }
    return lights;
}

/// Null if the GfxObj has no levels of detail.
const dat::DegradeInfo* levelsRecord(dat::RecordId gfxObj, Records& records) {
    const dat::GfxObj* record = records.gfxObj(gfxObj);
    return record != nullptr && record->degradeId != 0 ? records.degradeInfo(record->degradeId) : nullptr;
}

Facing facingOf(const dat::DegradeLevel& level) {
    constexpr auto kFirst = static_cast<std::uint32_t>(Facing::Eye);
    constexpr auto kLast = static_cast<std::uint32_t>(Facing::AroundZ);
    return level.mode >= kFirst && level.mode <= kLast ? static_cast<Facing>(level.mode) : Facing::Fixed;
}

/// The limit of a level without kDegradeDistance: from the least to the ideal to the greatest distance as the bias goes from
/// -1 to 0 to 1. docs/formats/geometry.md#levels-of-detail.
double biasedLimit(const dat::DegradeLevel& level, double bias) {
    if (bias == 1.0)
        return level.maxDistance; // whatever the other distances are
    const double ideal = level.idealDistance;
    return bias >= 0.0 ? std::lerp(ideal, double{level.maxDistance}, bias)
                       : std::lerp(ideal, double{level.minDistance}, -bias);
}

/// The distance up to which a level is drawn, metres at scale 1; 0: at none.
double limitOf(const dat::DegradeLevel& level, const LevelLimits& limits) {
    const double limit = biasedLimit(level, limits.bias);
    if (!(level.maxDistance > 0.0f && limit >= 0.0)) // also true for NaN
        return 0.0;
    return (limit > 0.0 ? limit * limits.detail : 0.0) + kDegradeDistance;
}

/// Metres: the reach of emitters whose mesh has no levels of detail.
constexpr double kFarthestParticles = 100.0;

/// The sphere of a mesh around its origin, for every turn about it.
Sphere inEveryTurn(const ModelPart& part, const Sphere& mesh) {
    if (mesh.radius < 0.0)
        return mesh;
    const Vec3 scale = glm::abs(part.scale);
    return {part.origin, (glm::length(mesh.centre) + mesh.radius) * std::max({scale.x, scale.y, scale.z})};
}

} // namespace

LevelRange levelRangeOf(const LevelBand& band, double scaleZ) {
    const double scale = std::isfinite(scaleZ) && scaleZ != 0.0 ? std::abs(scaleZ) : 1.0;
    const std::uint16_t from = levelRangeLimit(band.from * scale);
    return {std::min(from, static_cast<std::uint16_t>(kMostRangeSteps)), levelRangeLimit(band.upTo * scale)};
}

Facing facingOf(dat::RecordId gfxObj, Records& records) {
    const dat::DegradeInfo* info = levelsRecord(gfxObj, records);
    return info != nullptr && !info->levels.empty() ? facingOf(info->levels.front()) : Facing::Fixed;
}

std::vector<SurfaceList> listsOf(std::span<const dat::RecordId> surfaces, Records& records) {
    std::vector<SurfaceList> lists;
    for (const dat::RecordId id : surfaces) {
        const dat::Surface* surface = records.surface(id);
        lists.push_back(surface != nullptr ? listOf(surfaceClassOf(*surface), isSplit(*surface))
                                           : SurfaceList::Opaque);
    }
    return lists;
}

const Model& Models::model(dat::RecordId id) {
    return made(models_, id, cache_ != nullptr ? &cache_->models : nullptr, std::pair(id, limits_), records_,
                [&] { return read(id, nullptr); });
}

std::vector<Models::Level> Models::levelsOf(dat::RecordId gfxObj) {
    const dat::DegradeInfo* info = levelsRecord(gfxObj, records_);
    if (info == nullptr || info->levels.empty())
        return {{gfxObj, {}, Facing::Fixed}};
    std::vector<Level> levels;
    double from = 0.0;
    for (const dat::DegradeLevel& level : info->levels) {
        const bool isLast = &level == &info->levels.back();
        // The last level is drawn at every distance that is left. A marker that is its own only level, up to
        // no distance, is never drawn.
        const bool isMarker = info->levels.size() == 1 && !(level.maxDistance > 0.0f);
        const double upTo =
            isLast && !isMarker ? std::numeric_limits<double>::infinity() : limitOf(level, limits_);
        if (upTo > from)
            levels.push_back({level.gfxObj, {from, upTo}, facingOf(level)});
        from = std::max(from, upTo);
    }
    return levels;
}

LevelBand Models::particleBand(dat::RecordId gfxObj) {
    const dat::DegradeInfo* info = levelsRecord(gfxObj, records_);
    if (info == nullptr || info->levels.empty())
        return {0.0, kFarthestParticles * limits_.detail};
    const std::size_t count = info->levels.size();
    const dat::DegradeLevel& level = info->levels[count > 2 ? count - 2 : 0]; // the last one ends the list
    return {0.0, level.maxDistance * limits_.detail};
}

void Models::addPart(Model& model, const ModelPart& posed) {
    for (const Level& level : levelsOf(posed.gfxObj)) {
        if (level.gfxObj == 0 || level.band.from * std::abs(posed.scale.z) >= kMostRangeSteps / kRangeSteps)
            continue;
        auto& list = level.band.from == 0.0 ? model.parts : model.farther;
        list.push_back(posed);
        list.back().gfxObj = level.gfxObj;
        list.back().band = level.band;
        list.back().facing = level.facing;
    }
}

const Dress& dressOf(const ModelPart& part, const Dress& dress) {
    if (part.held == kNone)
        return dress;
    LIMEN_ASSERT(part.held < dress.held.size(), "the model was read in this dress");
    return *dress.held[part.held].dress;
}

void Models::addHeld(Model& model, const dat::Setup& holder, const HeldThing& thing, std::uint32_t number) {
    const dat::Setup* setup = records_.setup(thing.model);
    if (setup == nullptr)
        return;
    const Pose carrier = thing.part != kNone ? restOf(holder, thing.part) : Pose();
    for (std::size_t i = 0; i < setup->parts.size(); ++i) {
        ModelPart part;
        part.part = static_cast<std::uint32_t>(i);
        const DressedPart* worn = thing.dress->part(part.part);
        part.gfxObj = worn != nullptr && worn->gfxObj != 0 ? worn->gfxObj : setup->parts[i];
        Pose inThing = placedPartOf(*setup, thing.placement, i);
        inThing.origin *= thing.scale;
        part.grip = thing.at.of(inThing);
        part.scale = scaleOf(*setup, i) * thing.scale;
        const Pose pose = carrier.of(part.grip);
        part.origin = pose.origin;
        part.linear = glm::mat3_cast(pose.orientation);
        for (int axis = 0; axis < 3; ++axis)
            part.linear[axis] *= part.scale[axis];
        part.held = number;
        part.posedBy = thing.part;
        addPart(model, part);
    }
}

Model Models::read(dat::RecordId id, const Dress* dress) {
    Model model;
    if (isGfxObj(id)) {
        addPart(model, {id, Mat3(1.0), Vec3(0.0), {}, Facing::Fixed, 0, Vec3(1.0), kNone, 0, {}});
    } else if (const dat::Setup* setup = records_.setup(id)) {
        for (std::size_t i = 0; i < setup->parts.size(); ++i) {
            const Pose pose = restOf(*setup, i);
            const Vec3 scale = scaleOf(*setup, i);
            Mat3 linear = glm::mat3_cast(pose.orientation);
            for (int axis = 0; axis < 3; ++axis)
                linear[axis] *= scale[axis];
            const auto number = static_cast<std::uint32_t>(i);
            const DressedPart* worn = dress != nullptr ? dress->part(number) : nullptr;
            const dat::RecordId gfxObj =
                worn != nullptr && worn->gfxObj != 0 ? worn->gfxObj : setup->parts[i];
            addPart(model,
                    {gfxObj, linear, pose.origin, {}, Facing::Fixed, number, scale, kNone, number, {}});
        }
        for (std::size_t i = 0; dress != nullptr && i < dress->held.size(); ++i)
            addHeld(model, *setup, dress->held[i], static_cast<std::uint32_t>(i));
        model.lights = lightsOf(*setup);
    }
    model.bounds = boundsOf(model);
    return model;
}

Sphere Models::boundsOf(const Model& model) {
    std::vector<Vec3> points;
    std::vector<Sphere> turning;
    for (const std::vector<ModelPart>* parts : {&model.parts, &model.farther}) {
        for (const ModelPart& posed : *parts) {
            const PartMesh* mesh = part(posed.gfxObj);
            if (mesh == nullptr || mesh->mesh.empty())
                continue;
            std::vector<Vec3> corners;
            for (const MeshVertex& vertex : mesh->mesh.vertices)
                corners.push_back(vertex.corner());
            if (posed.facing != Facing::Fixed) {
                const Sphere sphere = inEveryTurn(posed, boundingSphere(corners));
                for (int axis = 0; axis < 3; ++axis) // on its surface, for the common centre
                    for (const double side : {-sphere.radius, sphere.radius})
                        points.push_back(sphere.centre + side * Mat3(1.0)[axis]);
                turning.push_back(sphere);
            } else {
                for (const Vec3& corner : corners)
                    points.push_back(posed.origin + posed.linear * corner);
            }
        }
    }
    Sphere bounds = boundingSphere(points);
    for (const Sphere& sphere : turning)
        bounds.radius = std::max(bounds.radius, glm::length(sphere.centre - bounds.centre) + sphere.radius);
    return bounds;
}

const PartMesh* Models::part(dat::RecordId gfxObj) {
    const std::optional<PartMesh>& part = made(parts_, gfxObj, cache_ != nullptr ? &cache_->parts : nullptr,
                                               gfxObj, records_, [&] { return build(gfxObj); });
    return part ? &*part : nullptr;
}

std::optional<PartMesh> Models::build(dat::RecordId gfxObj) {
    const dat::GfxObj* record = records_.gfxObj(gfxObj);
    if (record == nullptr)
        return std::nullopt;
    std::optional<PartMesh> part(std::in_place);
    part->gfxObj = gfxObj;
    part->surfaces = record->surfaces;
    std::set<std::uint16_t> portals;
    for (const PortalPolygonRef& ref : portalRefs(*record, kAnyPortalCount))
        portals.insert(ref.polygonId);
    BakedGeometry geometry;
    std::vector<std::uint32_t> polygons;
    std::vector<Finding> findings;
    for (SourcePolygon& polygon :
         readPolygons(record->vertexArray, record->polygons,
                      drawnSlots(record->surfaces, MeshOwner::Thing, records_), portals, gfxObj, findings))
        if (polygon.isDrawn())
            polygons.push_back(geometry.add(std::move(polygon), {}));
    records_.report(findings);
    geometry.bake();
    PolygonMesher mesher(listsOf(record->surfaces, records_));
    for (const std::uint32_t handle : polygons) {
        LIMEN_ASSERT(handle != kNone, "readPolygons leaves out all polygons that add() refuses");
        mesher.add(geometry, handle);
    }
    part->clamp = mesher.clamped();
    part->mesh = mesher.finish();
    return part;
}

} // namespace limen::world
