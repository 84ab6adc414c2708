#pragma once

#include <algorithm>
#include <chrono>
#include <future>
#include <memory>
#include <utility>
#include <vector>

namespace limen::engine {

/// Work on threads of its own that nobody has to wait for: what comes of it may be left to itself. Waits for all of it when it goes.
class Background {
public:
    /// Yields what comes of it. A result that is dropped waits for nothing.
    template <class Make>
    [[nodiscard]] auto run(Make make) -> std::future<decltype(make())> {
        std::erase_if(runs_, [](const std::future<void>& run) { return isReady(run); });
        std::packaged_task<decltype(make())()> task(std::move(make));
        auto made = task.get_future();
        runs_.push_back(std::async(std::launch::async, [task = std::move(task)]() mutable { task(); }));
        return made;
    }

    /// Lets something go on another thread, because taking it apart takes a while.
    template <class T>
    void discard(std::shared_ptr<T> thing) {
        if (thing != nullptr)
            static_cast<void>(run([thing = std::move(thing)]() mutable { thing.reset(); }));
    }

    template <class T>
    [[nodiscard]] static bool isReady(const std::future<T>& made) {
        return made.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    }

private:
    std::vector<std::future<void>> runs_;
};

} // namespace limen::engine
