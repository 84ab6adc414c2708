#include "SceneBuilder.h"

namespace limen::gpu::test {
namespace {

constexpr std::uint32_t kNormalSouth = (0x3FFu & static_cast<std::uint32_t>(-511)) << 10;

layout::ClipSet keepAll() {
    layout::ClipSet set;
    for (glm::vec4& plane : set.planes)
        plane = {0, 0, 0, 1};
    return set;
}

} // namespace

SceneBuilder::SceneBuilder() {
    layout::ViewConstants& c = plan.constants;
    c.clipFromEye = glm::mat4(1, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, kNearPlane, 0);
    c.nearPlane = kNearPlane;
    c.sunDirection = {0, -1, 0, 0};
    c.fogRange = {1e9f, 2e9f, 0, 0};
    c.voidColour = {1, 0, 1, 1};
    plan.blocks.push_back({0, 0, 0, 0});
    plan.clipSets.push_back(keepAll());
    c.landAmbient = c.skyAmbient = {1, 1, 1, 0};
    upload.lightSets.emplace_back();
    addMaterial({1, 1, 1, 1});
}

std::uint32_t SceneBuilder::addMaterial(const glm::vec4& colour, std::uint32_t texture, std::uint32_t flags) {
    layout::Material material;
    material.colour = colour;
    material.texture = texture;
    material.flags = flags;
    upload.materials.push_back(material);
    return static_cast<std::uint32_t>(upload.materials.size() - 1);
}

std::uint32_t SceneBuilder::addTexture(std::uint32_t width, std::uint32_t height,
                                       std::vector<std::uint8_t> rgba, bool clamp) {
    pixels_.push_back(std::move(rgba));
    upload.textures.push_back({width, height, pixels_.back(), clamp});
    return static_cast<std::uint32_t>(upload.textures.size() - 1);
}

std::uint32_t SceneBuilder::addQuad(std::uint32_t id, const std::array<glm::vec3, 4>& corners,
                                    const QuadOptions& options) {
    return addQuads(id, {&corners, 1}, options);
}

std::uint32_t SceneBuilder::addQuads(std::uint32_t id, std::span<const std::array<glm::vec3, 4>> quads,
                                     const QuadOptions& options) {
    layout::Instance instance;
    const auto& rows = options.rows;
    instance.pose0 = {rows[0].x, rows[1].x, rows[2].x, rows[0].y};
    instance.pose1 = {rows[1].y, rows[2].y, rows[0].z, rows[1].z};
    instance.pose2 = {rows[2].z, rows[0].w, rows[1].w, rows[2].w};
    instance.block = options.block;
    instance.idBase = id;
    instance.highlight = options.highlight;
    instance.level = layout::kFromAnywhere;
    instance.opacity = 1.0f;
    instance.firstMember = static_cast<std::uint32_t>(upload.members.size());
    instance.membersAndKind = static_cast<std::uint32_t>(options.members.size());
    upload.members.insert(upload.members.end(), options.members.begin(), options.members.end());
    if (options.program == frame::Program::Terrain) {
        instance.firstMaterial = options.material;
    } else {
        instance.firstMaterial = static_cast<std::uint32_t>(upload.materialRefs.size());
        upload.materialRefs.push_back(options.material);
    }
    const auto firstIndex = static_cast<std::uint32_t>(upload.indices.size());
    for (std::uint32_t polygon = 0; polygon < quads.size(); ++polygon) {
        const std::array<glm::vec3, 4>& corners = quads[polygon];
        const glm::vec3 facet =
            glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0])); // quads are flat
        for (const std::size_t i : {0u, 1u, 2u, 0u, 2u, 3u}) {
            upload.indices.push_back(static_cast<std::uint32_t>(upload.vertices.size()));
            upload.vertices.push_back({corners[i], kNormalSouth, options.uv[i], polygon, facet});
        }
    }
    const auto index = static_cast<std::uint32_t>(upload.instances.size());
    upload.instances.push_back(instance);
    const auto triangles = static_cast<std::uint32_t>(2 * quads.size());
    upload.pieces.push_back({firstIndex, triangles, index, firstIndex});
    drawAgain(index, options.program, options.gated);
    draws_[options.program].back().turn = options.turn;
    return index;
}

std::uint32_t SceneBuilder::addWall(std::uint32_t id, glm::vec2 min, glm::vec2 max, float y,
                                    const QuadOptions& options) {
    return addQuad(id, {glm::vec3{min.x, y, min.y}, {max.x, y, min.y}, {max.x, y, max.y}, {min.x, y, max.y}},
                   options);
}

