#include "doctor/retail/Census.h"

#include "doctor/retail/CensusParts.h"

#include <algorithm>
#include <array>

namespace limen::doctor {
namespace {

constexpr std::size_t kLandBlockBytes = 252;
constexpr std::size_t kReleaseEvery = 16384; // entries between two releases of read pages
constexpr std::size_t kProgressEvery = 256;

/// Walks the files of an archive and hands each record to a half of the census.
class Taker {
public:
    Taker(const dat::Archive& archive, Census& census, const CensusProgress& progress)
        : archive_(archive), census_(census), progress_(progress), portal_(archive, census),
          cell_(portal_, census) {}

    Result<void> run() {
        const std::array<const dat::File*, 4> files{&archive_.portal(), archive_.highres(), archive_.local(),
                                                    &archive_.cell()};
        std::vector<std::pair<const dat::File*, std::vector<dat::Entry>>> lists;
        for (const dat::File* file : files) {
            if (file == nullptr)
                continue;
            Result<std::vector<dat::Entry>> entries = entriesOf(*file);
            if (!entries)
                return Failure(entries.error());
            total_ += entries->size();
            lists.emplace_back(file, std::move(*entries));
        }
        for (const auto& [file, entries] : lists)
            readAll(*file, entries);
        portal_.finish();
        cell_.finish();
        return {};
    }

private:
    Result<std::vector<dat::Entry>> entriesOf(const dat::File& file) {
        FileCensus& sum = census_.files[static_cast<std::size_t>(file.role())];
        std::vector<dat::Entry> entries;
        const Result<void> walked = file.forEach(
            [&](const dat::Entry& entry) {
                entries.push_back(entry);
                return true;
            },
            nullptr, &sum.shape);
        if (!walked)
            return Failure(walked.error());
        sum.isThere = true;
        sum.entries = entries.size();
        for (const dat::Entry& entry : entries)
            countEntry(entry);
        return entries;
    }

    void countEntry(const dat::Entry& entry) {
        ++census_[Tally::Entries];
        census_[Tally::CompressedEntries] += (entry.flags & 1u) != 0;
        census_[Tally::OddVersions] += entry.version < 1 || entry.version > 3;
        census_[Tally::FirstVersion] += entry.version == 1 && entry.id != dat::kIterationId;
    }

    void readAll(const dat::File& file, const std::vector<dat::Entry>& entries) {
        for (const dat::Entry& entry : entries) {
            read(file, entry);
            ++done_;
            if (progress_ && done_ % kProgressEvery == 0)
                progress_(total_, done_);
            if (done_ % kReleaseEvery == 0)
                file.letPagesGo();
        }
        file.letPagesGo();
    }

    void read(const dat::File& file, const dat::Entry& entry) {
        switch (dat::kindOf(file.role(), entry.id)) {
        case dat::RecordKind::GfxObj:
            return take<dat::GfxObj>(file, entry, portal_);
        case dat::RecordKind::Setup:
            return take<dat::Setup>(file, entry, portal_);
        case dat::RecordKind::Palette:
            return take<dat::Palette>(file, entry, portal_);
        case dat::RecordKind::Surface:
            return take<dat::Surface>(file, entry, portal_);
        case dat::RecordKind::Environment:
            return take<dat::Environment>(file, entry, portal_);
        case dat::RecordKind::DegradeInfo:
            return take<dat::DegradeInfo>(file, entry, portal_);
        case dat::RecordKind::Scene:
            return take<dat::Scene>(file, entry, portal_);
        case dat::RecordKind::ParticleEmitter:
            return take<dat::ParticleEmitter>(file, entry, portal_);
        case dat::RecordKind::PhysicsScript:
            return take<dat::PhysicsScript>(file, entry, portal_);
        case dat::RecordKind::Animation:
            return take<dat::Animation>(file, entry, portal_);
        case dat::RecordKind::RenderSurface:
            if (file.role() == dat::FileRole::Highres)
                take<dat::RenderSurface>(file, entry, portal_);
            return;
        case dat::RecordKind::LandBlock:
            census_[Tally::OtherLandBlocks] += entry.size != kLandBlockBytes;
            return take<dat::LandBlock>(file, entry, cell_);
        case dat::RecordKind::LandBlockInfo:
            return take<dat::LandBlockInfo>(file, entry, cell_);
        case dat::RecordKind::EnvCell:
            return take<dat::EnvCell>(file, entry, cell_);
        default:
            return;
        }
    }

    template <class Record, class Half>
    void take(const dat::File& file, const dat::Entry& entry, Half& half) {
        const Result<dat::ByteView> payload = file.read(entry, scratch_);
        const Result<Record> record =
            payload ? dat::decode<Record>(entry.id, *payload) : Failure(payload.error());
        if (record)
            half.add(*record);
        else
            ++census_[Tally::Unreadable];
    }

    const dat::Archive& archive_;
    Census& census_;
    const CensusProgress& progress_;
    PortalCensus portal_;
    CellCensus cell_;
    dat::Bytes scratch_;
    std::size_t total_ = 0, done_ = 0;
};

} // namespace

std::span<const dat::RecordId> markers() {
    static constexpr std::array<dat::RecordId, 11> kMarkers{0x010001EC, 0x010008A8, 0x010027BB, 0x010028C6,
                                                            0x010028C7, 0x010028CA, 0x010028CB, 0x010028CD,
                                                            0x01002A65, 0x01002C11, 0x01004E0B};
    return kMarkers;
}

bool isMarker(dat::RecordId gfxObj) {
    return std::binary_search(markers().begin(), markers().end(), gfxObj);
}

Result<Census> takeCensus(const dat::Archive& archive, const CensusProgress& progress) {
    Census census;
    const Result<void> done = Taker(archive, census, progress).run();
    if (!done)
        return Failure(done.error());
    return census;
}

} // namespace limen::doctor
