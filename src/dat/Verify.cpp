#include "dat/Verify.h"

#include "dat/References.h"

#include <algorithm>
#include <map>
#include <unordered_map>

#include <fmt/format.h>

namespace limen::dat {
namespace {

/// The ids of all records.
class Index {
public:
    /// Adds a file's entries, in ascending order of id.
    std::vector<Entry> add(const File& file, VerifyReport& report) {
        std::vector<Entry> entries;
        const Result<void> walked = file.forEach(
            [&](const Entry& entry) {
                entries.push_back(entry);
                return true;
            },
            &report.warnings);
        if (!walked)
            report.warnings.push_back(walked.error().message());
        std::vector<RecordId>& ids = ids_[static_cast<std::size_t>(file.role())];
        ids.reserve(entries.size());
        for (const Entry& entry : entries)
            ids.push_back(entry.id);
        isKnown_[static_cast<std::size_t>(file.role())] = true;
        return entries;
    }

    [[nodiscard]] bool knows(RecordKind kind) const { return isKnown_[roleOf(kind)]; }
    [[nodiscard]] bool holds(RecordKind kind, RecordId id) const {
        const auto in = [&](FileRole role) {
            const std::vector<RecordId>& ids = ids_[static_cast<std::size_t>(role)];
            return kindOf(role, id) == kind && std::binary_search(ids.begin(), ids.end(), id);
        };
        return in(static_cast<FileRole>(roleOf(kind))) ||
               (kind == RecordKind::RenderSurface && in(FileRole::Highres));
    }

private:
    static std::size_t roleOf(RecordKind kind) {
        return static_cast<std::size_t>(isOfCells(kind) ? FileRole::Cell : FileRole::Portal);
    }
    std::array<std::vector<RecordId>, 4> ids_; ///< by FileRole
    std::array<bool, 4> isKnown_{};
};

class Verifier {
public:
    Verifier(std::span<const File* const> files, const VerifyOptions& options) : options_(options) {
        for (const File* file : files) {
            entries_.push_back({file, index_.add(*file, report_)});
            total_ += entries_.back().second.size();
        }
        // Files with shapes come before files with cells.
        std::stable_sort(entries_.begin(), entries_.end(), [](const auto& a, const auto& b) {
            return static_cast<int>(a.first->role()) < static_cast<int>(b.first->role());
        });
    }

    VerifyReport run() {
        std::size_t done = 0;
        for (const auto& [file, entries] : entries_) {
            file_ = file;
            for (const Entry& entry : entries) {
                verifyEntry(entry);
                if (options_.progress)
                    options_.progress(total_, ++done);
                if (options_.stopped && options_.stopped()) {
                    report_.isStopped = true;
                    return std::move(report_);
                }
            }
            finishBlock();
        }
        return std::move(report_);
    }

private:
    void fault(FaultKind kind, std::string what) { faultOf(entryId_, kind, std::move(what)); }
    void faultOf(RecordId id, FaultKind kind, std::string what) {
        ++report_.faultCounts[static_cast<std::size_t>(kind)];
        if (report_.faults.size() < options_.mostFaults)
            report_.faults.push_back({kind, file_->role(), id, std::move(what)});
    }

    void verifyEntry(const Entry& entry) {
        entryId_ = entry.id;
        const RecordKind kind = kindOf(file_->role(), entry.id);
        const Result<ByteView> payload = file_->read(entry, scratch_);
        if (!payload) {
            fault(FaultKind::Unreadable, payload.error().what);
            return;
        }
        VerifyReport::Sum& sum = report_.byKind[static_cast<std::size_t>(kind)];
        ++sum.records;
        sum.bytes += payload->size();
        if (file_->role() == FileRole::Cell && (entry.id & 0xFFFF0000u) != block_)
            beginBlock(entry.id & 0xFFFF0000u);
        visitKind(kind, [&]<class Record>(std::type_identity<Record>) { verifyRecord<Record>(*payload); });
    }

    template <class Record>
    void verifyRecord(ByteView payload) {
        const Result<Record> record = decode<Record>(entryId_, payload);
        if (!record) {
            fault(FaultKind::Unreadable, fmt::format("{}: {}", record.error().where, record.error().what));
            return;
        }
        const Result<Bytes> again = encode(*record);
        if (!again)
            fault(FaultKind::Changed, again.error().what);
        else if (!std::equal(again->begin(), again->end(), payload.begin(), payload.end()))
            fault(FaultKind::Changed,
                  fmt::format("{} bytes would be written as {} others", payload.size(), again->size()));
        forEachReference(*record, [this](const Reference& reference) { resolve(reference); });
        look(*record);
    }