void SceneBuilder::addWallWithOpening(std::uint32_t id, float outer, float half, float y,
                                      const QuadOptions& options) {
    addWall(id, {-outer, -outer}, {-half, outer}, y, options);
    addWall(id, {half, -outer}, {outer, outer}, y, options);
    addWall(id, {-half, -outer}, {half, -half}, y, options);
    addWall(id, {-half, half}, {half, outer}, y, options);
}

layout::SkyInstance& SceneBuilder::addSky(glm::vec2 min, glm::vec2 max, float y, std::uint32_t material,
                                          float opacity) {
    const std::uint32_t piece = addWall(0, min, max, y, {.material = material});
    draws_[frame::Program::Opaque].pop_back();
    sky_.emplace_back(piece, static_cast<std::uint32_t>(plan.skyInstances.size()));
    layout::SkyInstance object;
    object.row0 = {1, 0, 0, 0};
    object.row1 = {0, 1, 0, 0};
    object.row2 = {0, 0, 1, 0};
    object.firstMaterial = upload.instances.back().firstMaterial;
    object.opacity = opacity;
    object.luminosity = 1.0f;
    plan.skyInstances.push_back(object);
    return plan.skyInstances.back();
}

void SceneBuilder::drawAgain(std::uint32_t instance, frame::Program program, bool gated) {
    draws_[program].push_back({instance, gated, frame::Turn::After});
}

void SceneBuilder::root(std::uint32_t zone) {
    layout::Visit visit;
    visit.entryPlane = {0, 0, 0, 1};
    visit.zone = zone;
    visit.parent = layout::kNoVisit;
    plan.visits.push_back(visit);
    plan.constants.rootZone = zone;
}

std::uint32_t SceneBuilder::visitThrough(glm::vec2 min, glm::vec2 max, float y, std::uint32_t zone,
                                         std::uint32_t parent, std::uint32_t clipSet) {
    const auto number = static_cast<std::uint32_t>(plan.visits.size());
    layout::Visit visit;
    visit.entryPlane = {0, 1, 0, -(y - plan.constants.eyeHigh.y)};
    visit.zone = zone;
    visit.parent = parent;
    plan.visits.push_back(visit);
    const std::array<glm::vec3, 4> corners{
        glm::vec3{min.x, y, min.y}, {max.x, y, min.y}, {max.x, y, max.y}, {min.x, y, max.y}};
    addOpening(corners, number, clipSet);
    return number;
}

void SceneBuilder::addOpening(std::span<const glm::vec3> corners, std::uint32_t visit,
                              std::uint32_t clipSet) {
    layout::OwnershipVertex vertex;
    vertex.visit = visit;
    vertex.clipSet = clipSet;
    vertex.outlineFirst = static_cast<std::uint32_t>(plan.ownershipVertices.size());
    vertex.outlineCount = static_cast<std::uint32_t>(corners.size());
    glm::vec3 middle(0.0f);
    for (const glm::vec3& corner : corners)
        middle += corner / static_cast<float>(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        for (const glm::vec3& position : {middle, corners[i], corners[(i + 1) % corners.size()]}) {
            vertex.position = position;
            plan.ownershipVertices.push_back(vertex);
        }
    }
}

// Like a planner: one run for consecutive pieces.
void SceneBuilder::addBatch(frame::Program program, bool evenEmpty) {
    const auto& draws = draws_[program];
    if (draws.empty() && !evenEmpty)
        return;
    bool gated = plan.visits.size() > 1;
    for (const Drawn& drawn : draws)
        gated = gated || drawn.gated;
    frame::Batch batch{program, gated, static_cast<std::uint32_t>(plan.runs.size()), 0,
                       static_cast<std::uint32_t>(draws.size())};
    for (const auto& [number, isGated, turn] : draws) {
        const layout::DrawPiece& piece = upload.pieces[number];
        if (batch.count > 0 && plan.runs.back().firstPiece + plan.runs.back().pieceCount == number &&
            plan.runs.back().gated == isGated && plan.runs.back().turn == turn) {
            ++plan.runs.back().pieceCount;
            plan.runs.back().indexCount += 3 * piece.triangles;
        } else {
            plan.runs.push_back({number, 1, piece.indicesBefore, 3 * piece.triangles, isGated, {}, turn});
            ++batch.count;
        }
    }
    plan.batches.push_back(batch);
}

