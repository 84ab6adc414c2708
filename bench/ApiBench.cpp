#include "ApiBench.h"

#include "api/FloodWays.h"

namespace limen::bench {
namespace {

constexpr std::uint32_t kHouseSide = 16, kHouseSeed = 1;
constexpr std::size_t kHouseEyes = 1000;
constexpr int kApiRepeats = 31;
constexpr double kMostThroughC = 1.0, kMostThroughPython = 10.0; // microseconds more than in C++
constexpr const char* kHouseScene = "16 x 16 rooms, a zone each";

double perEye(double seconds) {
    return seconds * 1e6 / static_cast<double>(kHouseEyes);
}

BenchRow apiRow(const char* name, const FloodTimes& times) {
    BenchRow row{name, kHouseScene, perEye(times.samples.quantile(0.5)), perEye(times.samples.quantile(0.95)),
                 "us"};
    row.allocations = times.samples.allocations;
    row.hash = times.hash;
    return row;
}

/// The row of one way, and its difference from C++.
void addApiRows(const std::string& name, const Result<std::optional<FloodTimes>>& times, const BenchRow& cpp,
                double most, std::vector<BenchRow>& rows) {
    if (!times) {
        rows.push_back(failedRow(name, std::string(kHouseScene) + ": " + times.error().message(), "us"));
        return;
    }
    BenchRow more{name + "/more", kHouseScene, kNotMeasured, kNotMeasured, "us"};
    if (*times) {
        const BenchRow row = apiRow(name.c_str(), **times);
        if (row.hash != cpp.hash) {
            rows.push_back(failedRow(name, std::string(kHouseScene) + ": another result than in C++", "us"));
            return;
        }
        rows.push_back(row);
        more.value = row.value - cpp.value;
        more.p95 = row.p95 - cpp.value;
        more.hash = row.hash;
        more.hasTarget = true;
        more.target = most;
    }
    rows.push_back(more);
}

} // namespace

std::vector<BenchRow> benchApi(AllocationCounter counter) {
    const House house = gridHouse(kHouseSide, kHouseEyes, kHouseSeed);
    std::vector<BenchRow> rows{apiRow("api/c++", floodThroughCpp(house, kApiRepeats, counter))};
    const BenchRow cpp = rows.front();
    addApiRows("api/c", floodThroughC(house, kApiRepeats, counter).map([](FloodTimes&& times) {
        return std::optional(std::move(times));
    }),
               cpp, kMostThroughC, rows);
    addApiRows("api/python", floodThroughPython(house, kApiRepeats), cpp, kMostThroughPython, rows);
    return rows;
}

} // namespace limen::bench
