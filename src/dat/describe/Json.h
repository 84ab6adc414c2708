#pragma once

#include "dat/Codec.h"

#include <nlohmann/json.hpp>

// Values as JSON, shared by the descriptions of all records.
namespace limen::dat {

using Json = nlohmann::ordered_json;

[[nodiscard]] Json hexId(std::uint32_t id);
[[nodiscard]] Json hexHalf(std::uint16_t id);
/// The shortest decimal that reads back as the same float; "nan", "inf", "-inf" as strings.
[[nodiscard]] Json number(float value);
[[nodiscard]] Json number(double value);
/// Windows-1252 as UTF-8.
[[nodiscard]] Json text(const std::string& bytes);
[[nodiscard]] Json json(const Vec2f& v);
[[nodiscard]] Json json(const Vec3f& v);
[[nodiscard]] Json json(const Frame& f);
[[nodiscard]] Json json(const PlaneF& p);
[[nodiscard]] Json json(const SphereF& s);
[[nodiscard]] Json json(const Colour& c);
[[nodiscard]] Json json(const Stab& s);
[[nodiscard]] Json json(const AnimationHook& h);
[[nodiscard]] Json json(const AnimationFrame& f);

/// An array of `make(item)` for each item.
template <class List, class Make>
[[nodiscard]] Json listOf(const List& list, Make&& make) {
    Json out = Json::array();
    for (const auto& item : list)
        out.push_back(make(item));
    return out;
}
template <class List>
[[nodiscard]] Json hexIds(const List& list) {
    return listOf(list, [](auto id) {
        if constexpr (sizeof id == 2)
            return hexHalf(id);
        else
            return hexId(id);
    });
}

/// JSON with lines of readable length: values that fit are on one line.
[[nodiscard]] std::string pretty(const Json& value);

} // namespace limen::dat
