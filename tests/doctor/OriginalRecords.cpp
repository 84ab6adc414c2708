#include "doctor/OriginalRecords.h"

#include "doctor/retail/Census.h"

#include <array>
#include <cstring>
#include <set>

namespace limen::test {
namespace {

dat::AnimationHook hookOf(std::uint32_t type, const std::vector<std::uint32_t>& words, std::size_t bytes) {
    dat::AnimationHook hook;
    hook.type = type;
    hook.payload.resize(bytes);
    std::memcpy(hook.payload.data(), words.data(), words.size() * 4);
    return hook;
}

std::uint32_t bitsOf(float value) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
}

constexpr std::uint32_t kCreateParticle = 0x0D, kCallPes = 0x13, kSoundTweaked = 0x15;
constexpr std::size_t kCreateParticleBytes = 40, kCallPesBytes = 8, kSoundTweakedBytes = 16;

} // namespace

dat::BspTree leafTree() {
    dat::BspTree tree;
    tree.nodes.emplace_back();
    return tree;
}

dat::BspTree planeTree(dat::BspTag tag, float d) {
    dat::BspTree tree;
    tree.nodes.resize(3);
    tree.nodes[0].tag = tag;
    tree.nodes[0].plane.d = d;
    tree.nodes[0].positive = 1;
    if (tag == dat::BspTag::BPnN || tag == dat::BspTag::Port)
        tree.nodes[0].negative = 2;
    else
        tree.nodes.resize(2);
    return tree;
}

dat::Polygon bareTriangle(std::int16_t surface) {
    dat::Polygon polygon;
    polygon.stippling = dat::kNoPositiveUv;
    polygon.posSurface = surface;
    for (std::uint16_t key = 0; key < 3; ++key)
        polygon.vertexKeys.push_back(key);
    return polygon;
}

dat::Archive archiveOf(const dat::Writer& portal, const dat::Writer& cell) {
    const auto open = [](const dat::Writer& writer, const char* name) {
        return std::move(dat::File::fromBytes(*writer.build(), name).value());
    };
    return dat::Archive::of(open(portal, "portal"), open(cell, "cell"));
}

dat::Archive emptyArchive() {
    return archiveOf(dat::Writer(dat::FileTraits::portal()), dat::Writer(dat::FileTraits::cell()));
}

OriginalRecords::OriginalRecords(Values values) : values_(values) {
    addSurfaces();
    addModels();
    addLampsAndParts();
    addMeshes();
    addRegion();
    addBlocks();
    addNamedCells();
    addShapes();
    addAcademy();
    addHoltburg();
    addScripts();
}

dat::Archive OriginalRecords::archive() const {
    return archiveOf(portal_, cell_);
}

void OriginalRecords::addSurfaces() {
    const bool changed = values_ == Values::Changed;
    const auto add = [&](std::uint32_t id, std::uint32_t type, std::uint32_t colourOrTexture,
                         float translucency, float luminosity, float diffuse) {
        dat::Surface surface;
        surface.type = type;
        (surface.hasImage() ? surface.texture : surface.colour.argb) = colourOrTexture;
        surface.translucency = v(translucency);
        surface.luminosity = v(luminosity);
        surface.diffuse = v(diffuse);
        portal_.add(id, surface);
    };
    add(0x0800006B, v(0x11u), v(0xFFFFFFFEu) + 1 - (changed ? 2 : 0), 0.5f, 0, 1);
    add(0x08000005, changed ? 1 : 2, 0x05000001, 0, 0, 1);
    add(0x08000139, changed ? 2 : 1, v(0xFFC8C8C8u), 0, 0, 1);
    add(0x080000DD, 1, v(0xFFC8C8C8u), 1.0f, 0, 1);
    add(0x080000C5, changed ? 0x10102 : 0x10112, v(0x05001A26u), 0.5f, 0.148f, 1);
    add(0x08000DCB, changed ? 4 : 2, v(0x05001A9Au), 0, 0, 0.800781f);
    add(0x08000219, changed ? 0x11 : 1, v(0xFF6F3916u), 0, 0, 1);
    portal_.add(dat::SurfaceTexture{v(0x05001A26u), 0, 2, {v(0x06004002u)}});
}

