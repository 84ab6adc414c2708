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
                                      4, 4, 4, 0,  4, 8, 12, 16, 12, 8,  12, 4,  40};

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
    if (out.type == 5) // u8 part, a packed id of 2 or 4 bytes, padding
        out.payload = coin() ? std::vector<std::uint8_t>{1, 0x34, 0x12, 0}
                             : std::vector<std::uint8_t>{1, 0x01, 0x80, 0x78, 0x56, 0, 0, 0};
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

} // namespace limen::dat
