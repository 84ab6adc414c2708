#include "engine/DatDirectory.h"

#include "core/Nearest.h"
#include "core/platform/Files.h"
#include "engine/UserFiles.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <optional>

namespace limen::engine {
namespace {

namespace fs = std::filesystem;

constexpr int kDepth = 2;                  // levels of folders below the given one
constexpr std::size_t kMostFolders = 200;  // folders looked into; bounds the search from a large directory
constexpr std::size_t kMostListed = 12;    // paths in a message
constexpr std::size_t kMostEntries = 4096; // names read of one folder

constexpr std::array<DatFileFact, 4> kFacts{{
    {dat::kPortalName, true, "models, textures and the region"},
    {dat::kCellName, true, "landscape and interiors"},
    {dat::kHighresName, false, "textures of twice the size"},
    {dat::kLocalName, false, "texts of the game"},
}};

std::string inLowerCase(std::string text) {
    for (char& letter : text)
        letter = letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
    return text;
}

/// The entries of a directory whose names are text, ascending by name; empty if it cannot be read.
std::vector<fs::path> entriesOf(const fs::path& directory) {
    std::vector<fs::path> entries;
    std::error_code error;
    for (fs::directory_iterator it(directory, fs::directory_options::skip_permission_denied, error), end;
         !error && it != end && entries.size() < kMostEntries; it.increment(error))
        if (platform::isText(it->path()))
            entries.push_back(it->path());
    std::sort(entries.begin(), entries.end());
    return entries;
}

bool isDirectory(const fs::path& path) {
    std::error_code error;
    return fs::is_directory(path, error);
}

/// The entry with this name: the exact one, else one in other letter case; empty if there is none.
fs::path entryNamed(const std::vector<fs::path>& entries, const std::string& name) {
    fs::path similar;
    for (const fs::path& entry : entries) {
        if (entry.filename() == name)
            return entry;
        if (similar.empty() && inLowerCase(entry.filename().string()) == inLowerCase(name))
            similar = entry;
    }
    return similar;
}

/// The files of one directory.
struct Folder {
    fs::path path;
    std::vector<fs::path> entries;
    std::array<fs::path, kFacts.size()> files; ///< empty: it lacks the file
    bool hasOlderGame = false;

