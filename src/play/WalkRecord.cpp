#include "play/WalkRecord.h"

#include "output/OutputFile.h"
#include "world/Nearby.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

namespace limen::play {
namespace {

using WalkJson = nlohmann::json;

constexpr std::size_t kLimit = std::size_t{1} << 30; ///< bytes, enough for days of walking
constexpr std::array<const char*, PlayAct::kKinds> kActNames{
    "walk",     "chase",   "doors", "use", "weather", "place", "time",  "all_doors",
    "distance", "quality", "day",   "fov", "go",      "look",  "object"};

/// Visits the numbers and flags of an input by name, for reading and writing. Fields that are 0 or false are
/// omitted.
template <class Input, class Number, class Flag>
void eachField(Input& input, Number&& number, Flag&& flag) {
    number("seconds", input.seconds);
    number("forward", input.forward);
    number("right", input.right);
    number("up", input.up);
    number("turn_right", input.turnRight);
    number("turn_up", input.turnUp);
    flag("fast", input.fast);
    flag("jump", input.jump);
    flag("frozen", input.isFrozen);
}

/// Numbers of an act: a point has two.
std::size_t numbersOf(PlayActKind kind) {
    return kind == PlayActKind::Go ? 2 : 1;
}

nlohmann::ordered_json actJson(const PlayAct& act) {
    nlohmann::ordered_json json{kActNames[static_cast<std::size_t>(act.kind)], act.value};
    if (numbersOf(act.kind) == 2)
        json.push_back(act.north);
    return json;
}

bool readAct(const WalkJson& json, PlayAct& act) {
    if (!json.is_array() || json.size() < 2 || !json[0].is_string() || !json[1].is_number())
        return false;
    const auto found = std::find(kActNames.begin(), kActNames.end(), json[0].get<std::string>());
    act = {static_cast<PlayActKind>(found - kActNames.begin()), json[1].get<double>()};
    if (found == kActNames.end() || !std::isfinite(act.value) || json.size() != numbersOf(act.kind) + 1)
        return false;
    if (act.kind == PlayActKind::Go)
        act.north = json[2].is_number() ? json[2].get<double>() : std::nan("");
    return std::isfinite(act.north);
}

bool readSide(const WalkJson& json, std::uint32_t& side) {
    if (!json.is_number_unsigned() || json.get<std::uint64_t>() == 0 ||
        json.get<std::uint64_t>() > engine::kMaxSide)
        return false;
    side = json.get<std::uint32_t>();
    return true;
}

constexpr int kMostRadius = 64; ///< blocks; the program writes no larger radius

nlohmann::ordered_json loadJson(const world::LoadOptions& load) {
    nlohmann::ordered_json json{{"radius", load.radius}, {"far", load.farRadius}};
    if (std::isfinite(load.detail)) // infinity, the finest level everywhere, is written as no value
        json["detail"] = load.detail;
    return json;
}

bool readWithin(const WalkJson& json, const char* name, int most, int& value) {
    const auto found = json.find(name);
    if (found == json.end() || !found->is_number_unsigned() ||
        found->get<std::uint64_t>() > static_cast<std::uint64_t>(most))
        return false;
    value = found->get<int>();
    return true;
}

bool readLoad(const WalkJson& json, world::LoadOptions& load) {
    if (!json.is_object() || !readWithin(json, "radius", kMostRadius, load.radius) ||
        !readWithin(json, "far", kMostRadius, load.farRadius))
        return false;
    load.detail = std::numeric_limits<double>::infinity();
    if (const auto found = json.find("detail"); found != json.end())
        load.detail = found->is_number() ? found->get<double>() : -1.0;
    return load.detail > 0.0;
}

bool readShown(const WalkJson& json, engine::PartTarget& shown) {
    return readLoad(json, shown.options) && readWithin(json, "x", world::kMapSize - 1, shown.centre.x) &&
           readWithin(json, "y", world::kMapSize - 1, shown.centre.y);
}

bool readHash(const WalkJson& json, std::uint64_t& value) {
    if (!json.is_string())
        return false;
    const std::string& text = json.get_ref<const std::string&>();
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value, 16);
    return error == std::errc() && rest == end;
}

bool readFrame(const WalkJson& json, RecordedFrame& frame) {
    bool good = json.is_object();
    const auto take = [&](const char* name, const auto& read) {
        if (const auto found = good ? json.find(name) : json.end(); good && found != json.end())
            good = read(*found);
    };
    eachField(
        frame.input,
        [&](const char* name, double& value) {
            take(name, [&](const WalkJson& v) {
                value = v.is_number() ? v.get<double>() : std::nan("");
                return std::isfinite(value);
            });
        },
        [&](const char* name, bool& value) {
            take(name, [&](const WalkJson& v) {
                value = v.is_boolean() && v.get<bool>();
                return v.is_boolean();
            });
        });
    take("size", [&](const WalkJson& v) {
        return v.is_array() && v.size() == 2 && readSide(v[0], frame.input.size.width) &&
               readSide(v[1], frame.input.size.height);
    });
    take("acts", [&](const WalkJson& v) {
        frame.input.acts.resize(v.is_array() ? v.size() : 0);
        std::size_t next = 0;
        return v.is_array() && std::all_of(v.begin(), v.end(), [&](const WalkJson& a) {
                   return readAct(a, frame.input.acts[next++]);
               });
    });
    take("decided", [&](const WalkJson& v) { return readHash(v, frame.decided); });
    take("refused", [&](const WalkJson& v) {
        frame.isRefused = v.is_boolean() && v.get<bool>();
        return v.is_boolean();
    });
    take("shown", [&](const WalkJson& v) { return readShown(v, frame.shown.emplace()); });
    return good && frame.input.seconds >= 0.0;
}

bool readBeginning(const WalkJson& json, WalkRecord& record) {
    const bool good = json.is_object() && json.value("format", WalkJson()) == "limen walk" &&
                      json.value("version", WalkJson()) == 1 && json.contains("start") &&
                      json["start"].is_string();
    if (!good)
        return false;
    record.start = json["start"].get<std::string>();
    const auto streamed = json.find("streamed");
    return streamed == json.end() || readLoad(*streamed, record.streamed.emplace());
}

} // namespace

