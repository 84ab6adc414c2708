#include "doctor/Machine.h"

#include "core/platform/Environment.h"
#include "core/platform/Files.h"
#include "core/platform/Process.h"
#include "engine/UserFiles.h"
#include "gpu/device/HeadlessContext.h"
#include "gpu/device/TextureMemory.h"

namespace limen::doctor {
namespace {

namespace fs = std::filesystem;

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
        facts.problem = platform::writeProblem(existing);
    const fs::space_info space = fs::space(existing, error);
    if (!error)
        facts.freeBytes = space.available;
    return facts;
}

fs::path findProgram(const std::string& name) {
    for (const fs::path& directory : platform::directoriesOf(platform::environmentVariable("PATH")))
        if (fs::path program = directory / platform::programFileName(name); platform::isProgram(program))
            return program;
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
    const platform::Memory memory = platform::systemMemory();
    facts.memory = memory.total.value_or(0);
    facts.availableMemory = memory.available.value_or(0);
    facts.display = queryDisplay();
    facts.font = engine::findFont(engine::fontPaths(platform::programPath())).value_or(fs::path());
    facts.cache = queryDirectory(engine::cacheRoot());
    facts.configuration = queryDirectory(engine::configurationRoot());
    facts.ffmpeg = findProgram("ffmpeg");
    return facts;
}

} // namespace limen::doctor
