#include "placements/Import.h"
#include "placements/sql/SqlFiles.h"
#include "placements/sql/Statements.h"

namespace limen::placements {
namespace {

std::size_t totalSize(const std::vector<SqlFile>& files) {
    std::size_t total = 0;
    for (const SqlFile& file : files)
        total += file.size;
    return total;
}

/// Counts the bytes that pass, and stops the reading when the import is cancelled.
class CountedBytes {
public:
    CountedBytes(const ImportProgress& progress, std::size_t total) : progress_(progress), total_(total) {}

    [[nodiscard]] ReadBytes counted(const ReadBytes& bytes) {
        return [this, bytes](std::span<char> buffer) -> Result<std::size_t> {
            Result<std::size_t> count = bytes(buffer);
            done_ += count.value_or(0);
            if (progress_ && !progress_(std::min(done_, total_), total_))
                return fail(ErrorCode::Unreadable, "", "the import was cancelled");
            return count;
        };
    }

private:
    const ImportProgress& progress_;
    std::size_t total_, done_ = 0;
};

} // namespace

Result<Content> importSqlFiles(const std::vector<std::filesystem::path>& paths,
                               const ImportProgress& progress) {
    const Result<std::vector<SqlFile>> files = findSqlFiles(paths);
    if (!files)
        return Failure(files.error());
    CountedBytes counter(progress, totalSize(*files));
    ContentBuilder builder;
    const Result<void> read = readSqlFiles(paths, *files, [&](const SqlFile& file, const ReadBytes& bytes) {
        Tokens tokens(counter.counted(bytes), shownPath(paths, file).string());
        return executeSql(tokens, builder);
    });
    if (!read)
        return Failure(read.error());
    Content content = builder.finish();
    if (content.templates.empty() && content.landblocks.empty())
        return fail(
            ErrorCode::NotFound, paths.front().string(),
            "no rows of landblock_instance or weenie are there; give the folders of the world database");
    return content;
}

} // namespace limen::placements
