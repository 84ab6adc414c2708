#include "worlds/builtin/land/RegionBuilder.h"
#include "worlds/generate/GeneratedKinds.h"
#include "worlds/generate/House.h"
#include "worlds/generate/Land.h"
#include "worlds/generate/Sites.h"
#include "worlds/generate/SmallPictures.h"
#include "worlds/records/Carve.h"
#include "worlds/records/LandblockWriter.h"

#include <fmt/format.h>

namespace limen::worlds {

namespace {

constexpr dat::BlockCoord kSouthWestOfLand{0x60, 0x30};
constexpr int kSitesGround = 60; ///< index of the level around the sites
constexpr std::uint32_t kSitesPerBlock = 4;
constexpr std::size_t kMostTerrainPlaces = 80;
constexpr double kAboveGround = 0.25;

enum class Site : std::uint32_t { Tunnel, Court, Tower, Slope, Vault, Cellar, Count };
constexpr std::array<const char*, 6> kSiteNames{"tunnel", "court", "tower", "slope", "vault", "cellar"};

class TerrainBuilder {
public:
    explicit TerrainBuilder(const GeneratedSpec& spec)
        : spec_(spec), random_(seedOf(spec)), blocks_((spec.size + kSitesPerBlock - 1) / kSitesPerBlock),
          across_(acrossOf(blocks_)),
          land_(kSouthWestOfLand, across_, rowsOf(blocks_, across_), kSitesGround) {}

    WorldRecords build() {
        addGeneratedMaterials(records_, spec_.furnished);
        props_ = addProps(writer_, spec_.furnished);
        leaves_ = addHouseLeaves(writer_, spec_.furnished);
        addRegion(writer_, addGeneratedPlants(writer_, spec_.furnished));
        const std::uint32_t first = random_.below(static_cast<std::uint32_t>(Site::Count));
        std::uint32_t site = 0;
        for (int by = 0; by < rowsOf(blocks_, across_); ++by) {
            for (int bx = 0; bx < across_; ++bx) {
                LandblockWriter block(writer_, land_.blockAt(bx, by), kGeneratedCells);
                for (std::uint32_t k = 0; k < kSitesPerBlock && site < spec_.size; ++k, ++site) {
                    // Kinds alternate, so that even a small world has most of them.
                    const auto kind =
                        static_cast<Site>((first + site) % static_cast<std::uint32_t>(Site::Count));
                    addSite(block, kind, site, bx, by, static_cast<int>(k));
                }
                block.finish();
            }
        }
        land_.addTo(records_);
        records_.worldFile = notes_.take();
        return std::move(records_);
    }

private:
    static int acrossOf(std::uint32_t blocks) {
        int across = 1;
        while (static_cast<std::uint32_t>(across * across) < blocks)
            ++across;
        return across;
    }
    static int rowsOf(std::uint32_t blocks, int across) {
        return (static_cast<int>(blocks) + across - 1) / across;
    }

    void addSite(LandblockWriter& block, Site kind, std::uint32_t number, int bx, int by, int quarter) {
        const int vx = bx * kCellsPerBlock + 2 + 4 * (quarter % 2);
        const int vy = by * kCellsPerBlock + 2 + 4 * (quarter / 2);
        const bool alongY = random_.chance(0.5);
        Placement at{{48.0 + 96.0 * (quarter % 2), 48.0 + 96.0 * (quarter / 2),
                      heightOfIndex(kSitesGround) + kAboveGround},
                     alongY ? 90.0 : 0.0};
        std::vector<HouseOpening> openings;
        shapeGround(kind, vx, vy, alongY);
        BuildingPlan plan = planOf(kind, at, openings);
        if (random_.chance(0.5))
            at.turn += random_.between(-6.0, 6.0);
        const dat::BlockCoord coord = land_.blockAt(bx, by);
        const std::vector<CellPlan> cells = plan.cells;
        const dat::RecordId first = block.add(withClosedSeams(std::move(plan)), at).front();
        noteDoors(openings, leaves_, coord, at, first, random_, notes_);
        notePlaces(kind, number, coord, at, cells, first);
    }

    void shapeGround(Site kind, int vx, int vy, bool alongY) {
        if (kind == Site::Tunnel) {
            const int rise = 22 + static_cast<int>(random_.below(12));
            for (int k = -1; k <= 1; ++k) {
                land_.setHeight(vx + (alongY ? k : 0), vy + (alongY ? 0 : k), kSitesGround + rise);
                land_.setCover(vx + (alongY ? k : 0), vy + (alongY ? 0 : k), TerrainKind::BarrenRock, false);
            }
        } else if (kind == Site::Slope) {
            const int step = 5 + static_cast<int>(random_.below(5));
            for (int k = -1; k <= 1; ++k) {
                land_.setHeight(vx + (alongY ? k : -1), vy + (alongY ? -1 : k), kSitesGround - step);
                land_.setHeight(vx + (alongY ? k : 1), vy + (alongY ? 1 : k), kSitesGround + step);
            }
        } else {
            land_.setCover(vx, vy, TerrainKind::PackedDirt, false);
        }
    }

    BuildingPlan planOf(Site kind, Placement& at, std::vector<HouseOpening>& openings) {
        switch (kind) {
        case Site::Tunnel:
            return planTunnel(props_, random_);
        case Site::Court:
            return planCourt(props_, random_);
        case Site::Tower:
            return planTower(props_, random_);
        case Site::Vault:
            return planVault(props_, random_);
        default:
            break;
        }
        HouseSpec spec = randomHouse(random_, -4.0);
        spec.cellar = spec.cellar || kind == Site::Cellar;
        if (kind == Site::Slope)
            at.turn += 90.0 * random_.below(4);
        House house = planHouse(spec, props_, random_);
        openings = std::move(house.openings);
        return std::move(house.plan);
    }

    void notePlaces(Site kind, std::uint32_t number, dat::BlockCoord coord, const Placement& at,
                    const std::vector<CellPlan>& cells, dat::RecordId first) {
        const std::string name = fmt::format("{}.{}", kSiteNames[static_cast<std::size_t>(kind)], number);
        const auto global = [&](const Vec3& p) { return blockToGlobal(coord, place(at, p)); };
        for (std::size_t c = 0; c < cells.size() && notes_.placeCount() < kMostTerrainPlaces; ++c) {
            const auto portal = std::find_if(cells[c].faces.begin(), cells[c].faces.end(),
                                             [](const Face& f) { return f.portal; });
            notes_.addPlace(fmt::format("{}.{}", name, c), global(cells[c].eye),
                            global(centroidOf(portal->points)), first + static_cast<dat::RecordId>(c));
        }
        notes_.addPlace(name, global({-34.0, -20.0, 12.0}), global({0.0, 0.0, 1.0}), 0);
    }

    GeneratedSpec spec_;
    Random random_;
    std::uint32_t blocks_;
    int across_;
    Land land_;
    WorldRecords records_;
    ModelWriter writer_{records_};
    Props props_;
    HouseLeaves leaves_;
    WorldNotes notes_;
};

} // namespace

WorldRecords buildTerrainWorld(const GeneratedSpec& spec) {
    return TerrainBuilder(spec).build();
}

} // namespace limen::worlds
