#pragma once

#include "dat/File.h"

namespace limen::dat {

/// The names of the files as the game's installer writes them.
inline constexpr const char* kPortalName = "client_portal.dat";
inline constexpr const char* kCellName = "client_cell_1.dat";
inline constexpr const char* kHighresName = "client_highres.dat";
inline constexpr const char* kLocalName = "client_local_English.dat";

/// The paths of one world's files. The names may differ from the installer's.
struct ArchivePaths {
    std::filesystem::path directory;
    std::filesystem::path portal, cell;
    std::filesystem::path highres, local; ///< empty: none
};

/// The files of one world: `client_portal.dat` and `client_cell_1.dat`; `client_highres.dat` and
/// `client_local_English.dat` are optional. Safe to read from several threads.
class LIMEN_API Archive {
public:
    /// Errors: the directory does not exist; a required file is missing, of another format or damaged; a
    /// file's role is not that of its name.
    [[nodiscard]] static Result<Archive> open(const std::filesystem::path& directory);
    /// Errors: a file is missing, of another format or damaged; a file's role is not that of its path.
    [[nodiscard]] static Result<Archive> open(const ArchivePaths& paths);
    /// An archive of open files. For tests and fuzzing.
    [[nodiscard]] static Archive of(File portal, File cell) {
        return Archive("memory", std::move(portal), std::move(cell));
    }

    [[nodiscard]] const File& portal() const { return portal_; }
    [[nodiscard]] const File& cell() const { return cell_; }
    [[nodiscard]] const File* highres() const { return highres_ ? &*highres_ : nullptr; }
    [[nodiscard]] const File* local() const { return local_ ? &*local_ : nullptr; }
    [[nodiscard]] const std::filesystem::path& directory() const { return directory_; }

    /// Decodes a record of the portal file (a RenderSurface also from highres) or of the cell file, by its
    /// type. Errors, with file and id: the id is not of this type; the record does not exist or is damaged.
    template <class Record>
    [[nodiscard]] Result<Record> load(RecordId id) const;
    /// True if the file for records of this type has `id`. False if its index is damaged.
    template <class Record>
    [[nodiscard]] bool contains(RecordId id) const;
    /// The largest existing image of a SurfaceTexture: the first of its list that portal or highres holds.
    [[nodiscard]] Result<RecordId> imageOf(const SurfaceTexture& texture) const;
    /// File::letPagesGo of all files.
    void letPagesGo() const;
    /// File::letPagesGoEvery of all files.
    void letPagesGoEvery(std::size_t bytes);

private:
    Archive(std::filesystem::path directory, File portal, File cell)
        : directory_(std::move(directory)), portal_(std::move(portal)), cell_(std::move(cell)) {}

    [[nodiscard]] const File* holderOf(RecordKind kind, RecordId id) const;

    std::filesystem::path directory_;
    File portal_;
    File cell_;
    std::optional<File> highres_;
    std::optional<File> local_;
};

} // namespace limen::dat
