#include "cli/OpenWorld.h"

#include <optional>

namespace limen::cli {
namespace {

/// The line, until the first step of a search; then the bar.
class OpeningLine {
public:
    OpeningLine(const Console& console, std::string title)
        : console_(console), waiting_(std::in_place, console, std::move(title)) {}

    [[nodiscard]] engine::SearchProgress search() {
        return [this](std::size_t done, std::size_t all) {
            waiting_.reset();
            if (!bar_)
                bar_.emplace(console_, "searching for places", all);
            bar_->step(done);
            return true;
        };
    }

private:
    const Console& console_;
    std::optional<Waiting> waiting_;
    std::optional<Progress> bar_;
};

} // namespace

Result<engine::WorldSource> openWorld(const Console& console, const std::string& dat,
                                      engine::PlaceSearch search) {
    OpeningLine line(console, dat.empty() ? "writing and opening the built-in world" : "opening the files");
    return engine::openWorldSource(dat, search, line.search());
}

Result<std::vector<world::Place>> tourOf(const Console& console, const engine::WorldSource& source) {
    OpeningLine line(console, "searching for a tour");
    return engine::tourOf(source, line.search());
}

} // namespace limen::cli
