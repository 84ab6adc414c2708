#include "engine/map/MapPainter.h"

#include "core/Assert.h"
#include "world/block/BlockReader.h"
#include "world/terrain/Terrain.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace limen::engine {
namespace {

constexpr float kRoadHalfWidth = 5.0f;          ///< metres; wider than in the data, to be seen
const Vec3f kRoofLinear(0.20f, 0.055f, 0.035f); ///< a brick red that no terrain has
constexpr float kLandcell = static_cast<float>(world::kLandcellSize);

/// Light on a slope in proportion to that on level ground. `slope`: metres a metre, towards east and north.
float shadeOf(const Vec2f& slope) {
    const Vec3f sun = glm::normalize(Vec3f(-1.0f, 1.0f, 1.4f)); // from the north-west
    const Vec3f normal = glm::normalize(Vec3f(-slope, 1.0f));
    return std::clamp(glm::dot(normal, sun) / sun.z, 0.25f, 1.6f);
}

/// A point in a landcell, and the values at its corners SW, SE, NE, NW.
struct CellPoint {
    float east = 0.0f, north = 0.0f; ///< 0..1
    [[nodiscard]] std::array<float, 4> weights() const {
        return {(1 - east) * (1 - north), east * (1 - north), east * north, (1 - east) * north};
    }
};

struct CellValues {
    world::CellCorners corners;
    std::array<float, 4> heights{};
};

Vec2f slopeAt(const CellValues& cell, const CellPoint& at) {
    const auto& h = cell.heights;
    const float east = (h[1] - h[0]) * (1 - at.north) + (h[2] - h[3]) * at.north;
    const float north = (h[3] - h[0]) * (1 - at.east) + (h[2] - h[1]) * at.east;
    return Vec2f(east, north) / kLandcell;
}

/// The share of a road at a point. `texel`: metres.
float roadAt(const CellValues& cell, const CellPoint& at, float texel) {
    float road = 0.0f;
    const std::array<float, 4> weights = at.weights();
    for (std::size_t i = 0; i < 4; ++i)
        road += cell.corners.road[i] != 0 ? weights[i] : 0.0f;
    const float distance = (1.0f - road) * kLandcell, half = std::max(kRoadHalfWidth, texel * 0.5f);
    return std::clamp((half - distance) / texel + 0.5f, 0.0f, 1.0f);
}

Vec3f groundAt(const CellValues& cell, const CellPoint& at, float texel, const TerrainColours& colours) {
    Vec3f colour(0.0f);
    float water = 0.0f;
    const std::array<float, 4> weights = at.weights();
    for (std::size_t i = 0; i < 4; ++i) {
        colour += colours.linear[cell.corners.terrain[i]] * weights[i];
        water += isWater(cell.corners.terrain[i]) ? weights[i] : 0.0f;
    }
    colour = glm::mix(colour, colours.linear[kRoadColour], roadAt(cell, at, texel));
    return colour * glm::mix(shadeOf(slopeAt(cell, at)), 1.0f, water); // water is level
}

bool contains(const Footprint& shape, const Vec2& point) {
    bool isLeft = true, isRight = true;
    for (std::size_t i = 0; i < shape.size(); ++i) {
        const Vec2 along = shape[(i + 1) % shape.size()] - shape[i], to = point - shape[i];
        const double side = along.x * to.y - along.y * to.x;
        isLeft = isLeft && side >= 0.0;
        isRight = isRight && side <= 0.0;
    }
    return isLeft || isRight;
}

/// Around the blocks for which `counts` is true; around all if there are none.
template <class Counts>
void fitRectangle(LandscapeMap& map, Counts counts) {
    if (map.blocks.empty())
        return;
    const bool hasAny = std::any_of(map.blocks.begin(), map.blocks.end(), counts);
    int right = 0, top = 0;
    map.left = map.bottom = world::kMapSize;
    for (const LandscapeMap::Block& block : map.blocks) {
        if (hasAny && !counts(block))
            continue;
        map.left = std::min(map.left, block.coord.x);
        map.bottom = std::min(map.bottom, block.coord.y);
        right = std::max(right, block.coord.x);
        top = std::max(top, block.coord.y);
    }
    map.columns = right - map.left + 1;
    map.rows = top - map.bottom + 1;
}

/// Whether a block has cells, and no building that leads into them.
bool isDungeonOf(const dat::Archive& archive, const LandscapeMap::Block& block,
                 const std::optional<dat::Entry>& info) {
    if (block.cells == 0 || !info)
        return block.cells > 0;
    const auto record = archive.load<dat::LandBlockInfo>(info->id);
    return record && record->buildings.empty();
}

void fillDark(LandscapeMap& map) {
    map.rgb.resize(std::size_t{map.width()} * map.height() * 3);
    for (std::size_t i = 0; i < map.rgb.size(); ++i)
        map.rgb[i] = kNoGround[i % 3];
}

} // namespace

