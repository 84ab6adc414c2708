#include "dat/codec/Layout.h"

#include <initializer_list>

namespace limen::dat {
namespace {

constexpr std::size_t kSkyObjectBytes = 36;
constexpr std::size_t kReplaceBytes = 24;
constexpr std::size_t kMinSkyTimeBytes = 48;
constexpr std::size_t kSoundBytes = 20;
constexpr std::size_t kTerrainTextureBytes = 44;
constexpr std::size_t kMinTextBytes = 4;

/// Reads or writes consecutive values.
template <class IO, class... T>
void row(IO& io, T&... fields) {
    (io.value(fields), ...);
}

template <class IO, class L>
void landDefs(IO& io, L& l) {
    row(io, l.numBlockLength, l.numBlockWidth, l.squareLength, l.lblockLength, l.vertexPerCell);
    row(io, l.maxObjHeight, l.skyHeight, l.roadWidth);
    for (auto& height : l.heights)
        io.value(height);
}

template <class IO, class G>
void gameTime(IO& io, G& g) {
    row(io, g.zeroTimeOfYear, g.zeroYear, g.dayLength, g.daysPerYear);
    io.text(g.yearSpec);
    io.template list<std::uint32_t>(g.timesOfDay, 8 + kMinTextBytes, "times of day", [&](auto& t) {
        row(io, t.start, t.isNight);
        io.text(t.name);
    });
    io.template list<std::uint32_t>(g.daysOfWeek, kMinTextBytes, "days of the week",
                                    [&](auto& day) { io.text(day); });
    io.template list<std::uint32_t>(g.seasons, 4 + kMinTextBytes, "seasons", [&](auto& s) {
        io.value(s.startDay);
        io.text(s.name);
    });
}

template <class IO, class T>
void skyTime(IO& io, T& t) {
    row(io, t.begin, t.dirBright, t.dirHeading, t.dirPitch);
    colour(io, t.dirColour);
    io.value(t.ambBright);
    colour(io, t.ambColour);
    row(io, t.minFog, t.maxFog);
    colour(io, t.fogColour);
    io.value(t.fogMode);
    io.template list<std::uint32_t>(t.replaces, kReplaceBytes, "sky object changes", [&](auto& r) {
        row(io, r.objectIndex, r.gfxObj, r.rotate, r.transparent, r.luminosity, r.maxBright);
    });
}

template <class IO, class G>
void dayGroup(IO& io, G& g) {
    io.value(g.chance);
    io.text(g.name);
    io.template list<std::uint32_t>(g.objects, kSkyObjectBytes, "sky objects", [&](auto& o) {
        row(io, o.beginTime, o.endTime, o.beginAngle, o.endAngle, o.texVelocityX, o.texVelocityY);
        row(io, o.object, o.script, o.properties);
    });
    io.template list<std::uint32_t>(g.times, kMinSkyTimeBytes, "sky times", [&](auto& t) { skyTime(io, t); });
}

template <class IO, class S>
void sky(IO& io, S& s) {
    row(io, s.tickSize, s.lightTickSize);
    io.template list<std::uint32_t>(s.dayGroups, 12 + kMinTextBytes, "day groups",
                                    [&](auto& g) { dayGroup(io, g); });
}

template <class IO, class S>
void sounds(IO& io, S& tables) {
    io.template list<std::uint32_t>(tables, 8, "sound tables", [&](auto& table) {
        io.value(table.soundTable);
        io.template list<std::uint32_t>(table.sounds, kSoundBytes, "ambient sounds", [&](auto& s) {
            row(io, s.soundType, s.volume, s.chance, s.minRate, s.maxRate);
        });
    });
}

template <class IO, class S>
void sceneTypes(IO& io, S& types) {
    io.template list<std::uint32_t>(types, 8, "scene types", [&](auto& type) {
        io.value(type.ambientSound);
        values<std::uint32_t>(io, type.scenes, "scenes");
    });
}

template <class IO, class T>
void terrainTypes(IO& io, T& types) {
    io.template list<std::uint32_t>(types, kMinTextBytes + 8, "terrain types", [&](auto& type) {
        io.text(type.name);
        colour(io, type.colour);
        values<std::uint32_t>(io, type.sceneTypes, "scene types");
    });
}

template <class IO, class M>
void alphaMaps(IO& io, M& maps, const char* what) {
    io.template list<std::uint32_t>(maps, 8, what, [&](auto& map) { row(io, map.code, map.texture); });
}

template <class IO, class T>
void texMerge(IO& io, T& merge) {
    io.value(merge.baseTexSize);
    alphaMaps(io, merge.corners, "corner maps");
    alphaMaps(io, merge.sides, "side maps");
    alphaMaps(io, merge.roads, "road maps");
    io.template list<std::uint32_t>(merge.textures, kTerrainTextureBytes, "terrain textures", [&](auto& t) {
        row(io, t.terrainType, t.texture, t.tiling, t.maxBright, t.minBright, t.maxSaturate, t.minSaturate);
        row(io, t.maxHue, t.minHue, t.detailTiling, t.detailTexture);
    });
}

/// Only texture merging (0) has a known layout.
void landSurfType(ByteReader& io, std::uint32_t& type) {
    io.value(type);
    if (type != 0 && !io.failed()) {
        io.failAt(io.offset() - sizeof type,
                  fmt::format("land surfaces of type {} (palette shift) are not supported", type),
                  ErrorCode::Unsupported);
    }
}
void landSurfType(ByteWriter& io, const std::uint32_t& type) {
    io.require(type == 0, "only texture merging has a known layout");
    io.value(type);
}

template <class IO, class R>
void region(IO& io, RecordId key, R& r) {
    ownId(io, key, r.id);
    row(io, r.regionNumber, r.version);
    io.text(r.name);
    landDefs(io, r.landDefs);
    gameTime(io, r.gameTime);
    io.value(r.partsMask);
    if (r.partsMask & Region::kSky)
        sky(io, r.sky);
    if (r.partsMask & Region::kSound)
        sounds(io, r.sounds);
    if (r.partsMask & Region::kScene)
        sceneTypes(io, r.sceneTypes);
    terrainTypes(io, r.terrainTypes);
    landSurfType(io, r.landSurfType);
    texMerge(io, r.texMerge);
    if (r.partsMask & Region::kMisc) {
        auto& m = r.misc;
        row(io, m.version, m.gameMap, m.autotestMap, m.autotestMapSize, m.clearCell, m.clearMonster);
    }
}

constexpr std::size_t kSceneObjectBytes = 4 + kFrameBytes + 11 * 4;

template <class IO, class S>
void scene(IO& io, RecordId key, S& s) {
    ownId(io, key, s.id);
    io.template list<std::uint32_t>(s.objects, kSceneObjectBytes, "scene objects", [&](auto& o) {
        io.value(o.object);
        frame(io, o.baseLoc);
        row(io, o.frequency, o.displaceX, o.displaceY, o.minScale, o.maxScale, o.maxRotation);
        row(io, o.minSlope, o.maxSlope, o.align, o.orient, o.weenieObj);
    });
}

} // namespace

template <>
Result<Region> decode<Region>(RecordId id, ByteView payload) {
    return decodeWith<Region>(id, payload, [&](ByteReader& io, Region& r) { region(io, id, r); });
}
template <>
Result<Bytes> encode<Region>(const Region& r) {
    ByteWriter io;
    io.require((r.partsMask & Region::kSky) || r.sky.dayGroups.empty(), "a sky needs kSky");
    io.require((r.partsMask & Region::kSound) || r.sounds.empty(), "sounds need kSound");
    io.require((r.partsMask & Region::kScene) || r.sceneTypes.empty(), "scene types need kScene");
    region(io, r.id, r);
    return io.take(r.id);
}

template <>
Result<Scene> decode<Scene>(RecordId id, ByteView payload) {
    return decodeWith<Scene>(id, payload, [&](ByteReader& io, Scene& s) { scene(io, id, s); });
}
template <>
Result<Bytes> encode<Scene>(const Scene& s) {
    ByteWriter io;
    scene(io, s.id, s);
    return io.take(s.id);
}

} // namespace limen::dat
