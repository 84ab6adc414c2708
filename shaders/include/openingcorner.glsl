// The corners of an opening's outline. Before this is included: `opening`, the first vertex of its fan and the number of
// its corners.
vec3 outlineCorner(uint i) {
    OwnershipVertex corner = ownershipVertices[opening.x + 3u * i + 1u];
    return eyeFromBlock(corner.position, corner.rest, corner.block);
}