MapPainter::MapPainter(const dat::Archive& archive, LandscapeMap map, std::vector<Entries> entries,
                       std::optional<dat::Region> region)
    : archive_(&archive), map_(std::move(map)), entries_(std::move(entries)), region_(std::move(region)),
      footprints_(archive) {
    if (region_)
        colours_ = terrainColours(archive, *region_);
}

Result<MapPainter> MapPainter::begin(const dat::Archive& archive, int scale) {
    LIMEN_ASSERT(scale >= kLeastMapScale && scale <= kMostMapScale, "a scale of the map");
    struct Listed {
        LandscapeMap::Block block;
        Entries entries;
    };
    std::map<std::pair<int, int>, Listed> listed;
    const Result<void> read = archive.cell().forEach([&](const dat::Entry& entry) {
        const dat::BlockCoord coord = dat::blockOf(entry.id);
        const std::uint32_t low = entry.id & 0xFFFFu;
        if (coord.x >= world::kMapSize || coord.y >= world::kMapSize)
            return true; // beyond the map, or no record of a block
        Listed& at = listed[{coord.x, coord.y}];
        at.block.coord = coord;
        if (low == 0xFFFFu)
            at.entries.ground = entry;
        else if (low == 0xFFFEu)
            at.entries.info = entry;
        else
            at.block.cells += low >= dat::kFirstCell ? 1 : 0;
        return true;
    });
    if (!read)
        return Failure(read.error());
    LandscapeMap map;
    map.scale = scale;
    std::vector<Entries> entries;
    bool hasGround = false;
    for (auto& [key, at] : listed) {
        map.blocks.push_back(at.block);
        hasGround = hasGround || at.entries.ground.has_value();
        entries.push_back(at.entries);
    }
    // A small world may have dungeons far away from its landscape, at the edge of the map.
    std::map<std::pair<int, int>, bool> lands;
    for (std::size_t i = 0; i < map.blocks.size(); ++i)
        lands[{map.blocks[i].coord.x, map.blocks[i].coord.y}] =
            entries[i].ground && !isDungeonOf(archive, map.blocks[i], entries[i].info);
    fitRectangle(map, [&](const LandscapeMap::Block& block) {
        return lands[{block.coord.x, block.coord.y}];
    });
    fillDark(map);
    std::optional<dat::Region> region;
    if (hasGround && archive.contains<dat::Region>(dat::kRegionId)) {
        Result<dat::Region> loaded = archive.load<dat::Region>(dat::kRegionId);
        if (!loaded)
            return Failure(loaded.error());
        region = std::move(*loaded);
    }
    return MapPainter(archive, std::move(map), std::move(entries), std::move(region));
}

template <class Record>
std::optional<Record> MapPainter::read(const dat::Entry& entry) {
    const Result<dat::ByteView> bytes = archive_->cell().read(entry, scratch_);
    if (bytes)
        if (Result<Record> record = dat::decode<Record>(entry.id, *bytes))
            return std::move(*record);
    ++map_.damaged;
    return std::nullopt;
}

void MapPainter::paint(std::size_t count) {
    const std::size_t end = std::min(map_.blocks.size(), next_ + count);
    for (; next_ < end; ++next_)
        paintBlock(map_.blocks[next_], entries_[next_]);
    if (isDone())
        archive_->letPagesGo();
}

void MapPainter::paintBlock(LandscapeMap::Block& block, const Entries& entries) {
    const auto info = entries.info ? read<dat::LandBlockInfo>(*entries.info) : std::nullopt;
    const auto ground = entries.ground && region_ ? read<dat::LandBlock>(*entries.ground) : std::nullopt;
    if (ground && !world::isPureDungeon(*ground, info ? &*info : nullptr)) {
        block.hasGround = true;
        paintGround(block, *ground);
    } else if (block.cells > 0) {
        paintDungeon(block);
    }
    if (!info)
        return;
    block.buildings = static_cast<std::uint32_t>(info->buildings.size());
    for (const dat::Building& building : info->buildings)
        if (const std::optional<Footprint> footprint = footprints_.of(building))
            paintBuilding(block, *footprint);
}

