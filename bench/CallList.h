#pragma once

#include "frame/FramePlan.h"

#include <cstdint>
#include <map>
#include <vector>

namespace limen::bench {

/// Counts the GL calls of many frames by the stages and batches of their plans. Frames with equal stages and
/// batches must make the same number of calls, no matter how many objects they draw.
class CallList {
public:
    void add(const frame::FramePlan& plan, std::uint32_t calls);

    [[nodiscard]] std::uint32_t most() const; ///< 0 without frames
    /// Whether frames with the same stages and batches all made the same number of calls.
    [[nodiscard]] bool isOneForEachList() const { return same_; }
    [[nodiscard]] std::size_t lists() const {
        return calls_.size();
    } ///< number of different stage and batch lists
    [[nodiscard]] const std::vector<std::uint32_t>& frames() const { return frames_; }
    [[nodiscard]] std::uint64_t hash() const; ///< of all frames' numbers of calls, in order

private:
    std::map<std::vector<std::uint32_t>, std::uint32_t> calls_; ///< number of calls, by stage and batch list
    std::vector<std::uint32_t> frames_;
    bool same_ = true;
};

} // namespace limen::bench
