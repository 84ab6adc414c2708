#pragma once

#include "support/Puppet.h"

#include <numbers>

namespace limen::test {

inline constexpr std::uint32_t kSubstateOn = 0x4000000B, kSubstateOff = 0x4000000C;

/// Adds a motion table that turns part 0 by `swing` degrees, clockwise seen from above, in 30 frames of one second in all.
inline std::uint32_t addSwingTable(TestWorld& source, std::uint32_t id, std::uint32_t animationId,
                                   double swing) {
    constexpr int kFrames = 30;
    const auto motion = [&](int low, int high) {
        dat::MotionData data;
        data.animations = {{animationId, low, high, 30.0f}};
        return data;
    };
    dat::Animation animation;
    animation.id = animationId;
    animation.partCount = 1;
    for (int i = 0; i <= kFrames; ++i) {
        const double half = -swing * i / kFrames * std::numbers::pi / 360.0;
        const Quatf turn(static_cast<float>(std::cos(half)), 0.0f, 0.0f, static_cast<float>(std::sin(half)));
        animation.frames.push_back({{{Vec3f(0.0f), turn}}, {}});
    }
    source.portalFile().add(animation);
    dat::MotionTable table;
    table.id = id;
    table.defaultStyle = kPuppetStyle;
    table.styleDefaults = {{kPuppetStyle, kSubstateOff}};
    const std::uint32_t off = dat::motionKey(kPuppetStyle, kSubstateOff),
                        on = dat::motionKey(kPuppetStyle, kSubstateOn);
    table.cycles = {{off, motion(0, 0)}, {on, motion(kFrames, kFrames)}};
    table.links = {{off, {{kSubstateOn, motion(1, kFrames)}}}};
    source.portalFile().add(table);
    return id;
}

/// The moving hut whose opaque doors come from a world database in place of world.json. Their Setup has one part, the
/// leaf; their motion tables turn it about the hinge as `swing` degrees of world.json do.
struct PlacedHut {
    MovingHut hut;
    std::uint32_t setup = 0, clockwise = 0, counterClockwise = 0;

    PlacedHut() {
        dat::Setup door;
        door.parts = {hut.leaf};
        setup = hut.source.addSetup(door);
        clockwise = addTable(0x09000101, 0x03000101, 90.0);
        counterClockwise = addTable(0x09000102, 0x03000102, -90.0);
    }

    std::uint32_t addTable(std::uint32_t id, std::uint32_t animationId, double swing) {
        return addSwingTable(hut.source, id, animationId, swing);
    }

    /// A door whose hinge is at a block-local position, with its leaf along +y.
    [[nodiscard]] world::PlacedEntry door(std::uint64_t id, const Vec3& hinge, std::uint32_t table) const {
        world::PlacedEntry entry;
        entry.kind = world::PlacedEntry::Kind::Door;
        entry.id = id;
        entry.name = "door " + std::to_string(id);
        entry.model = setup;
        entry.motionTable = table;
        entry.block = hut.source.home();
        entry.position = hut.at(hinge);
        return entry;
    }
    /// Something that stands still.
    [[nodiscard]] world::PlacedEntry thing(std::uint64_t id, std::uint32_t model, dat::RecordId cell,
                                           const Vec3& at) const {
        world::PlacedEntry entry = door(id, at, 0);
        entry.kind = world::PlacedEntry::Kind::Thing;
        entry.name = "thing " + std::to_string(id);
        entry.model = model;
        entry.cell = cell;
        return entry;
    }

    /// Moves the hut's opaque doors from world.json to the database.
    void placeDoors() {
        hut.moving.placed.push_back(door(1, {10, 11, 2}, counterClockwise)); // front
        hut.moving.placed.push_back(door(2, {14, 11, 2}, clockwise));        // inner
        std::erase_if(hut.moving.doors, [](const world::DoorEntry& entry) { return entry.opaque; });
    }
};

} // namespace limen::test
