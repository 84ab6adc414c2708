#include "cli/Choices.h"
#include "cli/Parse.h"
#include "cli/dat/DatFiles.h"
#include "cli/dat/RetailVerb.h"
#include "dat/Verify.h"

#include <CLI/CLI.hpp>
#include <chrono>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <optional>

namespace limen::cli {
namespace {

struct VerifyArguments {
    std::string path;
    std::size_t most = 50;
    bool json = false;
    bool retail = false, all = false;
    std::string report;
};

/// The number of records and bytes of one kind.
struct KindLine {
    const char* name = "";
    dat::VerifyReport::Sum sum;
};
std::vector<KindLine> linesOf(const dat::VerifyReport& report) {
    std::vector<KindLine> lines;
    for (std::size_t i = 0; i < report.byKind.size(); ++i)
        if (report.byKind[i].records > 0)
            lines.push_back({dat::nameOf(static_cast<dat::RecordKind>(i)), report.byKind[i]});
    return lines;
}

std::string jsonOf(const dat::VerifyReport& report, double seconds) {
    nlohmann::ordered_json kinds = nlohmann::ordered_json::object();
    std::uint64_t records = 0, bytes = 0;
    for (const KindLine& line : linesOf(report)) {
        kinds[line.name] = {{"records", line.sum.records}, {"bytes", line.sum.bytes}};
        records += line.sum.records;
        bytes += line.sum.bytes;
    }
    nlohmann::ordered_json faults = nlohmann::ordered_json::array();
    for (const dat::Fault& fault : report.faults) {
        faults.push_back({{"file", nameOfRole(fault.role)},
                          {"id", dat::idText(fault.id)},
                          {"type", dat::nameOf(dat::kindOf(fault.role, fault.id))},
                          {"fault", dat::nameOf(fault.kind)},
                          {"what", fault.what}});
    }
    const auto count = [&](dat::FaultKind kind) {
        return report.faultCounts[static_cast<std::size_t>(kind)];
    };
    const nlohmann::ordered_json json{{"records", records},
                                      {"bytes", bytes},
                                      {"seconds", seconds},
                                      {"unreadable", count(dat::FaultKind::Unreadable)},
                                      {"changed", count(dat::FaultKind::Changed)},
                                      {"unresolved", count(dat::FaultKind::Unresolved)},
                                      {"warnings", report.warnings},
                                      {"kinds", kinds},
                                      {"faults", faults}};
    return json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string textOf(const dat::VerifyReport& report) {
    std::string text;
    for (const KindLine& line : linesOf(report))
        text +=
            fmt::format("{:<18} {:>9} records {:>13} bytes\n", line.name, line.sum.records, line.sum.bytes);
    for (const dat::Fault& fault : report.faults) {
        text +=
            fmt::format("{} {} {}: {}\n", nameOfRole(fault.role),
                        dat::nameOf(dat::kindOf(fault.role, fault.id)), dat::idText(fault.id), fault.what);
    }
    const auto& counts = report.faultCounts;
    const std::uint64_t all = counts[0] + counts[1] + counts[2];
    if (all > report.faults.size())
        text += fmt::format("... and {} more\n", all - report.faults.size());
    text += fmt::format("{} unreadable, {} changed, {} unresolved\n", counts[0], counts[1], counts[2]);
    return text;
}

std::uint64_t recordsOf(const dat::VerifyReport& report) {
    std::uint64_t records = 0;
    for (const dat::VerifyReport::Sum& sum : report.byKind)
        records += sum.records;
    return records;
}

Result<Exit> runVerify(const VerifyArguments& arguments, const Console& console) {
    if (arguments.retail)
        return runRetail({arguments.path, arguments.report, arguments.most, arguments.json, arguments.all},
                         console);
    const Result<DatFiles> files = openDatFiles(arguments.path);
    if (!files)
        return Failure(files.error());
    std::optional<Progress> progress;
    dat::VerifyOptions options;
    options.mostFaults = arguments.most;
    options.progress = [&](std::size_t total, std::size_t done) {
        if (!progress)
            progress.emplace(console, "verify", total);
        if (done % 256 == 0)
            progress->step(done);
    };
    console.interrupt().defer();
    options.stopped = [&console] { return console.interrupt().isRequested(); };
    const auto start = std::chrono::steady_clock::now();
    dat::VerifyReport report = dat::verify(files->list, options);
    progress.reset();
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    for (const dat::File* file : files->list)
        for (const std::string& warning : file->warnings())
            report.warnings.push_back(fmt::format("{}: {}", file->name(), warning));
    if (report.isStopped)
        console.note(
            fmt::format("limen: stopped after {} records; the report covers these", recordsOf(report)));
    console.data(arguments.json ? jsonOf(report, seconds) : textOf(report));
    for (const std::string& warning : report.warnings)
        console.note(fmt::format("limen: {}", warning));
    if (report.isStopped)
        return Exit::Interrupted;
    return report.isClean() ? Exit::Done : Exit::Finding;
}

} // namespace

void addVerifyVerb(CLI::App& dat, const Console& console, Choice& choice) {
    const auto arguments = std::make_shared<VerifyArguments>();
    CLI::App* verb =
        dat.add_subcommand("verify", "read every record, encode it again in memory and check its references");
    verb->add_option("PATH", arguments->path, "verify this dat file or directory (the built-in world)")
        ->type_name("");
    verb->add_option("--most", arguments->most,
                     "print at most this many faults or lines (50); all are counted")
        ->type_name("N")
        ->check(within(0, 1000000));
    verb->add_flag("--json", arguments->json, "print one JSON object");
    CLI::Option* retail =
        verb->add_flag("--retail", arguments->retail,
                       "compare the files with facts about the original game's files instead");
    verb->add_option("--report", arguments->report,
                     "also write the verdicts to this file: numbers, no game data (none)")
        ->type_name("FILE")
        ->needs(retail);
    verb->add_flag("--all", arguments->all, "print the facts that are right, too")->needs(retail);
    verb->footer("Exit codes: 0: no fault; 1: faults found, or a fact is wrong; 2: an error. References to "
                 "other files\n"
                 "are not checked when a single file is given.\n"
                 "Examples:\n  limen dat verify\n  limen dat verify --retail --report limen-report.json");
    verb->callback([&console, &choice, arguments] {
        choice.run = [&console, arguments] { return runVerify(*arguments, console); };
    });
}

} // namespace limen::cli
