#include "cli/PlaceNotation.h"

#include "engine/Camera.h"
#include "engine/map/MapCoordinates.h"

#include <charconv>
#include <fmt/format.h>

namespace limen::cli {
namespace {

constexpr double kBlockSize = 192.0;
constexpr int kLastBlock = 0xFE;
constexpr double kMapEnd = (kLastBlock + 1) * kBlockSize;

Failure bad(std::string_view option, std::string_view what) {
    return fail(ErrorCode::BadArgument, std::string(option), std::string(what));
}

bool isHexWord(std::string_view text) {
    if (text.starts_with("0x") || text.starts_with("0X"))
        text.remove_prefix(2);
    return (text.size() == 4 || text.size() == 8) &&
           text.find_first_not_of("0123456789abcdefABCDEF") == std::string_view::npos;
}

/// The block and, for eight digits, the root that a block word or cell id names.
struct BlockAndRoot {
    dat::BlockCoord block;
    engine::RootChoice root;
};

Result<BlockAndRoot> parseBlock(std::string_view option, std::string_view text) {
    const Result<dat::RecordId> number = parseRecordId(option, text);
    if (!number)
        return Failure(number.error());
    const bool wholeId = text.size() - (text.starts_with("0x") || text.starts_with("0X") ? 2 : 0) == 8;
    const dat::RecordId id = wholeId ? *number : *number << 16;
    BlockAndRoot result{dat::blockOf(id), {}};
    if (result.block.x > kLastBlock || result.block.y > kLastBlock)
        return bad(option, fmt::format("{} is beyond the map; the last landblock is 0xFEFE", text));
    const std::uint32_t low = id & 0xFFFFu;
    if (wholeId && low >= dat::kFirstCell && low <= dat::kLastCell)
        result.root = {engine::RootChoice::Rule::Cell, id};
    else if (wholeId && low >= 1 && low <= 0x40)
        result.root = {engine::RootChoice::Rule::Outside, 0};
    return result;
}

Vec3 globalOf(dat::BlockCoord block, const Vec3& local) {
    return Vec3(block.x * kBlockSize, block.y * kBlockSize, 0.0) + local;
}

/// Numbers separated by blanks or commas.
Result<std::vector<double>> parseNumbers(std::string_view option, std::string_view text) {
    std::vector<double> numbers;
    while (!(text = trimmed(text)).empty()) {
        const std::size_t end = std::min(text.find_first_of(" \t,"), text.size());
        const Result<double> number = parseNumber(option, text.substr(0, end));
        if (!number)
            return Failure(number.error());
        numbers.push_back(*number);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return numbers;
}

/// Sets the heading of a retail quaternion. The identity looks north, along +Y.
Result<void> setHeading(std::string_view option, const std::vector<double>& q, PlacePosition& place) {
    const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    if (!(length > 1e-6) || !std::isfinite(length))
        return bad(option, "the quaternion w x y z has length 0; give one such as 1 0 0 0");
    const Quat rotation(q[0] / length, q[1] / length, q[2] / length, q[3] / length);
    const engine::Heading heading = engine::headingOf(rotation * Vec3(0.0, 1.0, 0.0));
    place.yaw = heading.yaw;
    place.pitch = heading.pitch;
    return {};
}

/// "0xA9B40031 [x y z] w x y z".
Result<PlaceNotation> parseRetail(std::string_view option, std::string_view text) {
    const std::size_t open = text.find('['), close = text.find(']');
    if (close == std::string_view::npos || close < open)
        return bad(option,
                   fmt::format("'{}' has no closing bracket; write 0xA9B40031 [x y z] w x y z", text));
    const std::string_view word = trimmed(text.substr(0, open));
    if (!isHexWord(word))
        return bad(option, fmt::format("'{}' is not a cell id such as 0xA9B40031", word));
    const Result<BlockAndRoot> block = parseBlock(option, word);
    if (!block)
        return Failure(block.error());
    const Result<std::vector<double>> local = parseNumbers(option, text.substr(open + 1, close - open - 1));
    if (!local)
        return Failure(local.error());
    const Result<std::vector<double>> quat = parseNumbers(option, text.substr(close + 1));
    if (!quat)
        return Failure(quat.error());
    if (local->size() != 3 || (!quat->empty() && quat->size() != 4))
        return bad(option, "a retail location has the form 0xA9B40031 [x y z] w x y z");
    PlacePosition place;
    place.eye = globalOf(block->block, {(*local)[0], (*local)[1], (*local)[2]});
    place.root = block->root;
    if (!quat->empty()) {
        if (const Result<void> set = setHeading(option, *quat, place); !set)
            return Failure(set.error());
    }
    return place;
}

/// "42.1N": the number, negated by `minus`; nullopt if the text does not end in `plus` or `minus`.
std::optional<double> readCoordinate(std::string_view text, char plus, char minus) {
    text = trimmed(text);
    if (text.empty())
        return {};
    const char letter = static_cast<char>(text.back() & ~0x20); // upper case
    const Result<double> number = parseNumber("", text.substr(0, text.size() - 1));
    if (!number || (letter != plus && letter != minus))
        return {};
    return letter == minus ? -*number : *number;
}

/// "42.1N 33.6E" or "42.1N, 33.6E"; nullopt for any other form.
std::optional<Vec2> readMapCoordinates(std::string_view text) {
    const std::size_t split = text.find_first_of(" ,");
    if (split == std::string_view::npos)
        return {};
    std::string_view second = trimmed(text.substr(split));
    if (second.starts_with(','))
        second.remove_prefix(1);
    const std::optional<double> north = readCoordinate(text.substr(0, split), 'N', 'S');
    const std::optional<double> east = readCoordinate(second, 'E', 'W');
    if (!north || !east)
        return {};
    return Vec2(*east, *north) * engine::kMapUnitMetres + engine::kMapOriginMetres;
}

} // namespace

Result<PlaceNotation> parsePlace(std::string_view option, std::string_view text) {
    const std::string_view clean = trimmed(text);
    if (clean.empty())
        return bad(option, "the place is empty; give a name or a position");
    if (clean.find('[') != std::string_view::npos)
        return parseRetail(option, clean);
    if (const std::optional<Vec2> ground = readMapCoordinates(clean)) {
        if (!(ground->x >= 0.0 && ground->y >= 0.0 && ground->x < kMapEnd && ground->y < kMapEnd))
            return bad(option,
                       fmt::format(
                           "'{}' is beyond the map, whose coordinates end at 101.9S 101.9W and 102.0N 102.0E",
                           clean));
        PlacePosition place;
        place.eye = Vec3(*ground, 0.0);
        place.onGround = true;
        return place;
    }
    const std::size_t dot = clean.find('.');
    if (dot != std::string_view::npos && isHexWord(clean.substr(0, dot)) &&
        clean.find(',') != std::string_view::npos) {
        const Result<BlockAndRoot> block = parseBlock(option, clean.substr(0, dot));
        if (!block)
            return Failure(block.error());
        const Result<Vec3> local = parseVec3(option, clean.substr(dot + 1));
        if (!local)
            return Failure(local.error());
        PlacePosition place;
        place.eye = globalOf(block->block, *local);
        place.root = block->root;
        return place;
    }
    const char first = static_cast<char>(clean.front() | 0x20); // lower case
    const bool isLikeName = first >= 'a' && first <= 'z' && clean.find(',') == std::string_view::npos;
    if (clean.find_first_of(" ,") != std::string_view::npos && !isLikeName)
        return bad(
            option,
            fmt::format(
                "'{}' is not a place; give a name, BLOCK.x,y,z, 0xCELL [x y z] w x y z or map coordinates",
                clean));
    return PlaceName{std::string(clean)};
}

} // namespace limen::cli
