#include "dat/Describe.h"
#include "dat/describe/Json.h"

namespace limen::dat {
namespace {

Json landDefs(const LandDefs& l) {
    return {{"blocks_north_south", l.numBlockLength},
            {"blocks_east_west", l.numBlockWidth},
            {"square_length", number(l.squareLength)},
            {"squares_per_block", l.lblockLength},
            {"vertex_per_cell", l.vertexPerCell},
            {"max_object_height", number(l.maxObjHeight)},
            {"sky_height", number(l.skyHeight)},
            {"road_width", number(l.roadWidth)},
            {"heights", listOf(l.heights, [](float h) { return number(h); })}};
}

Json gameTime(const GameTime& g) {
    return {
        {"zero_time_of_year", number(g.zeroTimeOfYear)},
        {"zero_year", g.zeroYear},
        {"day_length", number(g.dayLength)},
        {"days_per_year", g.daysPerYear},
        {"year_spec", text(g.yearSpec)},
        {"times_of_day",
         listOf(
             g.timesOfDay,
             [](const TimeOfDay& t) {
                 return Json{{"start", number(t.start)}, {"night", t.isNight != 0}, {"name", text(t.name)}};
             })},
        {"days_of_week", listOf(g.daysOfWeek, text)},
        {"seasons", listOf(g.seasons, [](const Season& s) {
             return Json{{"start_day", s.startDay}, {"name", text(s.name)}};
         })}};
}

Json skyObject(const SkyObject& o) {
    return {{"begin_time", number(o.beginTime)},
            {"end_time", number(o.endTime)},
            {"begin_angle", number(o.beginAngle)},
            {"end_angle", number(o.endAngle)},
            {"tex_velocity", Json::array({number(o.texVelocityX), number(o.texVelocityY)})},
            {"object", hexId(o.object)},
            {"script", hexId(o.script)},
            {"properties", o.properties}};
}

Json skyTime(const SkyTimeOfDay& t) {
    return {{"begin", number(t.begin)},
            {"dir_bright", number(t.dirBright)},
            {"dir_heading", number(t.dirHeading)},
            {"dir_pitch", number(t.dirPitch)},
            {"dir_colour", json(t.dirColour)},
            {"amb_bright", number(t.ambBright)},
            {"amb_colour", json(t.ambColour)},
            {"min_fog", number(t.minFog)},
            {"max_fog", number(t.maxFog)},
            {"fog_colour", json(t.fogColour)},
            {"fog_mode", t.fogMode},
            {"replaces", listOf(t.replaces, [](const SkyObjectReplace& r) {
                 return Json{{"object_index", r.objectIndex},      {"gfx_obj", hexId(r.gfxObj)},
                             {"rotate", number(r.rotate)},         {"transparent", number(r.transparent)},
                             {"luminosity", number(r.luminosity)}, {"max_bright", number(r.maxBright)}};
             })}};
}

Json sky(const SkyDesc& s) {
    return {{"tick_size", number(s.tickSize)},
            {"light_tick_size", number(s.lightTickSize)},
            {"day_groups", listOf(s.dayGroups, [](const DayGroup& g) {
                 return Json{{"chance", number(g.chance)},
                             {"name", text(g.name)},
                             {"objects", listOf(g.objects, skyObject)},
                             {"times", listOf(g.times, skyTime)}};
             })}};
}

Json soundTable(const AmbientSoundTable& t) {
    return {{"sound_table", hexId(t.soundTable)}, {"sounds", listOf(t.sounds, [](const AmbientSound& s) {
                                                       return Json{{"type", s.soundType},
                                                                   {"volume", number(s.volume)},
                                                                   {"chance", number(s.chance)},
                                                                   {"min_rate", number(s.minRate)},
                                                                   {"max_rate", number(s.maxRate)}};
                                                   })}};
}

Json alphaMaps(const std::vector<AlphaMap>& maps) {
    return listOf(maps, [](const AlphaMap& m) {
        return Json{{"code", m.code}, {"texture", hexId(m.texture)}};
    });
}

Json terrainTexture(const TerrainTexture& t) {
    return {{"terrain_type", t.terrainType},
            {"texture", hexId(t.texture)},
            {"tiling", t.tiling},
            {"bright", Json::array({t.minBright, t.maxBright})},
            {"saturate", Json::array({t.minSaturate, t.maxSaturate})},
            {"hue", Json::array({t.minHue, t.maxHue})},
            {"detail_tiling", t.detailTiling},
            {"detail_texture", hexId(t.detailTexture)}};
}

Json misc(const RegionMisc& m) {
    return {{"version", m.version},
            {"game_map", hexId(m.gameMap)},
            {"autotest_map", hexId(m.autotestMap)},
            {"autotest_map_size", m.autotestMapSize},
            {"clear_cell", hexId(m.clearCell)},
            {"clear_monster", hexId(m.clearMonster)}};
}

Json numbers(const std::vector<std::uint32_t>& list) {
    return listOf(list, [](std::uint32_t i) { return Json(i); });
}

} // namespace

std::string describe(const Region& r) {
    Json out = {{"kind", "Region"},
                {"id", hexId(r.id)},
                {"region_number", r.regionNumber},
                {"version", r.version},
                {"name", text(r.name)},
                {"land", landDefs(r.landDefs)},
                {"time", gameTime(r.gameTime)},
                {"parts_mask", r.partsMask}};
    if (r.partsMask & Region::kSky)
        out["sky"] = sky(r.sky);
    if (r.partsMask & Region::kSound)
        out["sounds"] = listOf(r.sounds, soundTable);
    if (r.partsMask & Region::kScene)
        out["scene_types"] = listOf(r.sceneTypes, [](const SceneType& t) {
            return Json{{"ambient_sound", t.ambientSound}, {"scenes", hexIds(t.scenes)}};
        });
    out["terrain_types"] = listOf(r.terrainTypes, [](const TerrainType& t) {
        return Json{
            {"name", text(t.name)}, {"colour", json(t.colour)}, {"scene_types", numbers(t.sceneTypes)}};
    });
    const TexMerge& merge = r.texMerge;
    out["base_texture_size"] = merge.baseTexSize;
    out["corner_maps"] = alphaMaps(merge.corners);
    out["side_maps"] = alphaMaps(merge.sides);
    out["road_maps"] = alphaMaps(merge.roads);
    out["terrain_textures"] = listOf(merge.textures, terrainTexture);
    if (r.partsMask & Region::kMisc)
        out["misc"] = misc(r.misc);
    return pretty(out);
}

std::string describe(const Scene& s) {
    return pretty({{"kind", "Scene"},
                   {"id", hexId(s.id)},
                   {"objects", listOf(s.objects, [](const SceneObject& o) {
                        return Json{{"object", hexId(o.object)},
                                    {"base", json(o.baseLoc)},
                                    {"frequency", number(o.frequency)},
                                    {"displace", Json::array({number(o.displaceX), number(o.displaceY)})},
                                    {"scale", Json::array({number(o.minScale), number(o.maxScale)})},
                                    {"max_rotation", number(o.maxRotation)},
                                    {"slope", Json::array({number(o.minSlope), number(o.maxSlope)})},
                                    {"align", o.align},
                                    {"orient", o.orient},
                                    {"weenie", hexId(o.weenieObj)}};
                    })}});
}

} // namespace limen::dat
