#include "cli/ReportFacts.h"

#include "engine/Quality.h"
#include "output/OutputFile.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <ctime>
#include <fmt/chrono.h>
#include <fmt/format.h>

namespace limen::cli {
namespace {

std::string quotedForShell(const std::string& word) {
    const auto isPlain = [](unsigned char c) {
        return std::isalnum(c) != 0 ||
               std::string_view("-_./,=:+@%").find(static_cast<char>(c)) != std::string_view::npos;
    };
    if (!word.empty() && std::all_of(word.begin(), word.end(), isPlain))
        return word;
    std::string text = "'";
    for (const char c : word)
        text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

std::string nowUtc() {
    return fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(std::time(nullptr)));
}

std::filesystem::path pageOf(const std::string& directory) {
    return std::filesystem::path(directory) / "index.html";
}

} // namespace

std::string commandLineOf(const CLI::App& verb) {
    std::string text = "limen " + verb.get_name();
    for (const CLI::Option* option : verb.get_options()) {
        if (option->count() == 0)
            continue;
        const bool isFlag = option->get_expected_max() == 0;
        if (option->get_positional() && option->get_lnames().empty()) {
            for (const std::string& value : option->results())
                text += " " + quotedForShell(value);
            continue;
        }
        const std::string name = option->get_lnames().empty() ? "-" + option->get_snames().front()
                                                              : "--" + option->get_lnames().front();
        if (isFlag)
            text += " " + name;
        else
            for (const std::string& value : option->results())
                text += " " + name + " " + quotedForShell(value);
    }
    return text;
}

output::ReportHead reportHead(const engine::Session& session, const std::string& command) {
    const engine::SessionOptions& options = session.options();
    const engine::FrameFigures figures = session.figures();
    output::ReportHead head;
    head.world = options.dat.empty() ? "built-in world" : options.dat;
    head.version = std::string("limen ") + LIMEN_VERSION;
    head.driver = figures.driver;
    head.made = nowUtc();
    head.command = command;
    head.facts = {{"Radius", fmt::format("{} landblocks", options.load.radius)},
                  {"Zones", options.load.mergeZones ? "merged" : "one a cell"},
                  {"Drawing", options.drawing == gpu::Drawing::Fast ? "fast" : "exact"},
                  {"Samples per pixel", fmt::format("{}", session.samples())},
                  {"Textures", figures.textures}};
    return head;
}

Result<void> checkReportPlace(const std::string& directory) {
    if (directory.empty())
        return {};
    if (Result<void> made = output::makeDirectory(directory); !made)
        return made;
    return output::checkWritable(pageOf(directory));
}

Result<std::string> writeReport(const std::string& directory, const std::string& page) {
    if (Result<void> written = output::writeFile(pageOf(directory), std::string_view(page)); !written)
        return Failure(written.error());
    return pageOf(directory).string();
}

} // namespace limen::cli
