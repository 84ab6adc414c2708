#include "demo/Village.h"

#include "demo/Cottages.h"
#include "demo/OutdoorProps.h"
#include "demo/TerrainShape.h"

namespace limen::demo {

namespace {

/// Stands a model on the ground at block coordinates.
void stand(BlockBuilder& block, dat::RecordId model, double x, double y, double turn) {
    block.addObject({model, {{x, y, groundHeight(192.0 + x, 192.0 + y)}, turn}});
}

/// A row of fence pieces along x, 3 m each, open where a piece would lie in the gap.
void fenceRow(BlockBuilder& block, dat::RecordId fence, double y, double from, double to, double gapFrom,
              double gapTo) {
    for (double x = from; x + 3.0 <= to + 1e-9; x += 3.0) {
        if (x + 3.0 <= gapFrom || x >= gapTo) {
            stand(block, fence, x, y, 0.0);
        }
    }
}

} // namespace

VillageMap addVillage(ModelSink& sink) {
    const Furniture furniture = addFurniture(sink);
    const OutdoorProps props = addOutdoorProps(sink);
    BlockBuilder block(sink, kVillage);
    VillageMap map;
    const double floor = siteLevel() + kFloorAboveGround;
    map.cottage = {{84.0, 106.0, floor}, 0.0};
    map.neighbour = {{84.0, 86.0, floor}, 180.0};
    map.cottageCells = block.addBuilding(planCottage(sink, furniture), map.cottage);
    map.neighbourCells = block.addBuilding(planNeighbour(sink, furniture), map.neighbour);
    fenceRow(block, props.fence, 101.2, 67.5, 103.5, 82.4, 85.6);
    fenceRow(block, props.fence, 90.6, 67.5, 100.5, 82.4, 85.6);
    stand(block, props.well, 92.4, 103.9, 25.0);
    stand(block, props.trough, 95.2, 103.0, 80.0);
    stand(block, props.woodpile, 77.35, 110.6, -90.0);
    stand(block, props.bench, 87.5, 105.35, 0.0);
    stand(block, props.signpost, 70.6, 100.3, 0.0);
    stand(block, props.lampPost, 89.4, 100.7, 0.0);
    stand(block, furniture.barrel, 82.2, 105.3, 0.0);
    stand(block, furniture.barrel, 81.4, 105.45, 60.0);
    stand(block, furniture.crate, 86.6, 86.6, 12.0);
    stand(block, props.bench, 81.2, 86.7, 180.0);
    stand(block, props.woodpile, 89.0, 82.0, 90.0);
    block.finish();
    return map;
}

} // namespace limen::demo
