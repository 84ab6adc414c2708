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

/// The benchmarks replace operator new, so they are a program of their own, beside this one.
Result<std::filesystem::path> benchProgram() {
    std::error_code error;
    const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
    const std::filesystem::path program = self.parent_path() / "limen-bench";
    if (error || !std::filesystem::exists(program, error))
        return fail(ErrorCode::NotFound, program.string(),
                    "the benchmarks are not installed; build the target limen-bench");
    return program;
}

/// Takes this process's place, so that output, signals and exit code are the benchmarks' own.
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
    CLI::App* verb =
        program.add_subcommand("bench", "measure, and compare with targets (exit 1 if one is missed)");
    verb->set_help_flag();      // the benchmarks print their own help
    verb->prefix_command(true); // and read their own options
    verb->callback(
        [&choice, verb] { choice.run = [arguments = verb->remaining()] { return becomeBench(arguments); }; });
}

} // namespace limen::cli
