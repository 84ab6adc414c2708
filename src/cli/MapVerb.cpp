#include "cli/OpenWorld.h"
#include "cli/Parse.h"
#include "cli/Verbs.h"
#include "engine/WorldSource.h"
#include "engine/map/MapPainter.h"
#include "output/MapPicture.h"
#include "output/OutputFile.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>
#include <optional>

namespace limen::cli {
namespace {

struct MapArguments {
    std::string dat, size, output = "map.png";
    int scale = engine::kLeastMapScale;
    bool labels = false;
};

/// The line that reports the written map: size, extent in landblocks and in map coordinates.
std::string contentOf(const engine::LandscapeMap& map, const output::Picture& picture) {
    std::size_t grounds = 0;
    for (const engine::LandscapeMap::Block& block : map.blocks)
        grounds += block.hasGround ? 1 : 0;
    const std::string damaged =
        map.damaged > 0 ? fmt::format("; {} records could not be read: see limen dat verify", map.damaged)
                        : "";
    return fmt::format("{}x{} pixels, {} landblocks with ground of {:02X}{:02X} to {:02X}{:02X}{}",
                       picture.width, picture.height, grounds, map.left, map.bottom,
                       map.left + map.columns - 1, map.bottom + map.rows - 1, damaged);
}

Result<output::Picture> drawMap(const MapArguments& arguments, const engine::WorldSource& source,
                                const engine::LandscapeMap& map) {
    if (map.blocks.empty())
        return fail(ErrorCode::NotFound, arguments.dat.empty() ? "the built-in world" : arguments.dat,
                    "has no landblock, so there is no map; check client_cell_1.dat with limen dat verify");
    output::Picture picture = output::pictureOfMap(map);
    if (!arguments.size.empty()) {
        const Result<engine::PixelSize> box = parseSize("--size", arguments.size);
        if (!box)
            return Failure(box.error());
        picture = output::shrunkToFit(picture, box->width, box->height);
    }
    if (arguments.labels)
        output::drawPlaces(picture, map, source.file.places,
                           static_cast<double>(picture.width) / map.width());
    return picture;
}

Result<Exit> runMap(const MapArguments& arguments, const Console& console) {
    if (!arguments.size.empty())
        if (const Result<engine::PixelSize> box = parseSize("--size", arguments.size); !box)
            return Failure(box.error());
    if (Result<void> writable = output::checkPictureWritable(arguments.output); !writable)
        return Failure(writable.error());
    const Result<engine::WorldSource> source = openWorld(console, arguments.dat);
    if (!source)
        return Failure(source.error());
    std::optional<Progress> progress;
    const Result<engine::LandscapeMap> map =
        engine::paintMap(source->archive, arguments.scale, [&](std::size_t done, std::size_t all) {
            if (!progress)
                progress.emplace(console, "map", all);
            progress->step(done);
        });
    if (!map)
        return Failure(map.error());
    const Result<output::Picture> picture = drawMap(arguments, *source, *map);
    if (!picture)
        return Failure(picture.error());
    if (Result<void> written = output::writePicture(arguments.output, *picture); !written)
        return Failure(written.error());
    progress.reset();
    console.wrote(arguments.output, contentOf(*map, *picture));
    return Exit::Done;
}

} // namespace

void addMapVerb(CLI::App& program, const Console& console, Choice& choice) {
    CLI::App* verb = program.add_subcommand("map", "draw the landscape from above, as a picture");
    const auto arguments = std::make_shared<MapArguments>();
    verb->add_option("--dat", arguments->dat, "read the dat files of this directory (the built-in world)")
        ->type_name("DIR");
    verb->add_option("--scale", arguments->scale,
                     "set the pixels along a landblock's side of 192 m, 8 to 64 (8)")
        ->type_name("N")
        ->check(CLI::Range(engine::kLeastMapScale, engine::kMostMapScale));
    verb->add_option("--size", arguments->size, "reduce the map so that it fits into WxH pixels (no limit)")
        ->type_name("WxH");
    verb->add_flag("--labels", arguments->labels, "write the names of places on the map");
    verb->add_option("-o,--output", arguments->output, "write the picture to this file (map.png)")
        ->type_name("FILE");
    verb->footer(
        "North is up. The map shows the smallest rectangle around all landblocks of the data; blocks "
        "without ground are dark.\nNeeds no OpenGL.\n"
        "Examples:\n  limen map -o map.png\n  limen map --labels --scale 16 -o map.png");
    verb->callback([&console, &choice, arguments] {
        choice.run = [&console, arguments] { return runMap(*arguments, console); };
    });
}

} // namespace limen::cli
