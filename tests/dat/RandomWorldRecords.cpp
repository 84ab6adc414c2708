#include "dat/RandomRecords.h"

// Records of models, cells and land.
namespace limen::dat {

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
