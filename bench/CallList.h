#pragma once

#include "frame/FramePlan.h"

#include <cstdint>
#include <map>
#include <vector>

namespace limen::bench {

/// GL calls of many frames, by the stages and batches of their plans: frames with the same ones should make as many calls,
/// whatever is in them.
class CallList {
public:
    void add(const frame::FramePlan& plan, std::uint32_t calls);

    [[nodiscard]] std::uint32_t most() const; ///< 0 without frames
    /// Whether frames with the same stages and batches all made the same number of calls.
    [[nodiscard]] bool isOneForEachList() const { return same_; }
    [[nodiscard]] std::size_t lists() const { return calls_.size(); } ///< that differ
    [[nodiscard]] const std::vector<std::uint32_t>& frames() const { return frames_; }
    [[nodiscard]] std::uint64_t hash() const; ///< of every frame's number, in order

private:
    std::map<std::vector<std::uint32_t>, std::uint32_t> calls_; ///< by list
    std::vector<std::uint32_t> frames_;
    bool same_ = true;
};

} // namespace limen::bench
