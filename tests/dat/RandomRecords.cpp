#include "dat/RandomRecords.h"

#include <bit>
#include <iterator>

namespace limen::dat {
namespace {

struct PixelCase {
    PixelFormat format;
    std::size_t bitsPerTexel; ///< of 4x4 blocks for the DXT formats
    bool blocks = false;
};
constexpr PixelCase kPixelCases[] = {{PixelFormat::R8G8B8, 24},
                                     {PixelFormat::A8R8G8B8, 32},
                                     {PixelFormat::X8R8G8B8, 32},
                                     {PixelFormat::R5G6B5, 16},
                                     {PixelFormat::X1R5G5B5, 16},
                                     {PixelFormat::A1R5G5B5, 16},
                                     {PixelFormat::A4R4G4B4, 16},
                                     {PixelFormat::A8, 8},
                                     {PixelFormat::P8, 8},
                                     {PixelFormat::L8, 8},
                                     {PixelFormat::Index16, 16},
                                     {PixelFormat::LandscapeR8G8B8, 24},
                                     {PixelFormat::LandscapeAlpha, 8},
                                     {PixelFormat::Dxt1, 4, true},
                                     {PixelFormat::Dxt3, 8, true},
                                     {PixelFormat::Dxt5, 8, true}};

constexpr std::size_t kHookBytes[] = {0, 4, 4, 28, 0, 0, 4,  16, 12, 16, 12, 16, 8, 40,
                                      4, 4, 4, 0,  4, 8, 12, 16, 12, 8,  12, 4,  0};

bool hasChildren(BspTag tag) {
    return tag != BspTag::Leaf && tag != BspTag::BPOL && tag != BspTag::BPFL;
}

} // namespace

float RandomRecords::number() {
    // Mostly plausible values, sometimes random bits, including NaNs with payloads.
    return below(8) == 0 ? std::bit_cast<float>(word()) : static_cast<float>(below(20001)) * 0.01f - 100.0f;
}

Frame RandomRecords::frame() {
    return {vec3(), Quatf(number(), number(), number(), number())};
}

std::string RandomRecords::text() {
    std::string out;
    fill(out, below(12), [&] { return static_cast<char>(byte()); });
    return out;
}

std::vector<std::uint8_t> RandomRecords::octets(std::size_t n) {
    std::vector<std::uint8_t> out;
    fill(out, n, [&] { return byte(); });
    return out;
}

VertexArray RandomRecords::vertexArray() {
    VertexArray out;
    fill(out.vertices, count(), [&] {
        Vertex v{vec3(), vec3(), {}};
        fill(v.uvs, below(5), [&] { return Vec2f{number(), number()}; });
        return std::pair{half(), v};
    });
    return out;
}

Polygon RandomRecords::polygon() {
    Polygon p;
    p.stippling = static_cast<std::uint8_t>(below(16));
    p.sides = below(10) == 0 ? static_cast<std::int32_t>(word()) : static_cast<std::int32_t>(below(3));
    p.posSurface = static_cast<std::int16_t>(half());
    p.negSurface = static_cast<std::int16_t>(half());
    const std::size_t n = below(20) == 0 ? 255 : 3 + below(8);
    fill(p.vertexKeys, n, [&] { return half(); });
    if ((p.stippling & kNoPositiveUv) == 0)
        fill(p.posUv, n, [&] { return byte(); });
    if (p.sides == 2 && (p.stippling & kNoNegativeUv) == 0)
        fill(p.negUv, n, [&] { return byte(); });
    return p;
}

PolygonList RandomRecords::polygons() {
    PolygonList out;
    fill(out, below(10) == 0 ? 130 : count(), [&] { return std::pair{half(), polygon()}; });
    return out;
}

std::int32_t RandomRecords::bspNode(BspTree& tree, BspKind kind, int depth) {
    constexpr BspTag kTags[] = {BspTag::Leaf, BspTag::Port, BspTag::BPnn, BspTag::BPIn, BspTag::BpIN,
                                BspTag::BpnN, BspTag::BPIN, BspTag::BPnN, BspTag::BPOL, BspTag::BPFL};
    const auto index = tree.nodes.size();
    BspNode node;
    node.tag = depth > 5 ? BspTag::Leaf : kTags[below(std::size(kTags))];
    const bool portal = node.tag == BspTag::Port;
    if (node.tag == BspTag::Leaf) {
        node.leafIndex = static_cast<std::int32_t>(word());
        node.solid = kind == BspKind::Physics ? static_cast<std::int32_t>(below(2)) : 0;
    } else {
        node.plane = {vec3(), number()};
    }
    const bool hasLists = kind == BspKind::Physics ? node.tag == BspTag::Leaf
                                                   : kind == BspKind::Drawing && node.tag != BspTag::Leaf;
    if (hasLists)
        fill(node.polygonIds, count(), [&] { return half(); });
    if (hasLists || (kind == BspKind::Physics && !portal))
        node.sphere = sphere();
    if (portal && kind == BspKind::Drawing)
        fill(node.portals, count(), [&] { return PortalRef{half(), half()}; });
    tree.nodes.push_back(node);
    const bool positive = hasChildren(node.tag) && node.tag != BspTag::BpIN && node.tag != BspTag::BpnN;
    const bool negative = hasChildren(node.tag) && node.tag != BspTag::BPnn && node.tag != BspTag::BPIn;
    if (positive) {
        const auto child = bspNode(tree, kind, depth + 1);
        tree.nodes[index].positive = child;
    }
    if (negative) {
        const auto child = bspNode(tree, kind, depth + 1);
        tree.nodes[index].negative = child;
    }
    return static_cast<std::int32_t>(index);
}

BspTree RandomRecords::bsp(BspKind kind) {
    BspTree tree;
    bspNode(tree, kind, 0);
    return tree;
}

CellStruct RandomRecords::cellStruct() {
    CellStruct cell;
    cell.vertexArray = vertexArray();
    cell.polygons = polygons();
    fill(cell.portalPolygons, count(), [&] { return half(); });
    cell.cellBsp = bsp(BspKind::Cell);
    cell.physicsPolygons = polygons();
    cell.physicsBsp = bsp(BspKind::Physics);
    if (coin())
        cell.drawingBsp = bsp(BspKind::Drawing);
    if (coin()) {
        cell.padding = {byte(), byte(), byte()};
        cell.portalPadding = {byte(), byte(), byte()};
    }
    return cell;
}

AnimationHook RandomRecords::hook() {
    AnimationHook out;
    out.type = static_cast<std::uint32_t>(below(std::size(kHookBytes)));
    out.direction = static_cast<std::int32_t>(below(3)) - 1;
    out.payload = octets(kHookBytes[out.type]);
    if (out.type == 5)
        out.payload = coin() ? std::vector<std::uint8_t>{1, 0, 0x34, 0x12}
                             : std::vector<std::uint8_t>{1, 0, 0x01, 0x80, 0x78, 0x56};
    return out;
}

AnimationFrame RandomRecords::animationFrame(std::size_t parts) {
    AnimationFrame f;
    fill(f.parts, parts, [&] { return frame(); });
    fill(f.hooks, count(), [&] { return hook(); });
    return f;
}

MotionData RandomRecords::motion() {
    MotionData m;
    m.bitfield = byte();
    m.flags = static_cast<std::uint8_t>(below(4));
    if (coin())
        m.padding = {byte()};
    fill(m.animations, below(20) == 0 ? 255 : count(), [&] {
        return AnimationRange{word(), static_cast<std::int32_t>(word()), static_cast<std::int32_t>(word()),
                              number()};
    });
    if (m.flags & MotionData::kVelocity)
        m.velocity = vec3();
    if (m.flags & MotionData::kOmega)
        m.omega = vec3();
    return m;
}

MotionTable::Keyed<MotionData> RandomRecords::motions() {
    MotionTable::Keyed<MotionData> out;
    fill(out, count(), [&] { return std::pair{word(), motion()}; });
    return out;
}

template <>
Animation RandomRecords::make<Animation>() {
    Animation a;
    a.id = word();
    a.flags = static_cast<std::uint32_t>(below(4));
    a.partCount = static_cast<std::uint32_t>(count());
    const std::size_t n = count();
    if (a.flags & Animation::kPositionFrames)
        fill(a.positionFrames, n, [&] { return frame(); });
    fill(a.frames, n, [&] { return animationFrame(a.partCount); });
    return a;
}

template <>
MotionTable RandomRecords::make<MotionTable>() {
    MotionTable t;
    t.id = word();
    t.defaultStyle = word();
    fill(t.styleDefaults, count(), [&] { return std::pair{word(), word()}; });
    t.cycles = motions();
    t.modifiers = motions();
    fill(t.links, count(), [&] { return std::pair{word(), motions()}; });
    return t;
}

template <>
PaletteSet RandomRecords::make<PaletteSet>() {
    PaletteSet s;
    s.id = word();
    fill(s.palettes, count(), [&] { return word(); });
    return s;
}

template <>
ClothingTable RandomRecords::make<ClothingTable>() {
    ClothingTable t;
    t.id = word();
    t.parts.buckets = half();
    fill(t.parts.entries, count(), [&] {
        std::vector<PartChange> changes;
        fill(changes, count(), [&] {
            PartChange change{word(), word(), {}};
            fill(change.textures, count(), [&] { return TextureChange{word(), word()}; });
            return change;
        });
        return std::pair{word(), std::move(changes)};
    });
    t.palettes.buckets = half();
    fill(t.palettes.entries, count(), [&] {
        PaletteTemplate one{word(), {}};
        fill(one.changes, count(), [&] {
            PaletteChange change;
            fill(change.ranges, count(), [&] { return PaletteRange{word(), word()}; });
            change.palettes = word();
            return change;
        });
        return std::pair{word(), std::move(one)};
    });
    return t;
}

template <>
DegradeInfo RandomRecords::make<DegradeInfo>() {
    DegradeInfo d;
    d.id = word();
    fill(d.levels, count(), [&] { return DegradeLevel{word(), word(), number(), number(), number()}; });
    return d;
}

template <>
ParticleEmitter RandomRecords::make<ParticleEmitter>() {
    const auto whole = [&] { return static_cast<std::int32_t>(word()); };
    ParticleEmitter e;
    e.id = word();
    e.unknown = word();
    e.emitterType = whole();
    e.particleType = static_cast<ParticleType>(coin() ? whole() : static_cast<std::int32_t>(1 + below(12)));
    e.softwareGfxObj = word();
    e.gfxObj = word();
    e.birthrate = std::bit_cast<double>(random_());
    e.maxParticles = whole();
    e.initialParticles = whole();
    e.totalParticles = whole();
    e.totalSeconds = std::bit_cast<double>(random_());
    e.lifespan = static_cast<double>(number());
    e.lifespanRandom = static_cast<double>(number());
    for (ScaledVector* v : {&e.offset, &e.a, &e.b, &e.c})
        *v = scaledVector();
    e.scale = fade();
    e.translucency = fade();
    e.isParentLocal = static_cast<std::uint32_t>(below(3));
    return e;
}

template <>
PhysicsScript RandomRecords::make<PhysicsScript>() {
    PhysicsScript s;
    s.id = word();
    fill(s.hooks, count(), [&] { return ScriptedHook{std::bit_cast<double>(random_()), hook()}; });
    return s;
}

template <>
PhysicsScriptTable RandomRecords::make<PhysicsScriptTable>() {
    PhysicsScriptTable t;
    t.id = word();
    fill(t.scripts, count(), [&] {
        std::vector<ScriptChoice> choices;
        fill(choices, count(), [&] { return ScriptChoice{number(), word()}; });
        return std::pair{word(), std::move(choices)};
    });
    return t;
}

template <>
Palette RandomRecords::make<Palette>() {
    Palette p;
    p.id = word();
    fill(p.colours, coin() ? 256 : count(), [&] { return Colour{word()}; });
    return p;
}

template <>
SurfaceTexture RandomRecords::make<SurfaceTexture>() {
    SurfaceTexture s{word(), word(), byte(), {}};
    fill(s.images, count(), [&] { return word(); });
    return s;
}

template <>
RenderSurface RandomRecords::make<RenderSurface>() {
    RenderSurface s;
    s.id = word();
    s.category = word();
    if (below(10) == 0) {
        s.format = PixelFormat::RawJpeg;
        s.width = static_cast<std::int32_t>(word());
        s.height = static_cast<std::int32_t>(word());
        s.pixels = octets(count());
        return s;
    }
    const PixelCase& one = kPixelCases[below(std::size(kPixelCases))];
    const std::size_t w = below(20), h = below(20);
    s.format = one.format;
    s.width = static_cast<std::int32_t>(w);
    s.height = static_cast<std::int32_t>(h);
    const std::size_t texels = one.blocks ? ((w + 3) / 4) * ((h + 3) / 4) * 16 : w * h;
    s.pixels = octets(texels * one.bitsPerTexel / 8);
    if (s.format == PixelFormat::P8 || s.format == PixelFormat::Index16)
        s.defaultPalette = word();
    return s;
}

template <>
Surface RandomRecords::make<Surface>() {
    Surface s;
    s.type = coin() ? word() : static_cast<std::uint32_t>(below(8));
    if (s.hasImage()) {
        s.texture = word();
        s.palette = word();
    } else {
        s.colour = {word()};
    }
    s.translucency = number();
    s.luminosity = number();
    s.diffuse = number();
    return s;
}

template <>
GfxObj RandomRecords::make<GfxObj>() {
    GfxObj g;
    g.id = word();
    g.flags = static_cast<std::uint32_t>(below(16));
    fill(g.surfaces, below(10) == 0 ? 200 : count(), [&] { return word(); });
    g.vertexArray = vertexArray();
    g.sortCenter = vec3();
    if (g.flags & GfxObj::kPhysics) {
        g.physicsPolygons = polygons();
        g.physicsBsp = bsp(BspKind::Physics);
    }
    if (g.flags & GfxObj::kDrawing) {
        g.polygons = polygons();
        g.drawingBsp = bsp(BspKind::Drawing);
    }
    if (g.flags & GfxObj::kHasDegrade)
        g.degradeId = word();
    return g;
}

template <>
Setup RandomRecords::make<Setup>() {
    Setup s;
    s.id = word();
    s.flags = static_cast<std::uint32_t>(below(16));
    const std::size_t n = count();
    fill(s.parts, n, [&] { return word(); });
    if (s.flags & Setup::kParents)
        fill(s.parents, n, [&] { return word(); });
    if (s.flags & Setup::kScales)
        fill(s.scales, n, [&] { return vec3(); });
    const auto location = [&] {
        return Location{static_cast<std::int32_t>(word()), static_cast<std::int32_t>(word()), frame()};
    };
    fill(s.holdingLocations, count(), location);
    fill(s.connectionPoints, count(), location);
    fill(s.placementFrames, count(), [&] {
        AnimationFrame f = animationFrame(n);
        return std::pair{word(), std::move(f)};
    });
    fill(s.cylSpheres, count(), [&] { return CylSphere{vec3(), number(), number()}; });
    fill(s.spheres, count(), [&] { return sphere(); });
    s.height = number();
    s.stepDown = number();
    s.sortingSphere = sphere();
    s.selectionSphere = sphere();
    fill(s.lights, count(), [&] {
        return std::pair{static_cast<std::int32_t>(word()),
                         LightInfo{frame(), {word()}, number(), number(), number()}};
    });
    s.animation = word();
    s.scriptTable = word();
    return s;
}

template <>
Environment RandomRecords::make<Environment>() {
    Environment e;
    e.id = word();
    fill(e.cells, count(), [&] { return std::pair{word(), cellStruct()}; });
    return e;
}

template <>
EnvCell RandomRecords::make<EnvCell>() {
    EnvCell c;
    c.id = word();
    c.flags = static_cast<std::uint32_t>(below(16));
    fill(c.surfaces, below(10) == 0 ? 255 : count(), [&] { return half(); });
    c.environment = half();
    c.cellStructure = half();
    c.position = frame();
    fill(c.portals, count(), [&] { return CellPortal{half(), half(), half(), half()}; });
    fill(c.visibleCells, count(), [&] { return half(); });
    if (c.flags & EnvCell::kHasStatics)
        fill(c.statics, count(), [&] { return stab(); });
    if (c.flags & EnvCell::kHasRestriction)
        c.restriction = word();
    return c;
}

template <>
LandBlock RandomRecords::make<LandBlock>() {
    LandBlock b;
    b.id = word();
    b.hasObjects = static_cast<std::uint32_t>(below(3));
    for (auto& t : b.terrain)
        t = half();
    for (auto& h : b.heights)
        h = byte();
    b.padding = byte();
    return b;
}

Building RandomRecords::building() {
    Building b{word(), frame(), word(), {}};
    fill(b.portals, count(), [&] {
        BuildingPortal p{half(), half(), half(), {}, {}};
        fill(p.stabs, count(), [&] { return half(); });
        if (p.stabs.size() % 2 != 0 && coin())
            p.padding = {byte(), byte()};
        return p;
    });
    return b;
}

template <>
LandBlockInfo RandomRecords::make<LandBlockInfo>() {
    LandBlockInfo info;
    info.id = word();
    info.numCells = word();
    fill(info.objects, count(), [&] { return stab(); });
    fill(info.buildings, count(), [&] { return building(); });
    info.hasRestrictions = static_cast<std::uint16_t>(below(3));
    if (info.hasRestrictions != 0) {
        info.restrictionBuckets = half();
        fill(info.restrictions, count(), [&] { return std::pair{word(), word()}; });
    }
    return info;
}

GameTime RandomRecords::gameTime() {
    GameTime g;
    g.zeroTimeOfYear = std::bit_cast<double>(random_());
    g.yearSpec = text();
    fill(g.timesOfDay, count(), [&] { return TimeOfDay{number(), word(), text()}; });
    fill(g.daysOfWeek, count(), [&] { return text(); });
    fill(g.seasons, count(), [&] { return Season{word(), text()}; });
    return g;
}

DayGroup RandomRecords::dayGroup() {
    DayGroup g{number(), text(), {}, {}};
    fill(g.objects, count(), [&] {
        return SkyObject{number(), number(), number(), number(), number(), number(), word(), word(), word()};
    });
    fill(g.times, count(), [&] {
        SkyTimeOfDay t{number(), number(), number(), number(), {word()}, number(),
                       {word()}, number(), number(), {word()}, word(),   {}};
        fill(t.replaces, count(),
             [&] { return SkyObjectReplace{word(), word(), number(), number(), number(), number()}; });
        return t;
    });
    return g;
}

TexMerge RandomRecords::texMerge() {
    TexMerge m;
    const auto map = [&] { return AlphaMap{word(), word()}; };
    fill(m.corners, count(), map);
    fill(m.sides, count(), map);
    fill(m.roads, count(), map);
    fill(m.textures, count(), [&] {
        return TerrainTexture{word(), word(), word(), word(), word(), word(),
                              word(), word(), word(), word(), word()};
    });
    return m;
}

template <>
Region RandomRecords::make<Region>() {
    Region r;
    r.id = word();
    r.name = text();
    for (auto& h : r.landDefs.heights)
        h = number();
    r.gameTime = gameTime();
    r.partsMask = (coin() ? Region::kSound : 0) | (coin() ? Region::kScene : 0) |
                  (coin() ? Region::kSky : 0) | (coin() ? Region::kMisc : 0);
    if (r.partsMask & Region::kSky)
        fill(r.sky.dayGroups, count(), [&] { return dayGroup(); });
    if (r.partsMask & Region::kSound)
        fill(r.sounds, count(), [&] {
            AmbientSoundTable t{word(), {}};
            fill(t.sounds, count(), [&] {
                return AmbientSound{word(), number(), number(), number(), number()};
            });
            return t;
        });
    if (r.partsMask & Region::kScene)
        fill(r.sceneTypes, count(), [&] {
            SceneType t{word(), {}};
            fill(t.scenes, count(), [&] { return word(); });
            return t;
        });
    fill(r.terrainTypes, count(), [&] {
        TerrainType t{text(), {word()}, {}};
        fill(t.sceneTypes, count(), [&] { return word(); });
        return t;
    });
    r.texMerge = texMerge();
    if (r.partsMask & Region::kMisc)
        r.misc = {word(), word(), word(), word(), word(), word()};
    return r;
}

template <>
Scene RandomRecords::make<Scene>() {
    Scene s;
    s.id = word();
    fill(s.objects, count(), [&] {
        SceneObject o;
        o.object = word();
        o.baseLoc = frame();
        o.frequency = number();
        o.maxSlope = number();
        o.align = static_cast<std::int32_t>(word());
        o.weenieObj = word();
        return o;
    });
    return s;
}

} // namespace limen::dat