    [[nodiscard]] bool isComplete() const { return !files[0].empty() && !files[1].empty(); }
};

Folder readFolder(const fs::path& path) {
    Folder folder{path, entriesOf(path), {}, false};
    for (std::size_t i = 0; i < kFacts.size(); ++i)
        folder.files[i] = entryNamed(folder.entries, kFacts[i].name);
    folder.hasOlderGame =
        !entryNamed(folder.entries, "portal.dat").empty() || !entryNamed(folder.entries, "cell.dat").empty();
    return folder;
}

DatDirectory found(Folder folder) {
    DatDirectory result{
        folder.path, {folder.path, folder.files[0], folder.files[1], folder.files[2], folder.files[3]}, {}};
    for (std::size_t i = 0; i < kFacts.size(); ++i)
        if (folder.files[i].empty())
            result.absent.emplace_back(kFacts[i].name);
    return result;
}

/// The longest existing part of a path, with each component in its real letter case.
struct RealPath {
    fs::path there; ///< exists
    fs::path rest;  ///< components that do not exist
};

RealPath realPathOf(const fs::path& path) {
    const fs::path normal = path.lexically_normal();
    RealPath real{normal.root_path(), {}}; // a drive without its slash is no directory
    for (const fs::path& part : normal.relative_path()) {
        if (part.empty() || !real.rest.empty()) {
            real.rest /= part;
            continue;
        }
        std::error_code error;
        const fs::path next = real.there / part;
        if (fs::exists(next, error)) {
            real.there = next;
            continue;
        }
        const fs::path similar =
            entryNamed(entriesOf(real.there.empty() ? fs::path(".") : real.there), part.string());
        if (similar.empty())
            real.rest /= part;
        else
            real.there /= similar.filename();
    }
    return real;
}

std::string optionalFiles() {
    return fmt::format("Optional: {} ({}) and {} ({})", kFacts[2].name, kFacts[2].use, kFacts[3].name,
                       kFacts[3].use);
}

std::string nextStep() {
    return fmt::format("Give the directory of the game's installation, e.g. --dat {}",
                       gameDirectoryExample());
}

Failure noSuchPath(const fs::path& given, const RealPath& real) {
    std::vector<std::string> names;
    for (const fs::path& entry : entriesOf(real.there.empty() ? fs::path(".") : real.there))
        if (isDirectory(entry))
            names.push_back(entry.filename().string());
    const std::string wanted = real.rest.begin() == real.rest.end() ? "" : real.rest.begin()->string();
    return fail(ErrorCode::NotFound, given.string(),
                fmt::format("there is no such directory; '{}' has no '{}'.{} {} needs {} and {}. {}",
                            real.there.empty() ? "." : real.there.string(), wanted,
                            didYouMean(nearest(wanted, names)), "A world", kFacts[0].name, kFacts[1].name,
                            nextStep()));
}

/// "client_portal.dat: not found; client_cell_1.dat: found in A, B".
std::string whereAbouts(const std::vector<Folder>& tried, std::size_t file) {
    std::vector<std::string> places;
    for (const Folder& folder : tried)
        if (!folder.files[file].empty())
            places.push_back(folder.files[file].string());
    return places.empty() ? fmt::format("{} is missing", kFacts[file].name)
                          : fmt::format("{} is {}", kFacts[file].name, fmt::join(places, " and "));
}

Failure nothingFound(const fs::path& given, const std::vector<Folder>& tried) {
    std::vector<std::string> paths;
    for (std::size_t i = 0; i < std::min(tried.size(), kMostListed); ++i)
        paths.push_back(tried[i].path.string());
    if (tried.size() > paths.size())
        paths.push_back(fmt::format("{} more", tried.size() - paths.size()));
    const auto older =
        std::find_if(tried.begin(), tried.end(), [](const Folder& f) { return f.hasOlderGame; });
    if (older != tried.end() && older->files[0].empty())
        return fail(ErrorCode::Unsupported, given.string(),
                    fmt::format("portal.dat and cell.dat in {} are game files older than the end of retail; "
                                "only end-of-retail files ({}, {}) can be read. {}",
                                older->path.string(), kFacts[0].name, kFacts[1].name, nextStep()));
    return fail(ErrorCode::NotFound, given.string(),
                fmt::format("the game's files are not there together: {}; {}. Tried: {}. {}. {}",
                            whereAbouts(tried, 0), whereAbouts(tried, 1), fmt::join(paths, ", "),
                            optionalFiles(), nextStep()));
}

} // namespace

std::span<const DatFileFact> datFileFacts() {
    return kFacts;
}

Result<DatDirectory> findDatDirectory(const fs::path& path) {
    if (path.empty())
        return fail(ErrorCode::BadArgument, "--dat", fmt::format("is empty. {}", nextStep()));
    const RealPath real = realPathOf(path);
    std::error_code error;
    const bool isThere = fs::exists(real.there, error);
    const bool isFile = isThere && !isDirectory(real.there);
    // A named file that is missing: its directory is the user's choice all the same.
    const bool namesDat = std::distance(real.rest.begin(), real.rest.end()) == 1 &&
                          inLowerCase(real.rest.extension().string()) == ".dat";
    if (!isThere || (!real.rest.empty() && !namesDat))
        return noSuchPath(path, real);
    const fs::path first =
        isFile ? (real.there.has_parent_path() ? real.there.parent_path() : fs::path(".")) : real.there;
    std::vector<Folder> tried;
    std::vector<fs::path> level{first};
    for (int depth = 0; depth <= kDepth && !level.empty(); ++depth) {
        std::vector<fs::path> below;
        for (const fs::path& directory : level) {
            if (tried.size() == kMostFolders)
                break;
            tried.push_back(readFolder(directory));
            if (tried.back().isComplete())
                return found(std::move(tried.back()));
            if (depth < kDepth && !isFile)
                std::copy_if(tried.back().entries.begin(), tried.back().entries.end(),
                             std::back_inserter(below), isDirectory);
        }
        level = std::move(below);
    }
    return nothingFound(path, tried);
}

} // namespace limen::engine
