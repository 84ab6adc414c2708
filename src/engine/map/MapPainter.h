#pragma once

#include "dat/Archive.h"
#include "engine/map/Footprints.h"
#include "engine/map/LandscapeMap.h"
#include "engine/map/TerrainColours.h"
#include "engine/picture/LinearFilter.h"

#include <functional>

namespace limen::engine {

/// Paints the map of a world block by block. Terrain types have the mean colours of their textures, slopes are
/// shaded with light from the north-west, roads and buildings are drawn over them. A record that is missing or
/// damaged leaves its block dark.
class MapPainter {
public:
    /// Lists the blocks of the data. The archive must outlive it. Errors: the cell file's index is damaged; there
    /// is a Region that cannot be read. Without a Region no block has ground. `scale`: kLeastMapScale..kMostMapScale.
    [[nodiscard]] static Result<MapPainter> begin(const dat::Archive& archive, int scale = kLeastMapScale);

    [[nodiscard]] const LandscapeMap& map() const { return map_; }
    [[nodiscard]] LandscapeMap takeMap() { return std::move(map_); }
    [[nodiscard]] std::size_t painted() const { return next_; }
    [[nodiscard]] bool isDone() const { return next_ == map_.blocks.size(); }
    /// Paints at most `count` further blocks.
    void paint(std::size_t count);

private:
    /// A block's record entries in the cell file, as LandscapeMap::blocks.
    struct Entries {
        std::optional<dat::Entry> ground, info;
    };
    MapPainter(const dat::Archive& archive, LandscapeMap map, std::vector<Entries> entries,
               std::optional<dat::Region> region);
    template <class Record>
    [[nodiscard]] std::optional<Record> read(const dat::Entry& entry);
    void paintBlock(LandscapeMap::Block& block, const Entries& entries);
    void paintDungeon(const LandscapeMap::Block& block);
    void paintGround(const LandscapeMap::Block& block, const dat::LandBlock& ground);
    void paintBuilding(const LandscapeMap::Block& block, const Footprint& footprint);
    void blend(int x, int y, const Vec3f& linear, float share);

    const dat::Archive* archive_;
    LandscapeMap map_;
    std::vector<Entries> entries_;
    std::optional<dat::Region> region_;
    TerrainColours colours_;
    LinearMean light_;
    Footprints footprints_;
    dat::Bytes scratch_;
    std::size_t next_ = 0;
};

/// Paints a whole map. Errors: MapPainter::begin's.
[[nodiscard]] Result<LandscapeMap>
paintMap(const dat::Archive& archive, int scale = kLeastMapScale,
         const std::function<void(std::size_t, std::size_t)>& progress = {});

} // namespace limen::engine
