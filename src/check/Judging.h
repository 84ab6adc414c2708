#pragma once

#include "check/Drawer.h"
#include "check/Run.h"

#include <condition_variable>
#include <map>
#include <mutex>
#include <thread>

namespace limen::check {

/// A drawn view, ready to be traced.
struct DrawnView {
    View view;
    reference::Camera camera;
    DrawnImages images;
    world::DynamicState dynamics; ///< of the picture
    std::uint64_t moved = 0;      ///< pixels that differ in a second picture of the view
    double seconds = 0.0;         ///< spent on drawing
};

/// Traces and judges drawn views of one loaded world on its own thread, in the order of their indices. Views
/// may come from several threads.
class Judging {
public:
    /// `first`: index of the first view. This object writes to `progress` under its lock until it is
    /// destroyed.
    Judging(TracedWorld& traced, std::size_t first, unsigned threads, IdColour idColour,
            const RunEvents& events, Progress& progress);
    /// Judges the waiting views up to the first missing one.
    ~Judging();
    Judging(const Judging&) = delete;
    Judging& operator=(const Judging&) = delete;

    /// Adds a view; blocks while too many views wait. Every index from the first on must be added once, from
    /// any thread.
    void add(std::size_t index, DrawnView view);
    /// Announces that some views will be missing, so that add() no longer blocks.
    void giveUp();
    /// Waits until all added views are judged. Call it after the last add(). Errors: of writing a picture.
    [[nodiscard]] Result<void> finish();
    /// A copy of the progress so far.
    [[nodiscard]] Progress progress() const;

private:
    void work();
    [[nodiscard]] bool isNextThere() const { return !waiting_.empty() && waiting_.begin()->first == next_; }
    void judge(const DrawnView& view);
    void judgeSamples(const DrawnView& view, Retracer& retracer);

    TracedWorld& traced_;
    const unsigned threads_;
    const IdColour idColour_; // of multisampled pictures
    const RunEvents& events_;
    mutable std::mutex lock_;
    std::condition_variable changed_;
    Progress& progress_;                       // under lock_
    std::map<std::size_t, DrawnView> waiting_; // by index, under lock_
    std::size_t waitingPixels_ = 0;            // of waiting_, under lock_
    std::size_t next_;                         // index of the next view to judge, under lock_
    bool busy_ = false, ending_ = false;       // under lock_
    bool gaveUp_ = false;                      // under lock_
    Result<void> failure_;                     // under lock_
    reference::Picture picture_;               // the thread's
    std::vector<reference::Picture> sampled_;  // the thread's, by sample
    Comparison comparison_;                    // the thread's
    std::thread thread_;                       // last: the thread uses the members above
};

} // namespace limen::check
