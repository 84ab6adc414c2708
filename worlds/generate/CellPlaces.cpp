#include "worlds/generate/CellPlaces.h"

#include "worlds/records/Carve.h"

#include <fmt/format.h>

#include <algorithm>

namespace limen::worlds {

namespace {

Vec3 firstOpeningOf(const CellPlan& cell) {
    const auto opening =
        std::find_if(cell.faces.begin(), cell.faces.end(), [](const Face& face) { return face.portal; });
    return opening != cell.faces.end() ? centroidOf(opening->points) : cell.eye + Vec3(1.0, 0.0, 0.0);
}

} // namespace

void notePlaces(const PlacedCells& placed, const std::vector<CellPlan>& cells, WorldNotes& notes) {
    constexpr std::size_t kSteps = 48;
    const std::size_t step = std::max<std::size_t>(1, cells.size() / kSteps);
    const auto global = [&](const Vec3& local) {
        return blockToGlobal(placed.block, place(placed.at, local));
    };
    for (std::size_t c = 0; c < cells.size(); c += step)
        notes.addPlace(fmt::format("{}.{}", placed.name, c), global(cells[c].eye),
                       global(firstOpeningOf(cells[c])), placed.first + static_cast<dat::RecordId>(c));
}

} // namespace limen::worlds
