#include "support/TestWorld.h"

// Surfaces, textures and the Region of TestWorld.
namespace limen::test {

dat::RenderSurface solidImage(std::int32_t width, std::int32_t height, std::uint32_t argb) {
    dat::RenderSurface image;
    image.width = width;
    image.height = height;
    image.format = dat::PixelFormat::A8R8G8B8;
    for (std::int32_t i = 0; i < width * height; ++i)
        for (const int shift : {0, 8, 16, 24})
            image.pixels.push_back(static_cast<std::uint8_t>(argb >> shift));
    return image;
}

std::uint32_t TestWorld::solid(const std::string& name, std::uint32_t argb, std::uint32_t extraType,
                               float translucency) {
    dat::Surface surface;
    surface.type = dat::Surface::kBase1Solid | extraType;
    surface.colour.argb = argb;
    surface.translucency = translucency;
    portalFile_.add(nextSurface_, surface);
    return surfaces_[name] = nextSurface_++;
}

std::uint32_t TestWorld::luminous(const std::string& name, float luminosity, float diffuse,
                                  std::uint32_t extraType) {
    dat::Surface surface;
    surface.type = dat::Surface::kBase1Solid | extraType;
    surface.luminosity = luminosity;
    surface.diffuse = diffuse;
    portalFile_.add(nextSurface_, surface);
    return surfaces_[name] = nextSurface_++;
}

std::uint32_t TestWorld::picture(const std::string& name, const dat::RenderSurface& image,
                                 std::uint32_t type) {
    dat::RenderSurface stored = image;
    stored.id = nextImage_++;
    portalFile_.add(stored);
    dat::SurfaceTexture texture;
    texture.id = nextTexture_++;
    texture.images = {stored.id};
    portalFile_.add(texture);
    dat::Surface surface;
    surface.type = type;
    surface.texture = texture.id;
    portalFile_.add(nextSurface_, surface);
    return surfaces_[name] = nextSurface_++;
}

std::uint32_t TestWorld::surfaceId(const std::string& name) {
    if (const auto found = surfaces_.find(name); found != surfaces_.end())
        return found->second;
    std::uint32_t hash = 2166136261u;
    for (const char c : name)
        hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
    return solid(name, 0xFF000000u | (hash & 0x7F7F7Fu) | 0x404040u);
}

void TestWorld::addSolidTexture(std::uint32_t texture, std::uint32_t image, std::uint32_t argb) {
    dat::RenderSurface picture = solidImage(4, 4, argb);
    picture.id = image;
    portalFile_.add(picture);
    dat::SurfaceTexture record;
    record.id = texture;
    record.images = {image};
    portalFile_.add(record);
}

void TestWorld::makeRegion() {
    region_.id = dat::kRegionId;
    region_.name = "Test";
    region_.partsMask = dat::Region::kSky;
    for (std::size_t i = 0; i < region_.landDefs.heights.size(); ++i)
        region_.landDefs.heights[i] = 2.0f * static_cast<float>(i);
    constexpr std::uint32_t kColours[] = {0xFF606060, 0xFF308030, 0xFFC0D0E0, 0xFF40A040, 0xFF706040};
    for (std::uint32_t i = 0; i < 5; ++i) {
        addSolidTexture(0x05000001 + i, 0x06000001 + i, kColours[i]);
        dat::TerrainTexture texture;
        texture.terrainType = i < 4 ? i : 0x20;
        texture.texture = 0x05000001 + i;
        texture.tiling = 2;
        region_.texMerge.textures.push_back(texture);
    }
    for (std::uint32_t i = 0; i < 4; ++i) {
        dat::RenderSurface map;
        map.id = 0x06000010 + i;
        map.width = map.height = 8;
        map.format = dat::PixelFormat::LandscapeAlpha;
        for (std::uint32_t at = 0; at < 64; ++at)
            map.pixels.push_back(static_cast<std::uint8_t>((at * 4 + i) & 0xFF));
        portalFile_.add(map);
        dat::SurfaceTexture record;
        record.id = 0x05000010 + i;
        record.images = {map.id};
        portalFile_.add(record);
    }
    region_.texMerge.corners = {{8, 0x05000010}};
    region_.texMerge.sides = {{9, 0x05000011}};
    region_.texMerge.roads = {{8, 0x05000010}, {9, 0x05000012}, {10, 0x05000013}};
    for (const char* name : {"BarrenRock", "Grassland", "Ice", "LushGrass"}) {
        dat::TerrainType type;
        type.name = name;
        region_.terrainTypes.push_back(type);
    }
    dat::DayGroup day;
    day.name = "Clear";
    dat::SkyTimeOfDay noon;
    noon.dirBright = 1.0f;
    noon.dirPitch = 60.0f;
    noon.dirColour.argb = 0xFFFFFFFF;
    noon.ambBright = 0.4f;
    noon.ambColour.argb = 0xFFFFFFFF;
    noon.minFog = 400.0f;
    noon.maxFog = 2000.0f;
    noon.fogColour.argb = 0xFFA0B0C0;
    day.times = {noon};
    region_.sky.dayGroups = {day};
}

} // namespace limen::test
