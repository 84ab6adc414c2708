#include "world/assemble/PlacedLook.h"

namespace limen::world {

Dress dressOf(const PlacedEntry& entry, Records& records) {
    Dress dress = dressOf(entry.model, {entry.clothing, entry.basePalette, &entry.beneath}, records);
    applyLook(entry.look, records, dress);
    dress.held = heldThings(entry.model, entry.scale, entry.held, records);
    return dress;
}

} // namespace limen::world
