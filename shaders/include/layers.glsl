// What one translucent polygon adds to the hash of the layers met in a pixel: 1..0xFFFF, so that sums of 256 layers are
// exact in a float. The same in src/reference/Scene.h.
float layerHash(uint id) {
    return float(((id * 2654435761u) >> 16) | 1u);
}
