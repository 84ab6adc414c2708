#pragma once

#include "core/Api.h"
#include "geometry/Vec.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

// Values shared by several records, as stored (docs/formats/primitives.md). Floats keep their bits, NaNs included,
// so that a record encodes to the same bytes.
LIMEN_API_BEGIN
namespace limen::dat {

/// Position and orientation: p_parent = origin + rotate(orientation, p).
struct Frame {
    Vec3f origin{0.0f};
    Quatf orientation{1.0f, 0.0f, 0.0f, 0.0f}; ///< w,x,y,z in the file
};

/// n·p + d, positive in front.
struct PlaneF {
    Vec3f n{0.0f};
    float d = 0.0f;
};

struct SphereF {
    Vec3f centre{0.0f};
    float radius = 0.0f;
};

struct CylSphere {
    Vec3f low{0.0f};
    float radius = 0.0f;
    float height = 0.0f;
};

/// 0xAARRGGBB.
struct Colour {
    std::uint32_t argb = 0;
};

/// A model placed in a landblock: `model` is a GfxObj (0x01) or a Setup (0x02); the frame is
/// landblock-relative.
struct Stab {
    std::uint32_t model = 0;
    Frame frame;
};

/// A "PackableHashTable": pairs in the order of the file (by key modulo buckets), with repeated keys.
template <class Value>
struct PackedHashTable {
    std::uint16_t buckets = 32;
    std::vector<std::pair<std::uint32_t, Value>> entries;
};

} // namespace limen::dat
LIMEN_API_END
