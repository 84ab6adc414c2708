#include "FullWorld.h"

#include "dat/Archive.h"
#include "engine/WorldSource.h"
#include "placements/WorldDb.h"
#include "world/Loader.h"
#include "world/Nearby.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <random>

namespace limen::bench {
namespace {

using placements::Content;
using placements::Template;
using placements::TemplateType;

constexpr std::uint32_t kFirstGuid = 0x70000000;
constexpr std::size_t kMostPerBlock = 0x0FFF; ///< guids of a landblock

/// A place for an object, local to its landblock.
struct Site {
    std::uint32_t cell = 0; ///< with the landblock
    Vec3 at{0.0};
    std::array<float, 4> angles{1.0f, 0.0f, 0.0f, 0.0f};
};

/// A leaf and the box around it.
struct DoorModel {
    dat::RecordId id = 0;
    Vec3 low{0.0}, high{0.0};
};

std::optional<DoorModel> doorModelOf(const engine::WorldSource& source) {
    for (const world::DoorEntry& door : source.file.moving.doors) {
        if (!door.opaque || door.leaves.empty() || door.leaves.front().model >> 24 != 0x01)
            continue;
        const Result<dat::GfxObj> mesh = source.archive.load<dat::GfxObj>(door.leaves.front().model);
        if (!mesh || mesh->vertexArray.vertices.empty())
            continue;
        DoorModel model{door.leaves.front().model, Vec3(1e9), Vec3(-1e9)};
        for (const auto& [key, vertex] : mesh->vertexArray.vertices) {
            model.low = glm::min(model.low, Vec3(vertex.position));
            model.high = glm::max(model.high, Vec3(vertex.position));
        }
        return model;
    }
    return std::nullopt;
}

/// Makes the objects of one landblock after another.
class FullWorld {
public:
    FullWorld(const engine::WorldSource& source, const PlacedCounts& counts)
        : source_(source), counts_(counts), door_(doorModelOf(source)) {}

