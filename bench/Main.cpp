#include "AllocationCount.h"
#include "ApiBench.h"
#include "BenchTable.h"
#include "CallsBench.h"
#include "CardBench.h"
#include "CrowdBench.h"
#include "DatBench.h"
#include "DispatchBench.h"
#include "FloodBench.h"
#include "FrameBench.h"
#include "GatesBench.h"
#include "SoakBench.h"
#include "StreamBench.h"

#include "cli/Console.h"
#include "core/Nearest.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

namespace limen::bench {
namespace {

struct Bench {
    const char* name;
    const char* what;
    std::vector<BenchRow> (*run)(AllocationCounter);
    std::vector<BenchRow> (*runOver)(const std::string& dat) = nullptr; ///< null: only on its own data
    /// Null: draws no pictures.
    std::vector<BenchRow> (*runWithPictures)(AllocationCounter, const std::string& directory) = nullptr;
};

constexpr std::array kBenches{
    Bench{"dat", "opening of a dat file, look-ups, decoding of geometry", &benchDat},
    Bench{"dispatch", "planning and submission of frames with many objects, compared with draws by group",
          &benchDispatch},
    Bench{
        "frame",
        "whole frames along the tour, compared with frames without visibility, a plain renderer and a scene "
        "graph",
        &benchFrame, nullptr, &benchFrameWith},
    Bench{"card", "GPU time of whole frames on a graphics card, by stage", &benchCard},
    Bench{"gates", "time, GL calls, draws and fragments of the three gates along the tour", &benchGates,
          &benchGatesOver},
    Bench{"soak", "memory and device objects over an hour of walking", &benchSoak},
    Bench{"stream", "flights over streamed landblocks: time of the drawing thread, missing blocks, memory",
          &benchStream, &benchStreamOver},
    Bench{"placed", "flights over streamed landblocks with 365,183 placed objects", &benchPlaced,
          &benchPlacedOver},
    Bench{"calls", "GL calls a frame, along the tour and with many objects", &benchCalls},
    Bench{"crowd", "planning of frames with 200 people of a world database", &benchCrowd},
    Bench{"flood", "the portal flood in grids of rooms, fine cells, dungeons and a town", &benchFlood},
    Bench{"api", "the same floods through C++, the C interface and the Python module", &benchApi},
};

struct BenchOptions {
    std::vector<std::string> names;
    std::string dat;      ///< empty: each benchmark's own
    std::string pictures; ///< empty: none
    bool json = false, list = false;
};

std::string unknownMessage(const std::string& name) {
    std::vector<std::string> names;
    names.reserve(kBenches.size());
    for (const Bench& bench : kBenches)
        names.emplace_back(bench.name);
    const std::vector<std::string> similar = nearest(name, names, 1);
    return fmt::format("unknown benchmark '{}'{}", name,
                       similar.empty() ? "; limen bench --list prints the names" : "." + didYouMean(similar));
}

/// Empty: a benchmark can run with these options. Otherwise the reason.
std::string misfitOf(const Bench& bench, const BenchOptions& options) {
    if (!options.dat.empty() && bench.runOver == nullptr)
        return fmt::format("'{}' uses its own data; leave --dat out", bench.name);
    if (!options.pictures.empty() && bench.runWithPictures == nullptr)
        return fmt::format("'{}' draws no pictures; leave --pictures out", bench.name);
    return {};
}

Result<std::vector<const Bench*>> chosen(const BenchOptions& options) {
    const std::vector<std::string>& names = options.names;
    std::vector<const Bench*> benches;
    for (const Bench& bench : kBenches) {
        const bool isNamed = std::find(names.begin(), names.end(), bench.name) != names.end();
        const std::string misfit = misfitOf(bench, options);
        if (isNamed && !misfit.empty())
            return fail(ErrorCode::NotFound, "bench", misfit);
        if (isNamed || (names.empty() && misfit.empty()))
            benches.push_back(&bench);
    }
    for (const std::string& name : names)
        if (std::none_of(kBenches.begin(), kBenches.end(), [&](const Bench& b) { return b.name == name; }))
            return fail(ErrorCode::NotFound, "bench", unknownMessage(name));
    return benches;
}

std::vector<BenchRow> rowsOf(const Bench& bench, const BenchOptions& options) {
    if (!options.dat.empty())
        return bench.runOver(options.dat);
    if (!options.pictures.empty())
        return bench.runWithPictures(&allocationCount, options.pictures);
    return bench.run(&allocationCount);
}

Result<cli::Exit> runBench(const BenchOptions& options, const cli::Console& console) {
    if (options.list) {
        for (const Bench& bench : kBenches)
            console.data(fmt::format("{:<8} {}\n", bench.name, bench.what));
        return cli::Exit::Done;
    }
    const Result<std::vector<const Bench*>> benches = chosen(options);
    if (!benches)
        return Failure(benches.error());
    bool allMet = true;
    console.interrupt().defer();
    for (std::size_t i = 0; i < benches->size(); ++i) {
        if (console.interrupt().isRequested()) {
            console.note(fmt::format("Stopped after {} of {} benchmarks", i, benches->size()));
            return cli::Exit::Interrupted;
        }
        std::optional<cli::Waiting> waiting(
            std::in_place, console,
            fmt::format("bench {} ({} of {})", (*benches)[i]->name, i + 1, benches->size()));
        const std::vector<BenchRow> rows = rowsOf(*(*benches)[i], options);
        waiting.reset();
        allMet = allMet && std::all_of(rows.begin(), rows.end(), isMet);
        if (!options.json)
            console.data(benchTable(rows));
        for (std::size_t row = 0; options.json && row < rows.size(); ++row)
            console.data(benchJson(rows[row]).dump() + "\n");
    }
    return allMet ? cli::Exit::Done : cli::Exit::Finding;
}

} // namespace

int run(int argc, const char* const* argv) {
    CLI::App program("Measures Limen and compares it with targets. Exit codes: 0 all targets are met, 1 a "
                     "target is missed,\n"
                     "2 a measurement failed.",
                     "limen bench");
    BenchOptions options;
    program.add_option("NAME", options.names, "run these benchmarks (all)")->type_name("");
    program
        .add_option("--dat", options.dat,
                    "use this data in place of the benchmark's own (stream and gates only)")
        ->type_name("DIR");
    program
        .add_option("--pictures", options.pictures,
                    "write a picture of each place and renderer into this directory (frame only)")
        ->type_name("DIR")
        ->check(CLI::ExistingDirectory);
    program.add_flag("--json", options.json, "print one JSON object a row");
    program.add_flag("--list", options.list, "list the benchmarks");
    program.footer("ratio: how many times better than the best figure it is compared with.");
    const cli::Console console(stdout, stderr, Interrupt::install());
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
            console.data(program.help());
            return static_cast<int>(cli::Exit::Done);
        }
        console.error({ErrorCode::BadArgument, "bench", error.what()});
        return static_cast<int>(cli::Exit::Impossible);
    }
    const Result<cli::Exit> done = runBench(options, console);
    if (!done)
        console.error(done.error());
    return static_cast<int>(done && console.flush() ? *done : cli::Exit::Impossible);
}

} // namespace limen::bench

int main(int argc, char** argv) {
    return limen::bench::run(argc, argv);
}
