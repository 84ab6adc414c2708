#include "cli/Choices.h"
#include "cli/Verbs.h"
#include "core/platform/Environment.h"
#include "core/platform/Process.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <vector>

namespace limen::cli {
namespace {

/// The benchmarks replace operator new, so they are a separate program: next to this one in a build, and in
/// libexec of an installed copy.
Result<std::filesystem::path> benchProgram() {
    std::error_code error;
    const std::string name = platform::programFileName("limen-bench");
    const std::filesystem::path folder = platform::programPath().parent_path();
    const std::filesystem::path beside = folder / name;
    for (const std::filesystem::path& program : {beside, folder.parent_path() / "libexec" / "limen" / name})
        if (std::filesystem::exists(program, error))
            return program;
    return fail(ErrorCode::NotFound, beside.string(),
                "the benchmark program is missing; build the target limen-bench");
}

/// Replaces this process with the benchmarks, so that output, signals and exit code are theirs.
Result<Exit> becomeBench(const std::vector<std::string>& arguments) {
    const Result<std::filesystem::path> program = benchProgram();
    if (!program)
        return Failure(program.error());
    return fail(ErrorCode::Unreadable, program->string(), platform::becomeProgram(*program, arguments));
}

struct BenchArguments {
    std::vector<std::string> names;
    std::string dat, pictures;
    bool json = false, list = false;
};

std::vector<std::string> wordsOf(const BenchArguments& arguments) {
    std::vector<std::string> words = arguments.names;
    if (!arguments.dat.empty())
        words.insert(words.end(), {"--dat", arguments.dat});
    if (!arguments.pictures.empty())
        words.insert(words.end(), {"--pictures", arguments.pictures});
    if (arguments.json)
        words.emplace_back("--json");
    if (arguments.list)
        words.emplace_back("--list");
    return words;
}

} // namespace

// The options are those of bench/Main.cpp, which reads them again.
void addBenchVerb(CLI::App& program, const Console&, Choice& choice) {
    const auto arguments = std::make_shared<BenchArguments>();
    CLI::App* verb =
        program.add_subcommand("bench", "measure the program and compare the results with targets");
    verb->add_option("NAME", arguments->names, "run these benchmarks, e.g. flood (all)")->type_name("");
    verb->add_option("--dat", arguments->dat,
                     "use this directory of dat files in place of the benchmark's own world; only stream, "
                     "placed and gates can")
        ->type_name("DIR")
        ->check(notEmpty());
    verb->add_option("--pictures", arguments->pictures,
                     "write a picture of each place and renderer into this directory (none); only frame can")
        ->type_name("DIR")
        ->check(notEmpty());
    verb->add_flag("--json", arguments->json, "print one JSON object per row");
    verb->add_flag("--list", arguments->list, "list the benchmarks");
    verb->footer("Exit codes: 0: all targets are met; 1: a target is missed; 2: a measurement failed.\n"
                 "Examples:\n  limen bench --list\n  limen bench flood");
    verb->callback(
        [&choice, arguments] { choice.run = [arguments] { return becomeBench(wordsOf(*arguments)); }; });
}

} // namespace limen::cli
