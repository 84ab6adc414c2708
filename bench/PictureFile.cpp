#include "PictureFile.h"

#include <png.h>

namespace limen::bench {

Result<void> writePicture(const std::filesystem::path& file, const FramePicture& picture) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = picture.width;
    image.height = picture.height;
    image.format = PNG_FORMAT_RGBA;
    image.flags = PNG_IMAGE_FLAG_FAST;
    if (png_image_write_to_file(&image, file.c_str(), 0, picture.rgba.data(), 0, nullptr) == 0)
        return fail(ErrorCode::Unreadable, file.string(), image.message);
    return {};
}

} // namespace limen::bench