    Result<Content> make() {
        findModels();
        if (models_.empty() || !door_)
            return fail(ErrorCode::NotFound, source_.archive.directory().string(),
                        "has no model for doors or for things");
        addTemplates();
        for (const dat::BlockCoord block : chooseBlocks())
            if (Result<void> filled = fill(block); !filled)
                return Failure(filled.error());
        addRest();
        return std::move(content_);
    }

private:
    void findModels() {
        for (dat::RecordId id = 0x02000000; id < 0x02010000; ++id)
            if (source_.archive.contains<dat::Setup>(id))
                models_.push_back(id);
        for (dat::RecordId id = 0x01000000; id < 0x01010000 && models_.size() < 5'000; ++id)
            if (id != door_->id && source_.archive.contains<dat::GfxObj>(id))
                models_.push_back(id);
    }

    [[nodiscard]] std::uint32_t below(std::size_t count) {
        return static_cast<std::uint32_t>(random_() % count);
    }
    [[nodiscard]] double within(double low, double high) {
        return low + (high - low) * static_cast<double>(random_() >> 8) / static_cast<double>(1u << 24);
    }

    /// Two thirds of the templates share 30 models. In a real landblock 46 of 70 templates shared 4 Setups, and all had 25.
    [[nodiscard]] dat::RecordId anyModel() {
        constexpr std::size_t kCommon = 30;
        return models_[below(below(3) < 2 ? std::min(kCommon, models_.size()) : models_.size())];
    }

    /// Templates in the shares of the published ones: every kind has its own range of numbers.
    void addTemplates() {
        const std::uint32_t each = counts_.templates / 5;
        for (std::uint32_t id = 1; id <= counts_.templates; ++id) {
            const std::uint32_t kind = std::min((id - 1) / each, 4u);
            Template of;
            of.id = id;
            of.className = fmt::format("made-{}", id);
            of.name = fmt::format("Object of kind {}", id);
            of.physicsState = 1032;
            constexpr std::array kTypes{TemplateType::Generic, TemplateType::Door, TemplateType::Creature,
                                        TemplateType::Portal, TemplateType::Chest};
            of.type = static_cast<std::int32_t>(kTypes[kind]);
            of.setup = kind == 1 ? door_->id : anyModel();
            if (kind == 0)
                of.visibility = true; // a generator
            if (kind == 2)
                of.items = {{2, 1 + below(counts_.templates), 7, 0.33f}};
            if (kind == 3)
                of.destination = placements::Spot{0x7F7F0000, {96.0f, 96.0f, 0.0f}, {1.0f, 0.0f, 0.0f, 0.0f}};
            content_.templates.emplace_hint(content_.templates.end(), id, std::move(of));
        }
    }
    [[nodiscard]] std::uint32_t templateOfKind(std::uint32_t kind) {
        const std::uint32_t each = counts_.templates / 5;
        return 1 + kind * each + below(each);
    }

    /// All blocks with cells, up to the wanted number, then open land.
    [[nodiscard]] std::vector<dat::BlockCoord> chooseBlocks() {
        std::vector<dat::BlockCoord> towns, dungeons, open;
        for (int x = 0; x < world::kMapSize; ++x) {
            for (int y = 0; y < world::kMapSize; ++y) {
                const dat::BlockCoord block{x, y};
                if (world::isDungeon(source_.archive, block))
                    dungeons.push_back(block);
                else if (source_.archive.contains<dat::LandBlockInfo>(dat::landBlockInfoId(block)))
                    towns.push_back(block);
                else if (source_.archive.contains<dat::LandBlock>(dat::landBlockId(block)))
                    open.push_back(block);
            }
        }
        std::shuffle(open.begin(), open.end(), random_);
        std::shuffle(towns.begin(), towns.end(), random_);
        std::shuffle(dungeons.begin(), dungeons.end(), random_);
        std::vector<dat::BlockCoord> blocks;
        const auto take = [&](const std::vector<dat::BlockCoord>& from, std::size_t most) {
            const std::size_t count = std::min({most, from.size(), counts_.landblocks - blocks.size()});
            blocks.insert(blocks.end(), from.begin(), from.begin() + static_cast<std::ptrdiff_t>(count));
        };
        take(towns, counts_.landblocks / 2);
        take(dungeons, counts_.landblocks / 4);
        take(open, counts_.landblocks);
        return blocks;
    }

    /// One share of all objects, and doors in the openings of cells.
    Result<void> fill(dat::BlockCoord block) {
        const Result<world::World> world = world::loadWorld(source_.archive, block, {.radius = 0});
        if (!world)
            return Failure(world.error());
        const std::uint32_t number =
            static_cast<std::uint32_t>(block.x) << 8 | static_cast<std::uint32_t>(block.y);
        blocks_.push_back(number);
        placements::Landblock& rows = content_.landblocks[number];
        for (const world::Portal& portal : world->portals)
            if (const std::optional<Site> site = doorSite(*world, portal, block))
                add(rows, number, *site, 1);
        const std::uint32_t things = counts_.objects - counts_.generators - counts_.doors;
        for (std::uint32_t i = 0; i < things / counts_.landblocks; ++i) {
            const double kind = within(0.0, things);
            add(rows, number, siteIn(*world, block),
                kind < counts_.people                     ? 2u
                : kind < counts_.people + counts_.portals ? 3u
                                                          : 4u);
        }
        for (std::uint32_t i = 0; i < counts_.generators / counts_.landblocks; ++i)
            addGenerator(rows, number, siteIn(*world, block));
        return {};
    }

    [[nodiscard]] Site siteIn(const world::World& world, dat::BlockCoord block) {
        const Vec3 origin(block.x * world::kBlockSize, block.y * world::kBlockSize, 0.0);
        const std::uint32_t number =
            static_cast<std::uint32_t>(block.x) << 8 | static_cast<std::uint32_t>(block.y);
        const std::uint32_t space = below(world.spaces.size());
        const double half = within(0.0, 3.14159);
        const std::array<float, 4> angles{static_cast<float>(std::cos(half)), 0.0f, 0.0f,
                                          static_cast<float>(std::sin(half))};
        if (space != world::kOutside && below(2) == 0) {
            const Aabb& bounds = world.spaces[space].bounds;
            return {world.spaces[space].cellId, bounds.centre() - origin, angles};
        }
        const double x = within(1.0, 191.0), y = within(1.0, 191.0);
        const double ground = world::terrainHeight(world, origin.x + x, origin.y + y);
        return {number << 16, Vec3(x, y, std::isfinite(ground) ? ground : 0.0), angles};
    }

    /// The place at which the leaf's box is in the middle of an upright opening between cells, or to the outside.
    [[nodiscard]] std::optional<Site> doorSite(const world::World& world, const world::Portal& portal,
                                               dat::BlockCoord block) {
        constexpr double kUpright = 0.1;
        if (doors_ == counts_.doors || portal.space == world::kOutside ||
            portal.destination == world::kNone || portal.space > portal.destination ||
            std::abs(portal.plane.n.z) > kUpright || portal.cornerCount < 3)
            return std::nullopt;
        Vec3 low(1e9), high(-1e9);
        for (const Vec3& corner : world::cornersOf(world, portal)) {
            low = glm::min(low, corner);
            high = glm::max(high, corner);
        }
        const Vec3 size = door_->high - door_->low;
        const bool isThinX = size.x < size.y; // its normal in its own frame: +x, else +y
        const Vec3 n = portal.plane.n;
        const double turn = isThinX ? std::atan2(n.y, n.x) : std::atan2(-n.x, n.y);
        const Vec3 middle = (door_->low + door_->high) * 0.5;
        const Vec3 across(middle.x * std::cos(turn) - middle.y * std::sin(turn),
                          middle.x * std::sin(turn) + middle.y * std::cos(turn), 0.0);
        const Vec3 origin(block.x * world::kBlockSize, block.y * world::kBlockSize, 0.0);
        Site site;
        site.cell = world.spaces[portal.space].cellId;
        site.at =
            Vec3((low.x + high.x) * 0.5, (low.y + high.y) * 0.5, low.z - door_->low.z) - across - origin;
        site.angles = {static_cast<float>(std::cos(turn / 2.0)), 0.0f, 0.0f,
                       static_cast<float>(std::sin(turn / 2.0))};
        ++doors_;
        return site;
    }

    void add(placements::Landblock& rows, std::uint32_t number, const Site& site, std::uint32_t kind,
             bool isChild = false) {
        if (rows.placements.size() == kMostPerBlock)
            return;
        rows.placements.push_back(
            {kFirstGuid | number << 12 | static_cast<std::uint32_t>(rows.placements.size()),
             templateOfKind(kind),
             {site.cell,
              {static_cast<float>(site.at.x), static_cast<float>(site.at.y), static_cast<float>(site.at.z)},
              site.angles},
             isChild});
        ++made_;
    }
    /// A generator, linked to the object before it.
    void addGenerator(placements::Landblock& rows, std::uint32_t number, const Site& site) {
        add(rows, number, site, 0);
        if (rows.placements.size() >= 2)
            rows.links.push_back(
                {rows.placements.back().guid, rows.placements[rows.placements.size() - 2].guid});
    }

    /// Generators for the objects that are still missing, so that the number is exact.
    void addRest() {
        for (std::size_t i = 0; made_ < counts_.objects && !blocks_.empty(); ++i) {
            const std::uint32_t number = blocks_[i % blocks_.size()];
            addGenerator(content_.landblocks[number], number,
                         {number << 16, Vec3(96.0, 96.0, 0.0), {1.0f, 0, 0, 0}});
        }
        for (auto& [number, rows] : content_.landblocks)
            std::sort(rows.links.begin(), rows.links.end());
    }

    const engine::WorldSource& source_;
    const PlacedCounts counts_;
    std::optional<DoorModel> door_;
    std::mt19937 random_{20260226};
    std::vector<dat::RecordId> models_;
    std::vector<std::uint32_t> blocks_;
    std::uint32_t doors_ = 0;
    std::size_t made_ = 0;
    Content content_;
};

} // namespace

Result<void> writeFullWorld(const std::filesystem::path& dats, const PlacedCounts& counts) {
    const Result<engine::WorldSource> source =
        engine::openWorldSource(dats.string(), engine::PlaceSearch::Skip);
    if (!source)
        return Failure(source.error());
    const Result<Content> content = FullWorld(*source, counts).make();
    if (!content)
        return Failure(content.error());
    return placements::writeWorldDb(dats / placements::kWorldDbName, *content,
                                    {"made up for a benchmark", ""})
        .map([](const placements::WriteCounts&) {});
}

} // namespace limen::bench
