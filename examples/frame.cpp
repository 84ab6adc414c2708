// The engine without a window: opens a world, draws one frame, prints its content, and writes it as a PNG file.
//
//     frame [PLACE [DIR [FILE.png]]]        a place of the world (inn.hall), a directory of dat files ("": the built-in world)

#include <limen/engine/FrameDrawer.h>

#include <png.h>

#include <cstdio>
#include <string>

namespace engine = limen::engine;

namespace {

limen::Result<void> writePng(const std::string& file, const engine::FrameDescription& frame,
                             const std::vector<std::uint8_t>& rgba) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = frame.width;
    image.height = frame.height;
    image.format = PNG_FORMAT_RGBA;
    if (png_image_write_to_file(&image, file.c_str(), 0, rgba.data(), 0, nullptr) == 0)
        return limen::fail(limen::ErrorCode::Unreadable, file, image.message);
    return {};
}

limen::Result<void> drawFrame(const std::string& place, const std::string& directory,
                              const std::string& file) {
    const auto world = engine::OpenedWorld::open(directory);
    if (!world)
        return limen::Failure(world.error());
    const auto eye = world->viewpoint(place);
    if (!eye)
        return limen::Failure(eye.error());
    auto drawer = engine::FrameDrawer::headless(*world);
    if (!drawer)
        return limen::Failure(drawer.error());
    const engine::FrameDescription frame{.viewpoint = *eye, .width = 640, .height = 360, .withIds = true};
    const auto counts = drawer->draw(frame);
    if (!counts)
        return limen::Failure(counts.error());
    const auto middle = drawer->surfaceAt(frame.width / 2, frame.height / 2);
    if (!middle)
        return limen::Failure(middle.error());
    std::printf("%u visits, %u instances drawn; in the middle: %s of space %s, %.2f m away\n", counts->visits,
                counts->instances, middle->kind.c_str(), middle->space.c_str(), middle->distance);
    if (file.empty())
        return {};
    const auto colour = drawer->readColour();
    return colour ? writePng(file, frame, *colour) : limen::Failure(colour.error());
}

} // namespace

int main(int argc, char** argv) {
    const auto drawn =
        drawFrame(argc > 1 ? argv[1] : "inn.hall", argc > 2 ? argv[2] : "", argc > 3 ? argv[3] : "");
    if (!drawn)
        std::fprintf(stderr, "frame: %s\n", drawn.error().message().c_str());
    return drawn ? 0 : 2;
}
