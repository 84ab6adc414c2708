#include "world/block/BlockReader.h"

#include "core/Assert.h"
#include "world/block/BentOpenings.h"
#include "world/block/BuildingReader.h"
#include "world/block/CellReader.h"
#include "world/block/PortalLinks.h"
#include "world/block/Zones.h"
#include "world/records/Pose.h"
#include "world/terrain/Scenery.h"

#include <algorithm>

namespace limen::world {
namespace {

/// The identity of the `index`-th object of a record.
std::uint64_t objectId(dat::RecordId record, std::size_t index) {
    LIMEN_ASSERT(index < 0xFFFFFFFFu, "the last index is that of the record itself (wholeObject)");
    return static_cast<std::uint64_t>(record) << 32 | static_cast<std::uint32_t>(index);
}

/// The index of the first building of a LandBlockInfo. Its objects start at 0.
constexpr std::size_t kBuildingObjects = 0x80000000u;

/// Loads a record of the cell file. A record that exists but cannot be read is a finding.
template <class Record>
std::optional<Record> load(const dat::Archive& archive, dat::RecordId id, std::vector<Finding>& findings) {
    if (!archive.contains<Record>(id))
        return std::nullopt;
    Result<Record> record = archive.load<Record>(id);
    if (record)
        return std::move(*record);
    note(findings, id, record.error().message());
    return std::nullopt;
}

std::set<int> builtCells(const dat::LandBlockInfo* info) {
    std::set<int> cells;
    for (std::size_t i = 0; info != nullptr && i < info->buildings.size(); ++i) {
        const Vec3 origin = poseOf(info->buildings[i].frame).origin;
        if (origin.x >= 0.0 && origin.y >= 0.0 && origin.x < kBlockSize && origin.y < kBlockSize)
            cells.insert(static_cast<int>(origin.x / kLandcellSize) * 8 +
                         static_cast<int>(origin.y / kLandcellSize));
    }
    return cells;
}

PlacedModel placed(InstanceKind kind, const dat::Stab& stab, std::uint64_t object, std::uint32_t cell) {
    const Pose pose = poseOf(stab.frame);
    return {kind, stab.model, object, pose.origin, pose.orientation, 1.0, cell};
}

} // namespace

bool isPureDungeon(const dat::LandBlock& land, const dat::LandBlockInfo* info) {
    const bool flat =
        std::all_of(land.heights.begin(), land.heights.end(), [](std::uint8_t h) { return h == 0; });
    return flat && info != nullptr && info->numCells > 0 && info->buildings.empty();
}

std::optional<BlockContent> BlockReader::read(dat::BlockCoord coord) {
    auto [block, findings] = records_.collect([&] { return readNear(coord); });
    if (block)
        block->recordFindings = std::move(findings);
    return std::move(block);
}

std::optional<BlockContent> BlockReader::readGround(dat::BlockCoord coord) {
    auto [block, findings] = records_.collect([&] { return readFar(coord); });
    if (block)
        block->recordFindings = std::move(findings);
    return std::move(block);
}

std::optional<BlockContent> BlockReader::readFar(dat::BlockCoord coord) {
    BlockContent block;
    block.coord = coord;
    block.isFar = true;
    const dat::Archive& archive = records_.archive();
    const std::optional<dat::LandBlock> land =
        load<dat::LandBlock>(archive, dat::landBlockId(coord), block.findings);
    if (!land && block.findings.empty())
        return std::nullopt;
    if (!land || region_ == nullptr)
        return block;
    const bool isFlat =
        std::all_of(land->heights.begin(), land->heights.end(), [](std::uint8_t h) { return h == 0; });
    if (isFlat) { // only such a block can be a pure dungeon
        const std::optional<dat::LandBlockInfo> info =
            load<dat::LandBlockInfo>(archive, dat::landBlockInfoId(coord), block.findings);
        if (isPureDungeon(*land, info ? &*info : nullptr))
            return std::nullopt;
    }
    addTerrain(*land, block);
    return block;
}

std::optional<BlockContent> BlockReader::readNear(dat::BlockCoord coord) {
    BlockContent block;
    block.coord = coord;
    const dat::Archive& archive = records_.archive();
    const std::optional<dat::LandBlock> land =
        load<dat::LandBlock>(archive, dat::landBlockId(coord), block.findings);
    const std::optional<dat::LandBlockInfo> info =
        load<dat::LandBlockInfo>(archive, dat::landBlockInfoId(coord), block.findings);
    if (!land && !info && block.findings.empty())
        return std::nullopt;
    if (info)
        addCells(*info, block);
    block.zones = groupIntoZones(block, mergeZones_);
    if (land && region_ != nullptr && !isPureDungeon(*land, info ? &*info : nullptr))
        addGround(*land, info ? &*info : nullptr, block);
    if (info)
        addObjects(*info, block);
    return block;
}

void BlockReader::addCells(const dat::LandBlockInfo& info, BlockContent& block) {
    BakedGeometry geometry;
    std::vector<CellDraft> drafts;
    std::uint32_t missing = 0;
    const std::uint32_t count = std::min<std::uint32_t>(info.numCells, dat::kLastCell - dat::kFirstCell + 1);
    for (std::uint32_t i = 0; i < count; ++i) {
        const dat::RecordId id = dat::blockWord(block.coord) | (dat::kFirstCell + i);
        if (!records_.archive().contains<dat::EnvCell>(id)) {
            ++missing;
            continue;
        }
        if (std::optional<dat::EnvCell> record = load<dat::EnvCell>(records_.archive(), id, block.findings)) {
            if (std::optional<CellDraft> draft =
                    draftCell(std::move(*record), records_, geometry, block.findings))
                drafts.push_back(std::move(*draft));
        }
    }
    if (missing > 0 || count < info.numCells)
        note(block.findings, info.id,
             std::to_string(missing + (info.numCells - count)) + " of its cells do not exist");
    std::vector<BuildingDraft> buildings;
    for (std::size_t i = 0; i < info.buildings.size(); ++i)
        buildings.push_back(draftBuilding(info.buildings[i], objectId(info.id, kBuildingObjects + i),
                                          records_, models_, geometry, block.findings));
    geometry.bake();
    for (const CellDraft& draft : drafts)
        finishCell(draft, geometry, records_, block);
    LIMEN_ASSERT(block.cells.size() == drafts.size(), "cells have the indices of their drafts");
    linkCellPortals(block);
    for (std::size_t i = 0; i < info.buildings.size(); ++i) {
        finishBuilding(buildings[i], geometry, records_, block);
        linkBuilding(block, info.buildings[i], buildings[i].portalPolygons, info.id);
    }
    finishBuildings(block);
    splitBentOpenings(block);
    for (std::uint32_t cell = 0; cell < drafts.size(); ++cell) {
        const dat::EnvCell& record = drafts[cell].record;
        for (std::size_t i = 0; i < record.statics.size(); ++i)
            block.objects.push_back(
                placed(InstanceKind::Static, record.statics[i], objectId(record.id, i), cell));
    }
}

void BlockReader::addGround(const dat::LandBlock& record, const dat::LandBlockInfo* info,
                            BlockContent& block) {
    addTerrain(record, block);
    const std::vector<SceneryObject> scenery =
        growScenery(groundOf(record, *region_), *region_, builtCells(info), records_);
    for (std::size_t i = 0; i < scenery.size(); ++i) {
        block.objects.push_back({InstanceKind::Scenery, scenery[i].model, objectId(record.id, i),
                                 scenery[i].origin, scenery[i].orientation, scenery[i].scale, kOutdoorSpace});
    }
}

void BlockReader::addTerrain(const dat::LandBlock& record, BlockContent& block) {
    LIMEN_ASSERT(region_ != nullptr, "heights are in the Region");
    block.ground = landOf(groundOf(record, *region_));
    block.heightIndices.assign(record.heights.begin(), record.heights.end());
    block.terrain = terrainMesh(
        *block.ground, [this](int x, int y) { return x < 0 || y < 0 ? std::nullopt : heightAt(x, y); });
}

void BlockReader::addObjects(const dat::LandBlockInfo& info, BlockContent& block) {
    for (std::size_t i = 0; i < info.objects.size(); ++i)
        block.objects.push_back(
            placed(InstanceKind::Static, info.objects[i], objectId(info.id, i), kOutdoorSpace));
}

std::optional<float> BlockReader::heightAt(int globalX, int globalY) {
    LIMEN_ASSERT(globalX >= 0 && globalY >= 0, "a vertex of the map");
    // A vertex on a border belongs to up to four blocks. Some of them may not exist.
    for (int x = globalX / 8; x >= 0 && x * 8 + 8 >= globalX; --x) {
        for (int y = globalY / 8; y >= 0 && y * 8 + 8 >= globalY; --y) {
            const std::optional<dat::LandBlock>& land = neighbour({x, y});
            if (!land)
                continue;
            const auto index = static_cast<std::size_t>((globalX - x * 8) * 9 + globalY - y * 8);
            const float z = region_->landDefs.heights[land->heights[index]];
            return std::isfinite(z) ? std::optional(landHeight(z)) : std::nullopt;
        }
    }
    return std::nullopt;
}

const std::optional<dat::LandBlock>& BlockReader::neighbour(dat::BlockCoord coord) {
    const auto [entry, fresh] = neighbours_.try_emplace(dat::landBlockId(coord));
    if (fresh && coord.x < 255 && coord.y < 255) {
        if (Result<dat::LandBlock> record = records_.archive().load<dat::LandBlock>(dat::landBlockId(coord)))
            entry->second = *record;
    }
    return entry->second;
}

} // namespace limen::world
