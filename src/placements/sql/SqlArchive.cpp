#include "placements/sql/SqlArchive.h"

#include <archive.h>
#include <archive_entry.h>
#include <memory>

namespace limen::placements {
namespace {

constexpr std::size_t kMostEntries = 2'000'000;
/// Bytes for each byte of the archive, and bytes for every archive. Files of SQL are packed to a twentieth or so.
constexpr std::uint64_t kMostUnpacked = 100, kAlwaysUnpacked = std::uint64_t{64} << 20;

struct ArchiveClosed {
    void operator()(archive* open) const { archive_read_free(open); }
};

Failure damaged(const std::filesystem::path& path, archive* open) {
    const char* const reason = archive_error_string(open);
    return fail(ErrorCode::Malformed, path.string(),
                std::string("cannot be read as an archive: ") + (reason != nullptr ? reason : "unknown"));
}

/// The letters of a path are char, or wchar_t on Windows.
[[maybe_unused]] int openNamed(archive* archive, const char* name, std::size_t block) {
    return archive_read_open_filename(archive, name, block);
}
[[maybe_unused]] int openNamed(archive* archive, const wchar_t* name, std::size_t block) {
    return archive_read_open_filename_w(archive, name, block);
}

/// Windows has the wide name alone if the name has letters beyond ASCII. Empty without a name.
std::string nameOf(archive_entry* entry) {
    if (const char* name = archive_entry_pathname_utf8(entry); name != nullptr)
        return name;
    if (const wchar_t* name = archive_entry_pathname_w(entry); name != nullptr)
        return std::filesystem::path(name).generic_string();
    const char* name = archive_entry_pathname(entry);
    return name != nullptr ? name : "";
}

} // namespace

Result<void>
readArchive(const std::filesystem::path& path,
            const std::function<Result<void>(const ArchivedFile& file, const ReadBytes& bytes)>& read) {
    constexpr std::size_t kBlock = std::size_t{64} << 10;
    const std::unique_ptr<archive, ArchiveClosed> open(archive_read_new());
    if (open == nullptr)
        return fail(ErrorCode::Unsupported, path.string(), "libarchive cannot be used");
    archive_read_support_filter_all(open.get());
    archive_read_support_format_all(open.get());
    if (openNamed(open.get(), path.c_str(), kBlock) != ARCHIVE_OK)
        return damaged(path, open.get());
    std::error_code ignored;
    const std::uint64_t most = kMostUnpacked * std::filesystem::file_size(path, ignored) + kAlwaysUnpacked;
    std::uint64_t unpacked = 0;
    std::size_t entries = 0;
    for (;;) {
        archive_entry* entry = nullptr;
        const int status = archive_read_next_header(open.get(), &entry);
        if (status == ARCHIVE_EOF)
            return {};
        if (status != ARCHIVE_OK && status != ARCHIVE_WARN)
            return damaged(path, open.get());
        if (++entries > kMostEntries)
            return fail(ErrorCode::Unsupported, path.string(), "more than 2,000,000 files");
        const std::string name = nameOf(entry);
        if (archive_entry_filetype(entry) != AE_IFREG || name.empty())
            continue;
        const std::int64_t size = archive_entry_size_is_set(entry) != 0 ? archive_entry_size(entry) : 0;
        const ReadBytes bytes = [&](std::span<char> buffer) -> Result<std::size_t> {
            const la_ssize_t count = archive_read_data(open.get(), buffer.data(), buffer.size());
            if (count < 0)
                return damaged(path, open.get());
            unpacked += static_cast<std::uint64_t>(count);
            if (unpacked > most)
                return fail(
                    ErrorCode::Malformed, path.string(),
                    "unpacks to more than 100 times its size; unpack it yourself and give the directory");
            return static_cast<std::size_t>(count);
        };
        if (Result<void> done = read({name, static_cast<std::uint64_t>(size > 0 ? size : 0)}, bytes); !done)
            return done;
    }
}

Result<std::vector<ArchivedFile>> listArchive(const std::filesystem::path& path) {
    std::vector<ArchivedFile> files;
    return readArchive(path,
                       [&](const ArchivedFile& file, const ReadBytes&) -> Result<void> {
                           files.push_back(file);
                           return {};
                       })
        .map([&] { return std::move(files); });
}

} // namespace limen::placements
