#include "reference/Scene.h"

#include "reference/Follower.h"
#include "reference/SceneData.h"

namespace limen::reference {

Scene::Scene(const world::World& world, const RuleOptions& options)
    : data_(std::make_unique<Data>(world, options)) {}
Scene::~Scene() = default;
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;

void Scene::setDynamics(const world::DynamicState& dynamics) {
    data_->takeDynamics(dynamics);
}

world::SpaceIndex Scene::spaceOfEye(world::SpaceIndex root, const Vec3& eye) const {
    return data_->openings.spaceOfEye(root, eye - data_->origin);
}

Answer Scene::trace(world::SpaceIndex root, const Ray& ray) const {
    return Follower(*data_, ray).follow(spaceOfEye(root, ray.eye));
}

const SceneData& Scene::data() const {
    return *data_;
}

} // namespace limen::reference
