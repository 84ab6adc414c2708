// The walk of gate.glsl for pixels of several samples.
//
// Each sample is tested at its own position (samples.glsl), not at the pixel's centre within a pixel's tolerance: where
// a portal's plane cuts a surface, the cut is an edge like any other and must pass between the samples where it passes
// between their rays. Seen from afar or edge-on, positions are far from linear across a pixel, and the centre itself may
// lie beyond the triangle, even behind the eye; a covered sample never does.

// One walk from one leaf visit, for the samples that ended there. Adds those that are kept to `kept`; the first of them
// says which zone lights the fragment.
void walkFrom(uint leaf, uint asked, Instance instance, Place place, inout Keep keep, inout uint kept) {
    vec4 next = kNothingBeyond;
    uint shutBy = 0u;
    uint visitIndex = leaf;
    while (visitIndex < frame.visitCount && asked != 0u) {
        Visit visit = visits[visitIndex];
        float entryTolerance = toleranceFor(visit.entryPlane.xyz, place);
        float nextTolerance = leavingTolerance(instance, next.xyz, shutBy, place);
        uint within = 0u;
        for (int i = 0; i < int(kSamples); ++i) {
            bool isWithin = isBeyondEntry(visit.entryPlane, place.sampleAt[i], entryTolerance) &&
                            isBeforeNext(next, place.sampleAt[i], nextTolerance);
            within |= isWithin ? 1u << i : 0u;
        }
        within &= asked;
        uint lightSet;
        if (within != 0u && findMember(instance, visit.zone, lightSet)) {
            if (!keep.kept) {
                keep = Keep(true, visit.zone, lightSet);
            }
            kept |= within;
            asked &= ~within;
        }
        next = visit.entryPlane;
        shutBy = visit.shutBy;
        visitIndex = visit.parent;
    }
}

// Walks once for each leaf visit among the covered samples: nearly always a single one.
Keep walkChain(Instance instance, Place place, out uint kept) {
    uint leaves[kSamples];
    for (int i = 0; i < int(kSamples); ++i) {
        leaves[i] = leafVisit(i);
    }
    Keep keep = Keep(false, 0u, 0u);
    kept = 0u;
    uint open = uint(gl_SampleMaskIn[0]);
    for (int i = 0; i < int(kSamples) && open != 0u; ++i) {
        uint alike = 0u;
        for (int j = i; j < int(kSamples); ++j) {
            alike |= leaves[j] == leaves[i] ? 1u << j : 0u;
        }
        alike &= open;
        if (alike != 0u) {
            walkFrom(leaves[i], alike, instance, place, keep, kept);
        }
        open &= ~alike;
    }
    return keep;
}

Keep walkChain(Instance instance, Place place) {
    uint kept;
    return walkChain(instance, place, kept);
}
