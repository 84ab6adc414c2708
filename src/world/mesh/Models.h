#pragma once

#include "world/mesh/MeshData.h"
#include "world/records/Clothing.h"
#include "world/records/Records.h"

#include <compare>
#include <limits>
#include <optional>

namespace limen::world {

/// A GfxObj as a baked mesh in its own space: no corner is within an edge of another polygon.
struct PartMesh {
    dat::RecordId gfxObj = 0;
    MeshData mesh;
    std::vector<dat::RecordId> surfaces; ///< by slot
    std::vector<bool> clamp;             ///< by slot: false if its picture repeats
};

/// Distances at which a level of detail is drawn, metres at scale 1.
struct LevelBand {
    double from = 0.0, upTo = std::numeric_limits<double>::infinity();
    friend bool operator==(const LevelBand&, const LevelBand&) = default;
};
/// The band of a part whose scale has this z.
[[nodiscard]] LevelRange levelRangeOf(const LevelBand& band, double scaleZ);

/// Shifts of the distances at which levels of detail change.
struct LevelLimits {
    double detail = 1.0; ///< factor; infinite: the nearest level at every distance
    double bias = 1.0;   ///< Readings::levelBias
    auto operator<=>(const LevelLimits&) const = default;
};

/// One part of a model in its pose.
struct ModelPart {
    dat::RecordId gfxObj = 0;
    Mat3 linear{1.0}; ///< object space from part space: rotation and scale
    Vec3 origin{0.0}; ///< object space, metres
    LevelBand band;
    Facing facing = Facing::Fixed;
    std::uint32_t part = 0; ///< index in the Setup; levels of detail of one part share it
    Vec3 scale{1.0};        ///< the scale in `linear`
    /// Of a part of a held thing: its number in Dress::held. `part` is then an index in the Setup of the thing, and the part
    /// follows `posedBy` of the holder, at `grip` within its frame.
    std::uint32_t held = kNone;
    std::uint32_t posedBy = kNone;
    Pose grip;
};
/// The dress of a part: the model's own, or that of the held thing that it belongs to.
[[nodiscard]] const Dress& dressOf(const ModelPart& part, const Dress& dress);

struct ModelLight {
    Vec3 position{0.0}; ///< object space
    Vec3f colour{1.0f}; ///< 0..1
    float intensity = 1.0f;
    float falloff = 0.0f; ///< metres
};

/// A GfxObj or a Setup in its resting pose (docs/formats/geometry.md#setup).
struct Model {
    std::vector<ModelPart> parts;   ///< nearest levels of detail
    std::vector<ModelPart> farther; ///< levels of detail that replace some of them farther away
    std::vector<ModelLight> lights;
    Sphere bounds; ///< object space at scale 1, of the vertices of all levels, in every turn of billboards
};

struct ModelCache;

/// Reads models, each once. References are valid as long as the object. Not thread-safe: one object per
/// thread.
class Models {
public:
    /// `cache`: null, or a cache of the same archive, which outlives the object.
    explicit Models(Records& records, const LevelLimits& limits = {}, ModelCache* cache = nullptr)
        : records_(records), limits_(limits), cache_(cache) {}

    [[nodiscard]] const Model& model(dat::RecordId id);
    /// The model with the meshes of some of its parts replaced, and with the things that it holds. Cost: reads the model anew
    /// in each call.
    [[nodiscard]] Model dressed(dat::RecordId id, const Dress& dress) { return read(id, &dress); }
    /// The distances from an emitter at which its particles are drawn: up to the greatest distance of the
    /// mesh's second-last level, or of its only one; 100 m without levels.
    [[nodiscard]] LevelBand particleBand(dat::RecordId gfxObj);
    /// Null if the record is missing or damaged.
    [[nodiscard]] const PartMesh* part(dat::RecordId gfxObj);

private:
    [[nodiscard]] Model read(dat::RecordId id, const Dress* dress);
    struct Level {
        dat::RecordId gfxObj = 0;
        LevelBand band;
        Facing facing = Facing::Fixed;
    };
    /// The levels of detail of a GfxObj, the nearest first, without gaps from 0 to infinity. GfxObj 0 is an
    /// empty level; markers for editors have only that.
    [[nodiscard]] std::vector<Level> levelsOf(dat::RecordId gfxObj);
    /// Adds all levels of detail of `posed`.
    void addPart(Model& model, const ModelPart& posed);
    /// Adds the parts of a thing in the resting pose of its holder.
    void addHeld(Model& model, const dat::Setup& holder, const HeldThing& thing, std::uint32_t number);
    [[nodiscard]] Sphere boundsOf(const Model& model);
    [[nodiscard]] std::optional<PartMesh> build(dat::RecordId gfxObj);

    Records& records_;
    LevelLimits limits_;
    ModelCache* cache_;
    std::unordered_map<dat::RecordId, std::shared_ptr<const Found<Model>>> models_;
    std::unordered_map<dat::RecordId, std::shared_ptr<const Found<std::optional<PartMesh>>>> parts_;
};

/// How the nearest level of detail of a GfxObj turns to the eye.
[[nodiscard]] Facing facingOf(dat::RecordId gfxObj, Records& records);

/// The index list of each surface slot; a missing Surface counts as opaque.
[[nodiscard]] std::vector<SurfaceList> listsOf(std::span<const dat::RecordId> surfaces, Records& records);

} // namespace limen::world