/// A dungeon has no ground; its block is a little lighter than the void.
void MapPainter::paintDungeon(const LandscapeMap::Block& block) {
    const Vec3f colour(light_.linear(kDungeonBlock[0]), light_.linear(kDungeonBlock[1]),
                       light_.linear(kDungeonBlock[2]));
    for (int x = 0; x < map_.scale; ++x)
        for (int y = 0; y < map_.scale; ++y)
            blend((block.coord.x - map_.left) * map_.scale + x,
                  (block.coord.y - map_.bottom) * map_.scale + y, colour, 1.0f);
}

void MapPainter::blend(int x, int y, const Vec3f& linear, float share) {
    const int fromTop = static_cast<int>(map_.height()) - 1 - y;
    if (x < 0 || fromTop < 0 || x >= static_cast<int>(map_.width()) || y < 0)
        return;
    std::uint8_t* texel =
        &map_.rgb[(static_cast<std::size_t>(fromTop) * map_.width() + static_cast<std::size_t>(x)) * 3];
    for (int channel = 0; channel < 3; ++channel) {
        const float before = share < 1.0f ? light_.linear(texel[channel]) : 0.0f;
        texel[channel] = light_.encoded(before + (linear[channel] - before) * share);
    }
}

void MapPainter::paintGround(const LandscapeMap::Block& block, const dat::LandBlock& record) {
    const world::Ground ground = [&] {
        world::Ground made = world::groundOf(record, *region_);
        made.coord = block.coord;
        return made;
    }();
    const float texel = static_cast<float>(world::kBlockSize) / static_cast<float>(map_.scale);
    const float cells = 8.0f / static_cast<float>(map_.scale); ///< landcells a texel, 1 at most
    const int left = (block.coord.x - map_.left) * map_.scale;
    const int bottom = (block.coord.y - map_.bottom) * map_.scale;
    for (int x = 0; x < map_.scale; ++x) {
        for (int y = 0; y < map_.scale; ++y) {
            const float east = (static_cast<float>(x) + 0.5f) * cells,
                        north = (static_cast<float>(y) + 0.5f) * cells;
            const int cellX = static_cast<int>(east), cellY = static_cast<int>(north);
            CellValues cell{ground.corners(cellX, cellY), {}};
            for (std::size_t i = 0; i < 4; ++i) {
                const int cornerX = cellX + (i == 1 || i == 2 ? 1 : 0), cornerY = cellY + (i >= 2 ? 1 : 0);
                cell.heights[i] = ground.heights[static_cast<std::size_t>(cornerX * 9 + cornerY)];
            }
            const CellPoint at{east - static_cast<float>(cellX), north - static_cast<float>(cellY)};
            blend(left + x, bottom + y, groundAt(cell, at, texel, colours_), 1.0f);
        }
    }
}

/// Buildings smaller than a texel are drawn as one.
void MapPainter::paintBuilding(const LandscapeMap::Block& block, const Footprint& footprint) {
    const double texels = map_.scale / world::kBlockSize;
    const Vec2 corner((block.coord.x - map_.left) * map_.scale, (block.coord.y - map_.bottom) * map_.scale);
    Footprint shape;
    Vec2 least(1e9), most(-1e9), middle(0.0);
    for (std::size_t i = 0; i < shape.size(); ++i) {
        shape[i] = footprint[i] * texels + corner;
        least = glm::min(least, shape[i]);
        most = glm::max(most, shape[i]);
        middle += shape[i] / 4.0;
    }
    if (!(std::abs(middle.x) < 1e6 && std::abs(middle.y) < 1e6))
        return; // a damaged frame
    bool isPainted = false;
    for (int x = static_cast<int>(std::floor(least.x)); x <= static_cast<int>(most.x); ++x) {
        for (int y = static_cast<int>(std::floor(least.y)); y <= static_cast<int>(most.y); ++y) {
            if (!contains(shape, {x + 0.5, y + 0.5}))
                continue;
            blend(x, y, kRoofLinear, 0.9f);
            isPainted = true;
        }
    }
    if (!isPainted)
        blend(static_cast<int>(std::floor(middle.x)), static_cast<int>(std::floor(middle.y)), kRoofLinear,
              0.7f);
}

Result<LandscapeMap> paintMap(const dat::Archive& archive, int scale,
                              const std::function<void(std::size_t, std::size_t)>& progress) {
    constexpr std::size_t kStep = 256; ///< blocks
    Result<MapPainter> painter = MapPainter::begin(archive, scale);
    if (!painter)
        return Failure(painter.error());
    while (!painter->isDone()) {
        painter->paint(kStep);
        if (progress)
            progress(painter->painted(), painter->map().blocks.size());
    }
    return painter->takeMap();
}

} // namespace limen::engine
