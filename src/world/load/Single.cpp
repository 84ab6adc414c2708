#include "world/Single.h"

#include "world/assemble/AssembleWorld.h"
#include "world/mesh/Models.h"
#include "world/texture/Textures.h"

#include <fmt/format.h>
#include <limits>
#include <utility>

namespace limen::world {
namespace {

Failure refused(dat::RecordId id, ErrorCode code, const char* what) {
    return fail(code, fmt::format("0x{:08X}", id), what);
}

Result<Image> decodedPicture(const dat::Archive& archive, dat::RecordId id, dat::RecordId paletteId,
                             const DecodeRules& rules) {
    const Result<dat::RenderSurface> picture = archive.load<dat::RenderSurface>(id);
    if (!picture)
        return Failure(picture.error());
    std::optional<dat::Palette> palette;
    if (const dat::RecordId used = paletteId != 0 ? paletteId : picture->defaultPalette; used != 0) {
        Result<dat::Palette> loaded = archive.load<dat::Palette>(used);
        if (!loaded)
            return Failure(loaded.error());
        palette = std::move(*loaded);
    }
    Result<Image> image = decodeImage(*picture, palette ? &*palette : nullptr, rules);
    if (!image)
        image.error().where = fmt::format("0x{:08X}", id);
    return image;
}

Result<Image> pictureOfTexture(const dat::Archive& archive, dat::RecordId id, dat::RecordId palette,
                               const DecodeRules& rules) {
    const Result<dat::SurfaceTexture> texture = archive.load<dat::SurfaceTexture>(id);
    if (!texture)
        return Failure(texture.error());
    const Result<dat::RecordId> picture = archive.imageOf(*texture);
    if (!picture)
        return Failure(picture.error());
    return decodedPicture(archive, *picture, palette, rules);
}

} // namespace

Result<World> loadModel(const dat::Archive& archive, dat::RecordId model) {
    const bool isThere = archive.contains<dat::GfxObj>(model) || archive.contains<dat::Setup>(model);
    if (!isThere)
        return refused(model, ErrorCode::NotFound, "there is no such GfxObj or Setup");
    Records records(archive);
    Models models(records,
                  {.detail = std::numeric_limits<double>::infinity()}); // the nearest level of detail
    const auto block = std::make_shared<BlockContent>();
    block->objects.emplace_back().model = model;
    std::shared_ptr<const BlockContent> next = block;
    World world = assembleWorld({records, models}, [&next] { return std::exchange(next, nullptr); });
    if (world.instances.empty())
        return refused(model, ErrorCode::NotFound, "the model has no polygon to draw");
    return world;
}

Result<Image> loadPicture(const dat::Archive& archive, dat::RecordId id) {
    switch (dat::kindOf(dat::FileRole::Portal, id)) {
    case dat::RecordKind::RenderSurface:
        return decodedPicture(archive, id, 0, {});
    case dat::RecordKind::SurfaceTexture:
        return pictureOfTexture(archive, id, 0, {});
    case dat::RecordKind::Surface:
        break;
    default:
        return refused(id, ErrorCode::BadArgument, "is not the id of a picture, texture or surface");
    }
    const Result<dat::Surface> surface = archive.load<dat::Surface>(id);
    if (!surface)
        return Failure(surface.error());
    if (!surface->hasImage())
        return refused(id, ErrorCode::NotFound, "the surface has one colour and no picture");
    const DecodeRules rules{(surface->type & dat::Surface::kBase1ClipMap) != 0,
                            (surface->type & dat::Surface::kAdditive) != 0};
    return pictureOfTexture(archive, surface->texture, surface->palette, rules);
}

} // namespace limen::world
