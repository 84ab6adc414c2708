#include "doctor/FileHealth.h"

#include "core/NumberText.h"
#include "doctor/Bytes.h"
#include "doctor/Releases.h"

#include <fmt/format.h>

namespace limen::doctor {
namespace {

constexpr const char* kFetchAgain = "copy the file again from the game's installation; a file that was cut "
                                    "short or changed cannot be repaired";

/// The loss without an optional file.
const char* lossWithout(dat::FileRole role) {
    return role == dat::FileRole::Highres ? "textures are drawn in their smaller size"
                                          : "nothing that Limen draws";
}

Finding openFinding(const FileHealth& health) {
    const std::string name = health.path.filename().string();
    const char* check = roleName(health.role);
    if (!health.exists && health.isRequired)
        return {check, Outcome::Failed,
                fmt::format("{} is missing in {}", name, health.path.parent_path().string()),
                "give the directory that holds client_portal.dat and client_cell_1.dat"};
    if (!health.exists)
        return {check, Outcome::Ok, fmt::format("{} is not there; lost: {}", name, lossWithout(health.role)),
                ""};
    if (health.error)
        return {check, Outcome::Failed, health.error->message(),
                health.error->code == ErrorCode::Unsupported ? "install the last version of the game's files"
                                                             : kFetchAgain};
    if (health.file->role() != health.role)
        return {check, Outcome::Failed,
                fmt::format("{} holds a {} file by its header", name, roleName(health.file->role())),
                "give each file the name that fits its contents"};
    const dat::Header& header = health.file->header();
    const std::string text =
        fmt::format("{}: {} records, {}, blocks of {} bytes", name, groupedText(health.records),
                    bytesText(health.file->length()), header.blockSize);
    if (health.file->length() != header.fileSize)
        return {check, health.file->length() < header.fileSize ? Outcome::Failed : Outcome::Warning,
                fmt::format("{}; the header says {} bytes, the file has {}", text,
                            groupedText(header.fileSize), groupedText(health.file->length())),
                kFetchAgain};
    return {check, Outcome::Ok, text, ""};
}

Finding indexFinding(const FileHealth& health) {
    const std::string check = fmt::format("{} index", roleName(health.role));
    const std::string text = fmt::format("in order: {} nodes, {} {}", groupedText(health.shape.nodes),
                                         health.shape.depth, health.shape.depth == 1 ? "level" : "levels");
    if (health.strays.count > 0)
        return {check, Outcome::Failed,
                fmt::format("{} records are not in the file; the first is {} at offset 0x{:X}, {} bytes",
                            groupedText(health.strays.count), dat::idText(health.strays.first.id),
                            health.strays.first.offset, groupedText(health.strays.first.size)),
                kFetchAgain};
    if (!health.warnings.empty())
        return {check, Outcome::Warning, fmt::format("{}; {}", text, health.warnings.front()), ""};
    return {check, Outcome::Ok, text, ""};
}

Finding freeListFinding(const FileHealth& health) {
    const std::string check = fmt::format("{} free", roleName(health.role));
    if (!health.freeList.fault.empty())
        return {check, Outcome::Warning, fmt::format("free blocks: {}", health.freeList.fault),
                "nothing for Limen, which only reads; programs that write the file could damage it"};
    return {check, Outcome::Ok,
            fmt::format("{} free blocks, as the header says", groupedText(health.freeList.blocks)), ""};
}

Finding releaseFinding(const FileHealth& health) {
    const dat::Header& header = health.file->header();
    const Release release = releaseOf(identityOf(*health.file, health.records));
    return {
        fmt::format("{} release", roleName(health.role)), Outcome::Ok,
        fmt::format("{} (engine {}, version {})", nameOf(release), header.engineVersion, header.minorVersion),
        ""};
}

} // namespace

const char* roleName(dat::FileRole role) {
    constexpr std::array<const char*, 4> kRoles{"portal", "cell", "highres", "local"}; // by FileRole
    return kRoles.at(static_cast<std::size_t>(role));
}

FileHealth examineFile(const std::filesystem::path& path, dat::FileRole role, bool isRequired) {
    FileHealth health;
    health.path = path;
    health.role = role;
    health.isRequired = isRequired;
    std::error_code error;
    health.exists = std::filesystem::exists(path, error);
    if (!health.exists)
        return health;
    Result<dat::File> file = dat::File::open(path);
    if (!file) {
        health.error = file.error();
        return health;
    }
    const Result<void> walked = file->forEach(
        [&](const dat::Entry& entry) {
            ++health.records;
            health.compressed += (entry.flags & 1u) != 0;
            ++health.byKind[static_cast<std::size_t>(dat::kindOf(file->role(), entry.id))];
            if (!file->isInFile(entry) && ++health.strays.count == 1)
                health.strays.first = entry;
            return true;
        },
        &health.warnings, &health.shape);
    if (!walked)
        health.error = walked.error();
    else
        health.freeList = file->freeList();
    file->letPagesGo();
    health.file.emplace(std::move(*file));
    return health;
}

Findings judgeFile(const FileHealth& health) {
    Findings findings{openFinding(health)};
    if (!health.file || health.error)
        return findings;
    findings.push_back(indexFinding(health));
    findings.push_back(freeListFinding(health));
    findings.push_back(releaseFinding(health));
    return findings;
}

std::vector<FileHealth> examineDirectory(const std::filesystem::path& directory) {
    return examineFiles({directory, directory / dat::kPortalName, directory / dat::kCellName,
                         directory / dat::kHighresName, directory / dat::kLocalName});
}

std::vector<FileHealth> examineFiles(const dat::ArchivePaths& paths) {
    const auto orNamed = [&](const std::filesystem::path& path, const char* name) {
        return path.empty() ? paths.directory / name : path;
    };
    std::vector<FileHealth> files;
    files.push_back(examineFile(paths.portal, dat::FileRole::Portal, true));
    files.push_back(examineFile(paths.cell, dat::FileRole::Cell, true));
    files.push_back(examineFile(orNamed(paths.highres, dat::kHighresName), dat::FileRole::Highres, false));
    files.push_back(examineFile(orNamed(paths.local, dat::kLocalName), dat::FileRole::Local, false));
    return files;
}

} // namespace limen::doctor
