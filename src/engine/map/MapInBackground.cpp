#include "engine/map/MapInBackground.h"

#include "engine/map/MapPainter.h"

#include <chrono>

namespace limen::engine {

MapInBackground::MapInBackground(std::shared_ptr<const WorldSource> source)
    : work_(std::async(std::launch::async, [this, source = std::move(source)] {
          paint(*source);
          isDone_ = true;
      })) {}

MapInBackground::~MapInBackground() {
    isStopped_ = true;
    work_.wait();
}

std::shared_ptr<const LandscapeMap> MapInBackground::since(std::uint64_t& revision) const {
    const std::lock_guard lock(mutex_);
    if (revision == revision_)
        return nullptr;
    revision = revision_;
    return map_;
}

std::string MapInBackground::failure() const {
    const std::lock_guard lock(mutex_);
    return failure_;
}

void MapInBackground::publish(std::shared_ptr<const LandscapeMap> map) {
    const std::lock_guard lock(mutex_);
    map_ = std::move(map);
    ++revision_;
}

void MapInBackground::paint(const WorldSource& source) {
    using Clock = std::chrono::steady_clock;
    constexpr std::size_t kStep = 64;                         ///< blocks
    constexpr auto kBetween = std::chrono::milliseconds(300); ///< between partial maps, which are copies
    Result<MapPainter> painter = MapPainter::begin(source.archive);
    if (!painter) {
        const std::lock_guard lock(mutex_);
        failure_ = painter.error().message();
        return;
    }
    Clock::time_point published = Clock::now();
    while (!painter->isDone() && !isStopped_) {
        painter->paint(kStep);
        progress_ = static_cast<double>(painter->painted()) /
                    static_cast<double>(std::max<std::size_t>(painter->map().blocks.size(), 1));
        if (Clock::now() - published > kBetween && !painter->isDone()) {
            publish(std::make_shared<const LandscapeMap>(painter->map()));
            published = Clock::now();
        }
    }
    publish(std::make_shared<const LandscapeMap>(painter->takeMap()));
}

} // namespace limen::engine
