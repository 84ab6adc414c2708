#pragma once

#include <string_view>

namespace limen::bench::texts {

/// bench/api/flood.py, embedded by the build.
extern const std::string_view kFloodPy;

} // namespace limen::bench::texts
