// The colour that stands for an id where a frame is shaded flat. The same in src/frame/IdColour.h.
vec4 colourOfId(uint id) {
    uint mixed = (id + 1u) * 2654435761u;
    mixed = (mixed ^ (mixed >> 15)) * 2246822519u;
    mixed ^= mixed >> 13;
    return vec4(unpackUnorm4x8(mixed).rgb, 1.0);
}
