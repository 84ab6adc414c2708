// The engine library: opens a world, draws one frame without a window, and prints its content.
//
//     frame [PLACE [DIR]]        a place of world.json (cottage.cellar), a directory of dat files (the built-in world)

#include "engine/Session.h"

#include <fmt/format.h>

namespace {

using namespace limen;

Result<void> drawFrame(const std::string& place, const std::string& directory) {
    Result<engine::WorldSource> source = engine::openWorldSource(directory);
    if (!source)
        return Failure(source.error());
    engine::ViewRequest wanted;
    wanted.place = place;
    wanted.size = {640, 360};
    const Result<engine::ViewRequest> view = engine::resolvePlace(wanted, source->file);
    if (!view)
        return Failure(view.error());
    Result<engine::HeadlessSession> headless =
        engine::openHeadless(std::make_shared<const engine::WorldSource>(std::move(*source)), {});
    if (!headless)
        return Failure(headless.error());
    engine::Session& session = *headless->session;
    if (Result<void> loaded = session.load(engine::centreOf(*view)); !loaded)
        return loaded;
    const Result<engine::FrameRequest> frame =
        engine::frameRequest(session.part().world, session.source().file, *view);
    if (!frame)
        return Failure(frame.error());
    if (Result<void> drawn = session.draw(*frame, {.ids = true}); !drawn)
        return drawn;
    const Result<engine::Picked> middle = session.pick(*frame, 320, 180);
    if (!middle)
        return Failure(middle.error());
    fmt::print("{} visits, {} instances drawn; in the middle: {} of space {}, {:.2f} m away\n",
               session.visible().visits.size(), session.plan().counts.instancesDrawn, middle->meaning.kind,
               middle->meaning.space, middle->distance);
    return {};
}

} // namespace

int main(int argc, char** argv) {
    const Result<void> drawn = drawFrame(argc > 1 ? argv[1] : "cottage.cellar", argc > 2 ? argv[2] : "");
    if (!drawn)
        fmt::print(stderr, "frame: {}\n", drawn.error().message());
    return drawn ? 0 : 2;
}
