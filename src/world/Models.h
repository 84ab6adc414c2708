#pragma once

#include "world/Clothing.h"
#include "world/MeshBuilder.h"
#include "world/PolygonSource.h"
#include "world/Records.h"

#include <optional>

namespace limen::world {

/// A GfxObj as a mesh in its own space, baked: no corner lies within an edge of another polygon.
struct PartMesh {
    dat::RecordId gfxObj = 0;
    MeshData mesh;
    std::vector<dat::RecordId> surfaces; ///< by slot
    std::vector<bool> clamp;             ///< by slot: texture coordinates stay within 0..1
};

/// One part of a model, posed: object space from part space.
struct ModelPart {
    dat::RecordId gfxObj = 0;
    Mat3 linear{1.0}; ///< rotation and scale
    Vec3 origin{0.0};
    LevelRange reach;
    std::uint32_t part = 0; ///< index in the Setup; levels of detail of one part share it
    Vec3 scale{1.0};        ///< what `linear` has of it
};

struct ModelLight {
    Vec3 position{0.0}; ///< object space
    Vec3f colour{1.0f}; ///< times intensity
    float range = 0.0f;
};

/// A GfxObj or a Setup in its resting pose (docs/formats/geometry.md#setup).
struct Model {
    std::vector<ModelPart> parts;   ///< as they are seen from nearby
    std::vector<ModelPart> farther; ///< what takes the place of some of them from farther away
    std::vector<ModelLight> lights;
    Sphere bounds; ///< object space at scale 1, of the vertices
};

class LoadCache;

/// Reads models once each. References stay valid as long as the object. One per thread.
class Models {
public:
    /// `detail`: levels of detail change at so many times the distances of their records; infinite: the nearest stays. `cache`: null, or
    /// what others have made of the same archive; it outlives the object.
    explicit Models(Records& records, double detail = 1.0, LoadCache* cache = nullptr)
        : records_(records), detail_(detail), cache_(cache) {}

    [[nodiscard]] const Model& model(dat::RecordId id);
    /// The same with the meshes of some of its parts changed. Cost: read anew each time.
    [[nodiscard]] Model dressed(dat::RecordId id, const Dress& dress) { return read(id, &dress); }
    /// Null if the record is missing or damaged.
    [[nodiscard]] const PartMesh* part(dat::RecordId gfxObj);

private:
    [[nodiscard]] Model read(dat::RecordId id, const Dress* dress);
    struct Level {
        dat::RecordId gfxObj = 0;
        LevelRange reach;
    };
    /// What of a GfxObj is seen, the nearest first: itself, others, or nothing, as of marks that only editors show.
    [[nodiscard]] std::vector<Level> levelsOf(dat::RecordId gfxObj);
    /// Adds all levels of detail of `posed`.
    void addPart(Model& model, const ModelPart& posed);
    [[nodiscard]] std::optional<PartMesh> build(dat::RecordId gfxObj);

    Records& records_;
    double detail_;
    LoadCache* cache_;
    std::unordered_map<dat::RecordId, std::shared_ptr<const Found<Model>>> models_;
    std::unordered_map<dat::RecordId, std::shared_ptr<const Found<std::optional<PartMesh>>>> parts_;
};

/// Whether what is seen of a GfxObj from nearby is a sprite that faces the eye, by its levels of detail.
[[nodiscard]] bool isSprite(dat::RecordId gfxObj, Records& records);

/// Surface classes by slot; a missing Surface counts as opaque.
[[nodiscard]] std::vector<SurfaceList> listsOf(std::span<const dat::RecordId> surfaces, Records& records);

/// A frame as unit quaternion and finite origin; a broken one becomes the identity.
struct Pose {
    Quat orientation{1.0, 0.0, 0.0, 0.0};
    Vec3 origin{0.0};
    [[nodiscard]] Vec3 apply(const Vec3& p) const { return origin + orientation * p; }
};
[[nodiscard]] Pose poseOf(const dat::Frame& frame);
/// Where a part of a Setup rests, in the object's frame; the identity for parts that no placement frame tells of.
[[nodiscard]] Pose restOf(const dat::Setup& setup, std::size_t part);

} // namespace limen::world
