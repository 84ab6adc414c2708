#include "cli/Choices.h"
#include "cli/Parse.h"
#include "cli/dat/DatFiles.h"
#include "core/platform/Files.h"
#include "dat/Describe.h"
#include "dat/Writer.h"
#include "output/OutputFile.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <memory>

namespace limen::cli {
namespace {

namespace fs = std::filesystem;

struct PackArguments {
    std::vector<std::string> inputs, without;
    std::string output, base, role;
};

constexpr const char* kExtension = ".bin";
constexpr std::size_t kLargestRecord = std::size_t{1} << 28;

/// The role and format of the file to write.
struct Target {
    dat::FileRole role = dat::FileRole::Portal;
    dat::FileTraits traits;
};

Result<Target> targetNamed(const std::string& role) {
    for (const Target& target : {Target{dat::FileRole::Portal, dat::FileTraits::portal()},
                                 Target{dat::FileRole::Cell, dat::FileTraits::cell()},
                                 Target{dat::FileRole::Highres, dat::FileTraits::highres()},
                                 Target{dat::FileRole::Local, dat::FileTraits::local()}})
        if (role == nameOfRole(target.role))
            return target;
    return fail(ErrorCode::BadArgument, "--role",
                "no role for the new file; give --role portal, cell, highres or local, or --base FILE");
}

/// The role and format of an existing file.
Target targetLike(const dat::File& file) {
    const dat::Header& header = file.header();
    return {file.role(),
            {header.blockSize, header.type, header.subset, header.engineVersion, header.gameVersion,
             header.minorVersion}};
}

/// The record files, sorted by name.
Result<std::vector<fs::path>> filesOf(const std::vector<std::string>& inputs) {
    std::vector<fs::path> files;
    for (const std::string& input : inputs) {
        std::error_code error;
        if (!fs::is_directory(input, error)) {
            files.emplace_back(input);
            continue;
        }
        const std::size_t before = files.size();
        for (fs::directory_iterator entry(input, error), end; !error && entry != end;
             entry.increment(error)) {
            if (!platform::isText(entry->path()))
                return fail(ErrorCode::Unsupported, input, platform::kNoText);
            if (entry->path().extension() == kExtension)
                files.push_back(entry->path());
        }
        if (error)
            return fail(ErrorCode::NotFound, input, error.message());
        if (files.size() == before)
            return fail(
                ErrorCode::NotFound, input,
                "contains no record files such as 0200001A.bin; write them with limen dat export --as raw");
    }
    std::sort(files.begin(), files.end());
    return files;
}

Result<dat::RecordId> idOf(const fs::path& file) {
    const Result<dat::RecordId> id = parseRecordId(file.string(), file.stem().string());
    if (!id || file.extension() != kExtension)
        return fail(ErrorCode::BadArgument, file.string(),
                    "is not named by a record id; rename it like 0200001A.bin");
    return *id;
}

/// Adds the record of a file. Errors: bytes that do not decode as a record of this id.
Result<void> addFile(const fs::path& file, dat::FileRole role, dat::Writer& writer) {
    const Result<dat::RecordId> id = idOf(file);
    if (!id)
        return Failure(id.error());
    const Result<std::string> text = output::readTextFile(file, kLargestRecord); // binary data
    if (!text)
        return Failure(text.error());
    const auto* begin = reinterpret_cast<const std::byte*>(text->data());
    dat::Bytes payload(begin, begin + text->size());
    if (const Result<std::string> decoded = dat::describe(role, *id, payload); !decoded)
        return fail(decoded.error().code, file.string(), decoded.error().message());
    writer.add(*id, std::move(payload));
    return {};
}

/// Copies the records of the base file in their stored form.
Result<void> addBase(const dat::File& base, const std::vector<dat::RecordId>& without, dat::Writer& writer) {
    Result<void> added;
    dat::Bytes scratch;
    const Result<void> walked = base.forEach([&](const dat::Entry& entry) {
        if (std::find(without.begin(), without.end(), entry.id) != without.end())
            return true;
        const Result<dat::ByteView> payload = base.read(entry, scratch);
        if (!payload) {
            added = Failure(payload.error());
            return false;
        }
        constexpr std::uint16_t kCompressed = 1;
        writer.add(entry.id, dat::Bytes(payload->begin(), payload->end()), (entry.flags & kCompressed) != 0);
        return true;
    });
    return walked ? added : walked;
}

Result<std::vector<dat::RecordId>> idsOf(const std::vector<std::string>& texts) {
    std::vector<dat::RecordId> ids;
    for (const std::string& text : texts) {
        const Result<dat::RecordId> id = parseRecordId("--without", text);
        if (!id)
            return Failure(id.error());
        ids.push_back(*id);
    }
    return ids;
}

Result<Exit> runPack(const PackArguments& arguments, const Console& console) {
    if (Result<void> writable = output::checkWritable(arguments.output); !writable)
        return Failure(writable.error());
    const Result<std::vector<fs::path>> files = filesOf(arguments.inputs);
    const Result<std::vector<dat::RecordId>> without = idsOf(arguments.without);
    if (!files || !without)
        return Failure(files ? without.error() : files.error());
    std::optional<dat::File> base;
    if (!arguments.base.empty()) {
        Result<dat::File> opened = dat::File::open(arguments.base);
        if (!opened)
            return Failure(opened.error());
        base = std::move(*opened);
    }
    const Result<Target> target = base ? Result<Target>(targetLike(*base)) : targetNamed(arguments.role);
    if (!target)
        return Failure(target.error());
    dat::Writer writer(target->traits);
    if (base) {
        if (Result<void> added = addBase(*base, *without, writer); !added)
            return Failure(added.error());
    }
    Progress progress(console, "pack", files->size());
    console.interrupt().defer();
    for (std::size_t i = 0; i < files->size(); ++i) {
        if (console.interrupt().isRequested()) {
            console.note(
                fmt::format("Stopped after {} of {} records; nothing was written", i, files->size()));
            return Exit::Interrupted;
        }
        if (Result<void> added = addFile((*files)[i], target->role, writer); !added)
            return Failure(added.error());
        progress.step(i + 1);
    }
    base.reset(); // the output may replace this file
    if (Result<void> written = writer.write(arguments.output); !written)
        return Failure(written.error());
    console.wrote(arguments.output,
                  fmt::format("a {} file, with {} records from files{}", nameOfRole(target->role),
                              files->size(), arguments.base.empty() ? "" : " and those of the base"));
    return Exit::Done;
}

} // namespace

void addPackVerb(CLI::App& dat, const Console& console, Choice& choice) {
    const auto arguments = std::make_shared<PackArguments>();
    CLI::App* verb = dat.add_subcommand("pack", "write a dat file from records");
    verb->add_option("INPUT", arguments->inputs,
                     "pack these files or directories of files named by record id, e.g. 0200001A.bin (see "
                     "limen dat export --as raw)")
        ->type_name("");
    verb->add_option("-o,--output", arguments->output, "write this dat file")->required()->type_name("FILE");
    CLI::Option* base =
        verb->add_option("--base", arguments->base,
                         "start from the records of this dat file; INPUT replaces records of equal id (none)")
            ->type_name("FILE");
    verb->add_option("--role", arguments->role, "set the role of the new file (that of --base)")
        ->type_name("portal|cell|highres|local")
        ->check(oneOf({"portal", "cell", "highres", "local"}))
        ->excludes(base);
    verb->add_option("--without", arguments->without, "omit this record of the base; repeatable (none)")
        ->type_name("ID")
        ->needs(base);
    verb->footer(
        "Files that do not decode as their record are refused. Check references with limen dat verify.\n"
        "Examples:\n  limen dat export 0x13000000 --as raw -o records\n"
        "  limen dat pack records --role portal -o part.dat");
    verb->callback([&console, &choice, arguments] {
        choice.run = [&console, arguments] { return runPack(*arguments, console); };
    });
}

} // namespace limen::cli
