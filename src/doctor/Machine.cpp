#include "doctor/Machine.h"

#include "doctor/Bytes.h"
#include "engine/UserFiles.h"

#include <fmt/format.h>

namespace limen::doctor {
namespace {

constexpr std::uint64_t kMiB = std::uint64_t{1} << 20;
// The window holds 0.5 GiB at most (docs/performance.md); the system needs a margin.
constexpr std::uint64_t kNeededMemory = 512 * kMiB, kComfortableMemory = 1536 * kMiB;
constexpr std::uint64_t kNeededTextureMemory = 512 * kMiB;
// The built-in world takes 20 MiB; six versions stay in the cache.
constexpr std::uint64_t kNeededDisk = 64 * kMiB, kComfortableDisk = 512 * kMiB;
constexpr float kFullAnisotropy = 8.0f;

Finding driverFinding(const Result<gpu::Capabilities>& driver) {
    if (!driver)
        return {"OpenGL driver", Outcome::Failed, driver.error().message(),
                "install or update the graphics driver; on Debian, libegl-mesa0 and libgl1-mesa-dri draw "
                "without a "
                "graphics card. The verbs probe, walk and dat, and shot --reference, need no driver"};
    return {"OpenGL driver", Outcome::Ok, fmt::format("{}, {}", driver->renderer, driver->version), ""};
}

void addDriver(const MachineFacts& facts, Findings& findings) {
    findings.push_back(driverFinding(facts.driver));
    if (!facts.driver) {
        for (const char* check : {"drawing speed", "bindless", "anisotropy", "texture memory"})
            findings.push_back({check, Outcome::NotTested, "there is no driver", ""});
        return;
    }
    const gpu::Capabilities& driver = *facts.driver;
    if (driver.software)
        findings.push_back(
            {"drawing speed", Outcome::Warning,
             "software rasteriser: the processor draws; frames take 0.1 to 1 s, and films take hours",
             "install the driver of the graphics card, or draw small pictures (--size 640x360)"});
    else
        findings.push_back({"drawing speed", Outcome::Ok, "the graphics card draws", ""});
    findings.push_back(
        driver.bindless ? Finding{"bindless", Outcome::Ok, "GL_ARB_bindless_texture", ""}
                        : Finding{"bindless", Outcome::Ok,
                                  "no GL_ARB_bindless_texture: textures are kept in arrays, which takes more "
                                  "texture memory; pictures are the same",
                                  ""});
    findings.push_back(
        driver.maxAnisotropy >= kFullAnisotropy
            ? Finding{"anisotropy", Outcome::Ok, fmt::format("{:g} samples", driver.maxAnisotropy), ""}
            : Finding{"anisotropy", Outcome::Warning,
                      "no anisotropic filtering of 8 samples: distant floors and ground are blurred",
                      "update the graphics driver"});
    if (!facts.textureMemory)
        findings.push_back({"texture memory", Outcome::NotTested, "the driver does not report it", ""});
    else if (*facts.textureMemory < kNeededTextureMemory)
        findings.push_back({"texture memory", Outcome::Warning,
                            fmt::format("{}; a town with landscape takes up to {}",
                                        bytesText(*facts.textureMemory), bytesText(kNeededTextureMemory)),
                            "close other programs, or load fewer blocks (--radius)"});
    else
        findings.push_back({"texture memory", Outcome::Ok, bytesText(*facts.textureMemory), ""});
}

Finding memoryFinding(const MachineFacts& facts) {
    if (facts.availableMemory == 0)
        return {"memory", Outcome::NotTested, "the system does not report it", ""};
    const std::string text =
        fmt::format("{} available of {}", bytesText(facts.availableMemory), bytesText(facts.memory));
    if (facts.availableMemory < kNeededMemory)
        return {"memory", Outcome::Failed, fmt::format("{}; Limen needs {}", text, bytesText(kNeededMemory)),
                "close other programs"};
    if (facts.availableMemory < kComfortableMemory)
        return {"memory", Outcome::Warning,
                fmt::format("{}; {} are enough for any view", text, bytesText(kComfortableMemory)),
                "close other programs, or load fewer blocks (--radius)"};
    return {"memory", Outcome::Ok, text, ""};
}

Finding displayFinding(const DisplayFacts& display) {
    if (!display.desktop.empty())
        return {"display", Outcome::Ok, display.desktop, ""};
    if (display.answers)
        return {
            "display", Outcome::Ok,
            fmt::format("X11 display {}{}", display.x11, display.wayland.empty() ? "" : ", under Wayland"),
            ""};
    if (!display.x11.empty())
        return {
            "display", Outcome::Warning,
            fmt::format("the X server of display {} does not answer", display.x11),
            "check DISPLAY and the X authority of this user; limen view needs it, the other verbs do not"};
    if (!display.wayland.empty())
        return {"display", Outcome::Warning,
                fmt::format("Wayland display {} without an X11 display", display.wayland),
                "start Xwayland, or install the GLFW library for Wayland (libglfw3-wayland)"};
    return {"display", Outcome::Warning, "DISPLAY and WAYLAND_DISPLAY are not set: no window can open",
            "start limen view in a desktop session; the other verbs need no display"};
}

Finding fontFinding(const std::filesystem::path& font) {
    if (!font.empty())
        return {"font", Outcome::Ok, font.string(), ""};
    return {"font", Outcome::Warning, "the font of the window is not installed: its text is coarse",
            systemWords().fontRemedy};
}

Finding directoryFinding(const char* check, const DirectoryFacts& facts, const char* loss,
                         const char* variable, const char* fallback) {
    const std::string remedy = fmt::format("set {} to a writable directory", variable);
    if (facts.path.empty())
        return {check, Outcome::Warning, fmt::format("{} is not set: {}", fallback, loss), remedy};
    if (!facts.problem.empty())
        return {check, Outcome::Warning,
                fmt::format("{} is not writable ({}): {}", facts.path.string(), facts.problem, loss), remedy};
    return {check, Outcome::Ok, fmt::format("{}, {}", facts.path.string(), bytesText(facts.bytes)), ""};
}

Finding diskFinding(const DirectoryFacts& cache) {
    if (cache.path.empty() || !cache.problem.empty())
        return {"disk", Outcome::NotTested, "there is no writable cache directory", ""};
    const std::string text = fmt::format("{} free beside the cache", bytesText(cache.freeBytes));
    if (cache.freeBytes < kComfortableDisk)
        return {"disk", cache.freeBytes < kNeededDisk ? Outcome::Failed : Outcome::Warning, text,
                "free some space; the built-in world, pictures and films need it"};
    return {"disk", Outcome::Ok, text, ""};
}

Finding filmFinding(const std::filesystem::path& ffmpeg) {
    if (!ffmpeg.empty())
        return {"films", Outcome::Ok, ffmpeg.string(), ""};
    return {"films", Outcome::Warning, "there is no ffmpeg: walks can be drawn as pictures, not as films",
            systemWords().filmRemedy};
}

} // namespace

Findings judgeMachine(const MachineFacts& facts) {
    Findings findings;
    addDriver(facts, findings);
    findings.push_back(memoryFinding(facts));
    findings.push_back(displayFinding(facts.display));
    findings.push_back(fontFinding(facts.font));
    const engine::UserDirectoryNames names = engine::userDirectoryNames();
    findings.push_back(directoryFinding("cache", facts.cache,
                                        "the built-in world is written anew by every run", names.cache,
                                        names.cacheFallback));
    findings.push_back(directoryFinding("settings", facts.configuration, "settings are not kept",
                                        names.configuration, names.configurationFallback));
    findings.push_back(diskFinding(facts.cache));
    findings.push_back(filmFinding(facts.ffmpeg));
    return findings;
}

} // namespace limen::doctor
