#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

// The environment of the process. All texts are UTF-8.
namespace limen::platform {

/// "" for an unset variable.
[[nodiscard]] std::string environmentVariable(const char* name);
/// The user's own directory: $HOME, or %USERPROFILE% on Windows; empty if it is not set.
[[nodiscard]] std::filesystem::path homeDirectory();
/// True if a window may open: DISPLAY or WAYLAND_DISPLAY is set; always on Windows.
[[nodiscard]] bool hasDesktop();
/// The roots of the drives that are there; empty on systems without drive letters.
[[nodiscard]] std::vector<std::filesystem::path> driveRoots();

/// The absolute directories of a text in the form of PATH.
[[nodiscard]] std::vector<std::filesystem::path> directoriesOf(std::string_view searchPath);
/// The file name of a program: `name`, or NAME.exe on Windows.
[[nodiscard]] std::string programFileName(std::string_view name);
/// True for a file that this user may run.
[[nodiscard]] bool isProgram(const std::filesystem::path& file);

} // namespace limen::platform
