#include "doctor/Machine.h"
#include "engine/UserFiles.h"
#include "gpu/device/HeadlessContext.h"
#include "gpu/device/TextureMemory.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string_view>

#include <unistd.h>
#include <xcb/xcb.h>

namespace limen::doctor {
namespace {

namespace fs = std::filesystem;

std::string environmentText(const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr ? value : "";
}

bool answersAsXServer(const std::string& display) {
    xcb_connection_t* connection = xcb_connect(display.c_str(), nullptr);
    const bool answers = xcb_connection_has_error(connection) == 0;
    xcb_disconnect(connection);
    return answers;
}

/// A value of /proc/meminfo in bytes; 0 if it is missing.
std::uint64_t memoryField(std::string_view name) {
    std::ifstream in("/proc/meminfo");
    std::string field, unit;
    for (std::uint64_t kib = 0; in >> field >> kib; std::getline(in, unit))
        if (field == name)
            return kib * 1024;
    return 0;
}

/// The reason why no file can be created in a directory; empty: one can.
std::string writeProblem(const fs::path& directory) {
    std::string pattern = (directory / ".limen-doctor-XXXXXX").string();
    const int file = ::mkstemp(pattern.data());
    if (file < 0)
        return std::strerror(errno);
    ::close(file);
    ::unlink(pattern.c_str());
    return "";
}

std::uint64_t sizeOfFiles(const fs::path& directory) {
    std::uint64_t bytes = 0;
    std::error_code error;
    for (fs::recursive_directory_iterator it(directory, error), end; !error && it != end;
         it.increment(error)) {
        std::error_code ignored;
        if (it->is_regular_file(ignored))
            bytes += it->file_size(ignored);
    }
    return bytes;
}

} // namespace

DirectoryFacts queryDirectory(const fs::path& path) {
    DirectoryFacts facts{path, "", 0, 0};
    if (path.empty())
        return facts;
    std::error_code error;
    facts.bytes = sizeOfFiles(path);
    fs::path existing = path;
    while (!fs::exists(existing, error) && existing.has_relative_path())
        existing = existing.parent_path();
    if (!fs::is_directory(existing, error))
        facts.problem = existing.string() + " is not a directory";
    else
        facts.problem = writeProblem(existing);
    const fs::space_info space = fs::space(existing, error);
    if (!error)
        facts.freeBytes = space.available;
    return facts;
}

fs::path findProgram(const std::string& name) {
    const std::string paths = environmentText("PATH");
    for (std::size_t at = 0; at <= paths.size();) {
        const std::size_t end = std::min(paths.find(':', at), paths.size());
        const fs::path program = fs::path(paths.substr(at, end - at)) / name;
        std::error_code ignored;
        if (program.is_absolute() && fs::is_regular_file(program, ignored) &&
            ::access(program.c_str(), X_OK) == 0)
            return program;
        at = end + 1;
    }
    return {};
}

MachineFacts queryMachine() {
    MachineFacts facts;
    const Result<gpu::HeadlessContext> context = gpu::HeadlessContext::create();
    if (context) {
        facts.driver = gpu::queryCapabilities();
        facts.textureMemory = gpu::queryTextureMemory();
    } else {
        facts.driver = Failure(context.error());
    }
    facts.memory = memoryField("MemTotal:");
    facts.availableMemory = memoryField("MemAvailable:");
    facts.display = {environmentText("DISPLAY"), environmentText("WAYLAND_DISPLAY"), false};
    facts.display.answers = !facts.display.x11.empty() && answersAsXServer(facts.display.x11);
    facts.font = engine::findFont(engine::fontPaths(engine::programPath())).value_or(fs::path());
    facts.cache = queryDirectory(engine::cacheRoot());
    facts.configuration = queryDirectory(engine::configurationRoot());
    facts.ffmpeg = findProgram("ffmpeg");
    return facts;
}

} // namespace limen::doctor
