#include "cli/ShotRequest.h"

#include "cli/Choices.h"
#include "cli/Parse.h"
#include "cli/PlaceNotation.h"
#include "core/AbsolutePath.h"
#include "output/OutputFile.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <variant>

namespace limen::cli {
namespace {

constexpr double kFarthestPosition = 1e6; ///< metres; a position farther from the map is a typing error
constexpr std::size_t kMaxListFile = 64u << 20;

/// Parses `text` into `value` unless it is empty.
template <class T, class Parse>
Result<void> take(const std::string& text, const char* option, Parse parse, T& value) {
    if (text.empty())
        return {};
    auto parsed = parse(option, text);
    if (!parsed)
        return Failure(std::move(parsed.error()));
    value = std::move(*parsed);
    return {};
}

Result<Vec3> positionNearMap(std::string_view option, std::string_view text) {
    Result<Vec3> value = parseVec3(option, text);
    if (value &&
        !(std::max({std::abs(value->x), std::abs(value->y), std::abs(value->z)}) <= kFarthestPosition))
        return fail(
            ErrorCode::BadArgument, std::string(option),
            fmt::format(
                "'{}' is more than {:.0f} km from the map's corner; give metres from the south-west corner",
                text, kFarthestPosition / 1000.0));
    return value;
}

void takePlace(const PlaceNotation& notation, engine::ViewRequest& view) {
    if (const auto* name = std::get_if<PlaceName>(&notation)) {
        view.place = name->name;
        return;
    }
    const auto& position = std::get<PlacePosition>(notation);
    view.eye = position.eye;
    view.isOnGround = position.onGround;
    view.yaw = position.yaw;
    view.pitch = position.pitch;
    view.root = view.root.value_or(position.root);
}

Result<void> checkPosition(const ViewArguments& a, engine::ViewRequest& view) {
    std::optional<Vec3> eye;
    if (Result<void> r = take(a.eye, "--eye", positionNearMap, eye); !r)
        return r;
    std::optional<PlaceNotation> at;
    if (Result<void> r = take(a.at, "--at", parsePlace, at); !r)
        return r;
    if (Result<void> r = take(a.player, "--player", positionNearMap, view.player); !r)
        return r;
    if (Result<void> r = take(a.root, "--root", parseRoot, view.root); !r)
        return r;
    if (view.player && !a.body.empty())
        return fail(ErrorCode::BadArgument, "--player",
                    "--body sets the position of the player as well; give only one of the two");
    if (eye && at)
        return fail(ErrorCode::BadArgument, "--at", "--eye is given as well; give only one of the two");
    view.isAtStart = !eye && !at;
    if (eye)
        view.eye = *eye;
    else if (at)
        takePlace(*at, view);
    return {};
}

} // namespace

std::vector<std::filesystem::path> OutputPaths::all() const {
    std::vector<std::filesystem::path> paths;
    for (const std::filesystem::path& path : {frame, ids, depth, json, overlay})
        if (!path.empty())
            paths.push_back(path);
    return paths;
}

void addViewOptions(CLI::App& command, ViewArguments& a) {
    const auto add = [&command](const char* name, std::string& value, const char* type, const char* help) {
        command.add_option(name, value, help)->type_name(type)->group("View")->check(notEmpty());
    };
    add("--eye", a.eye, "X,Y,Z",
        "set the position of the eye in metres from the map's south-west corner, z up, e.g. 32530,34660,32");
    add("--at", a.at, "PLACE",
        "place the eye at a name (hill), BLOCK.x,y,z (A9B4.12,34,5), '0xCELL [x y z] w x y z' or '42.1N "
        "33.6E' (the world's start)");
    add("--yaw", a.yaw, "DEG", "set the heading; 0 is north, 90 is east (0, or that of the place)");
    add("--pitch", a.pitch, "DEG", "set the pitch, -90..90; 90 is straight up (0, or that of the place)");
    add("--fov", a.fov, "DEG", "set the vertical field of view (60)");
    add("--size", a.size, "WxH", "set the picture size in pixels (1280x720)");
    add("--root", a.root, "auto|outside|0xCELL", "set the space of the eye, e.g. 0xA9B40105 (auto)");
    add("--player", a.player, "X,Y,Z", "set the position of the player (at the eye)");
    add("--time", a.time, "0..1", "set the time of day; 0 and 1 are midnight (0.5)");
    add("--day", a.day, "NUMBER|NAME",
        "choose a day group of the data, with its sky and weather, e.g. Snow (that of the date)");
    add("--date", a.date, "DATE", "set the date, e.g. 116-3-24 or 'Seedsow 24, 116' (10-1-2)");
    add("--weather", a.weather, "clear|rain", "set the weather (clear)");
    add("--look", a.look, "retail|enhanced",
        "draw as the original did, or with light per pixel and smooth animations (retail)");
    add("--seconds", a.seconds, "S", "set the world's time in seconds, which moves villagers and smoke (0)");
    add("--doors", a.doors, "rest|closed|half|open|0..1",
        "set the openness of all doors (rest: each as in the data)");
    command
        .add_option("--door", a.eachDoor,
                    "set the openness of one door, e.g. inn.front=0.25; repeatable (as in the data)")
        ->type_name("NAME=0..1")
        ->group("View")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    add("--body", a.body, "X,Y,Z", "draw the player's body with its feet at this position (no body)");
    add("--body-yaw", a.bodyYaw, "DEG", "set the heading of the body (0)");
    add("--body-root", a.bodyRoot, "auto|outside|0xCELL", "set the space of the body's centre (auto)");
    add("--body-opacity", a.bodyOpacity, "0..1", "set the opacity of the body (1)");
    add("--body-speed", a.bodySpeed, "M/S",
        "set the speed of the body, which selects standing, walking or running (0)");
    add("--body-metres", a.bodyMetres, "M",
        "set the distance walked, which selects the pose within the stride (0)");
}

void addOutputOptions(CLI::App& command, OutputPaths& outputs) {
    const auto add = [&command](const char* name, std::filesystem::path& path, const char* help) {
        // Through a string, because CLI11 treats an empty path as a missing value.
        command
            .add_option_function<std::string>(
                name, [&path](const std::string& text) { path = text; }, help)
            ->type_name("FILE")
            ->group("Output")
            ->check(notEmpty());
    };
    add("-o,--output", outputs.frame,
        "write the picture; the ending selects the format: .png, .jpg or .webp (none)");
    add("--ids", outputs.ids, "write the id image as NumPy uint32 HxW (none)");
    add("--depth", outputs.depth, "write the distance along each ray in metres as NumPy float32 HxW (none)");
    add("--json", outputs.json, "write the frame's visits, stages, ids and times as JSON (none)");
    add("--overlay", outputs.overlay,
        "write the picture with the outlined region of every visit (none): .png, .jpg or .webp");
}

namespace {

/// Parses NAME=0..1. The name can contain any letters, including '='.
Result<void> checkDoors(const ViewArguments& a, engine::ViewRequest& view) {
    for (const std::string& text : a.eachDoor) {
        const std::size_t sign = text.rfind('=');
        if (sign == std::string::npos || sign == 0)
            return fail(ErrorCode::BadArgument, "--door",
                        "'" + text + "' is not NAME=0..1, such as inn.front=0.25");
        const Result<double> open = parseNumberBetween("--door", text.substr(sign + 1), 0.0, 1.0);
        if (!open)
            return Failure(open.error());
        view.scene.eachDoor.push_back({text.substr(0, sign), *open});
    }
    if (view.scene.doors && !view.scene.eachDoor.empty())
        return fail(ErrorCode::BadArgument, "--door", "--doors sets all doors; give only one of the two");
    return {};
}

Result<void> checkBody(const ViewArguments& a, engine::ViewRequest& view) {
    if (a.body.empty()) {
        if (!(a.bodyYaw + a.bodyRoot + a.bodyOpacity + a.bodySpeed + a.bodyMetres).empty())
            return fail(ErrorCode::BadArgument, "--body",
                        "missing; give the position of the body's feet with --body X,Y,Z");
        return {};
    }
    engine::BodyRequest& body = view.scene.body.emplace();
    const auto opacity = [](std::string_view option, std::string_view text) {
        return parseNumberBetween(option, text, 0.0, 1.0);
    };
    if (Result<void> r = take(a.body, "--body", positionNearMap, body.feet); !r)
        return r;
    if (Result<void> r = take(a.bodyYaw, "--body-yaw", parseNumber, body.yaw); !r)
        return r;
    if (Result<void> r = take(a.bodyRoot, "--body-root", parseRoot, body.root); !r)
        return r;
    if (Result<void> r = take(a.bodySpeed, "--body-speed", parseNumber, body.speed); !r)
        return r;
    if (Result<void> r = take(a.bodyMetres, "--body-metres", parseNumber, body.metres); !r)
        return r;
    return take(a.bodyOpacity, "--body-opacity", opacity, body.opacity);
}

} // namespace

Result<engine::ViewRequest> checkView(const ViewArguments& a) {
    engine::ViewRequest view;
    if (Result<void> r = checkPosition(a, view); !r)
        return Failure(r.error());
    const auto between = [](double low, double high) {
        return [low, high](std::string_view option, std::string_view text) {
            return parseNumberBetween(option, text, low, high);
        };
    };
    if (Result<void> r = take(a.yaw, "--yaw", parseNumber, view.yaw); !r)
        return Failure(r.error());
    if (Result<void> r = take(a.pitch, "--pitch", between(-90.0, 90.0), view.pitch); !r)
        return Failure(r.error());
    if (Result<void> r = take(a.fov, "--fov", between(0.1, 179.0), view.fov); !r)
        return Failure(r.error());
    if (Result<void> r = take(a.size, "--size", parseSize, view.size); !r)
        return Failure(r.error());
    if (Result<void> r = take(a.time, "--time", between(0.0, 1.0), view.scene.time); !r)
        return Failure(r.error());
    view.scene.day.day = a.day;
    if (Result<void> r = take(a.date, "--date", parseDate, view.scene.day.date); !r)
        return Failure(r.error());
    if (Result<void> r = take(a.weather, "--weather", parseWeather, view.scene.weather); !r)
        return Failure(r.error());
    if (Result<void> r = take(a.look, "--look", parseLook, view.scene.look); !r)
        return Failure(r.error());
    if (Result<void> r = take(a.seconds, "--seconds", between(-1e9, 1e9), view.scene.seconds); !r)
        return Failure(r.error());
    if (Result<void> r = take(a.doors, "--doors", parseDoors, view.scene.doors); !r)
        return Failure(r.error());
    if (Result<void> r = checkDoors(a, view); !r)
        return Failure(r.error());
    if (Result<void> r = checkBody(a, view); !r)
        return Failure(r.error());
    return view;
}

namespace {

/// The outputs of line `index`: those of the line, else those of the command line.
OutputPaths outputsOf(const OutputPaths& line, const OutputPaths& common,
                      const std::filesystem::path& directory, std::size_t index) {
    OutputPaths result;
    const auto place = [&](std::filesystem::path OutputPaths::*member) {
        if (!(line.*member).empty())
            result.*member = directory / (line.*member);
        else if (!(common.*member).empty())
            result.*member = directory / fmt::format("{:04}.{}", index, (common.*member).filename().string());
    };
    place(&OutputPaths::ids);
    place(&OutputPaths::depth);
    place(&OutputPaths::json);
    place(&OutputPaths::overlay);
    if (!line.frame.empty())
        result.frame = directory / line.frame;
    else if (line.all().empty())
        result.frame = directory / fmt::format("{:04}.png", index);
    return result;
}

/// Parses one line of a views file. Error messages start with `where`.
Result<ListedView> readView(std::string_view line, const std::string& where, const ViewArguments& common,
                            const OutputPaths& commonOutputs, const std::filesystem::path& directory,
                            std::size_t index) {
    Result<std::vector<std::string>> words = splitArguments(line);
    if (!words)
        return fail(ErrorCode::BadArgument, where, words.error().message());
    ViewArguments arguments = common;
    OutputPaths outputs;
    CLI::App parser;
    parser.set_help_flag();
    addViewOptions(parser, arguments);
    addOutputOptions(parser, outputs);
    std::reverse(words->begin(), words->end()); // CLI11 takes the last word first
    try {
        parser.parse(std::move(*words));
    } catch (const CLI::Error& error) {
        return fail(ErrorCode::BadArgument, where, error.what());
    }
    Result<engine::ViewRequest> view = checkView(arguments);
    if (!view)
        return fail(ErrorCode::BadArgument, where, view.error().message());
    if (view->isAtStart)
        return fail(ErrorCode::BadArgument, where, "no viewpoint given; use --at PLACE or --eye X,Y,Z");
    return ListedView{std::move(*view), outputsOf(outputs, commonOutputs, directory, index)};
}

} // namespace

Result<engine::ViewRequest> parseView(std::string_view line, const std::string& where) {
    return readView(line, where, {}, {}, {}, 0).map([](ListedView listed) { return std::move(listed.view); });
}

Result<std::vector<ListedView>> readViews(const std::filesystem::path& file, const ViewArguments& common,
                                          const OutputPaths& commonOutputs,
                                          const std::filesystem::path& directory) {
    const Result<std::string> text = output::readTextFile(file, kMaxListFile);
    if (!text)
        return Failure(text.error());
    std::vector<ListedView> views;
    std::size_t lineNumber = 0;
    for (std::string_view rest = *text; !rest.empty();) {
        const std::size_t end = rest.find('\n');
        const std::string_view line = trimmed(rest.substr(0, end));
        rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
        ++lineNumber;
        if (line.empty() || line.starts_with('#'))
            continue;
        Result<ListedView> view = readView(line, fmt::format("{} line {}", file.string(), lineNumber), common,
                                           commonOutputs, directory, views.size());
        if (!view)
            return Failure(view.error());
        views.push_back(std::move(*view));
    }
    if (views.empty())
        return fail(ErrorCode::BadArgument, file.string(),
                    "contains no view; write one line of options per view, such as --eye 1,2,3 --yaw 90");
    return views;
}

Result<void> checkOutputs(std::span<const std::filesystem::path> outputs) {
    std::vector<std::filesystem::path> sorted;
    for (const std::filesystem::path& path : outputs) {
        if (Result<void> writable = output::checkWritable(path); !writable)
            return writable;
        sorted.push_back(absolutePath(path).lexically_normal());
    }
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end() && !twice->string().starts_with("/dev/"))
        return fail(ErrorCode::BadArgument, twice->string(),
                    "is given for two outputs; give each its own file");
    return {};
}

} // namespace limen::cli
