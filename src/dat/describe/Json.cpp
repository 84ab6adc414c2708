#include "dat/describe/Json.h"

#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

namespace limen::dat {
namespace {

constexpr std::size_t kLineLength = 100;

/// Unicode of the Windows-1252 bytes 0x80 to 0x9F; 0 where none is assigned.
constexpr std::uint16_t kHighText[32] = {0x20AC, 0,      0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021,
                                         0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0,      0x017D, 0,
                                         0,      0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014,
                                         0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0,      0x017E, 0x0178};

void appendUtf8(std::string& out, std::uint32_t c) {
    if (c < 0x80) {
        out += static_cast<char>(c);
    } else if (c < 0x800) {
        out += static_cast<char>(0xC0 | (c >> 6));
        out += static_cast<char>(0x80 | (c & 0x3F));
    } else {
        out += static_cast<char>(0xE0 | (c >> 12));
        out += static_cast<char>(0x80 | ((c >> 6) & 0x3F));
        out += static_cast<char>(0x80 | (c & 0x3F));
    }
}

/// A value's text; `oneLine` is false if it has several lines.
struct Rendered {
    std::string text;
    bool oneLine = true;
};

Rendered render(const Json& value, std::size_t indent);

/// The rendered members of an object or array, with keys.
std::vector<Rendered> renderParts(const Json& value, std::size_t indent) {
    std::vector<Rendered> parts;
    for (auto it = value.begin(); it != value.end(); ++it) {
        Rendered part = render(*it, indent + 2);
        if (value.is_object())
            part.text = Json(it.key()).dump() + ": " + part.text;
        parts.push_back(std::move(part));
    }
    return parts;
}

Rendered render(const Json& value, std::size_t indent) {
    if (!value.is_structured())
        return {value.dump(-1, ' ', false, Json::error_handler_t::replace), true};
    const char* brackets = value.is_object() ? "{}" : "[]";
    const std::vector<Rendered> parts = renderParts(value, indent);
    std::size_t length = 2;
    bool fits = true;
    for (const Rendered& part : parts) {
        length += part.text.size() + 2;
        fits = fits && part.oneLine && length + indent <= kLineLength;
    }
    std::string out(1, brackets[0]);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (!fits)
            out += "\n" + std::string(indent + 2, ' ');
        out += parts[i].text;
        if (i + 1 < parts.size())
            out += fits ? ", " : ",";
    }
    if (!fits)
        out += "\n" + std::string(indent, ' ');
    out += brackets[1];
    return {std::move(out), fits};
}

} // namespace

Json hexId(std::uint32_t id) {
    return fmt::format("0x{:08X}", id);
}
Json hexHalf(std::uint16_t id) {
    return fmt::format("0x{:04X}", id);
}

Json number(float value) {
    // The shortest decimal of the float: 0.1f is shown as 0.1, not as its double.
    if (std::isfinite(value))
        return std::strtod(fmt::format("{}", value).c_str(), nullptr);
    return fmt::format("{}", value);
}
Json number(double value) {
    if (std::isfinite(value))
        return value;
    return fmt::format("{}", value);
}

Json text(const std::string& bytes) {
    std::string out;
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        const std::uint32_t mapped = byte >= 0x80 && byte < 0xA0 ? kHighText[byte - 0x80] : byte;
        appendUtf8(out, mapped == 0 && byte != 0 ? 0xFFFD : mapped);
    }
    return out;
}

Json json(const Vec2f& v) {
    return Json::array({number(v.x), number(v.y)});
}
Json json(const Vec3f& v) {
    return Json::array({number(v.x), number(v.y), number(v.z)});
}
Json json(const Frame& f) {
    const Quatf& q = f.orientation;
    return {{"origin", json(f.origin)},
            {"orientation_wxyz", Json::array({number(q.w), number(q.x), number(q.y), number(q.z)})}};
}
Json json(const PlaneF& p) {
    return {{"n", json(p.n)}, {"d", number(p.d)}};
}
Json json(const SphereF& s) {
    return {{"centre", json(s.centre)}, {"radius", number(s.radius)}};
}
Json json(const Colour& c) {
    return fmt::format("#{:08X}", c.argb);
}
Json json(const Stab& s) {
    return {{"model", hexId(s.model)}, {"frame", json(s.frame)}};
}

Json json(const AnimationHook& h) {
    std::string payload;
    for (const std::uint8_t b : h.payload)
        payload += fmt::format("{:02X}", b);
    return {{"type", h.type}, {"direction", h.direction}, {"payload", payload}};
}

Json json(const AnimationFrame& f) {
    return {{"parts", listOf(f.parts, [](const Frame& part) { return json(part); })},
            {"hooks", listOf(f.hooks, [](const AnimationHook& h) { return json(h); })}};
}

std::string pretty(const Json& value) {
    return render(value, 0).text;
}

} // namespace limen::dat
