#include "worlds/builtin/effects/Emitters.h"

#include "worlds/builtin/buildings/Inn.h"
#include "worlds/builtin/dungeon/DungeonPlaces.h"
#include "worlds/builtin/land/TerrainShape.h"
#include "worlds/builtin/people/Folk.h"
#include "worlds/builtin/people/FolkModels.h"
#include "worlds/records/Materials.h"

#include <array>
#include <fmt/format.h>

namespace limen::worlds {

namespace {

using Json = nlohmann::ordered_json;

/// The parameters of an emitter's sprites (docs/world-file.md).
struct SpriteSettings {
    Material surface = Material::Smoke;
    double rate = 6.0, life = 3.0;
    Vec3 velocity{0.0};
    double spread = 0.1;
    Vec3 acceleration{0.0};
    double radius = 0.1;
    std::array<double, 2> size{0.3, 0.6}, alpha{0.6, 0.0};
};

Json toJson(const Vec3& v) {
    const auto rounded = [](double c) { return std::round(c * 1024.0) / 1024.0; };
    return {rounded(v.x), rounded(v.y), rounded(v.z)};
}

class EmitterList {
public:
    void at(const std::string& name, const SpriteSettings& sprites, const Vec3& global, dat::RecordId cell) {
        add(name, sprites, global, cell == 0 ? "outside" : fmt::format("0x{:08X}", cell), "");
    }
    void on(const std::string& name, const SpriteSettings& sprites, const char* villager, const Vec3& local) {
        add(name, sprites, local, "outside", villager);
    }
    Json take() { return std::move(list_); }

private:
    void add(const std::string& name, const SpriteSettings& m, const Vec3& position, const std::string& cell,
             const char* villager) {
        Json json;
        json["name"] = name;
        json["surface"] = fmt::format("0x{:08X}", surfaceId(m.surface));
        json["position"] = toJson(position);
        json["cell"] = cell;
        json["attachedTo"] = villager;
        json["rate"] = m.rate;
        json["life"] = m.life;
        json["velocity"] = toJson(m.velocity);
        json["spread"] = m.spread;
        json["acceleration"] = toJson(m.acceleration);
        json["radius"] = m.radius;
        json["size"] = m.size;
        json["alpha"] = m.alpha;
        json["seed"] = list_.size() + 1;
        list_.push_back(std::move(json));
    }

    Json list_ = Json::array();
};

constexpr SpriteSettings kSmoke{Material::Smoke,     5.0,  5.0,           {0.0, 0.0, 0.9}, 0.15,
                                {0.12, 0.05, -0.05}, 0.10, {{0.35, 1.9}}, {{0.55, 0.0}}};
constexpr SpriteSettings kHearth{
    Material::Fire, 14.0, 0.7, {0.0, 0.0, 0.7}, 0.12, {0.0, 0.0, 0.3}, 0.22, {{0.34, 0.14}}, {{0.75, 0.0}}};
constexpr SpriteSettings kTorch{
    Material::Fire, 14.0, 0.6, {0.0, 0.0, 0.7}, 0.08, {0.1, 0.0, 0.4}, 0.03, {{0.26, 0.08}}, {{0.85, 0.0}}};
constexpr SpriteSettings kBrazier{Material::Fire,  9.0, 1.25,           {0.0, 0.0, 0.9}, 0.2,
                                  {0.0, 0.0, 0.3}, 0.2, {{0.26, 0.06}}, {{0.8, 0.0}}};
constexpr SpriteSettings kFireflies{
    Material::Firefly, 9.0, 6.0, {0.0, 0.0, 0.05}, 0.35, {0.0, 0.0, 0.02}, 4.5, {{0.30, 0.20}}, {{1.0, 0.0}}};
constexpr SpriteSettings kSwirl{Material::Swirl, 5.0,  2.4,          {0.0, 0.0, 0.12}, 0.05,
                                {0.0, 0.0, 0.0}, 0.18, {{0.7, 2.1}}, {{0.3, 0.0}}};
constexpr SpriteSettings kLanternGlow{
    Material::Fire, 9.0, 0.4, {0.0, 0.0, 0.25}, 0.02, {0.0, 0.0, 0.0}, 0.01, {{0.14, 0.06}}, {{0.9, 0.1}}};

Vec3 overGround(double x, double y, double height) {
    return toGlobal({192.0 + x, 192.0 + y, groundHeight(192.0 + x, 192.0 + y) + height});
}

} // namespace

Json buildEmitters(const VillageMap& map, const DungeonMap& dungeons) {
    EmitterList list;
    list.at("inn.chimney", kSmoke, globalOf(map.inn, inn::chimneyMouth()), 0);
    list.at("cottage.chimney", kSmoke, globalOf(map.cottage, {5.15, 2.5, 9.35}), 0);
    list.at("inn.hearth", kHearth, globalOf(map.inn, inn::hearthFire()),
            map.innCells.at(static_cast<std::size_t>(InnCell::Hall)));
    int count = 0;
    for (const Vec3& torch : hallTorches()) {
        // The head of the torch, in front of the hall's wall at -x.
        list.at(fmt::format("meetinghall.torch.{}", ++count), kTorch,
                globalOf(map.hall, torch + Vec3(-0.33, 0.0, 0.24)), 0);
    }
    list.at("meadow.fireflies", kFireflies, overGround(132.0, 108.0, 2.6), 0);
    list.at("orchard.fireflies", kFireflies, overGround(97.0, 80.0, 2.4), 0);
    list.at("swirl", kSwirl, overGround(134.0, 100.0, 1.4), 0);
    list.on("watchman.lantern", kLanternGlow, "watchman", kLantern);
    for (const Fire& fire : brazierFires(dungeons))
        list.at(fire.name, kBrazier, fire.position, fire.cell);
    return list.take();
}

} // namespace limen::worlds
