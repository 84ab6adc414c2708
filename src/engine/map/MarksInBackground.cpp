#include "engine/map/MarksInBackground.h"

#include <chrono>

namespace limen::engine {
namespace {

std::unique_ptr<const MarksInBackground::Marks> readMarks(const WorldSource& source,
                                                          const std::vector<placements::TemplateType>& types,
                                                          const std::atomic<bool>& isStopped) {
    auto marks = std::make_unique<MarksInBackground::Marks>(types.size());
    for (std::size_t i = 0; i < types.size() && source.placed != nullptr; ++i)
        if (const Result<std::vector<Vec3>> at =
                source.placed->positionsOf(types[i], [&] { return !isStopped; }))
            (*marks)[i].assign(at->begin(), at->end());
    return marks;
}

} // namespace

MarksInBackground::MarksInBackground(std::shared_ptr<const WorldSource> source,
                                     std::vector<placements::TemplateType> types)
    : work_(std::async(std::launch::async, [this, source = std::move(source), types = std::move(types)] {
          return readMarks(*source, types, isStopped_);
      })) {}

MarksInBackground::~MarksInBackground() {
    isStopped_ = true;
    if (work_.valid())
        work_.wait();
}

std::unique_ptr<const MarksInBackground::Marks> MarksInBackground::take() {
    if (!work_.valid() || work_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return nullptr;
    return work_.get();
}

} // namespace limen::engine
