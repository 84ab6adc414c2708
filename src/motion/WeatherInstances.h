#pragma once

#include "motion/DynamicInstances.h"
#include "motion/DynamicStateInput.h"

namespace limen::motion {

/// Appends the rain and the Region's weather, as far as the input has them. Both fall around the eye. They
/// belong to the outside alone, however near to a door they fall.
void addWeather(const DynamicStateInput& input, DynamicInstances& instances);

} // namespace limen::motion
