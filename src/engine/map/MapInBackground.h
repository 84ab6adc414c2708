#pragma once

#include "engine/WorldSource.h"
#include "engine/map/LandscapeMap.h"

#include <atomic>
#include <future>
#include <memory>
#include <mutex>
#include <string>

namespace limen::engine {

/// Paints the map of a world on a thread of its own. Partial maps can be taken at any time. The destructor
/// stops the work and waits for it, for milliseconds at most.
class MapInBackground {
public:
    explicit MapInBackground(std::shared_ptr<const WorldSource> source);
    ~MapInBackground();
    MapInBackground(const MapInBackground&) = delete;
    MapInBackground& operator=(const MapInBackground&) = delete;

    /// The map as painted so far, if it has changed since the revision; `revision` is then updated. Null: no
    /// change.
    [[nodiscard]] std::shared_ptr<const LandscapeMap> since(std::uint64_t& revision) const;
    /// The share of the blocks that is painted, 0..1.
    [[nodiscard]] double progress() const { return progress_; }
    [[nodiscard]] bool isDone() const { return isDone_; }
    /// The reason why there is no map; empty: none.
    [[nodiscard]] std::string failure() const;

private:
    void paint(const WorldSource& source);
    void publish(std::shared_ptr<const LandscapeMap> map);

    mutable std::mutex mutex_;
    std::shared_ptr<const LandscapeMap> map_; ///< guarded by mutex_, as are the next two
    std::uint64_t revision_ = 0;
    std::string failure_;
    std::atomic<double> progress_ = 0.0;
    std::atomic<bool> isDone_ = false, isStopped_ = false;
    std::future<void> work_; ///< last: it uses the others
};

} // namespace limen::engine
