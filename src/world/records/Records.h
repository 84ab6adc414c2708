#pragma once

#include "dat/Archive.h"
#include "world/World.h"

#include <memory>
#include <set>
#include <unordered_map>
#include <utility>

namespace limen::world {

void note(std::vector<Finding>& findings, dat::RecordId record, std::string what);

/// A value made from records, with the findings about these records.
template <class T>
struct Found {
    T value;
    std::vector<Finding> findings;
};

[[nodiscard]] constexpr bool isGfxObj(dat::RecordId id) {
    return id >> 24 == 0x01;
}
[[nodiscard]] constexpr bool isSetup(dat::RecordId id) {
    return id >> 24 == 0x02;
}

/// Decodes records of the portal file, each once. A missing or damaged record is null, and every look-up of
/// it is reported; findings() has each report once. Pointers are valid as long as the object, except
/// environments (forgetEnvironments). Not thread-safe: one object per thread.
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

    /// Drops all environments if more than `most` are decoded, which invalidates pointers to them. They are
    /// large, and distant blocks share few of them.
    void forgetEnvironments(std::size_t most) {
        if (environments_.size() > most)
            environments_.clear();
    }

    [[nodiscard]] const dat::Archive& archive() const { return *archive_; }
    [[nodiscard]] const std::vector<Finding>& findings() const { return log_.findings; }

    /// Adds findings. Duplicates are dropped.
    void report(const Finding& finding);
    void report(const std::vector<Finding>& findings);
    /// Calls `make` and yields its value with all findings reported during the call, including those reported
    /// before it. A cache keeps both, so a cached value brings the same findings as a new one.
    template <class Make>
    [[nodiscard]] auto collect(Make&& make) -> Found<decltype(make())> {
        Log before = std::exchange(log_, {});
        Found<decltype(make())> made{make(), {}};
        made.findings = std::move(log_.findings);
        log_ = std::move(before);
        report(made.findings);
        return made;
    }

private:
    struct Log {
        std::vector<Finding> findings;                       ///< in the order of their reports
        std::set<std::pair<dat::RecordId, std::string>> all; ///< the same, for look-up
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
            report({id, faults_[id]});
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
    Log log_;
};

/// The class follows from the Surface alone, never from its texels' alpha: Alpha, InvAlpha, Additive and
/// Translucent (or a translucency above 0.0002) blend, clip maps cut out, all others are opaque.
/// docs/formats/textures.md#drawing-order-and-blending.
[[nodiscard]] SurfaceClass surfaceClassOf(const dat::Surface& surface);
/// 1 - translucency if the surface is translucent, else 1.
[[nodiscard]] float alphaOf(const dat::Surface& surface);
/// True if its material gets Material::kSplit.
[[nodiscard]] bool isSplit(const dat::Surface& surface);

} // namespace limen::world