std::string beginningLine(const std::string& start, const std::optional<world::LoadOptions>& streamed) {
    nlohmann::ordered_json json{{"format", "limen walk"}, {"version", 1}, {"start", start}};
    if (streamed)
        json["streamed"] = loadJson(*streamed);
    return json.dump() + "\n";
}

std::string frameLine(const RecordedFrame& frame) {
    nlohmann::ordered_json json;
    eachField(
        frame.input,
        [&](const char* name, const double& value) {
            if (value != 0.0)
                json[name] = value;
        },
        [&](const char* name, const bool& value) {
            if (value)
                json[name] = true;
        });
    json["size"] = {frame.input.size.width, frame.input.size.height};
    for (const PlayAct& act : frame.input.acts)
        json["acts"].push_back(actJson(act));
    if (frame.shown) {
        json["shown"] = {{"x", frame.shown->centre.x}, {"y", frame.shown->centre.y}};
        json["shown"].update(loadJson(frame.shown->options));
    }
    if (frame.isRefused)
        json["refused"] = true;
    json["decided"] = fmt::format("{:016x}", frame.decided);
    return json.dump() + "\n";
}

Result<WalkRecord> parseWalk(const std::string& text, const std::string& name) {
    WalkRecord record;
    std::size_t number = 0;
    for (std::size_t begin = 0; begin < text.size(); ++number) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const WalkJson json =
            WalkJson::parse(text.begin() + static_cast<std::ptrdiff_t>(begin),
                            text.begin() + static_cast<std::ptrdiff_t>(end), nullptr, false);
        begin = end + 1;
        if (number == 0) {
            if (!readBeginning(json, record))
                return fail(ErrorCode::Malformed, name,
                            "is not a recorded walk; record one with limen view --record or limen walk");
            continue;
        }
        if (!readFrame(json, record.frames.emplace_back()))
            return fail(ErrorCode::Malformed, name,
                        fmt::format("line {} is not a frame of a walk; record the walk again", number + 1));
    }
    if (record.frames.empty())
        return fail(ErrorCode::Malformed, name, "contains no frame; record the walk again");
    return record;
}

Result<WalkRecord> readWalk(const std::filesystem::path& file) {
    const Result<std::string> text = output::readTextFile(file, kLimit);
    if (!text)
        return Failure(text.error());
    return parseWalk(*text, file.string());
}

} // namespace limen::play
