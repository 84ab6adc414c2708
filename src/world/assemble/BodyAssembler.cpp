#include "world/assemble/BodyAssembler.h"

#include "core/Assert.h"
#include "world/assemble/LevelEntries.h"

#include <algorithm>

namespace limen::world {

MovingBody BodyAssembler::add(dat::RecordId modelId, InstanceKind kind, std::uint64_t object,
                              const BodyOptions& options) {
    const Dress& dress = options.dress;
    const Model model = dress.changesModel() ? models_.dressed(modelId, dress) : models_.model(modelId);
    const bool isFilling = kind == InstanceKind::Filling;
    const bool nearestOnly = isFilling || options.isAlwaysNear;
    MovingBody body;
    body.firstPart = static_cast<std::uint32_t>(world_.movingParts.size());
    body.bounds = model.bounds;
    std::vector<PosedPart> posed;
    for (const ModelPart& part : partsOf(model, nearestOnly)) {
        const PartMesh* mesh = models_.part(part.gfxObj);
        if (mesh == nullptr || mesh->mesh.empty())
            continue;
        Instance instance;
        instance.kind = kind;
        instance.mesh = arena_.shared(*mesh);
        instance.linear = glm::mat3(part.linear);
        instance.origin = Vec3f(part.origin);
        instance.bounds = world_.meshes[instance.mesh].bounds;
        instance.object = object;
        instance.record = part.gfxObj;
        instance.firstMaterial = materials_.ofDressedPart(*mesh, part.part, dressOf(part, dress));
        instance.facing = isFilling ? Facing::Fixed : part.facing;
        if (!nearestOnly)
            instance.level =
                addLevel({levelRangeOf(part.band, part.scale.z * options.scale), {}, {}}, world_);
        world_.movingParts.push_back(instance);
        posed.push_back(
            {part.posedBy, part.scale, part.held != kNone, {part.grip.orientation, part.grip.origin}});
    }
    body.partCount = static_cast<std::uint32_t>(world_.movingParts.size()) - body.firstPart;
    if (!isFilling)
        addCycles(modelId, options.motionTable, posed, body);
    return body;
}

std::vector<ModelPart> BodyAssembler::partsOf(const Model& model, bool nearestOnly) {
    std::vector<ModelPart> parts = model.parts;
    if (!nearestOnly)
        parts.insert(parts.end(), model.farther.begin(), model.farther.end());
    return parts;
}

void BodyAssembler::addCycles(dat::RecordId model, dat::RecordId motionTable,
                              std::span<const PosedPart> posed, MovingBody& body) {
    LIMEN_ASSERT(posed.size() == body.partCount, "one pose for each part");
    body.cycles = cycles_.of(model, motionTable);
    if (std::all_of(body.cycles.begin(), body.cycles.end(), [](std::uint32_t c) { return c == kNone; }))
        return;
    body.firstPosed = static_cast<std::uint32_t>(world_.posedParts.size());
    world_.posedParts.insert(world_.posedParts.end(), posed.begin(), posed.end());
    body.bounds = boundsInMotion(world_, body);
}

MovingBody BodyAssembler::addBlended(const MovingBody& solid) {
    LIMEN_ASSERT(solid.firstPart + solid.partCount <= world_.movingParts.size(), "the body is in the world");
    MovingBody ghost = solid;
    ghost.firstPart = static_cast<std::uint32_t>(world_.movingParts.size());
    for (std::uint32_t p = solid.firstPart; p < solid.firstPart + solid.partCount; ++p) {
        Instance part = world_.movingParts[p];
        const PartMesh* mesh = models_.part(part.record);
        LIMEN_ASSERT(mesh != nullptr, "the solid part was made from this mesh");
        part.mesh = arena_.add(blendedMesh(mesh->mesh), contentKey(MeshSource::Ghost, part.record, p));
        part.firstMaterial = materials_.addBlended(part.firstMaterial, mesh->surfaces.size());
        world_.movingParts.push_back(part);
    }
    return ghost;
}

} // namespace limen::world
