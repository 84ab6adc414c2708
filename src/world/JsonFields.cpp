#include "world/JsonFields.h"

#include <cmath>
#include <cstdlib>

namespace limen::world {
namespace {

using Json = nlohmann::json;

bool isFiniteNumber(const Json& value) {
    return value.is_number() && std::isfinite(value.get<double>());
}

/// A list of exactly `count` finite numbers, written to `out`.
bool readNumbers(const Json& object, const char* key, double* out, std::size_t count) {
    const auto found = object.find(key);
    if (found == object.end())
        return true;
    if (!found->is_array() || found->size() != count)
        return false;
    for (std::size_t i = 0; i < count; ++i) {
        if (!isFiniteNumber((*found)[i]))
            return false;
        out[i] = (*found)[i].get<double>();
    }
    return true;
}

} // namespace

bool readField(const Json& object, const char* key, double& out) {
    const auto found = object.find(key);
    if (found == object.end())
        return true;
    if (!isFiniteNumber(*found))
        return false;
    out = found->get<double>();
    return true;
}

bool readField(const Json& object, const char* key, bool& out) {
    const auto found = object.find(key);
    if (found == object.end())
        return true;
    if (!found->is_boolean())
        return false;
    out = found->get<bool>();
    return true;
}

bool readField(const Json& object, const char* key, std::string& out) {
    const auto found = object.find(key);
    if (found == object.end())
        return true;
    if (!found->is_string())
        return false;
    out = found->get<std::string>();
    return true;
}

bool readField(const Json& object, const char* key, std::uint32_t& out) {
    const auto found = object.find(key);
    if (found == object.end())
        return true;
    if (!found->is_number_unsigned() || found->get<std::uint64_t>() > 0xFFFFFFFFu)
        return false;
    out = found->get<std::uint32_t>();
    return true;
}

bool readField(const Json& object, const char* key, Vec3& out) {
    return readNumbers(object, key, &out.x, 3);
}

bool readField(const Json& object, const char* key, std::array<double, 2>& out) {
    return readNumbers(object, key, out.data(), 2);
}

bool readId(const Json& object, const char* key, dat::RecordId& out) {
    const auto found = object.find(key);
    if (found == object.end() || found->is_null())
        return true;
    if (!found->is_string())
        return readField(object, key, out);
    const std::string text = found->get<std::string>();
    if (text.empty() || text == "outside") {
        out = 0;
        return true;
    }
    char* end = nullptr;
    const unsigned long long value = std::strtoull(text.c_str(), &end, 0);
    out = static_cast<dat::RecordId>(value);
    return *end == '\0' && value <= 0xFFFFFFFFu;
}

} // namespace limen::world
