#pragma once

#include "world/MovingEntries.h"
#include "world/assemble/Cycles.h"
#include "world/assemble/JoiningBlock.h"
#include "world/assemble/ParticleStyleAssembler.h"
#include "world/records/EmitterStarts.h"

namespace limen::world {

/// Adds the particle sources that scripts and animation hooks start to a World: on objects, on villagers, and
/// in the sky.
class ParticleAssembler {
public:
    ParticleAssembler(Records& records, ParticleStyleAssembler& styles, Cycles& cycles, World& world)
        : records_(records), styles_(styles), cycles_(cycles), world_(world), starts_(records) {}

    /// `idle`: the object's index in World::idleObjects; kNone if it is static.
    void addToObject(const PlacedModel& object, std::uint32_t idle, const ObjectSite& site);
    /// `villager`: index into World::villagers. `play`: the script that world.json starts on it.
    void addToVillager(std::uint32_t villager, dat::RecordId model, const PlayEntry& play);
    /// The scripts of sky objects, which run at the eye. A sky object without a script that is a Setup has
    /// its default script. docs/formats/sky_weather.md#sky-objects.
    void addWeather(const dat::SkyDesc& sky);

private:
    void addWeather(std::uint32_t dayGroup, std::uint32_t number, const dat::SkyObject& object);
    /// `source` completed with the values of its start and its style; nothing if it can show no particle.
    [[nodiscard]] std::optional<ParticleSource> sourceOf(const EmitterStart& start, const dat::Setup& setup,
                                                         ParticleSource source);
    /// The starts of a Setup's default script and of the hooks of its cycles.
    [[nodiscard]] std::vector<EmitterStart>
    startsOf(const dat::Setup& setup, std::span<const std::uint32_t> cycles, std::uint64_t seed);

    /// Adds the starts of the script of a table that plays from the start, if there is one.
    void addPlayed(const PlayEntry& play, dat::RecordId tableId, const dat::Setup& setup, std::uint64_t seed,
                   std::vector<EmitterStart>& starts);

    Records& records_;
    ParticleStyleAssembler& styles_;
    Cycles& cycles_;
    World& world_;
    EmitterStarts starts_;
};

} // namespace limen::world
