// Levels of detail by distance; world/LevelRange.cpp computes the same in the same integers. Needs buffers.glsl.

uint squareOf(int steps) {
    uint away = uint(min(abs(steps), int(kMostRangeSteps)));
    return away * away;
}

// Landcells added before a division, which then rounds down. Their steps exceed kMostLocalSteps.
const int kToPositive = 4096;

int landcellMiddle(int steps) {
    int side = int(kLandcellSteps);
    return ((steps + kToPositive * side) / side - kToPositive) * side + side / 2;
}

// Whether the eye is within the instance's range.
bool isInLevelRange(Instance instance) {
    if (instance.level == kFromAnywhere) {
        return true;
    }
    Level level = levels[instance.level];
    int originZ = level.originZ >> findLSB(kMeasures);
    uint measure = uint(level.originZ) % kMeasures;
    ivec3 eye = ivec3(frame.eyeSteps.xyz) - ivec3(blockOrigin(instance.block) * float(kRangeSteps));
    uint away = squareOf(level.originX - eye.x) + squareOf(level.originY - eye.y) + squareOf(originZ - eye.z);
    uint across = squareOf(landcellMiddle(level.originX) - eye.x) + squareOf(landcellMiddle(level.originY) - eye.y);
    bool isOfLandcell = measure == kMeasureLandcell && across > kLandcellBeyond * kLandcellBeyond;
    uint squared = isOfLandcell ? across : away;
    uint from = level.range & 0xFFFFu;
    uint upTo = level.range >> 16;
    return squared >= from * from && (upTo == kEndlessRange || squared < upTo * upTo);
}
