#pragma once

#include "dat/Ids.h"
#include "geometry/Vec.h"

#include <nlohmann/json.hpp>
#include <string>

// Functions that read one field of a JSON object. False: the field has another type or value than described.
// An absent field leaves `out` unchanged, and the result is true.
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
/// A record id: a number, or text such as "0x20300100"; "" and "outside" are 0.
[[nodiscard]] bool readId(const nlohmann::json& object, const char* key, dat::RecordId& out);

} // namespace limen::world
