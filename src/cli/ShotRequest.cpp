#include "cli/ShotRequest.h"

#include "cli/Parse.h"
#include "cli/PlaceNotation.h"
#include "output/OutputFile.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <variant>

namespace limen::cli {
namespace {

constexpr double kFarthestPosition = 1e6; ///< metres; farther from the map a position is a slip of the hand
constexpr std::size_t kMaxListFile = 64u << 20;

/// Parses `text` into `value` unless it is empty.
template <class T, class Parse>
Result<void> take(const std::string& text, const char* option, Parse parse, T& value) {
    if (text.empty())
        return {};
    auto parsed = parse(option, text);
    if (!parsed)
        return tl::unexpected(std::move(parsed.error()));
    value = std::move(*parsed);
    return {};
}

Result<Vec3> positionNearMap(std::string_view option, std::string_view text) {
    const Result<Vec3> value = parseVec3(option, text);
    if (value &&
        !(std::max({std::abs(value->x), std::abs(value->y), std::abs(value->z)}) <= kFarthestPosition))
        return fail(ErrorCode::BadArgument, std::string(option),
                    fmt::format("'{}' lies more than {:.0f} km from the map's corner", text,
                                kFarthestPosition / 1000.0));
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
        return fail(ErrorCode::BadArgument, "--player", "the player is where --body is; give one of the two");
    if (eye && at)
        return fail(ErrorCode::BadArgument, "--at", "give either --eye or --at, not both");
    if (!eye && !at)
        return fail(ErrorCode::BadArgument, "--eye", "no viewpoint given; use --at PLACE or --eye X,Y,Z");
    if (eye)
        view.eye = *eye;
    else
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

namespace {

/// For CLI11: an empty argument is a slip (an unset variable in a script), never a value.
std::string refuseEmpty(const std::string& text) {
    return text.empty() ? "is given without a value" : "";
}

} // namespace

void addViewOptions(CLI::App& command, ViewArguments& a) {
    const auto add = [&command](const char* name, std::string& value, const char* type, const char* help) {
        command.add_option(name, value, help)->type_name(type)->group("View")->check(refuseEmpty);
    };
    add("--eye", a.eye, "X,Y,Z", "the eye, in metres from the map's south-west corner, z up");
    add("--at", a.at, "PLACE", "or a place: a name, BLOCK.x,y,z, '0xCELL [x y z] w x y z', '42.1N 33.6E'");
    add("--yaw", a.yaw, "DEG", "0 looks north, 90 east");
    add("--pitch", a.pitch, "DEG", "-90..90, 90 looks straight up");
    add("--fov", a.fov, "DEG", "vertical field of view (60)");
    add("--size", a.size, "WxH", "picture size in pixels (1280x720)");
    add("--root", a.root, "auto|outside|0xCELL", "the space the eye is in (auto)");
    add("--player", a.player, "X,Y,Z", "where the player stands (at the eye)");
    add("--time", a.time, "0..1", "time of day, 0 and 1 midnight (0.5)");
    add("--day", a.day, "NUMBER|NAME",
        "the kind of day, of those that the data has: its sky and weather (0)");
    add("--weather", a.weather, "clear|rain", "the weather (clear)");
    add("--seconds", a.seconds, "S", "seconds since the world began: where villagers and smoke are (0)");
    add("--doors", a.doors, "rest|closed|half|open|0..1", "how far all doors stand open (each as it rests)");
    command.add_option("--door", a.eachDoor, "how far one door stands open; may be given again")
        ->type_name("NAME=0..1")
        ->group("View")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    add("--body", a.body, "X,Y,Z", "the feet of the player's body, which is seen (none)");
    add("--body-yaw", a.bodyYaw, "DEG", "where it faces (0)");
    add("--body-root", a.bodyRoot, "auto|outside|0xCELL", "the space its middle is in (auto)");
    add("--body-opacity", a.bodyOpacity, "0..1", "how much of it is seen (1)");
    add("--body-speed", a.bodySpeed, "M/S", "how fast it walks or runs (0: it stands)");
    add("--body-metres", a.bodyMetres, "M", "how far it has walked: where it is in its stride (0)");
}

void addOutputOptions(CLI::App& command, OutputPaths& outputs) {
    const auto add = [&command](const char* name, std::filesystem::path& path, const char* help) {
        // Through a string: CLI11 takes an empty path for no value.
        command
            .add_option_function<std::string>(
                name, [&path](const std::string& text) { path = text; }, help)
            ->type_name("FILE")
            ->group("Output")
            ->check(refuseEmpty);
    };
    add("-o,--output", outputs.frame, "the picture, PNG");
    add("--ids", outputs.ids, "the id image, NumPy uint32 HxW");
    add("--depth", outputs.depth, "the distance along each ray in metres, NumPy float32 HxW");
    add("--json", outputs.json, "what the frame is made of, JSON");
    add("--overlay", outputs.overlay, "the picture with the region of every visit outlined, PNG");
}

namespace {

/// NAME=0..1; the name may have any letters, '=' too.
Result<void> checkDoors(const ViewArguments& a, engine::ViewRequest& view) {
    for (const std::string& text : a.eachDoor) {
        const std::size_t sign = text.rfind('=');
        if (sign == std::string::npos || sign == 0)
            return fail(ErrorCode::BadArgument, "--door", "'" + text + "' is not NAME=0..1");
        const Result<double> open = parseNumberBetween("--door", text.substr(sign + 1), 0.0, 1.0);
        if (!open)
            return tl::unexpected(open.error());
        view.scene.eachDoor.push_back({text.substr(0, sign), *open});
    }
    if (view.scene.doors && !view.scene.eachDoor.empty())
        return fail(ErrorCode::BadArgument, "--door",
                    "says nothing where --doors speaks for all; give one of the two");
    return {};
}

Result<void> checkBody(const ViewArguments& a, engine::ViewRequest& view) {
    if (a.body.empty()) {
        if (!(a.bodyYaw + a.bodyRoot + a.bodyOpacity + a.bodySpeed + a.bodyMetres).empty())
            return fail(ErrorCode::BadArgument, "--body", "missing: where the body's feet are, X,Y,Z");
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
        return tl::unexpected(r.error());
    const auto between = [](double low, double high) {
        return [low, high](std::string_view option, std::string_view text) {
            return parseNumberBetween(option, text, low, high);
        };
    };
    if (Result<void> r = take(a.yaw, "--yaw", parseNumber, view.yaw); !r)
        return tl::unexpected(r.error());
    if (Result<void> r = take(a.pitch, "--pitch", between(-90.0, 90.0), view.pitch); !r)
        return tl::unexpected(r.error());
    if (Result<void> r = take(a.fov, "--fov", between(0.1, 179.0), view.fov); !r)
        return tl::unexpected(r.error());
    if (Result<void> r = take(a.size, "--size", parseSize, view.size); !r)
        return tl::unexpected(r.error());
    if (Result<void> r = take(a.time, "--time", between(0.0, 1.0), view.scene.time); !r)
        return tl::unexpected(r.error());
    view.scene.day = a.day;
    if (Result<void> r = take(a.weather, "--weather", parseWeather, view.scene.weather); !r)
        return tl::unexpected(r.error());
    if (Result<void> r = take(a.seconds, "--seconds", between(-1e9, 1e9), view.scene.seconds); !r)
        return tl::unexpected(r.error());
    if (Result<void> r = take(a.doors, "--doors", parseDoors, view.scene.doors); !r)
        return tl::unexpected(r.error());
    if (Result<void> r = checkDoors(a, view); !r)
        return tl::unexpected(r.error());
    if (Result<void> r = checkBody(a, view); !r)
        return tl::unexpected(r.error());
    return view;
}

namespace {

/// The outputs of line `index`: what the line names, else what the command line asks for.
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

/// One line of a views file, or a message that starts with where it stands.
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
        return tl::unexpected(text.error());
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
            return tl::unexpected(view.error());
        views.push_back(std::move(*view));
    }
    if (views.empty())
        return fail(ErrorCode::BadArgument, file.string(),
                    "holds no view; write one line of options each, such as --eye 1,2,3 --yaw 90");
    return views;
}

Result<void> checkOutputs(std::span<const std::filesystem::path> outputs) {
    std::vector<std::filesystem::path> sorted;
    for (const std::filesystem::path& path : outputs) {
        if (Result<void> writable = output::checkWritable(path); !writable)
            return writable;
        sorted.push_back(std::filesystem::absolute(path).lexically_normal());
    }
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end() && !twice->string().starts_with("/dev/"))
        return fail(ErrorCode::BadArgument, twice->string(), "is named for two outputs");
    return {};
}

} // namespace limen::cli
