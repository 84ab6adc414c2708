#include "frame/FramePlan.h"

namespace limen::frame {

void FramePlan::clear() {
    constants = {};
    blocks.clear();
    visits.clear();
    ownershipVertices.clear();
    clipSets.clear();
    rects.clear();
    skyInstances.clear();
    lamps.clear();
    dynamicRecords = {};
    dynamicInstances.clear();
    dynamicChanges.clear();
    records.clear();
    replacements.clear();
    members.clear();
    pieces.clear();
    runs.clear();
    batches.clear();
    stages.clear();
    gate = Gate::Ownership;
    levelSixteenths = 16;
    plainSky = {};
    clips = false;
    spaces.clear();
    firstOccludee = 0;
    counts = {};
}

} // namespace limen::frame
