#include "cli/Verbs.h"

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <unistd.h>
#include <vector>

namespace limen::cli {
namespace {

/// The benchmarks replace operator new, so they are a separate program next to this one.
Result<std::filesystem::path> benchProgram() {
    std::error_code error;
    const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
    const std::filesystem::path program = self.parent_path() / "limen-bench";
    if (error || !std::filesystem::exists(program, error))
        return fail(ErrorCode::NotFound, program.string(),
                    "the benchmark program is missing; build the target limen-bench");
    return program;
}

/// Replaces this process with the benchmarks, so that output, signals and exit code are theirs.
Result<Exit> becomeBench(const std::vector<std::string>& arguments) {
    const Result<std::filesystem::path> program = benchProgram();
    if (!program)
        return tl::unexpected(program.error());
    std::vector<const char*> argv{program->c_str()};
    for (const std::string& argument : arguments)
        argv.push_back(argument.c_str());
    argv.push_back(nullptr);
    ::execv(program->c_str(), const_cast<char* const*>(argv.data()));
    return fail(ErrorCode::Unreadable, program->string(), std::strerror(errno));
}

} // namespace

void addBenchVerb(CLI::App& program, const Console&, Choice& choice) {
    CLI::App* verb = program.add_subcommand(
        "bench", "run benchmarks and compare the results with targets (exit 1 if a target is missed)");
    verb->set_help_flag();      // the benchmark program prints its own help
    verb->prefix_command(true); // and reads its own options
    verb->callback(
        [&choice, verb] { choice.run = [arguments = verb->remaining()] { return becomeBench(arguments); }; });
}

} // namespace limen::cli