void OriginalRecords::addModels() {
    dat::DegradeInfo info;
    info.id = 0x11000000;
    info.levels = {{v(0x01003769u), 1, v(10.f), v(25.f), v(50.f)},
                   {v(0x0100376Eu), 1, v(25.f), v(50.f), v(100.f)},
                   {v(0x0100376Fu), 1, v(50.f), v(100.f), v(200.f)},
                   {0, 1, 1e38f, 1e38f, 1e38f}};
    if (values_ == Values::Changed)
        info.levels.resize(5);
    portal_.add(info);
    dat::RecordId next = 0x11000010;
    for (const dat::RecordId marker : doctor::markers()) {
        dat::GfxObj object;
        object.id = marker;
        object.flags = dat::GfxObj::kHasDegrade;
        object.degradeId = next++;
        dat::DegradeInfo never;
        never.id = object.degradeId;
        never.levels = {{marker, 1, 0, v(0.f), 0}};
        portal_.add(object);
        portal_.add(never);
    }
    dat::Setup body;
    body.id = 0x02000001;
    for (dat::RecordId part = 0x01000100; part < 0x01000100u + v(34u); ++part) {
        dat::GfxObj object;
        object.id = part;
        object.flags = dat::GfxObj::kHasDegrade;
        object.degradeId = part + 0x10000000;
        dat::DegradeInfo levels;
        levels.id = object.degradeId;
        levels.levels = {{part < 0x01000100u + v(16u) ? 0x01000001u : part, 1, 0, 0, 0}};
        portal_.add(object);
        portal_.add(levels);
        body.parts.push_back(part);
    }
    portal_.add(body);
}

void OriginalRecords::addLampsAndParts() {
    const auto setup = [&](dat::RecordId id, std::vector<std::uint32_t> parts) {
        dat::Setup made;
        made.id = id;
        made.parts = std::move(parts);
        return made;
    };
    for (const dat::RecordId id : {0x02000588u, 0x02000589u, 0x02000BA6u})
        portal_.add(setup(id, {v(0x010001ECu)}));
    portal_.add(setup(0x02000C39, {v(0x010028CAu)}));
    dat::LightInfo light;
    light.colour.argb = v(0xFFC800C8u);
    dat::Setup lamp = setup(0x020001B3, {});
    lamp.lights = {{0, light}};
    portal_.add(lamp);
    light.colour.argb = v(0xFFFF9650u);
    light.intensity = v(100.0f);
    lamp = setup(0x020005D9, {});
    lamp.lights = {{0, light}};
    portal_.add(lamp);
    dat::Setup clouds = setup(0x02000714, {});
    clouds.script = v(0x330007DBu);
    portal_.add(clouds);
}

void OriginalRecords::addMeshes() {
    const auto mesh = [&](dat::RecordId id, std::size_t polygons, std::size_t openings) {
        dat::GfxObj object;
        object.id = id;
        object.flags = dat::GfxObj::kDrawing;
        for (std::size_t i = 0; i < polygons; ++i)
            object.polygons.emplace_back(static_cast<std::uint16_t>(i), bareTriangle(0));
        object.drawingBsp = openings > 0 ? planeTree(dat::BspTag::Port, 0) : leafTree();
        for (std::size_t i = 0; i < openings; ++i)
            object.drawingBsp.nodes[0].portals.push_back({});
        return object;
    };
    const bool changed = values_ == Values::Changed;
    portal_.add(mesh(0x01000830, 0, changed ? 0 : 2));
    portal_.add(mesh(0x01000907, 0, changed ? 1 : 0));
    dat::GfxObj sky = mesh(0x01001348, 0, 0);
    sky.sortCenter = {v(1050.f), 0, 0};
    portal_.add(sky);
    sky.id = 0x01001F6A;
    sky.sortCenter = {v(2066.82f), 552.99f, 0};
    portal_.add(sky);
    for (const dat::RecordId id : {0x01004C42u, 0x01004C44u}) {
        dat::GfxObj rain = mesh(id, v(8u), 0);
        rain.surfaces = {v(0x080000C5u)};
        portal_.add(rain);
    }
}

void OriginalRecords::addRegion() {
    dat::Region region;
    region.id = dat::kRegionId;
    region.partsMask = dat::Region::kSky | (values_ == Values::AsStated ? 8u : 0u);
    for (std::size_t i = 0; i <= 200; ++i)
        region.landDefs.heights[i] = v(2.0f * static_cast<float>(i));
    for (std::size_t i = 201; i < 256; ++i)
        region.landDefs.heights[i] = 400.0f + static_cast<float>(i - 200) * 300.0f / 55.0f + v(0.0f);
    if (values_ == Values::Changed)
        region.landDefs.heights[201] = region.landDefs.heights[202] = 300.0f;
    dat::GameTime& time = region.gameTime;
    time.zeroTimeOfYear = v(3600.0);
    time.dayLength = v(7620.0f);
    time.daysPerYear = v(360u);
    time.zeroYear = v(10u);
    time.timesOfDay.resize(v(16u));
    for (std::size_t i = 0; i < time.timesOfDay.size(); ++i)
        time.timesOfDay[i].isNight = i < v(4u) || i > 11;
    time.daysOfWeek.resize(v(6u));
    dat::TexMerge& merge = region.texMerge;
    merge.baseTexSize = v(1024u);
    merge.textures.resize(v(33u));
    merge.corners.assign(4, {v(8u), 0});
    merge.sides = {{v(9u), 0}};
    merge.roads = {{9, 0}, {v(10u), 0}, {8, 0}};
    region.terrainTypes.resize(v(32u));
    for (dat::TerrainType& type : region.terrainTypes)
        type.sceneTypes.resize(v(32u));
    addSky(region);
    portal_.add(region);
}

