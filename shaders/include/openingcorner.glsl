// The corners of an opening's outline. Before this is included: `opening`, the fan's first vertex and its number of
// corners.
vec3 outlineCorner(uint i) {
    OwnershipVertex corner = ownershipVertices[opening.x + 3u * i + 1u];
    return eyeFromBlock(corner.position, corner.rest, corner.block);
}
