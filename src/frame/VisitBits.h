#pragma once

#include "frame/FramePlan.h"

#include <vector>

namespace limen::frame {

/// The visits of a plan by their zones: bit v of a zone is set if visit v is to it. So the ownership test of a fast draw reads no
/// list of members. Reuse it: steady frames allocate nothing.
class VisitBits {
public:
    /// Whether the visits of a plan have bits; else draws have lists of members.
    [[nodiscard]] static bool suffice(const FramePlan& plan) {
        return plan.constants.visitCount <= gpu::kMostVisitBits;
    }

    /// Requires that bits suffice.
    void prepare(const FramePlan& plan);
    [[nodiscard]] std::uint64_t of(std::uint32_t zone) const { return zone < bits_.size() ? bits_[zone] : 0; }

private:
    std::vector<std::uint64_t> bits_;  ///< by zone; 0 but for those of `zones_`
    std::vector<std::uint32_t> zones_; ///< of the plan's visits
};

} // namespace limen::frame
