#pragma once

#include "dat/Archive.h"
#include "world/World.h"

#include <memory>
#include <set>
#include <unordered_map>
#include <utility>

namespace limen::world {

/// Adds a finding.
void note(std::vector<Finding>& findings, dat::RecordId record, std::string what);

/// Something made from records, with what was found of these meanwhile.
template <class T>
struct Found {
    T value;
    std::vector<Finding> said;
};

/// Records of the portal file, decoded once each. A record that is missing or damaged is null, and said whenever it is asked for; the
/// findings have each thing once. Pointers stay valid as long as the object, unless
/// it is told to forget. One per thread.
class Records {
public:
    explicit Records(const dat::Archive& archive) : archive_(&archive) {}

    [[nodiscard]] const dat::GfxObj* gfxObj(dat::RecordId id) { return get(id, gfxObjs_); }
    [[nodiscard]] const dat::DegradeInfo* degradeInfo(dat::RecordId id) { return get(id, degradeInfos_); }
    [[nodiscard]] const dat::Setup* setup(dat::RecordId id) { return get(id, setups_); }
    [[nodiscard]] const dat::Animation* animation(dat::RecordId id) { return get(id, animations_); }
    [[nodiscard]] const dat::MotionTable* motionTable(dat::RecordId id) { return get(id, motionTables_); }
    [[nodiscard]] const dat::Environment* environment(dat::RecordId id) { return get(id, environments_); }
    [[nodiscard]] const dat::Scene* scene(dat::RecordId id) { return get(id, scenes_); }
    [[nodiscard]] const dat::Surface* surface(dat::RecordId id) { return get(id, surfaces_); }
    [[nodiscard]] const dat::SurfaceTexture* surfaceTexture(dat::RecordId id) {
        return get(id, surfaceTextures_);
    }
    [[nodiscard]] const dat::Palette* palette(dat::RecordId id) { return get(id, palettes_); }
    [[nodiscard]] const dat::PaletteSet* paletteSet(dat::RecordId id) { return get(id, paletteSets_); }
    [[nodiscard]] const dat::ClothingTable* clothingTable(dat::RecordId id) {
        return get(id, clothingTables_);
    }
    [[nodiscard]] const dat::ParticleEmitter* particleEmitter(dat::RecordId id) {
        return get(id, particleEmitters_);
    }
    [[nodiscard]] const dat::PhysicsScript* physicsScript(dat::RecordId id) {
        return get(id, physicsScripts_);
    }
    [[nodiscard]] const dat::PhysicsScriptTable* physicsScriptTable(dat::RecordId id) {
        return get(id, physicsScriptTables_);
    }

    /// Environments are large, and blocks far apart share few: with more than `most` decoded all of them go, and pointers to them.
    void forgetEnvironments(std::size_t most) {
        if (environments_.size() > most)
            environments_.clear();
    }

    [[nodiscard]] const dat::Archive& archive() const { return *archive_; }
    [[nodiscard]] const std::vector<Finding>& findings() const { return heard_.findings; }

    /// Adds findings, but those that are there.
    void say(const Finding& finding);
    void say(const std::vector<Finding>& findings);
    /// Makes something: yields it with what was found meanwhile, whether that had been found before or not. The findings have it, too.
    template <class Make>
    [[nodiscard]] auto listen(Make&& make) -> Found<decltype(make())> {
        Heard before = std::exchange(heard_, {});
        Found<decltype(make())> made{make(), {}};
        made.said = std::move(heard_.findings);
        heard_ = std::move(before);
        say(made.said);
        return made;
    }

private:
    /// What was said since somebody listens.
    struct Heard {
        std::vector<Finding> findings;
        std::set<std::pair<dat::RecordId, std::string>> all; ///< the same, to look them up
    };
    template <class Record>
    using Cache = std::unordered_map<dat::RecordId, std::unique_ptr<const Record>>;

    template <class Record>
    const Record* get(dat::RecordId id, Cache<Record>& cache) {
        const auto [entry, fresh] = cache.try_emplace(id);
        if (fresh) {
            if (Result<Record> record = archive_->load<Record>(id))
                entry->second = std::make_unique<const Record>(std::move(*record));
            else
                faults_[id] = record.error().message();
        }
        if (entry->second == nullptr)
            say({id, faults_[id]});
        return entry->second.get();
    }

    const dat::Archive* archive_;
    Cache<dat::GfxObj> gfxObjs_;
    Cache<dat::DegradeInfo> degradeInfos_;
    Cache<dat::Setup> setups_;
    Cache<dat::Animation> animations_;
    Cache<dat::MotionTable> motionTables_;
    Cache<dat::Environment> environments_;
    Cache<dat::Scene> scenes_;
    Cache<dat::Surface> surfaces_;
    Cache<dat::SurfaceTexture> surfaceTextures_;
    Cache<dat::Palette> palettes_;
    Cache<dat::PaletteSet> paletteSets_;
    Cache<dat::ClothingTable> clothingTables_;
    Cache<dat::ParticleEmitter> particleEmitters_;
    Cache<dat::PhysicsScript> physicsScripts_;
    Cache<dat::PhysicsScriptTable> physicsScriptTables_;
    std::unordered_map<dat::RecordId, std::string> faults_; ///< of records that are null
    Heard heard_;
};

/// The bits of a Surface that decide how it is drawn (docs/formats/textures.md#drawing-order-and-blending): Alpha, InvAlpha, Additive and
/// Translucent (or a translucency between 0 and 1) blend, clip maps cut out, everything else is opaque,
/// whatever its texels' alpha.
[[nodiscard]] SurfaceClass surfaceClassOf(const dat::Surface& surface);
/// 1 - translucency where the surface is translucent at all, else 1.
[[nodiscard]] float alphaOf(const dat::Surface& surface);
/// Of Material::kSplit.
[[nodiscard]] bool isSplit(const dat::Surface& surface);

} // namespace limen::world
