#pragma once

#include "engine/WorldSource.h"

#include <atomic>
#include <future>
#include <memory>
#include <vector>

namespace limen::engine {

/// Reads the positions of all placed objects of some types on a thread of its own. The destructor stops the work and waits
/// for it, for milliseconds at most.
class MarksInBackground {
public:
    /// By type, in the order in which the types were given: points along the ground, global.
    using Marks = std::vector<std::vector<Vec2>>;

    MarksInBackground(std::shared_ptr<const WorldSource> source, std::vector<placements::TemplateType> types);
    ~MarksInBackground();
    MarksInBackground(const MarksInBackground&) = delete;
    MarksInBackground& operator=(const MarksInBackground&) = delete;

    /// The marks, once, when all are read; null before and after. Empty lists: the world has no such objects, or its database
    /// is damaged. Does not block.
    [[nodiscard]] std::unique_ptr<const Marks> take();

private:
    std::atomic<bool> isStopped_ = false;
    std::future<std::unique_ptr<const Marks>> work_; ///< last: it uses the others
};

} // namespace limen::engine
