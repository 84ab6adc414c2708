#include "plain/PlainScene.h"

#include "FrustumSides.h"

#include "world/LevelRange.h"

#include <algorithm>
#include <tuple>

namespace limen::bench {

namespace {

/// Adds models to a scene, each once.
class ModelList {
public:
    ModelList(const world::World& world, PlainScene& scene) : world_(world), scene_(scene) {}

    std::uint32_t numberFor(const world::Instance& instance) {
        const auto next = static_cast<std::uint32_t>(scene_.blendedOf.size());
        const auto [entry, isNew] = numbers_.try_emplace(partsKeyOf(instance), next);
        if (isNew)
            add(instance, next);
        return entry->second;
    }

private:
    void add(const world::Instance& instance, std::uint32_t model) {
        PlainRun blended{static_cast<std::uint32_t>(scene_.blended.size()), 0};
        for (const MeshPart& part : partsOf(world_, instance)) {
            const PlainDraw draw{part.surface, static_cast<std::uint32_t>(scene_.indices.size()),
                                 static_cast<std::uint32_t>(part.indices.size()), model};
            const auto base = static_cast<std::uint32_t>(scene_.vertices.size());
            scene_.vertices.insert(scene_.vertices.end(), part.vertices.begin(), part.vertices.end());
            for (const std::uint32_t index : part.indices)
                scene_.indices.push_back(base + index);
            const bool isBlended = part.surface.surfaceClass == world::SurfaceClass::Blended;
            (isBlended ? scene_.blended : scene_.solid).push_back(draw);
            blended.count += isBlended ? 1 : 0;
        }
        scene_.blendedOf.push_back(blended);
    }

    const world::World& world_;
    PlainScene& scene_;
    std::map<PartsKey, std::uint32_t> numbers_;
};

auto solidOrder(const PlainDraw& draw) {
    return std::tuple(draw.surface.surfaceClass, draw.surface.texture, draw.model);
}

/// Finds the visible objects; counts them by model.
void findVisible(const world::World& world, const PlainScene& scene, const visibility::View& view,
                 PlainSelection& selection) {
    const FrustumSides sides = FrustumSides::of(view);
    const world::RangeSteps eye = world::rangeStepsOf(view.eye);
    selection.visible.clear();
    selection.ofModel.assign(scene.blendedOf.size(), {});
    for (std::uint32_t i = 0; i < scene.objects.size(); ++i) {
        const PlainObject& object = scene.objects[i];
        if (!sides.sees(object.instance.bounds) || !world::isInLevelRange(world, object.instance, eye))
            continue;
        selection.visible.push_back(i);
        ++selection.ofModel[object.model].count;
    }
}

} // namespace

PlainScene plainSceneOf(const FramePlace& place) {
    const world::World& world = place.part->world;
    PlainScene scene;
    scene.origin = originNear(place.view.view.eye);
    ModelList models(world, scene);
    for (const std::vector<world::Instance>* instances : {&world.instances, &place.dynamics.instances})
        for (const world::Instance& instance : *instances)
            if (instance.mesh != world::kNone)
                scene.objects.push_back(
                    {instance, placementOf(world, instance, scene.origin), models.numberFor(instance)});
    std::sort(scene.solid.begin(), scene.solid.end(),
              [](const PlainDraw& a, const PlainDraw& b) { return solidOrder(a) < solidOrder(b); });
    return scene;
}

void selectPlain(const world::World& world, const PlainScene& scene, const visibility::View& view,
                 PlainSelection& selection) {
    findVisible(world, scene, view, selection);
    std::uint32_t next = 0;
    for (PlainRun& run : selection.ofModel) {
        run.first = next;
        next += run.count;
        run.count = 0; // counted again below
    }
    selection.placements.resize(next);
    selection.blended.clear();
    for (const std::uint32_t i : selection.visible) {
        const PlainObject& object = scene.objects[i];
        PlainRun& run = selection.ofModel[object.model];
        const std::uint32_t instance = run.first + run.count++;
        selection.placements[instance] = object.placement;
        const PlainRun& parts = scene.blendedOf[object.model];
        for (std::uint32_t draw = parts.first; draw < parts.first + parts.count; ++draw)
            selection.blended.push_back(
                {draw, instance, glm::length(object.instance.bounds.centre - view.eye)});
    }
    std::sort(selection.blended.begin(), selection.blended.end(),
              [](const PlainSelection::Blended& a, const PlainSelection::Blended& b) {
                  return std::tuple(-a.distance, a.draw, a.instance) <
                         std::tuple(-b.distance, b.draw, b.instance);
              });
}

std::size_t trianglesOf(const PlainScene& scene, const PlainSelection& selection) {
    std::size_t indices = 0;
    for (const PlainDraw& draw : scene.solid)
        indices += std::size_t{draw.indexCount} * selection.ofModel[draw.model].count;
    for (const PlainSelection::Blended& blended : selection.blended)
        indices += scene.blended[blended.draw].indexCount;
    return indices / 3;
}

} // namespace limen::bench
