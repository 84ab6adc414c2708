// Colour of an id in flat shading. src/frame/IdColour.h has the same function.
vec4 colourOfId(uint id) {
    uint mixed = (id + 1u) * 2654435761u;
    mixed = (mixed ^ (mixed >> 15)) * 2246822519u;
    mixed ^= mixed >> 13;
    return vec4(unpackUnorm4x8(mixed).rgb, 1.0);
}
