#include "cli/Verbs.h"
#include "core/platform/Terminal.h"
#include "doctor/FileHealth.h"
#include "doctor/Finding.h"
#include "doctor/Machine.h"
#include "doctor/WorldHealth.h"
#include "engine/DatDirectory.h"
#include "engine/WorldSource.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <optional>

namespace limen::cli {
namespace {

constexpr std::size_t kTableWidth = 80, kWidestTable = 120;

struct DoctorArguments {
    std::string path;
    bool json = false, thorough = false;
};

/// The files that a run examines. The built-in world is kept alive with them.
struct Patient {
    std::optional<engine::WorldSource> builtIn;
    std::vector<doctor::FileHealth> files;
    doctor::Findings findings; ///< about the files as a whole
};

/// Examines the files of a directory, or of one around it. If none has the required files, those of the directory
/// itself are examined, so that each file that is there has its finding.
void examineUserDirectory(const std::string& path, Patient& patient) {
    const Result<engine::DatDirectory> found = engine::findDatDirectory(path);
    if (!found) {
        patient.files = doctor::examineDirectory(path);
        patient.findings.push_back({"files", doctor::Outcome::Failed, found.error().message(), ""});
        return;
    }
    patient.files = doctor::examineFiles(found->paths);
    patient.findings.push_back({"files", doctor::Outcome::Ok, found->directory.string(), ""});
}

Result<Patient> examine(const std::string& path) {
    Patient patient;
    std::error_code error;
    if (path.empty()) {
        Result<engine::WorldSource> source = engine::openWorldSource("", engine::PlaceSearch::Skip);
        if (!source)
            return Failure(source.error());
        patient.builtIn.emplace(std::move(*source));
        patient.files = doctor::examineDirectory(patient.builtIn->archive.directory());
        patient.findings.push_back({"files", doctor::Outcome::Ok, "the built-in world", ""});
    } else if (std::filesystem::is_regular_file(path, error)) {
        const Result<dat::File> file = dat::File::open(path);
        const dat::FileRole role = file ? file->role() : dat::FileRole::Portal;
        patient.files.push_back(doctor::examineFile(path, role, true));
        patient.findings.push_back({"files", doctor::Outcome::Ok, "one file: " + path, ""});
    } else if (std::filesystem::is_directory(path, error)) {
        const std::filesystem::directory_iterator probe(path, error);
        if (error)
            return fail(ErrorCode::Unreadable, path, error.message());
        examineUserDirectory(path, patient);
    } else {
        return fail(ErrorCode::NotFound, path,
                    "there is no such file or directory; give the directory that holds client_portal.dat");
    }
    return patient;
}

/// Adds the checks of the files. Records are examined in sound files only.
void addFiles(Patient& patient, const DoctorArguments& arguments, const Console& console,
              doctor::Findings& findings) {
    findings.insert(findings.end(), patient.findings.begin(), patient.findings.end());
    std::vector<doctor::FileHealth> sound;
    for (doctor::FileHealth& health : patient.files) {
        const doctor::Findings more = doctor::judgeFile(health);
        findings.insert(findings.end(), more.begin(), more.end());
        if (health.isSound() && health.file->role() == health.role)
            sound.push_back(std::move(health));
    }
    if (sound.empty()) {
        findings.push_back({"records", doctor::Outcome::NotTested, "there is no sound file", ""});
        return;
    }
    std::optional<Progress> progress;
    doctor::WorldOptions options;
    options.thorough = arguments.thorough;
    options.progress = [&](std::size_t total, std::size_t done) {
        if (!progress)
            progress.emplace(console, "doctor", total);
        progress->step(done);
    };
    const doctor::Findings more = doctor::judgeWorld(sound, options);
    findings.insert(findings.end(), more.begin(), more.end());
}

std::size_t tableWidth() {
    const std::optional<std::size_t> width = platform::terminalWidth();
    return width ? std::clamp(*width, kTableWidth / 2, kWidestTable) : kTableWidth;
}

Result<Exit> runDoctor(const DoctorArguments& arguments, const Console& console) {
    Result<Patient> patient = examine(arguments.path);
    if (!patient)
        return Failure(patient.error());
    doctor::Findings findings = doctor::judgeMachine(doctor::queryMachine());
    addFiles(*patient, arguments, console, findings);
    if (arguments.json)
        console.data(doctor::findingsJson(findings));
    else
        console.data(doctor::tableOf(findings, tableWidth()) + "\n" + doctor::verdictOf(findings) + "\n");
    return doctor::isSound(findings) ? Exit::Done : Exit::Finding;
}

} // namespace

void addDoctorVerb(CLI::App& program, const Console& console, Choice& choice) {
    const auto arguments = std::make_shared<DoctorArguments>();
    CLI::App* verb = program.add_subcommand(
        "doctor", "check that this computer can run Limen and that dat files are whole");
    verb->add_option("DIR", arguments->path,
                     "examine this directory of dat files, or one dat file (the built-in world)")
        ->type_name("");
    verb->add_flag("--thorough", arguments->thorough,
                   "decode every record and follow all references (a sample)");
    verb->add_flag("--json", arguments->json, "print one JSON object");
    verb->footer("Exit codes: 0: ready, warnings allowed; 1: a check failed; 2: nothing could be examined.\n"
                 "Examples:\n  limen doctor\n  limen doctor --thorough --json");
    verb->callback([&console, &choice, arguments] {
        choice.run = [&console, arguments] { return runDoctor(*arguments, console); };
    });
}

} // namespace limen::cli
