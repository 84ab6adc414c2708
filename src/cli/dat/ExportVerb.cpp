#include "cli/Choices.h"
#include "cli/Parse.h"
#include "cli/dat/DatFiles.h"
#include "dat/Describe.h"
#include "output/Encode.h"
#include "output/Gltf.h"
#include "output/OutputFile.h"
#include "world/Loader.h"
#include "world/Single.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <numeric>

namespace limen::cli {
namespace {

enum class Format { Natural, Json, Png, Gltf, Raw };

struct ExportArguments {
    std::string dat, directory = ".";
    std::vector<std::string> ids;
    Format format = Format::Natural;
};

struct Exported {
    std::string extension, bytes;
};

/// The file of a record: the portal file if it contains the id, then highres, else the cell file.
const dat::File& fileOf(const dat::Archive& archive, dat::RecordId id) {
    for (const dat::File* file : {&archive.portal(), archive.highres()}) {
        if (file == nullptr)
            continue;
        const auto entry = file->find(id);
        if (entry && *entry)
            return *file;
    }
    return archive.cell();
}

Format naturalOf(dat::RecordKind kind) {
    switch (kind) {
    case dat::RecordKind::Surface:
    case dat::RecordKind::SurfaceTexture:
    case dat::RecordKind::RenderSurface:
        return Format::Png;
    case dat::RecordKind::GfxObj:
    case dat::RecordKind::Setup:
    case dat::RecordKind::EnvCell:
    case dat::RecordKind::LandBlockInfo:
        return Format::Gltf;
    default:
        return Format::Json;
    }
}

Result<Exported> asJson(const dat::File& file, dat::RecordId id) {
    dat::Bytes scratch;
    const Result<dat::ByteView> payload = file.read(id, scratch);
    if (!payload)
        return Failure(payload.error());
    const Result<std::string> text = dat::describe(file.role(), id, *payload);
    if (!text)
        return Failure(text.error());
    return Exported{"json", *text};
}

/// The record's bytes, as input for `limen dat pack`.
Result<Exported> asBytes(const dat::File& file, dat::RecordId id) {
    dat::Bytes scratch;
    return file.read(id, scratch).map([](dat::ByteView payload) {
        return Exported{"bin", std::string(reinterpret_cast<const char*>(payload.data()), payload.size())};
    });
}

Result<Exported> asPng(const dat::Archive& archive, dat::RecordId id) {
    const Result<world::Image> image = world::loadPicture(archive, id);
    if (!image)
        return Failure(image.error());
    const Result<std::vector<std::byte>> png = output::encodePng(image->width, image->height, image->rgba);
    if (!png)
        return Failure(png.error());
    return Exported{"png", std::string(reinterpret_cast<const char*>(png->data()), png->size())};
}

/// A cell with its objects, or a landblock's objects without the ground.
Result<Exported> placesAsGltf(const dat::Archive& archive, dat::RecordId id, dat::RecordKind kind) {
    const Result<world::World> world = world::loadWorld(
        archive, dat::blockOf(id),
        {.radius = 0, .detail = std::numeric_limits<double>::infinity()}); // the finest level of detail
    if (!world)
        return Failure(world.error());
    const world::SpaceIndex cell =
        kind == dat::RecordKind::EnvCell ? world::findCell(*world, id) : world::kNone;
    if (kind == dat::RecordKind::EnvCell && cell == world::kNone)
        return fail(ErrorCode::NotFound, dat::idText(id),
                    "the cell cannot be read; look for the fault with limen dat verify");
    std::vector<world::InstanceIndex> instances;
    for (world::InstanceIndex i = 0; i < world->instances.size(); ++i)
        if (cell == world::kNone || world->instances[i].placedIn == cell)
            instances.push_back(i);
    const Result<std::string> bytes = output::encodeGlb(*world, instances, world->blocks.front().origin());
    if (!bytes)
        return Failure(bytes.error());
    return Exported{"glb", *bytes};
}

Result<Exported> asGltf(const dat::Archive& archive, dat::RecordId id, dat::RecordKind kind) {
    switch (kind) {
    case dat::RecordKind::EnvCell:
    case dat::RecordKind::LandBlockInfo:
        return placesAsGltf(archive, id, kind);
    case dat::RecordKind::GfxObj:
    case dat::RecordKind::Setup:
        break;
    default:
        return fail(
            ErrorCode::BadArgument, dat::idText(id),
            fmt::format("a {} has no geometry for glTF; export it with --as json", dat::nameOf(kind)));
    }
    const Result<world::World> world = world::loadModel(archive, id);
    if (!world)
        return Failure(world.error());
    std::vector<world::InstanceIndex> instances(world->instances.size());
    std::iota(instances.begin(), instances.end(), 0u);
    const Result<std::string> bytes = output::encodeGlb(*world, instances, world->blocks.front().origin());
    if (!bytes)
        return Failure(bytes.error());
    return Exported{"glb", *bytes};
}

Result<Exported> exported(const dat::Archive& archive, dat::RecordId id, Format wanted) {
    const dat::File& file = fileOf(archive, id);
    const dat::RecordKind kind = dat::kindOf(file.role(), id);
    switch (wanted == Format::Natural ? naturalOf(kind) : wanted) {
    case Format::Png:
        return asPng(archive, id);
    case Format::Gltf:
        return asGltf(archive, id, kind);
    case Format::Raw:
        return asBytes(file, id);
    case Format::Json:
    case Format::Natural:
        break;
    }
    return asJson(file, id);
}

Result<Exit> runExport(const ExportArguments& arguments, const Console& console) {
    std::vector<dat::RecordId> ids;
    for (const std::string& text : arguments.ids) {
        const Result<dat::RecordId> id = parseRecordId("ID", text);
        if (!id)
            return Failure(id.error());
        ids.push_back(*id);
    }
    const Result<engine::WorldSource> source =
        engine::openWorldSource(arguments.dat, engine::PlaceSearch::Skip);
    if (!source)
        return Failure(source.error());
    if (Result<void> made = output::makeDirectory(arguments.directory); !made)
        return Failure(made.error());
    console.interrupt().defer();
    std::size_t count = 0;
    Progress progress(console, "export", ids.size());
    for (const dat::RecordId id : ids) {
        if (console.interrupt().isRequested()) {
            console.note(fmt::format("Stopped after {} of {} records", count, ids.size()));
            return Exit::Interrupted;
        }
        const Result<Exported> out = exported(source->archive, id, arguments.format);
        if (!out)
            return Failure(out.error());
        const std::filesystem::path path =
            std::filesystem::path(arguments.directory) / fmt::format("{:08X}.{}", id, out->extension);
        if (Result<void> written = output::writeFile(path, std::string_view(out->bytes)); !written)
            return Failure(written.error());
        console.data(path.string() + "\n");
        progress.step(++count);
    }
    console.wrote(arguments.directory, fmt::format("{} {}", count, count == 1 ? "record" : "records"));
    return Exit::Done;
}

} // namespace

void addExportVerb(CLI::App& dat, const Console& console, Choice& choice) {
    const auto arguments = std::make_shared<ExportArguments>();
    CLI::App* verb = dat.add_subcommand("export", "write records as PNG, glTF, JSON or raw bytes");
    verb->add_option("ID", arguments->ids, "export the records with these hexadecimal ids, e.g. 0x0200001A")
        ->required()
        ->type_name("");
    verb->add_option("--dat", arguments->dat, "read this directory of dat files (the built-in world)")
        ->type_name("DIR");
    verb->add_option("-o", arguments->directory, "write to this directory; create it if missing (.)")
        ->type_name("DIR");
    verb->add_option_function<std::string>(
            "--as",
            [arguments](const std::string& text) {
                arguments->format = text == "json"  ? Format::Json
                                    : text == "png" ? Format::Png
                                    : text == "raw" ? Format::Raw
                                                    : Format::Gltf;
            },
            "choose the format (pictures: png; models, cells and landblocks: gltf, binary; others: json); "
            "raw writes the bytes for limen dat pack")
        ->type_name("png|gltf|json|raw")
        ->check(oneOf({"png", "gltf", "json", "raw"}));
    verb->footer(
        "Writes one file per record, named by its id, and prints the names. A cell includes its objects;\n"
        "a landblock (0xXXYYFFFE) excludes its ground.\n"
        "Examples:\n  limen dat export 0x13000000\n  limen dat export 0xA9B40100 --as gltf -o models");
    verb->callback([&console, &choice, arguments] {
        choice.run = [&console, arguments] { return runExport(*arguments, console); };
    });
}

} // namespace limen::cli
