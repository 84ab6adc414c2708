#pragma once

#include "check/Drawer.h"
#include "check/Run.h"

#include <condition_variable>
#include <map>
#include <mutex>
#include <thread>

namespace limen::check {

/// A drawn view that waits to be traced.
struct DrawnView {
    View view;
    reference::Camera camera;
    DrawnImages images;
    world::DynamicState dynamics; ///< of the picture
    std::uint64_t moved = 0;      ///< pixels that a second picture of it had otherwise
    double seconds = 0.0;         ///< that drawing took
};

/// Traces and judges drawn views of one loaded world on a thread of its own, in the order of their indices: several may draw.
class Judging {
public:
    /// `first`: index of the first view that will come. `progress` is written to under this object's lock until it is destroyed.
    Judging(TracedWorld& traced, std::size_t first, unsigned threads, IdColour idColour,
            const RunEvents& events, Progress& progress);
    /// Judges what still waits, up to the first that is missing.
    ~Judging();
    Judging(const Judging&) = delete;
    Judging& operator=(const Judging&) = delete;

    /// Hands a view over; waits while very many wait already. Every index from the first on must come, once, from any thread.
    void add(std::size_t index, DrawnView view);
    /// Says that some will not come: nobody waits for them any more.
    void giveUp();
    /// Waits until all that came are judged; none may come any more. Errors: what writing a picture met.
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
    std::size_t next_;                         // index of the view to be judged next, under lock_
    bool busy_ = false, ending_ = false;       // under lock_
    bool gaveUp_ = false;                      // under lock_
    Result<void> failure_;                     // under lock_
    reference::Picture picture_;               // the thread's
    std::vector<reference::Picture> sampled_;  // the thread's, by sample
    Comparison comparison_;                    // the thread's
    std::thread thread_;                       // last: starts when the rest is there
};

} // namespace limen::check