void SceneBuilder::addSkyBatch(bool evenEmpty) {
    if (sky_.empty() && !evenEmpty)
        return;
    frame::Batch batch{frame::Program::SkyObjects, plan.visits.size() > 1,
                       static_cast<std::uint32_t>(plan.runs.size()), 0, 0};
    std::uint32_t before = 0;
    for (const auto& [number, object] : sky_) {
        layout::DrawPiece piece = upload.pieces[number];
        plan.runs.push_back(
            {plan.constants.staticPieces + batch.draws, 1, before, 3 * piece.triangles, false});
        plan.pieces.push_back({piece.firstIndex, piece.triangles | layout::kNeverCulled, object, before});
        before += 3 * piece.triangles;
        ++batch.draws;
        ++batch.count;
    }
    plan.batches.push_back(batch);
}

const frame::FramePlan& SceneBuilder::finish(bool allBatches) {
    using frame::Program;
    plan.constants.visitCount = static_cast<std::uint32_t>(plan.visits.size());
    plan.constants.staticInstances = static_cast<std::uint32_t>(upload.instances.size());
    plan.constants.staticMembers = static_cast<std::uint32_t>(upload.members.size());
    plan.constants.staticPieces = static_cast<std::uint32_t>(upload.pieces.size());
    plan.pieces.clear();
    plan.runs.clear();
    plan.batches.clear();
    plan.stages.clear();
    const auto stage = [&](frame::StageKind kind, std::size_t firstBatch) {
        plan.stages.push_back({kind, static_cast<std::uint32_t>(firstBatch),
                               static_cast<std::uint32_t>(plan.batches.size() - firstBatch)});
    };
    const auto vertices = static_cast<std::uint32_t>(plan.ownershipVertices.size());
    plan.batches.push_back({Program::Ownership, false, 0, vertices, vertices > 0 ? 1u : 0u});
    stage(frame::StageKind::Ownership, 0);
    std::size_t first = plan.batches.size();
    addBatch(Program::Terrain, allBatches);
    plan.firstOccludee = static_cast<std::uint32_t>(plan.batches.size());
    addBatch(Program::Opaque, allBatches);
    addBatch(Program::CutOut, allBatches);
    stage(frame::StageKind::Solid, first);
    first = plan.batches.size();
    plan.batches.push_back({Program::SkyPlain, plan.constants.visitCount > 1, 0, 0, 1});
    addSkyBatch(allBatches);
    stage(frame::StageKind::Sky, first);
    first = plan.batches.size();
    addBatch(Program::Blended, allBatches);
    stage(frame::StageKind::Transparent, first);
    stage(frame::StageKind::Overlay, plan.batches.size());
    return plan;
}

const frame::FramePlan& SceneBuilder::finishRootFirst() {
    finish(true);
    frame::Stage& solid = plan.stages[static_cast<std::size_t>(frame::StageKind::Solid)];
    const auto first = plan.batches.begin() + solid.firstBatch; // ground, opaque, cut-outs
    frame::Batch ground = first[0], meshes = first[2];
    for (frame::Batch& batch : std::span(&*first, 3)) {
        batch.gated = false;
        batch.turn = frame::Turn::Before;
    }
    meshes.first = first[1].first;
    meshes.count += first[1].count;
    meshes.draws += first[1].draws;
    ground.gated = meshes.gated = true;
    ground.turn = meshes.turn = frame::Turn::After;
    const frame::Batch clearing{frame::Program::Clearing, false,
                                static_cast<std::uint32_t>(plan.rects.size()), 1, 1};
    plan.rects.emplace_back(-1, -1, 1, 1);
    plan.batches.insert(first + 3, {clearing, meshes, ground});
    solid.batchCount += 3;
    for (std::size_t i = static_cast<std::size_t>(frame::StageKind::Solid) + 1; i < plan.stages.size(); ++i)
        plan.stages[i].firstBatch += 3;
    plan.constants.flags |= layout::kFrameRootFirst;
    return plan;
}

std::vector<std::string> picture(const std::vector<std::uint32_t>& ids, std::size_t width) {
    std::vector<std::string> rows;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        if (i % width == 0)
            rows.emplace_back();
        rows.back() += ids[i] == layout::kVoidId  ? '.'
                       : ids[i] == layout::kSkyId ? '~'
                                                  : static_cast<char>(ids[i]);
    }
    return rows;
}

} // namespace limen::gpu::test
