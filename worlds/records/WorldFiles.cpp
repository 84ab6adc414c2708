#include "worlds/records/WorldFiles.h"

#include "core/Interrupt.h"
#include "dat/Writer.h"

#include <fstream>

namespace limen::worlds {

namespace {

template <class Record>
void addAll(dat::Writer& writer, const std::vector<Record>& records) {
    for (const Record& record : records)
        writer.add(record);
}

/// Writes to a second name and renames the file, so that no reader sees a partial file.
Result<void> writeText(const std::filesystem::path& path, const std::string& text) {
    const UninterruptedWrite whole;
    const std::filesystem::path part = path.string() + ".part";
    std::ofstream file(part, std::ios::binary | std::ios::trunc);
    file << text;
    file.close();
    std::error_code error;
    if (file)
        std::filesystem::rename(part, path, error);
    if (!file || error) {
        std::error_code ignored;
        std::filesystem::remove(part, ignored);
        return fail(ErrorCode::Unreadable, path.string(),
                    "cannot be written; check the folder's permissions and free space");
    }
    return {};
}

} // namespace

Result<void> writeWorldFiles(const WorldRecords& records, const std::filesystem::path& directory) {
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    if (error) {
        return fail(ErrorCode::Unreadable, directory.string(),
                    "the folder cannot be made: " + error.message());
    }
    dat::Writer portal(dat::FileTraits::portal());
    addAll(portal, records.palettes);
    addAll(portal, records.surfaceTextures);
    addAll(portal, records.renderSurfaces);
    for (const auto& [id, surface] : records.surfaces)
        portal.add(id, surface);
    addAll(portal, records.gfxObjs);
    addAll(portal, records.setups);
    addAll(portal, records.animations);
    addAll(portal, records.motionTables);
    addAll(portal, records.degradeInfos);
    addAll(portal, records.paletteSets);
    addAll(portal, records.clothingTables);
    addAll(portal, records.particleEmitters);
    addAll(portal, records.physicsScripts);
    addAll(portal, records.physicsScriptTables);
    addAll(portal, records.environments);
    addAll(portal, records.scenes);
    addAll(portal, records.regions);
    dat::Writer cell(dat::FileTraits::cell());
    addAll(cell, records.landBlocks);
    addAll(cell, records.landBlockInfos);
    addAll(cell, records.envCells);
    if (auto done = portal.write(directory / "client_portal.dat"); !done)
        return done;
    if (auto done = cell.write(directory / "client_cell_1.dat"); !done)
        return done;
    return writeText(directory / "world.json", records.worldFile.dump(1) + "\n");
}

} // namespace limen::worlds
