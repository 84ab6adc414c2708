#include "check/View.h"

#include "world/Loader.h"

#include <algorithm>

#include <fmt/format.h>

namespace limen::check {

std::optional<ViewKind> kindNamed(std::string_view name) {
    const auto found = std::find(kKindNames.begin(), kKindNames.end(), name);
    if (found == kKindNames.end())
        return std::nullopt;
    return static_cast<ViewKind>(found - kKindNames.begin());
}

dat::BlockCoord centreOf(const View& view) {
    return view.root != 0 ? dat::blockOf(view.root) : world::blockAt(view.eye);
}

namespace {

std::string rootOption(dat::RecordId cell) {
    return cell == 0 ? "outside" : fmt::format("0x{:08X}", cell);
}

std::string doorOptions(const View& view) {
    if (view.doors)
        return fmt::format(" --doors={}", *view.doors);
    std::string text;
    for (const View::DoorState& door : view.eachDoor)
        text += fmt::format(" --door='{}={}'", door.name, door.open);
    return text;
}

std::string playerOptions(const View& view) {
    if (view.body) {
        const View::Body& body = *view.body;
        return fmt::format(" --body={},{},{} --body-yaw={} --body-root={}", body.feet.x, body.feet.y,
                           body.feet.z, body.yaw, rootOption(body.root)) +
               (body.opacity != 1.0 ? fmt::format(" --body-opacity={}", body.opacity) : "") +
               (body.speed != 0.0 ? fmt::format(" --body-speed={}", body.speed) : "") +
               (body.metres != 0.0 ? fmt::format(" --body-metres={}", body.metres) : "");
    }
    return view.player ? fmt::format(" --player={},{},{}", view.player->x, view.player->y, view.player->z)
                       : "";
}

} // namespace

std::string shotOptions(const View& view) {
    return fmt::format("--eye={},{},{} --yaw={} --pitch={} --fov={} --size={}x{} --root={}", view.eye.x,
                       view.eye.y, view.eye.z, view.yaw, view.pitch, view.fov, view.width, view.height,
                       rootOption(view.root)) +
           (view.time != 0.5 ? fmt::format(" --time={}", view.time) : "") +
           (view.seconds != 0.0 ? fmt::format(" --seconds={}", view.seconds) : "") + doorOptions(view) +
           fmt::format(" --day={}", view.dayGroup) + (view.rain ? " --weather=rain" : "") +
           (view.look == world::Look::Enhanced ? " --look=enhanced" : "") + playerOptions(view);
}

} // namespace limen::check
