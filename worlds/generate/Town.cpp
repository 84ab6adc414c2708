#include "worlds/builtin/land/RegionBuilder.h"
#include "worlds/generate/GeneratedKinds.h"
#include "worlds/generate/SmallPictures.h"
#include "worlds/generate/TownBlocks.h"

#include <fmt/format.h>

namespace limen::worlds {

namespace {

constexpr dat::BlockCoord kSouthWestOfTown{0x50, 0x60};
constexpr int kTownGround = 40; ///< index of the mean height of the town

class TownBuilder {
public:
    explicit TownBuilder(const GeneratedSpec& spec)
        : spec_(spec), random_(seedOf(spec)), blocks_((spec.size + kMostHouses - 1) / kMostHouses),
          across_(acrossOf(blocks_)),
          land_(kSouthWestOfTown, across_,
                static_cast<int>((blocks_ + static_cast<std::uint32_t>(across_) - 1) /
                                 static_cast<std::uint32_t>(across_)),
                kTownGround) {}

    WorldRecords build() {
        addGeneratedMaterials(records_, spec_.furnished);
        props_ = addProps(writer_, spec_.furnished);
        leaves_ = addHouseLeaves(writer_, spec_.furnished);
        addRegion(writer_, addGeneratedPlants(writer_, spec_.furnished));
        roll();
        TownBlocks town({writer_, props_, leaves_, notes_}, land_, random_);
        for (std::uint32_t b = 0; b < blocks_; ++b) {
            const std::uint32_t houses = spec_.size / blocks_ + (b < spec_.size % blocks_ ? 1u : 0u);
            const Placement district =
                town.build(static_cast<int>(b) % across_, static_cast<int>(b) / across_, houses);
            if (b == 0)
                notePlaces(land_.blockAt(0, 0), Vec3(0.0), district);
        }
        for (std::uint32_t b = blocks_; b < static_cast<std::uint32_t>(across_ * landBlocksY()); ++b) {
            LandblockWriter(writer_,
                            land_.blockAt(static_cast<int>(b) % across_, static_cast<int>(b) / across_),
                            kGeneratedCells)
                .finish();
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
    [[nodiscard]] int landBlocksY() const { return (land_.verticesY() - 1) / kCellsPerBlock; }

    /// Makes gentle ground: heights differ by a few steps of the table.
    void roll() {
        for (int vx = 0; vx < land_.verticesX(); ++vx) {
            for (int vy = 0; vy < land_.verticesY(); ++vy) {
                land_.setHeight(vx, vy, kTownGround + static_cast<int>(random_.below(4)));
                land_.setCover(vx, vy, random_.chance(0.3) ? TerrainKind::PackedDirt : TerrainKind::LushGrass,
                               false, spec_.furnished ? 1 : 0);
            }
        }
    }

    void notePlaces(dat::BlockCoord coord, const Vec3& corner, const Placement& district) {
        const auto at = [&](double x, double y, double up) {
            Vec3 p = place(district, {x, y, 0.0});
            p.z = land_.heightAt(corner.x + p.x, corner.y + p.y) + up;
            return blockToGlobal(coord, p);
        };
        notes_.addPlace("street", at(-58.0, 0.0, 1.7), at(0.0, 0.0, 2.0), 0);
        notes_.addPlace("above", at(-70.0, -60.0, 45.0), at(0.0, 0.0, 0.0), 0);
        notes_.addPlace("gardens", at(-54.0, 15.0, 1.7), at(0.0, 16.0, 1.5), 0);
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

WorldRecords buildTown(const GeneratedSpec& spec) {
    return TownBuilder(spec).build();
}

} // namespace limen::worlds