void OriginalRecords::addSky(dat::Region& region) const {
    const bool changed = values_ == Values::Changed;
    dat::SkyDesc& sky = region.sky;
    sky.tickSize = v(0.8);
    sky.lightTickSize = v(15.0);
    sky.dayGroups.resize(changed ? 11 : 20);
    const std::set<std::size_t> rainy{3, 7, 9, 15, 16, 17, 18, 19};
    const auto add = [](dat::DayGroup& group, std::uint32_t properties, std::uint32_t script,
                        std::size_t count) {
        dat::SkyObject object;
        object.properties = properties;
        object.script = script;
        group.objects.insert(group.objects.end(), count, object);
    };
    std::size_t rains = 0;
    for (std::size_t i = 0; i < sky.dayGroups.size(); ++i) {
        dat::DayGroup& group = sky.dayGroups[i];
        const bool isRainy = rainy.contains(i) != (changed && i == 3);
        group.name = isRainy ? "Rainy" : i == 5 && !changed ? "Sunny" : "Fair";
        add(group, 0, 0, 6);
        group.objects.front().object = 0x010015EF;
        add(group, 2, 1, 1);
        if (isRainy) {
            add(group, 4, 0, 1);
            add(group, 5, 0, 1);
            add(group, 13, 1, rains++ % 2 == 0 ? 9 : 10);
        }
        dat::SkyTimeOfDay dawn;
        dawn.dirBright = changed ? 0.1f : 0.2f;
        group.times = {dawn};
    }
    // Between two keyframes, so that the colour must be mixed.
    const auto colours = [&](std::size_t index, std::uint32_t from, std::uint32_t to) {
        if (index >= sky.dayGroups.size())
            return;
        dat::DayGroup& group = sky.dayGroups[index];
        group.times.resize(2, group.times.front());
        group.times[1].begin = 0.3628f;
        group.times[0].ambColour.argb = from;
        group.times[1].ambColour.argb = to;
    };
    colours(5, changed ? 0xFF000000 : 0xFF9DB1FF, 0xFFC5B1FF);  // (157, 177, 255) and (197, 177, 255)
    colours(15, changed ? 0xFF000000 : 0xFFBF72FF, 0xFFBF9AFF); // (191, 114, 255) and (191, 154, 255)
    dat::SkyObjectReplace replace;
    replace.objectIndex = 1000;
    replace.luminosity = replace.maxBright = 50.0f;
    if (changed)
        replace.maxBright = 20.0f;
    sky.dayGroups[0].times[0].replaces.assign(v(433u), replace);
}

void OriginalRecords::addBlocks() {
    const auto block = [&](std::uint32_t word, std::uint8_t height) {
        dat::LandBlock land;
        land.id = word << 16 | 0xFFFF;
        land.heights.fill(height);
        return land;
    };
    // The landblocks of the known places; changed, the ground is above them.
    for (const std::uint32_t word :
         {0x0FB9, 0x1133, 0x17B2, 0x1DB6, 0x21B0, 0x23DA, 0x2681, 0x26EC, 0x2B12, 0x2BB5, 0x33D9,
          0x38F7, 0x3F31, 0x42DE, 0x49B7, 0x49F0, 0x5A9C, 0x64D5, 0x7D64, 0x8090, 0x8588, 0x876C,
          0x8F58, 0x934B, 0x95D6, 0x9722, 0x977B, 0x9F44, 0xA0A4, 0xA21E, 0xA260, 0xB46F, 0xBA17,
          0xBB9F, 0xBDD0, 0xC080, 0xC6A9, 0xC95B, 0xC98C, 0xCE41, 0xCE94, 0xDA55, 0xDA75, 0xDC3C,
          0xE632, 0xE63E, 0xE64E, 0xE822, 0xF224, 0xF559, 0xF682})
        cell_.add(block(word, values_ == Values::AsStated ? 0 : 255));
    dat::LandBlock holtburg = block(0xA9B4, values_ == Values::AsStated ? 0 : 255);
    holtburg.hasObjects = v(1u);
    // The plane of landcell (0, 2) is at 77.934 m under the known point.
    const bool stated = values_ == Values::AsStated;
    holtburg.heights[2] = stated ? 42 : 255;
    holtburg.heights[3] = stated ? 40 : 255;
    holtburg.heights[9 + 2] = stated ? 38 : 255;
    holtburg.heights[9 + 3] = stated ? 36 : 255;
    cell_.add(holtburg);
    dat::LandBlock spire = block(0x9AB1, 0);
    spire.heights[0] = v<std::uint8_t>(120);
    spire.heights[1] = v<std::uint8_t>(139);
    spire.heights[40] = v<std::uint8_t>(93);
    spire.heights[79] = v<std::uint8_t>(93);
    spire.heights[80] = v<std::uint8_t>(110);
    cell_.add(spire);
}

