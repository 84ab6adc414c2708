#include "viewer/map/MapTexture.h"

#include <bit>
#include <epoxy/gl.h>

namespace limen::viewer {

MapTexture::~MapTexture() {
    glDeleteTextures(1, &name_);
}

void MapTexture::write(const engine::LandscapeMap& map) {
    if (map.rgb.empty())
        return;
    if (name_ == 0 || width_ != map.width() || height_ != map.height()) {
        glDeleteTextures(1, &name_);
        glCreateTextures(GL_TEXTURE_2D, 1, &name_);
        width_ = map.width();
        height_ = map.height();
        const auto levels = static_cast<GLsizei>(std::bit_width(std::max(width_, height_)));
        glTextureStorage2D(name_, levels, GL_RGB8, static_cast<GLsizei>(width_),
                           static_cast<GLsizei>(height_));
        glTextureParameteri(name_, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
        glTextureParameteri(name_, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        glTextureParameteri(name_, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glTextureParameteri(name_, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(name_, 0, 0, 0, static_cast<GLsizei>(width_), static_cast<GLsizei>(height_), GL_RGB,
                        GL_UNSIGNED_BYTE, map.rgb.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glGenerateTextureMipmap(name_);
}

} // namespace limen::viewer