    void resolve(const Reference& reference) {
        const auto [one, other] = reference.kinds;
        if (!index_.knows(one) || index_.holds(one, reference.id) || index_.holds(other, reference.id))
            return;
        fault(FaultKind::Unresolved, fmt::format("names {} 0x{:08X} as {}, and there is none", nameOf(one),
                                                 reference.id, reference.as));
    }

    // Checks beyond references.
    template <class Record>
    void look(const Record&) {}

    void look(const SurfaceTexture& texture) {
        const bool any = std::any_of(texture.images.begin(), texture.images.end(), [&](RecordId id) {
            return index_.holds(RecordKind::RenderSurface, id);
        });
        if (!any)
            fault(FaultKind::Unresolved,
                  fmt::format("none of its {} images is there", texture.images.size()));
    }

    void look(const Environment& environment) {
        for (const auto& [key, shape] : environment.cells)
            shapes_[shapeKey(environment.id & 0xFFFFu, key)] = shape.portalPolygons;
    }

    void look(const EnvCell& cell) {
        cells_[static_cast<std::uint16_t>(cell.id)] = cell.portals;
        if (!index_.holds(RecordKind::Environment, 0x0D000000u | cell.environment))
            return; // reported already, or the file is not given
        const auto shape = shapes_.find(shapeKey(cell.environment, cell.cellStructure));
        if (shape == shapes_.end()) {
            fault(FaultKind::Unresolved,
                  fmt::format("has shape {} of Environment 0x{:08X}, which has no such shape",
                              cell.cellStructure, 0x0D000000u | cell.environment));
            return;
        }
        for (const CellPortal& portal : cell.portals) {
            const std::vector<std::uint16_t>& polygons = shape->second;
            if (std::find(polygons.begin(), polygons.end(), portal.polygonId) == polygons.end())
                fault(FaultKind::Unresolved,
                      fmt::format("has a portal on polygon {}, which is none of its shape's portals",
                                  portal.polygonId));
        }
    }

    void look(const LandBlockInfo& info) {
        if (info.numCells > kLastCell - kFirstCell + 1u)
            fault(FaultKind::Unresolved,
                  fmt::format("{} cells are more than a landblock can have", info.numCells));
        for (const Building& building : info.buildings)
            for (const BuildingPortal& portal : building.portals)
                lookBehind(info.id, portal.otherCellId, portal.otherPortalId, "a building's portal");
    }

    /// Checks the portal behind a portal, in a cell of this block.
    void lookBehind(RecordId from, std::uint16_t cell, std::uint16_t portal, const char* what) {
        const auto found = cells_.find(cell);
        if (cell == kOutdoors || portal == kNoPortal || found == cells_.end())
            return; // missing cells are reported already
        if (portal >= found->second.size())
            faultOf(from, FaultKind::Unresolved,
                    fmt::format("{} leads to portal {} of cell 0x{:08X}, which has {}", what, portal,
                                block_ | cell, found->second.size()));
    }

    static std::uint64_t shapeKey(std::uint32_t environment, std::uint32_t key) {
        return std::uint64_t{environment} << 32 | key;
    }

    void beginBlock(RecordId block) {
        finishBlock();
        block_ = block;
    }
    void finishBlock() {
        for (const auto& [cell, portals] : cells_)
            for (const CellPortal& portal : portals)
                lookBehind(block_ | cell, portal.otherCellId, portal.otherPortalId, "a portal");
        cells_.clear();
    }

    const VerifyOptions& options_;
    VerifyReport report_;
    Index index_;
    std::vector<std::pair<const File*, std::vector<Entry>>> entries_;
    std::size_t total_ = 0;
    const File* file_ = nullptr; ///< current file
    RecordId entryId_ = 0;       ///< current record
    Bytes scratch_;
    std::unordered_map<std::uint64_t, std::vector<std::uint16_t>> shapes_; ///< portal polygons, by shapeKey
    RecordId block_ = 0;
    std::map<std::uint16_t, std::vector<CellPortal>> cells_; ///< of the current block
};

} // namespace

const char* nameOf(FaultKind kind) {
    constexpr std::array<const char*, 3> kNames{"unreadable", "changed", "unresolved"};
    return kNames.at(static_cast<std::size_t>(kind));
}

VerifyReport verify(std::span<const File* const> files, const VerifyOptions& options) {
    return Verifier(files, options).run();
}

} // namespace limen::dat
