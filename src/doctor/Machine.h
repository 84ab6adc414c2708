#pragma once

#include "core/Error.h"
#include "doctor/Finding.h"
#include "gpu/device/Capabilities.h"

#include <cstdint>
#include <filesystem>
#include <optional>

// The computer: driver, memory, display, fonts, directories, programs. Facts are queried first, then judged, so that
// tests can judge any computer.
namespace limen::doctor {

/// A directory that Limen writes to.
struct DirectoryFacts {
    std::filesystem::path path; ///< empty: no directory is known, because a variable is not set
    std::string problem;        ///< the reason why it is not writable; empty: it is
    std::uint64_t bytes = 0;    ///< size of its files
    std::uint64_t freeBytes = 0;
};

/// The display for `limen view`.
struct DisplayFacts {
    std::string x11;       ///< the value of DISPLAY; empty: not set
    std::string wayland;   ///< the value of WAYLAND_DISPLAY; empty: not set
    bool answers = false;  ///< the X server of `x11` accepts this process
    std::string desktop{}; ///< a desktop without X11 and Wayland; empty: there is none
};

struct MachineFacts {
    Result<gpu::Capabilities> driver = fail(ErrorCode::Driver, "EGL", "not queried");
    std::optional<std::uint64_t> textureMemory;    ///< bytes, if the driver reports them
    std::uint64_t memory = 0, availableMemory = 0; ///< bytes; 0: not known
    DisplayFacts display;
    std::filesystem::path font; ///< of the window; empty: not found
    DirectoryFacts cache, configuration;
    std::filesystem::path ffmpeg; ///< empty: not found
};

/// The words for this system in findings.
struct SystemWords {
    const char *fontRemedy, *filmRemedy;
};

/// The display, the words and the variables of this system.
[[nodiscard]] DisplayFacts queryDisplay();
[[nodiscard]] SystemWords systemWords();

/// Queries this computer and process. Creates a headless OpenGL context for a moment. Leaves no files.
[[nodiscard]] MachineFacts queryMachine();
/// Checks of the facts, in the order of the table.
[[nodiscard]] Findings judgeMachine(const MachineFacts& facts);

/// Facts of a directory that need not exist yet: the nearest existing one above it decides.
[[nodiscard]] DirectoryFacts queryDirectory(const std::filesystem::path& path);
/// A program in PATH; empty if there is none.
[[nodiscard]] std::filesystem::path findProgram(const std::string& name);

} // namespace limen::doctor
