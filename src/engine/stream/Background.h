#pragma once

#include <algorithm>
#include <chrono>
#include <future>
#include <memory>
#include <utility>
#include <vector>

namespace limen::engine {

/// Runs work on threads of its own. A caller may drop the result and need not wait for it. The destructor
/// waits for all work that is left.
class Background {
public:
    /// Starts `make` on a new thread and returns the future of its result. Unlike a future of std::async,
    /// this one does not block when it is destroyed.
    template <class Make>
    [[nodiscard]] auto run(Make make) -> std::future<decltype(make())> {
        std::erase_if(runs_, [](const std::future<void>& run) { return isReady(run); });
        std::packaged_task<decltype(make())()> task(std::move(make));
        auto made = task.get_future();
        runs_.push_back(std::async(std::launch::async, [task = std::move(task)]() mutable { task(); }));
        return made;
    }

    /// Releases an object on another thread, then calls `after` there: the destructors of a part of the world take too
    /// long for one frame.
    template <class T, class After>
    void discard(std::shared_ptr<T> thing, After after) {
        if (thing == nullptr)
            return;
        static_cast<void>(run([thing = std::move(thing), after = std::move(after)]() mutable {
            thing.reset();
            after();
        }));
    }
    template <class T>
    void discard(std::shared_ptr<T> thing) {
        discard(std::move(thing), [] {});
    }

    template <class T>
    [[nodiscard]] static bool isReady(const std::future<T>& made) {
        return made.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    }

private:
    std::vector<std::future<void>> runs_;
};

} // namespace limen::engine
