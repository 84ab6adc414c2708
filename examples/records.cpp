// The dat library alone: writes a dat file with two records, opens it again, reads and verifies them.
//
//     records FILE    the file to write; it is replaced

#include <limen/dat/Describe.h>
#include <limen/dat/Verify.h>
#include <limen/dat/Writer.h>

#include <cstdio>

namespace dat = limen::dat;

namespace {

int report(const limen::Error& error) {
    std::fprintf(stderr, "%s\n", error.message().c_str());
    return 2;
}

/// A palette of greys, and a texture of 2 × 2 pixels that uses it.
dat::Writer makeFile() {
    dat::Palette palette;
    palette.id = 0x04000001;
    for (std::uint32_t grey = 0; grey < 256; ++grey)
        palette.colours.push_back({0xFF000000u | grey << 16 | grey << 8 | grey});
    dat::RenderSurface picture;
    picture.id = 0x06000001;
    picture.width = picture.height = 2;
    picture.format = dat::PixelFormat::P8;
    picture.pixels = {0, 85, 170, 255};
    picture.defaultPalette = palette.id;
    dat::Writer writer(dat::FileTraits::portal());
    writer.add(palette);
    writer.add(picture);
    return writer;
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "Usage: records FILE\n");
        return 2;
    }
    if (const auto written = makeFile().write(argv[1]); !written)
        return report(written.error());
    const auto file = dat::File::open(argv[1]);
    if (!file)
        return report(file.error());
    dat::Bytes scratch;
    const auto walked = file->forEach([](const dat::Entry& entry) {
        std::printf("%s %s, %u bytes\n", dat::idText(entry.id).c_str(),
                    dat::nameOf(dat::kindOf(dat::FileRole::Portal, entry.id)), entry.size);
        return true;
    });
    if (!walked)
        return report(walked.error());
    const auto payload = file->read(0x06000001, scratch);
    if (!payload)
        return report(payload.error());
    const auto picture = dat::decode<dat::RenderSurface>(0x06000001, *payload);
    if (!picture)
        return report(picture.error());
    std::printf("%s\n", dat::describe(*picture).c_str());
    const dat::File* const files[] = {&*file};
    const dat::VerifyReport verified = dat::verify(files);
    std::printf("%zu faults\n", verified.faults.size());
    return verified.isClean() ? 0 : 1;
}
