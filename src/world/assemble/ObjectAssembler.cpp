#include "world/assemble/ObjectAssembler.h"

#include "world/assemble/LevelEntries.h"

#include <algorithm>

namespace limen::world {
namespace {

double largestScale(const Mat3& m) {
    return std::max({glm::length(m[0]), glm::length(m[1]), glm::length(m[2])});
}

/// A model-space sphere in global space. An empty one stays empty.
Sphere placedSphere(const Sphere& sphere, const Mat3& linear, const Vec3& origin) {
    if (sphere.radius < 0.0)
        return sphere;
    return {origin + linear * sphere.centre, sphere.radius * largestScale(linear)};
}

} // namespace

void ObjectAssembler::add(const JoiningBlock& block) {
    for (const PlacedModel& object : block.content.objects)
        addObject(object, block.siteOf(object.cell));
}

void ObjectAssembler::addObject(const PlacedModel& object, const ObjectSite& site) {
    // A model with other meshes is read anew; all others are shared.
    const bool hasParts = object.dress != nullptr && object.dress->changesModel();
    const Model dressed = hasParts ? models_.dressed(object.model, *object.dress) : Model();
    const Model& model = hasParts ? dressed : models_.model(object.model);
    const Mat3 linear = glm::mat3_cast(object.orientation) * object.scale;
    const Vec3 origin = site.blockOrigin + object.origin;
    const std::uint32_t idle = idle_.add(object, site);
    if (idle == kNone)
        addStatic(object, model, placedSphere(model.bounds, linear, origin), site);
    addEffects(object, idle, site);
}

void ObjectAssembler::addEffects(const PlacedModel& object, std::uint32_t idle, const ObjectSite& site) {
    const Mat3 linear = glm::mat3_cast(object.orientation) * object.scale;
    const Vec3 origin = site.blockOrigin + object.origin;
    particles_.addToObject(object, idle, site);
    for (const ModelLight& light : models_.model(object.model).lights)
        lamps_.push_back(
            {{origin + linear * light.position, light.colour, light.intensity, light.falloff}, site.space});
}

void ObjectAssembler::addStatic(const PlacedModel& object, const Model& model, const Sphere& bounds,
                                const ObjectSite& site) {
    ObjectGroup group{static_cast<InstanceIndex>(world_.instances.size()), 0, bounds,
                      site.blockOrigin + object.origin};
    for (const std::vector<ModelPart>* parts : {&model.parts, &model.farther})
        for (const ModelPart& part : *parts)
            addPart(object, part, site);
    group.instanceCount = static_cast<InstanceIndex>(world_.instances.size()) - group.firstInstance;
    if (group.instanceCount > 0)
        groups_.push_back(group);
}

void ObjectAssembler::addPart(const PlacedModel& object, const ModelPart& part, const ObjectSite& site) {
    const PartMesh* mesh = models_.part(part.gfxObj);
    if (mesh == nullptr || mesh->mesh.empty())
        return;
    const Mat3 linear = glm::mat3_cast(object.orientation) * object.scale * part.linear;
    const Vec3 origin = object.origin + object.orientation * part.origin * object.scale;
    Instance instance;
    instance.kind = object.kind;
    instance.mesh = arena_.shared(*mesh);
    instance.block = site.block;
    instance.linear = glm::mat3(linear);
    instance.origin = Vec3f(origin);
    instance.bounds = placedSphere(world_.meshes[instance.mesh].bounds, linear, site.blockOrigin + origin);
    instance.placedIn = site.space;
    instance.object = object.object;
    instance.record = part.gfxObj;
    instance.firstMaterial = object.dress != nullptr
                                 ? materials_.ofDressedPart(*mesh, part.part, dressOf(part, *object.dress))
                                 : materials_.ofPart(*mesh);
    instance.facing = part.facing;
    if (part.facing != Facing::Fixed) // around its origin, for every turn
        instance.bounds = {site.blockOrigin + origin,
                           glm::length(instance.bounds.centre - site.blockOrigin - origin) +
                               instance.bounds.radius};
    const bool isOutdoors = instance.placedIn == kOutside;
    instance.level =
        addLevel({levelRangeOf(part.band, part.scale.z * object.scale),
                  isOutdoors ? LevelMeasure::Landcell : LevelMeasure::Object, localRangeSteps(object.origin)},
                 world_);
    world_.instances.push_back(instance);
}

} // namespace limen::world
