#include "worlds/generate/DungeonBlock.h"
#include "worlds/generate/GeneratedKinds.h"
#include "worlds/generate/SmallPictures.h"

namespace limen::worlds {

namespace {

/// Below the limit of the format, which has the cell numbers 0x0100..0xFFFD.
constexpr std::uint32_t kMostCellsOfBlock = 60000;
constexpr dat::BlockCoord kFirstBlock{0x10, 0x20};

} // namespace

WorldRecords buildDungeon(const GeneratedSpec& spec) {
    WorldRecords records;
    addGeneratedMaterials(records, spec.furnished);
    ModelWriter writer(records);
    ShapeLibrary library(records);
    DungeonShapes shapes(library);
    const Props props = addProps(writer, spec.furnished);
    const DungeonLeaves leaves = addDungeonLeaves(writer, spec.furnished);
    WorldNotes notes;
    const std::uint32_t blocks = (spec.size + kMostCellsOfBlock - 1) / kMostCellsOfBlock;
    for (std::uint32_t b = 0; b < blocks; ++b) {
        const std::uint32_t cells = spec.size / blocks + (b < spec.size % blocks ? 1u : 0u);
        const std::uint64_t seed = seedOf(spec) ^ static_cast<std::uint64_t>(b) << 56;
        const DungeonLayout layout = layOutDungeon(cells, spec.overlapShare, Random(seed));
        writeDungeonBlock({writer, shapes, props, leaves},
                          {kFirstBlock.x + static_cast<int>(b), kFirstBlock.y}, layout, Random(~seed), notes);
    }
    records.worldFile = notes.take();
    return records;
}

} // namespace limen::worlds
