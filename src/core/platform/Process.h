#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace limen::platform {

[[nodiscard]] int processId();
/// The path of the running program; empty if the system does not report it.
[[nodiscard]] std::filesystem::path programPath();
/// A path under which the bytes of this code can be read. For the running program, also if its file was replaced
/// meanwhile; for a program that uses the engine as a shared library, those of the library.
[[nodiscard]] std::filesystem::path programBytes();
/// Lets another program take the place of this one, with its output and its exit code. Returns only on failure, with
/// the reason.
[[nodiscard]] std::string becomeProgram(const std::filesystem::path& program,
                                        const std::vector<std::string>& arguments);

/// Main memory in bytes; none: unknown.
struct Memory {
    std::optional<std::uint64_t> total;
    std::optional<std::uint64_t> available; ///< for programs, without swapping
};
[[nodiscard]] Memory systemMemory();

} // namespace limen::platform
