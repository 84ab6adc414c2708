#pragma once

#include "check/Run.h"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

namespace limen::check {

/// A drawn view that waits to be traced.
struct DrawnView {
    View view;
    reference::Camera camera;
    DrawnImages images;
    world::Moment moment;    ///< of the picture
    std::uint64_t moved = 0; ///< pixels that a second picture of it had otherwise
    double seconds = 0.0;    ///< that drawing took
};

/// Traces and judges drawn views of one loaded world on a thread of its own, in the order they come.
class Judging {
public:
    /// `progress` is written to under this object's lock until it is destroyed.
    Judging(TracedWorld& traced, unsigned threads, IdColour idColour, const RunEvents& events,
            Progress& progress);
    /// Judges what still waits.
    ~Judging();
    Judging(const Judging&) = delete;
    Judging& operator=(const Judging&) = delete;

    /// Hands a view over; waits while very many wait already.
    void add(DrawnView view);
    /// Waits until all are judged. Errors: what writing a picture met.
    [[nodiscard]] Result<void> finish();
    /// A copy of the progress so far.
    [[nodiscard]] Progress progress() const;

private:
    void work();
    void judge(const DrawnView& view);
    void judgeSamples(const DrawnView& view, Retracer& retracer);

    TracedWorld& traced_;
    const unsigned threads_;
    const IdColour idColour_; // of multisampled pictures
    const RunEvents& events_;
    mutable std::mutex lock_;
    std::condition_variable changed_;
    Progress& progress_;                      // under lock_
    std::deque<DrawnView> waiting_;           // under lock_
    std::size_t waitingPixels_ = 0;           // of waiting_, under lock_
    bool busy_ = false, ending_ = false;      // under lock_
    Result<void> failure_;                    // under lock_
    reference::Picture picture_;              // the thread's
    std::vector<reference::Picture> sampled_; // the thread's, by sample
    Comparison comparison_;                   // the thread's
    std::thread thread_;                      // last: starts when the rest is there
};

} // namespace limen::check
