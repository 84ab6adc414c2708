#pragma once

#include "dat/Ids.h"
#include "geometry/Vec.h"

#include <nlohmann/json.hpp>
#include <string>

// Reading one field of a JSON object. Each yields false if the field is there and not of its shape; an absent one is fine and
// leaves `out` alone.
namespace limen::world {

/// A finite number.
[[nodiscard]] bool readField(const nlohmann::json& object, const char* key, double& out);
[[nodiscard]] bool readField(const nlohmann::json& object, const char* key, bool& out);
[[nodiscard]] bool readField(const nlohmann::json& object, const char* key, std::string& out);
/// A whole number of 32 bits.
[[nodiscard]] bool readField(const nlohmann::json& object, const char* key, std::uint32_t& out);
/// [x, y, z], finite.
[[nodiscard]] bool readField(const nlohmann::json& object, const char* key, Vec3& out);
/// [a, b], finite.
[[nodiscard]] bool readField(const nlohmann::json& object, const char* key, std::array<double, 2>& out);
/// A record's id: a number, or text such as "0x20300100"; "" and "outside" are 0.
[[nodiscard]] bool readId(const nlohmann::json& object, const char* key, dat::RecordId& out);

} // namespace limen::world