void OriginalRecords::addNamedCells() {
    dat::EnvCell cell;
    cell.id = 0xDA550177;
    cell.environment = v<std::uint16_t>(0x0364);
    const auto portal = [&](std::uint16_t flags, std::uint16_t polygon, std::uint16_t other,
                            std::uint16_t back) {
        cell.portals.push_back({flags, v(polygon), other, back});
    };
    portal(3, 34, 0x178, 0);
    portal(1, 36, 0x17E, 1);
    portal(1, 37, 0x17D, 2);
    portal(1, 35, 0x17B, 1);
    portal(1, 33, 0x179, 0);
    if (values_ == Values::Changed)
        portal(0, 0, 0, 0);
    cell_.add(cell);
    cell.id = 0xDA550178;
    cell.cellStructure = 1;
    cell.portals.clear();
    portal(1, 7, 0x177, 0);
    portal(7, 6, 0xFFFF, 0xFFFF);
    if (values_ == Values::Changed)
        portal(0, 0, 0, 0);
    cell_.add(cell);
    // The cells of known places: a shape of 20 m around the place, or far from it.
    const auto room = [&](std::uint32_t id, Vec3f at) {
        dat::EnvCell indoor;
        indoor.id = id;
        indoor.environment = 0x0700;
        indoor.position.origin = at + Vec3f(v(0.0f) * 100.0f, 0, 0);
        cell_.add(indoor);
    };
    room(0x018A024F, {120.0f, -79.9f, 0});
    room(0x016C01BC, {49.2f, -31.9f, 0});
    room(0x013A02AE, {140, -40, 12});
    room(0x01110108, {10, -10, 0});
    room(0x01E901C2, {152.3f, -2.4f, -12});
    room(0x00070143, {70, -60, 0});
}

void OriginalRecords::addShapes() {
    const auto shape = [] {
        dat::CellStruct made;
        made.cellBsp = made.physicsBsp = leafTree();
        return made;
    };
    dat::Environment inn;
    inn.id = 0x0D000364;
    dat::CellStruct first = shape(), second = shape();
    for (const std::uint16_t id : std::array<std::uint16_t, 5>{34, 36, 37, 35, 33}) {
        first.portalPolygons.push_back(v(id));
        first.polygons.emplace_back(id, bareTriangle(v<std::int16_t>(9)));
    }
    for (const std::uint16_t id : std::array<std::uint16_t, 2>{7, 6}) {
        second.portalPolygons.push_back(v(id));
        second.polygons.emplace_back(id, bareTriangle(v<std::int16_t>(id == 7 ? 9 : 10)));
    }
    inn.cells = {{0, first}, {1, second}};
    portal_.add(inn);

    dat::Environment sample;
    sample.id = 0x0D00062E;
    dat::CellStruct box = shape();
    for (std::uint32_t i = 0; i < v(8u); ++i)
        box.vertexArray.vertices.emplace_back(static_cast<std::uint16_t>(i),
                                              dat::Vertex{{v(4.0f), -0.6f, 1.8f}, {}, {}});
    dat::Polygon side = bareTriangle(0);
    side.vertexKeys.push_back(v<std::uint16_t>(3));
    for (std::uint32_t i = 0; i < v(6u); ++i)
        box.polygons.emplace_back(static_cast<std::uint16_t>(i), side);
    box.cellBsp = planeTree(dat::BspTag::BPnn, v(-1.8f));
    box.physicsBsp = planeTree(dat::BspTag::BPnN, v(1.8f));
    box.drawingBsp = planeTree(dat::BspTag::BPIn, v(-1.8f));
    sample.cells = {{0, box}};
    if (values_ == Values::Changed)
        sample.cells.emplace_back(1, box);
    portal_.add(sample);

    dat::Environment rooms;
    rooms.id = 0x0D000700;
    dat::CellStruct cube = shape();
    cube.vertexArray.vertices.emplace_back(0, dat::Vertex{Vec3f(-10.0f), {}, {}});
    cube.vertexArray.vertices.emplace_back(1, dat::Vertex{Vec3f(10.0f), {}, {}});
    rooms.cells = {{0, cube}};
    portal_.add(rooms);
}

