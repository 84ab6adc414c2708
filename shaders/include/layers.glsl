// Share of one transparent polygon in the hash of a pixel's layers: 1..0xFFFF, so that sums of 256 layers are exact in
// a float. src/reference/Scene.h has the same function.
float layerHash(uint id) {
    return float(((id * 2654435761u) >> 16) | 1u);
}
