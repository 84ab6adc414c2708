#include "world/texture/Jpeg.h"

#include <memory>

#include <fmt/format.h>
#include <turbojpeg.h>

namespace limen::world {
namespace {

struct Destroy {
    void operator()(void* decoder) const { tjDestroy(decoder); }
};
using Decoder = std::unique_ptr<void, Destroy>;

Failure damaged(const Decoder& decoder) {
    return fail(ErrorCode::Malformed, "", fmt::format("JPEG picture: {}", tjGetErrorStr2(decoder.get())));
}

} // namespace

Result<Image> decodeJpeg(std::span<const std::uint8_t> bytes, int largest) {
    const Decoder decoder(tjInitDecompress());
    if (decoder == nullptr)
        return fail(ErrorCode::Driver, "", "libjpeg-turbo cannot create a decoder");
    const auto size = static_cast<unsigned long>(bytes.size());
    int width = 0, height = 0, sampling = 0, colours = 0;
    if (tjDecompressHeader3(decoder.get(), bytes.data(), size, &width, &height, &sampling, &colours) != 0)
        return damaged(decoder);
    if (width < 1 || height < 1 || width > largest || height > largest)
        return fail(ErrorCode::Malformed, "",
                    fmt::format("the picture's width or height is out of 1..{}", largest));
    if (colours != TJCS_YCbCr && colours != TJCS_GRAY && colours != TJCS_RGB)
        return fail(ErrorCode::Unsupported, "", "JPEG picture in colours other than grey and YCbCr");
    Image image;
    image.width = static_cast<std::uint32_t>(width);
    image.height = static_cast<std::uint32_t>(height);
    image.rgba.resize(std::size_t{image.width} * image.height * 4);
    // TJPF_RGBA sets alpha to 255. The library only warns of a truncated file; TJFLAG_STOPONWARNING makes it
    // an error.
    if (tjDecompress2(decoder.get(), bytes.data(), size, image.rgba.data(), width, 0, height, TJPF_RGBA,
                      TJFLAG_ACCURATEDCT | TJFLAG_STOPONWARNING) != 0)
        return damaged(decoder);
    return image;
}

} // namespace limen::world