void OriginalRecords::addAcademy() {
    const bool changed = values_ == Values::Changed;
    // Shape 0 has three untextured portal polygons, shape 1 has two; each also has one polygon with a picture.
    dat::Environment shapes;
    shapes.id = 0x0D000800;
    for (std::uint32_t key = 0; key < 2; ++key) {
        dat::CellStruct shape;
        shape.cellBsp = shape.physicsBsp = leafTree();
        for (std::uint32_t id = 0; id < 3 - key; ++id) {
            shape.polygons.emplace_back(static_cast<std::uint16_t>(id), bareTriangle(0));
            if (!changed)
                shape.portalPolygons.push_back(static_cast<std::uint16_t>(id));
        }
        shape.polygons.emplace_back(9, bareTriangle(1));
        shapes.cells.emplace_back(key, shape);
    }
    portal_.add(shapes);
    dat::Surface plain, picture;
    plain.type = dat::Surface::kBase1Solid;
    picture.type = dat::Surface::kBase1Image;
    portal_.add(0x08000801, plain);
    portal_.add(0x08000802, picture);
    for (const std::uint32_t block : {0x7F03u, 0x8602u, 0x8C04u})
        for (std::uint32_t i = 0; i < v(568u); ++i) {
            dat::EnvCell cell;
            cell.id = block << 16 | (0x100 + i);
            cell.environment = 0x0800;
            cell.cellStructure = i < 236 ? 0 : 1;
            cell.surfaces = {0x0801, 0x0802};
            cell.portals = {{0, 0, changed ? dat::kOutdoors : std::uint16_t{0x0100}, 0}};
            if (cell.id == 0x860201AD) {
                cell.flags = dat::EnvCell::kHasStatics;
                cell.statics.assign(v(30u), {0x02000002, {}});
                cell.statics[3] = {v(0x02000C39u), {{12.3199f, -28.482f, 0}, {1, 0, 0, 0}}};
                cell.statics[4].model = v(0x02000943u);
            }
            cell_.add(cell);
        }
}

void OriginalRecords::addHoltburg() {
    dat::LandBlockInfo info;
    info.id = 0xA9B4FFFE;
    info.numCells = 2;
    info.objects.resize(v(114u), {0x02000002, {}});
    dat::Building cottage;
    cottage.model = v(0x01000830u);
    cottage.portals.resize(1);
    info.buildings.assign(values_ == Values::AsStated ? 8 : 6, cottage);
    cell_.add(info);
    for (std::uint32_t i = 0; i < 2; ++i) {
        dat::EnvCell cell;
        cell.id = 0xA9B40100 + i;
        cell.flags = dat::EnvCell::kHasStatics;
        cell.statics.assign(i == 0 ? v(400u) : 5, {0x02000002, {}});
        cell_.add(cell);
    }
}

void OriginalRecords::addScripts() {
    dat::PhysicsScript clouds;
    clouds.id = 0x330007DB;
    for (const std::uint32_t emitter : {0x32000455u, 0x32000456u, 0x32000457u})
        clouds.hooks.push_back({v(0.0), hookOf(kCreateParticle, {v(emitter)}, kCreateParticleBytes)});
    portal_.add(clouds);
    for (const std::uint32_t id : {0x33000428u, 0x33000429u}) {
        dat::PhysicsScript wind;
        wind.id = id;
        wind.hooks = {
            {0.0, hookOf(kSoundTweaked, {v(0x0A00038Bu), 0, 0, bitsOf(0.35f)}, kSoundTweakedBytes)}};
        portal_.add(wind);
    }
    dat::PhysicsScript thunder;
    thunder.id = 0x33000453;
    thunder.hooks = {{0.0, hookOf(kCreateParticle, {v(0x320002C2u)}, kCreateParticleBytes)},
                     {1.0, hookOf(kCallPes, {v(0x33000453u), bitsOf(v(30.0f))}, kCallPesBytes)}};
    portal_.add(thunder);
}

} // namespace limen::test
