#include "check/View.h"

#include "world/Loader.h"

#include <algorithm>

#include <fmt/format.h>

namespace limen::check {

std::optional<Kind> kindNamed(std::string_view name) {
    const auto found = std::find(kKindNames.begin(), kKindNames.end(), name);
    if (found == kKindNames.end())
        return std::nullopt;
    return static_cast<Kind>(found - kKindNames.begin());
}

dat::BlockCoord centreOf(const View& view) {
    return view.root != 0 ? dat::blockOf(view.root) : world::blockAt(view.eye);
}

std::string shotOptions(const View& view) {
    const std::string root = view.root == 0 ? "outside" : fmt::format("0x{:08X}", view.root);
    return fmt::format("--eye={},{},{} --yaw={} --pitch={} --fov={} --size={}x{} --root={}", view.eye.x,
                       view.eye.y, view.eye.z, view.yaw, view.pitch, view.fov, view.width, view.height,
                       root) +
           (view.seconds != 0.0 ? fmt::format(" --seconds={}", view.seconds) : "") +
           (view.doors ? fmt::format(" --doors={}", *view.doors) : "") + (view.rain ? " --weather=rain" : "");
}

} // namespace limen::check
