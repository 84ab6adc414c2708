#pragma once

#include "frame/FramePlan.h"
#include "frame/SceneUpload.h"
#include "frame/VisitBits.h"
#include "geometry/Vec.h"

#include <span>
#include <vector>

namespace limen::frame {

/// The static arrays that draw records are made from: copies of a SceneUpload's.
struct RecordTables {
    std::vector<gpu::DrawPiece> pieces;
    std::vector<gpu::Instance> instances;
    std::vector<gpu::Member> members;
    std::vector<gpu::Level> levels;
    std::vector<gpu::LightSet> lightSets;
};
[[nodiscard]] RecordTables tablesOf(const SceneUpload& scene);

/// Makes the draw records of one plan on the CPU: placement, light and members of each drawn piece's
/// instance. For drivers that read a record once for a draw, but an array once for every vertex.
class DrawRecords {
public:
    /// `own`: the plan's instances, dynamic ones first. All must outlive it.
    DrawRecords(const RecordTables& tables, const FramePlan& plan, std::span<const gpu::Instance> own)
        : tables_(tables), plan_(plan), own_(own) {}

    /// A piece of the scene or of the plan, by its number in a run.
    [[nodiscard]] const gpu::DrawPiece& piece(std::uint32_t number) const {
        const auto fixed = static_cast<std::uint32_t>(tables_.pieces.size());
        return number < fixed ? tables_.pieces[number] : plan_.pieces[number - fixed];
    }
    /// Whether the eye is within an instance's level of detail; as cull.comp decides.
    [[nodiscard]] bool isInRange(std::uint32_t instance) const;
    /// Whether lamps or the viewer's light may light an instance.
    [[nodiscard]] bool hasLamps(std::uint32_t instance) const;
    /// The record of an instance, or of the instance that replaces it in this frame.
    [[nodiscard]] gpu::DrawRecord of(std::uint32_t instance) const;
    /// The visits to the zones that an instance belongs to.
    [[nodiscard]] std::uint64_t visitsTo(std::uint32_t instance, const VisitBits& visits) const;

private:
    /// The number of the instance that draws an instance in this frame.
    [[nodiscard]] std::uint32_t replaced(std::uint32_t instance) const;
    /// From the eye to block-local coordinates, metres.
    [[nodiscard]] Vec3 offsetOf(std::uint32_t block, const Vec3f& local) const;
    [[nodiscard]] const gpu::Instance& at(std::uint32_t instance) const {
        const auto fixed = static_cast<std::uint32_t>(tables_.instances.size());
        return instance < fixed ? tables_.instances[instance] : own_[instance - fixed];
    }
    [[nodiscard]] const gpu::Member& member(std::uint32_t number) const {
        const auto fixed = static_cast<std::uint32_t>(tables_.members.size());
        return number < fixed ? tables_.members[number] : plan_.members[number - fixed];
    }
    [[nodiscard]] gpu::Member memberThatLights(const gpu::Instance& instance) const;
    void place(const gpu::Instance& instance, gpu::DrawRecord& record) const;
    void light(std::uint32_t instance, gpu::DrawRecord& record) const;

    const RecordTables& tables_;
    const FramePlan& plan_;
    std::span<const gpu::Instance> own_;
};

} // namespace limen::frame
