#include "placements/sql/SqlFiles.h"

#include "core/Assert.h"
#include "core/platform/Files.h"
#include "placements/Tables.h"
#include "placements/sql/SqlArchive.h"
#include "placements/sql/Text.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fmt/format.h>
#include <map>
#include <memory>
#include <unordered_set>

namespace limen::placements {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFiles = 2'000'000;

bool isSql(const fs::path& path) {
    return isSameName(path.extension().string(), ".sql");
}

Result<void> addDirectory(const fs::path& root, std::size_t source, std::vector<SqlFile>& out) {
    std::error_code error;
    const std::size_t first = out.size();
    for (fs::recursive_directory_iterator at(root, error), end; !error && at != end; at.increment(error)) {
        if (!platform::isText(at->path()))
            return fail(ErrorCode::Unsupported, root.string(), platform::kNoText);
        if (!at->is_regular_file(error) || !isSql(at->path()))
            continue;
        if (out.size() == kMostFiles)
            return fail(ErrorCode::Unsupported, root.string(), "more than 2,000,000 files of SQL");
        const std::uint64_t size = at->file_size(error);
        out.push_back({at->path().lexically_relative(root).generic_string(), source, size});
    }
    if (error)
        return fail(ErrorCode::Unreadable, root.string(), error.message());
    std::sort(out.begin() + static_cast<std::ptrdiff_t>(first), out.end(),
              [](const SqlFile& a, const SqlFile& b) { return a.name < b.name; });
    return {};
}

Result<void> addPath(const fs::path& path, std::size_t source, std::vector<SqlFile>& out) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status))
        return fail(ErrorCode::NotFound, path.string(),
                    "no such file or directory; give a directory, an archive or a file of SQL");
    if (fs::is_directory(status))
        return addDirectory(path, source, out);
    if (isSql(path)) {
        out.push_back({path.filename().string(), source, fs::file_size(path, error)});
        return {};
    }
    return listArchive(path).map([&](const std::vector<ArchivedFile>& entries) {
        for (const ArchivedFile& entry : entries)
            if (isSql(entry.name))
                out.push_back({entry.name, source, entry.size});
    });
}

/// Digits and a blank, as in "9 WeenieDefaults".
bool isNumberedFolder(const std::string& name) {
    const std::size_t digits = name.find_first_not_of("0123456789");
    return digits != std::string::npos && digits > 0 && name[digits] == ' ';
}

/// Removes each file that one of a later path replaces.
void removeReplaced(std::vector<SqlFile>& files) {
    std::map<std::string, std::size_t> lastSource;
    for (const SqlFile& file : files) {
        std::size_t& last = lastSource[replacementKey(file.name)];
        last = std::max(last, file.source);
    }
    std::erase_if(files, [&](const SqlFile& f) { return f.source < lastSource[replacementKey(f.name)]; });
}

struct Closed {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

Result<void> readFile(const fs::path& path, const SqlFile& file, const ReadSqlFile& read) {
    const std::unique_ptr<std::FILE, Closed> stream(platform::openFile(path, "rb"));
    if (stream == nullptr)
        return fail(ErrorCode::Unreadable, path.string(), std::strerror(errno));
    return read(file, [&](std::span<char> buffer) -> Result<std::size_t> {
        const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), stream.get());
        if (count == 0 && std::ferror(stream.get()) != 0)
            return fail(ErrorCode::Unreadable, path.string(), std::strerror(errno));
        return count;
    });
}

} // namespace

std::string replacementKey(const std::string& name) {
    const fs::path path(name);
    for (const fs::path& part : path.parent_path())
        if (isNumberedFolder(part.string()))
            return part.string() + "/" + path.filename().string();
    return name;
}

fs::path shownPath(const std::vector<fs::path>& paths, const SqlFile& file) {
    const fs::path& path = paths[file.source];
    std::error_code ignored;
    return isSql(path) && !fs::is_directory(path, ignored) ? path : path / file.name;
}

Result<std::vector<SqlFile>> findSqlFiles(const std::vector<fs::path>& paths) {
    std::vector<SqlFile> files;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        const std::size_t before = files.size();
        if (Result<void> added = addPath(paths[i], i, files); !added)
            return Failure(added.error());
        if (files.size() == before)
            return fail(ErrorCode::NotFound, paths[i].string(), "no file of SQL (*.sql) is there");
    }
    removeReplaced(files);
    return files;
}

Result<void> readSqlFiles(const std::vector<fs::path>& paths, const std::vector<SqlFile>& files,
                          const ReadSqlFile& read) {
    for (std::size_t i = 0; i < files.size();) {
        const SqlFile& file = files[i];
        LIMEN_ASSERT(file.source < paths.size(), "the file was found at one of the paths");
        const fs::path& path = paths[file.source];
        std::error_code ignored;
        const bool isDirectory = fs::is_directory(path, ignored);
        if (isDirectory || isSql(path)) {
            if (Result<void> done = readFile(isDirectory ? path / file.name : path, file, read); !done)
                return done;
            ++i;
            continue;
        }
        // All files of one archive are read in one pass, in the order in which the archive has them.
        std::unordered_map<std::string, const SqlFile*> wanted;
        for (; i < files.size() && files[i].source == file.source; ++i)
            wanted.emplace(files[i].name, &files[i]);
        Result<void> done = readArchive(path, [&](const ArchivedFile& entry, const ReadBytes& bytes) {
            const auto found = wanted.find(entry.name);
            return found != wanted.end() ? read(*found->second, bytes) : Result<void>();
        });
        if (!done)
            return done;
    }
    return {};
}

} // namespace limen::placements
