#pragma once

#include "core/Hash.h"

#include <cstdint>

namespace limen::placements {

/// A number from 0 up to 1 that depends on an object and two numbers, so that each start of the world is the same.
inline double chance(std::uint64_t object, std::uint32_t number, std::uint32_t purpose) {
    Hash hash;
    hash.add(object);
    hash.add(number);
    hash.add(purpose);
    std::uint64_t bits = hash.value();
    bits ^= bits >> 33;
    bits *= 0xFF51AFD7ED558CCDu;
    bits ^= bits >> 33;
    return static_cast<double>(bits >> 11) / 9007199254740992.0;
}

} // namespace limen::placements
