#include "doctor/WorldHealth.h"

#include "core/NumberText.h"
#include "dat/RecordTypes.h"
#include "dat/Verify.h"
#include "doctor/Bytes.h"

#include <algorithm>

#include <fmt/format.h>

namespace limen::doctor {
namespace {

constexpr const char* kDamagedNext =
    "copy the file again from the game's installation; limen doctor --thorough lists all "
    "damaged records";
constexpr dat::RecordId kPlayerBody = 0x02000001;
constexpr std::size_t kFindingsOfThorough = 20, kStoredFaults = 100000;

const FileHealth* healthOf(std::span<const FileHealth> files, dat::FileRole role) {
    const auto found = std::find_if(files.begin(), files.end(), [&](const FileHealth& health) {
        return health.file && health.file->role() == role;
    });
    return found != files.end() ? &*found : nullptr;
}

std::uint64_t countOfKind(std::span<const FileHealth> files, dat::RecordKind kind) {
    std::uint64_t count = 0;
    for (const FileHealth& health : files)
        count += health.byKind[static_cast<std::size_t>(kind)];
    return count;
}

Finding kindsFinding(std::span<const FileHealth> files) {
    std::string text;
    for (std::size_t i = 0; i <= static_cast<std::size_t>(dat::RecordKind::Other); ++i) {
        const auto kind = static_cast<dat::RecordKind>(i);
        if (const std::uint64_t count = countOfKind(files, kind); count > 0)
            text += fmt::format("{}{} {}", text.empty() ? "" : ", ", dat::nameOf(kind), groupedText(count));
    }
    if (text.empty())
        return {"records", Outcome::Failed, "the files hold no records", "copy the files again"};
    return {"records", Outcome::Ok, text, ""};
}

Result<void> decodes(const dat::File& file, const dat::Entry& entry, dat::Bytes& scratch) {
    const Result<dat::ByteView> payload = file.read(entry, scratch);
    if (!payload)
        return Failure(payload.error());
    Result<void> done;
    dat::visitKind(dat::kindOf(file.role(), entry.id), [&]<class Record>(std::type_identity<Record>) {
        const Result<Record> record = dat::decode<Record>(entry.id, *payload);
        if (!record) {
            done = Failure(record.error());
            done.error().where =
                fmt::format("{}, {} (file offset 0x{:X})", file.name(), done.error().where, entry.offset);
        }
    });
    return done;
}

/// Decodes one record. Missing: no value.
std::optional<Result<void>> tryRecord(const dat::File& file, dat::RecordId id) {
    const Result<std::optional<dat::Entry>> entry = file.find(id);
    if (!entry)
        return Result<void>(Failure(entry.error()));
    if (!*entry)
        return std::nullopt;
    dat::Bytes scratch;
    return decodes(file, **entry, scratch);
}

Finding regionFinding(const FileHealth* portal, const FileHealth* cell) {
    if (portal == nullptr)
        return {"region", Outcome::NotTested, "there is no portal file", ""};
    const std::optional<Result<void>> region = tryRecord(*portal->file, dat::kRegionId);
    const bool hasLand =
        cell != nullptr && cell->byKind[static_cast<std::size_t>(dat::RecordKind::LandBlock)] > 0;
    if (!region)
        return {"region", hasLand ? Outcome::Failed : Outcome::Warning,
                "Region 0x13000000 is missing: no landscape, no sky, no calendar",
                "copy client_portal.dat again"};
    if (!*region)
        return {"region", Outcome::Failed, region->error().message(), "copy client_portal.dat again"};
    return {"region", Outcome::Ok, "Region 0x13000000: landscape, sky and calendar", ""};
}

Finding landFinding(const FileHealth* cell) {
    if (cell == nullptr)
        return {"land and cells", Outcome::NotTested, "there is no cell file", ""};
    const auto count = [&](dat::RecordKind kind) { return cell->byKind[static_cast<std::size_t>(kind)]; };
    const std::uint64_t blocks = count(dat::RecordKind::LandBlock), cells = count(dat::RecordKind::EnvCell);
    if (blocks == 0)
        return {"land and cells", Outcome::Failed,
                "the cell file has no LandBlock: there is no place to stand", "copy client_cell_1.dat again"};
    const std::string text = fmt::format("{} landblocks, {} cells", groupedText(blocks), groupedText(cells));
    return {"land and cells", Outcome::Ok, text, ""};
}

Finding shapesFinding(std::span<const FileHealth> files) {
    if (healthOf(files, dat::FileRole::Portal) == nullptr || healthOf(files, dat::FileRole::Cell) == nullptr)
        return {"shapes", Outcome::NotTested, "it needs the portal and the cell file", ""};
    const bool needed = countOfKind(files, dat::RecordKind::EnvCell) > 0;
    const std::uint64_t shapes = countOfKind(files, dat::RecordKind::Environment);
    if (needed && shapes == 0)
        return {"shapes", Outcome::Failed, "there are cells and no Environment: no room can be drawn",
                "use a portal file and a cell file of the same release"};
    const std::uint64_t surfaces = countOfKind(files, dat::RecordKind::Surface);
    const std::uint64_t pictures = countOfKind(files, dat::RecordKind::RenderSurface);
    if (surfaces == 0 || pictures == 0)
        return {"shapes", Outcome::Warning,
                fmt::format("{} surfaces, {} pictures: all is drawn in one colour", groupedText(surfaces),
                            groupedText(pictures)),
                "copy client_portal.dat again"};
    return {"shapes", Outcome::Ok,
            fmt::format("{} Environments, {} surfaces, {} pictures", groupedText(shapes),
                        groupedText(surfaces), groupedText(pictures)),
            ""};
}

/// The first picture of the ground that is not there; no value: all are.
std::optional<std::string> missingGround(std::span<const FileHealth> files, const dat::File& portal) {
    dat::Bytes scratch;
    const Result<dat::ByteView> payload = portal.read(dat::kRegionId, scratch);
    const Result<dat::Region> region =
        payload ? dat::decode<dat::Region>(dat::kRegionId, *payload) : Failure(payload.error());
    if (!region)
        return std::nullopt; // reported by another check
    const FileHealth* highres = healthOf(files, dat::FileRole::Highres);
    const auto has = [](const dat::File& file, dat::RecordId id) {
        const Result<std::optional<dat::Entry>> entry = file.find(id);
        return entry && *entry;
    };
    for (const dat::TerrainTexture& texture : region->texMerge.textures) {
        dat::Bytes bytes;
        const Result<dat::ByteView> list = portal.read(texture.texture, bytes);
        const Result<dat::SurfaceTexture> images =
            list ? dat::decode<dat::SurfaceTexture>(texture.texture, *list) : Failure(list.error());
        const bool any =
            images && std::any_of(images->images.begin(), images->images.end(), [&](dat::RecordId id) {
                return has(portal, id) || (highres != nullptr && has(*highres->file, id));
            });
        if (!any)
            return fmt::format("SurfaceTexture {}, a picture of the ground, is missing",
                               dat::idText(texture.texture));
    }
    return std::nullopt;
}

void addPortalChecks(std::span<const FileHealth> files, const FileHealth& portal, Findings& findings) {
    if (const std::optional<std::string> missing = missingGround(files, *portal.file))
        findings.push_back({"ground", Outcome::Warning, *missing, "copy client_portal.dat again"});
    else
        findings.push_back({"ground", Outcome::Ok, "every picture of the ground is there", ""});
    const std::optional<Result<void>> body = tryRecord(*portal.file, kPlayerBody);
    if (body && !*body)
        findings.push_back({"player's body", Outcome::Failed, body->error().message(), kDamagedNext});
    else if (body)
        findings.push_back({"player's body", Outcome::Ok, "Setup 0x02000001", ""});
    else
        findings.push_back(
            {"player's body", Outcome::Ok,
             "Setup 0x02000001 is not there: the player has the body that world.json names, or none", ""});
}

/// Every n-th record of each kind, at most kSampleOfKind of a kind and file.
std::vector<dat::Entry> sampleOf(const FileHealth& health) {
    std::array<std::uint64_t, std::tuple_size_v<decltype(health.byKind)>> seen{};
    std::vector<dat::Entry> sample;
    const Result<void> walked = health.file->forEach([&](const dat::Entry& entry) {
        const auto kind = static_cast<std::size_t>(dat::kindOf(health.file->role(), entry.id));
        const std::uint64_t step = (health.byKind[kind] + kSampleOfKind - 1) / kSampleOfKind;
        if (seen[kind]++ % std::max<std::uint64_t>(step, 1) == 0)
            sample.push_back(entry);
        return true;
    });
    if (!walked)
        sample.clear(); // reported by another check
    return sample;
}

void addSample(std::span<const FileHealth> files, const HealthProgress& progress, Findings& findings) {
    std::vector<std::pair<const dat::File*, dat::Entry>> sample;
    for (const FileHealth& health : files)
        for (const dat::Entry& entry : sampleOf(health))
            sample.emplace_back(&*health.file, entry);
    std::size_t read = 0, damaged = 0;
    std::string first;
    dat::Bytes scratch;
    for (const auto& [file, entry] : sample) {
        const Result<void> done = decodes(*file, entry, scratch);
        if (!done && damaged++ == 0)
            first = done.error().message();
        if (progress)
            progress(sample.size(), ++read);
    }
    for (const FileHealth& health : files)
        health.file->letPagesGo();
    if (damaged > 0)
        findings.push_back(
            {"sample", Outcome::Failed,
             fmt::format("{} of {} records do not decode; the first: {}", damaged, sample.size(), first),
             kDamagedNext});
    else
        findings.push_back({"sample", Outcome::Ok,
                            fmt::format("{} records, up to {} of each kind, decode; --thorough tests all",
                                        groupedText(sample.size()), kSampleOfKind),
                            ""});
}

void addThorough(std::span<const FileHealth> files, const HealthProgress& progress, Findings& findings) {
    std::vector<const dat::File*> list;
    for (const FileHealth& health : files)
        list.push_back(&*health.file);
    dat::VerifyOptions options;
    options.mostFaults = kStoredFaults;
    options.progress = progress;
    dat::VerifyReport report = dat::verify(list, options);
    std::uint64_t records = 0;
    for (const dat::VerifyReport::Sum& sum : report.byKind)
        records += sum.records;
    const auto [unreadable, changed, unresolved] = report.faultCounts;
    const Outcome outcome = unreadable > 0             ? Outcome::Failed
                            : changed + unresolved > 0 ? Outcome::Warning
                                                       : Outcome::Ok;
    findings.push_back({"all records", outcome,
                        fmt::format("{} records: {} unreadable, {} changed, {} unresolved references",
                                    groupedText(records), unreadable, changed, unresolved),
                        outcome == Outcome::Ok ? "" : "limen dat verify lists all of them"});
    // Unreadable records come first: references can be unresolved by the hundred.
    std::stable_sort(report.faults.begin(), report.faults.end(),
                     [](const dat::Fault& a, const dat::Fault& b) { return a.kind < b.kind; });
    report.faults.resize(std::min(report.faults.size(), kFindingsOfThorough));
    for (const dat::Fault& fault : report.faults)
        findings.push_back(
            {"", fault.kind == dat::FaultKind::Unreadable ? Outcome::Failed : Outcome::Warning,
             fmt::format("{} file, {} {}: {}", roleName(fault.role),
                         dat::nameOf(dat::kindOf(fault.role, fault.id)), dat::idText(fault.id), fault.what),
             ""});
}

} // namespace

Findings judgeWorld(std::span<const FileHealth> files, const WorldOptions& options) {
    const FileHealth* portal = healthOf(files, dat::FileRole::Portal);
    Findings findings{kindsFinding(files), regionFinding(portal, healthOf(files, dat::FileRole::Cell)),
                      landFinding(healthOf(files, dat::FileRole::Cell)), shapesFinding(files)};
    if (portal != nullptr)
        addPortalChecks(files, *portal, findings);
    if (options.thorough)
        addThorough(files, options.progress, findings);
    else
        addSample(files, options.progress, findings);
    return findings;
}

} // namespace limen::doctor
