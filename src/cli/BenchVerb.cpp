#include "cli/AllocationCount.h"
#include "cli/BenchTable.h"
#include "cli/Verbs.h"

#include "CallsBench.h"
#include "DatBench.h"
#include "DispatchBench.h"
#include "FloodBench.h"
#include "FrameBench.h"
#include "SoakBench.h"
#include "StreamBench.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>
#include <nlohmann/json.hpp>

namespace limen::cli {
namespace {

struct Bench {
    const char* name;
    const char* what;
    std::vector<bench::BenchRow> (*run)(bench::AllocationCounter);
    std::vector<bench::BenchRow> (*runOver)(const std::string& dat) = nullptr; ///< null: only on its own data
};

constexpr std::array kBenches{
    Bench{"dat", "opening a dat, looking records up, decoding geometry", &bench::benchDat},
    Bench{"dispatch",
          "planning and submitting frames of many objects, beside the way of binding and drawing by groups",
          &bench::benchDispatch},
    Bench{"frame", "whole frames along the tour, beside frames without visibility and without ownership",
          &bench::benchFrame},
    Bench{"soak", "memory and device objects over an hour of walking", &bench::benchSoak},
    Bench{"stream",
          "flying over landblocks that are streamed in: time of the drawing thread, what is missing, memory",
          &bench::benchStream, &bench::benchStreamOver},
    Bench{"calls", "GL calls a frame, along the tour and with many objects", &bench::benchCalls},
    Bench{"flood", "following the rays of a view through grids of rooms, fine cells, dungeons, a town",
          &bench::benchFlood},
};

struct BenchOptions {
    std::vector<std::string> names;
    std::string dat; ///< empty: each benchmark's own
    bool json = false, list = false;
};

Result<std::vector<const Bench*>> chosen(const std::vector<std::string>& names, bool overDat) {
    std::vector<const Bench*> benches;
    for (const Bench& bench : kBenches) {
        const bool isNamed = std::find(names.begin(), names.end(), bench.name) != names.end();
        if (isNamed && overDat && bench.runOver == nullptr)
            return fail(ErrorCode::NotFound, "bench",
                        fmt::format("'{}' runs on its own data alone", bench.name));
        if (isNamed || (names.empty() && (!overDat || bench.runOver != nullptr)))
            benches.push_back(&bench);
    }
    for (const std::string& name : names) {
        if (std::none_of(kBenches.begin(), kBenches.end(), [&](const Bench& b) { return b.name == name; }))
            return fail(ErrorCode::NotFound, "bench",
                        fmt::format("'{}' is not a benchmark; limen bench --list names them", name));
    }
    return benches;
}

Result<Exit> runBench(const BenchOptions& options, const Console& console) {
    if (options.list) {
        for (const Bench& bench : kBenches)
            console.data(fmt::format("{:<8} {}\n", bench.name, bench.what));
        return Exit::Done;
    }
    const Result<std::vector<const Bench*>> benches = chosen(options.names, !options.dat.empty());
    if (!benches)
        return tl::unexpected(benches.error());
    bool allMet = true;
    Progress progress(console, "bench", benches->size());
    for (std::size_t i = 0; i < benches->size(); ++i) {
        progress.step(i);
        const std::vector<bench::BenchRow> rows =
            options.dat.empty() ? (*benches)[i]->run(&allocationCount) : (*benches)[i]->runOver(options.dat);
        allMet = allMet && std::all_of(rows.begin(), rows.end(), isMet);
        if (!options.json)
            console.data(benchTable(rows));
        for (std::size_t row = 0; options.json && row < rows.size(); ++row)
            console.data(benchJson(rows[row]).dump() + "\n");
    }
    return allMet ? Exit::Done : Exit::Finding;
}

} // namespace

void addBenchVerb(CLI::App& program, const Console& console, Choice& choice) {
    CLI::App* verb =
        program.add_subcommand("bench", "measures, and compares with targets (exit 1 if one is missed)");
    const auto options = std::make_shared<BenchOptions>();
    verb->add_option("NAME", options->names, "which benchmarks; all of them unless said")->type_name("");
    verb->add_option("--dat", options->dat, "on this data instead of the benchmark's own (stream)")
        ->type_name("DIR");
    verb->add_flag("--json", options->json, "one JSON object a row");
    verb->add_flag("--list", options->list, "names the benchmarks");
    verb->footer("ratio: how many times better than the best figure it is measured against.");
    verb->callback([&console, &choice, options] {
        choice.run = [&console, options] { return runBench(*options, console); };
    });
}

} // namespace limen::cli
