#include "cli/Choices.h"
#include "cli/Parse.h"
#include "cli/Verbs.h"
#include "cli/dat/DatFiles.h"
#include "dat/Describe.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>

namespace limen::cli {
namespace {

std::string lowerCase(std::string text) {
    for (char& c : text)
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
    return text;
}

/// Every kind of record; the last is Other.
std::vector<dat::RecordKind> allKinds() {
    std::vector<dat::RecordKind> kinds;
    for (int i = 0; i <= static_cast<int>(dat::RecordKind::Other); ++i)
        kinds.push_back(static_cast<dat::RecordKind>(i));
    return kinds;
}

Result<std::optional<dat::RecordKind>> parseKind(const std::string& text) {
    if (text.empty())
        return std::nullopt;
    std::vector<std::string> names;
    for (const dat::RecordKind kind : allKinds()) {
        if (lowerCase(text) == lowerCase(dat::nameOf(kind)))
            return kind;
        names.emplace_back(dat::nameOf(kind));
    }
    return fail(ErrorCode::BadArgument, "--type",
                fmt::format("unknown record type '{}'{}", text, suggestion(text, names)));
}

std::string entryLine(const dat::File& file, const dat::Entry& entry, bool json) {
    const char* kind = dat::nameOf(dat::kindOf(file.role(), entry.id));
    const bool compressed = (entry.flags & 1u) != 0;
    if (!json)
        return fmt::format("{}  {:<14} {:>9}  {}{}\n", dat::idText(entry.id), kind, entry.size,
                           nameOfRole(file.role()), compressed ? "  compressed" : "");
    const nlohmann::ordered_json object{{"id", dat::idText(entry.id)},
                                        {"type", kind},
                                        {"size", entry.size},
                                        {"file", nameOfRole(file.role())},
                                        {"compressed", compressed}};
    return object.dump() + "\n";
}

struct ListOptions {
    std::string path, type;
    bool json = false;
};

Result<Exit> runList(const ListOptions& options, const Console& console) {
    const Result<std::optional<dat::RecordKind>> wanted = parseKind(options.type);
    if (!wanted)
        return Failure(wanted.error());
    const Result<DatFiles> files = openDatFiles(options.path);
    if (!files)
        return Failure(files.error());
    std::size_t count = 0;
    for (const dat::File* file : files->list) {
        for (const std::string& warning : file->warnings())
            console.note(fmt::format("limen: {}: {}", file->name(), warning));
        const Result<void> walked = file->forEach([&](const dat::Entry& entry) {
            if (!*wanted || **wanted == dat::kindOf(file->role(), entry.id)) {
                console.data(entryLine(*file, entry, options.json));
                ++count;
            }
            return true;
        });
        if (!walked)
            return Failure(walked.error());
    }
    if (count == 0)
        console.note(fmt::format("limen: no {} record is in these files; list all kinds with limen dat ls",
                                 options.type));
    return Exit::Done;
}

struct ShowOptions {
    std::string path, id, in;
};

/// The file that contains the record. The same id can name different records in different files.
Result<const dat::File*> holderOf(const DatFiles& files, dat::RecordId id, const std::string& in) {
    std::vector<const dat::File*> holders;
    for (const dat::File* file : files.list) {
        if (!in.empty() && in != nameOfRole(file->role()))
            continue;
        const Result<std::optional<dat::Entry>> entry = file->find(id);
        if (!entry)
            return Failure(entry.error());
        if (*entry)
            holders.push_back(file);
    }
    if (holders.empty())
        return fail(ErrorCode::NotFound, dat::idText(id),
                    "no dat file contains this record; list the records with limen dat ls");
    if (holders.size() > 1 && in.empty() && holders[1]->role() != dat::FileRole::Highres)
        return fail(ErrorCode::BadArgument, dat::idText(id),
                    fmt::format("both the {} and the {} file contain this id; choose one, e.g. with --in {}",
                                nameOfRole(holders[0]->role()), nameOfRole(holders[1]->role()),
                                nameOfRole(holders[0]->role())));
    return holders.front();
}

Result<Exit> runShow(const ShowOptions& options, const Console& console) {
    const Result<dat::RecordId> id = parseRecordId("ID", options.id);
    if (!id)
        return Failure(id.error());
    const Result<DatFiles> files = openDatFiles(options.path);
    if (!files)
        return Failure(files.error());
    const Result<const dat::File*> file = holderOf(*files, *id, options.in);
    if (!file)
        return Failure(file.error());
    dat::Bytes scratch;
    const Result<dat::ByteView> payload = (*file)->read(*id, scratch);
    if (!payload)
        return Failure(payload.error());
    const Result<std::string> text = dat::describe((*file)->role(), *id, *payload);
    if (!text)
        return Failure(text.error());
    console.data(*text);
    if (!text->ends_with('\n'))
        console.data("\n");
    return Exit::Done;
}

} // namespace

void addDatVerb(CLI::App& program, const Console& console, Choice& choice) {
    CLI::App* verb =
        program.add_subcommand("dat", "list, show, export, pack and verify the records of dat files");
    verb->require_subcommand(1);
    verb->footer("To read about one of them: limen help dat VERB.\n"
                 "Examples:\n  limen dat ls --type Region\n  limen dat verify");

    const auto list = std::make_shared<ListOptions>();
    CLI::App* ls =
        verb->add_subcommand("ls", "list the records of a dat file or of a directory of dat files");
    ls->add_option("PATH", list->path, "list this dat file or directory (the built-in world)")->type_name("");
    ls->add_option("--type", list->type, "list only records of this type, e.g. EnvCell (all)")
        ->type_name("TYPE");
    ls->add_flag("--json", list->json, "print one JSON object per line");
    ls->footer("Examples:\n  limen dat ls --type Region\n  limen dat ls --type EnvCell --json");
    ls->callback(
        [&console, &choice, list] { choice.run = [&console, list] { return runList(*list, console); }; });

    const auto show = std::make_shared<ShowOptions>();
    CLI::App* print = verb->add_subcommand("show", "print one record as JSON");
    print->add_option("ID", show->id, "print the record with this hexadecimal id, e.g. 0x13000000")
        ->required()
        ->type_name("");
    print->add_option("--dat", show->path, "read this dat file or directory (the built-in world)")
        ->type_name("PATH");
    print->add_option("--in", show->in, "read the record from this file if two contain the id (the only one)")
        ->type_name("portal|cell|highres|local")
        ->check(oneOf({"portal", "cell", "highres", "local"}));
    print->footer("Examples:\n  limen dat show 0x13000000\n  limen dat show 0xA9B40100 --in cell");
    print->callback(
        [&console, &choice, show] { choice.run = [&console, show] { return runShow(*show, console); }; });
    addExportVerb(*verb, console, choice);
    addPackVerb(*verb, console, choice);
    addVerifyVerb(*verb, console, choice);
}

} // namespace limen::cli
