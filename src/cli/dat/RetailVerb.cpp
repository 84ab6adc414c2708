#include "cli/dat/RetailVerb.h"

#include "cli/dat/DatFiles.h"
#include "doctor/retail/Suite.h"
#include "output/OutputFile.h"

#include <fmt/format.h>
#include <optional>

namespace limen::cli {
namespace {

/// Says before the long part whether these are the original files.
void noteRelease(const dat::Archive& archive, const Console& console) {
    const doctor::Release release =
        doctor::releaseOf(doctor::identityOf(archive.portal(), 0), doctor::identityOf(archive.cell(), 0));
    if (release == doctor::Release::Unknown)
        console.note("limen: these are not the original files; most facts will be wrong or not there");
    else if (release == doctor::Release::EndOfRetailChanged)
        console.note("limen: these are the original files with other contents; counts may differ");
}

} // namespace

Result<Exit> runRetail(const RetailArguments& arguments, const Console& console) {
    if (!arguments.report.empty())
        if (const Result<void> writable = output::checkWritable(arguments.report); !writable)
            return Failure(writable.error());
    const Result<DatFiles> files = openDatFiles(arguments.path);
    if (!files)
        return Failure(files.error());
    if (files->source == nullptr)
        return fail(ErrorCode::BadArgument, arguments.path,
                    "--retail compares the files with one another; give their directory");
    noteRelease(files->source->archive, console);
    std::optional<Progress> progress;
    const Result<doctor::SuiteResult> result =
        doctor::runSuite(files->source->archive, [&](std::size_t total, std::size_t done) {
            if (!progress)
                progress.emplace(console, "verify", total);
            progress->step(done);
        });
    progress.reset();
    if (!result)
        return Failure(result.error());
    const std::string report = doctor::reportJson(*result, std::string("limen ") + LIMEN_VERSION);
    console.data(arguments.json ? report : doctor::reportText(*result, arguments.most, arguments.all));
    if (!arguments.report.empty()) {
        if (const Result<void> written = output::writeFile(arguments.report, report); !written)
            return Failure(written.error());
        console.note(fmt::format("wrote {}: numbers of facts, no game data", arguments.report));
    }
    return result->ledger.count(doctor::Verdict::Wrong) == 0 ? Exit::Done : Exit::Finding;
}

} // namespace limen::cli
