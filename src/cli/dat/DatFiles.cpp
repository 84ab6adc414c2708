#include "cli/dat/DatFiles.h"

#include <array>
#include <filesystem>

namespace limen::cli {

Result<DatFiles> openDatFiles(const std::string& path) {
    DatFiles files;
    std::error_code ignored;
    if (std::filesystem::is_regular_file(path, ignored)) {
        Result<dat::File> file = dat::File::open(path);
        if (!file)
            return Failure(file.error());
        files.single = std::make_unique<dat::File>(std::move(*file));
        files.list.push_back(files.single.get());
        return files;
    }
    Result<engine::WorldSource> source = engine::openWorldSource(path, engine::PlaceSearch::Skip);
    if (!source)
        return Failure(source.error());
    files.source = std::make_unique<engine::WorldSource>(std::move(*source));
    const dat::Archive& archive = files.source->archive;
    for (const dat::File* file : {&archive.portal(), &archive.cell(), archive.highres(), archive.local()})
        if (file != nullptr)
            files.list.push_back(file);
    return files;
}

const char* nameOfRole(dat::FileRole role) {
    constexpr std::array<const char*, 4> kNames{"portal", "cell", "highres", "local"}; // by FileRole
    return kNames.at(static_cast<std::size_t>(role));
}

} // namespace limen::cli
