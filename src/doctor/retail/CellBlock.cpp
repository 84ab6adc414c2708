#include "doctor/retail/CellBlock.h"

#include <algorithm>
#include <map>
#include <optional>

namespace limen::doctor {
namespace {

/// Reads records of cells, each shape and surface once.
class CellBlockReader {
public:
    CellBlockReader(const dat::Archive& archive, CellBlock& sums) : archive_(archive), sums_(sums) {}

    void add(const dat::EnvCell& cell) {
        ++sums_.cells;
        sums_.things += static_cast<double>(cell.statics.size());
        for (const dat::CellPortal& portal : cell.portals)
            sums_.portalsOutdoors += portal.otherCellId == dat::kOutdoors;
        const dat::Environment* shapes = environment(0x0D000000u | cell.environment);
        if (shapes == nullptr)
            return;
        for (const auto& [key, shape] : shapes->cells)
            if (key == cell.cellStructure)
                addPolygons(cell, shape);
    }

private:
    void addPolygons(const dat::EnvCell& cell, const dat::CellStruct& shape) {
        for (const auto& [id, polygon] : shape.polygons) {
            const auto slot = static_cast<std::size_t>(polygon.posSurface);
            if (polygon.posSurface < 0 || slot >= cell.surfaces.size() ||
                hasPicture(0x08000000u | cell.surfaces[slot]))
                continue;
            const auto& portals = shape.portalPolygons;
            ++sums_.untextured;
            sums_.untexturedThatAreNoPortals +=
                std::find(portals.begin(), portals.end(), id) == portals.end();
        }
    }

    /// A missing surface counts as one with a picture.
    bool hasPicture(dat::RecordId id) {
        const auto [known, isNew] = pictures_.try_emplace(id, true);
        if (isNew) {
            const auto surface = archive_.load<dat::Surface>(id);
            known->second = !surface || surface->hasImage();
        }
        return known->second;
    }

    const dat::Environment* environment(dat::RecordId id) {
        const auto [known, isNew] = environments_.try_emplace(id);
        if (isNew)
            if (auto loaded = archive_.load<dat::Environment>(id))
                known->second = std::move(*loaded);
        return known->second ? &*known->second : nullptr;
    }

    const dat::Archive& archive_;
    CellBlock& sums_;
    std::map<dat::RecordId, bool> pictures_;
    std::map<dat::RecordId, std::optional<dat::Environment>> environments_;
};

} // namespace

CellBlock readCellBlock(const dat::Archive& archive, std::uint32_t block) {
    CellBlock sums;
    CellBlockReader reader(archive, sums);
    for (std::uint32_t low = dat::kFirstCell; low <= dat::kLastCell; ++low) {
        const auto cell = archive.load<dat::EnvCell>(block << 16 | low);
        if (cell)
            reader.add(*cell);
        else if (cell.error().code == ErrorCode::NotFound)
            break;
    }
    return sums;
}

} // namespace limen::doctor
