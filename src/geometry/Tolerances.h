#pragma once

// The tolerances of the ray rule, the loader and the picture, shared with the shaders.
#include "../../shaders/include/Tolerances.h"
