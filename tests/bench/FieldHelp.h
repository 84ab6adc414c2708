#pragma once

#include "ObjectField.h"

namespace limen::bench::test {

/// 200 boxes in 20 groups.
inline FieldSpec smallField(double movingShare = 0.0) {
    return {.objects = 200, .groups = 20, .side = 40.0, .movingShare = movingShare};
}

/// All boxes of a field, static ones first.
inline std::vector<world::Instance> boxesOf(const ObjectField& field) {
    std::vector<world::Instance> boxes;
    for (const world::Instance& instance : field.world.instances)
        if (instance.kind == world::InstanceKind::Scenery)
            boxes.push_back(instance);
    boxes.insert(boxes.end(), field.dynamics.instances.begin(), field.dynamics.instances.end());
    return boxes;
}

} // namespace limen::bench::test
