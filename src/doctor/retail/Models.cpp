#include "doctor/retail/Judges.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace limen::doctor {
namespace {

constexpr const char* kLevels = "test of a public client against the files";
constexpr const char* kNamed = "named record in a public note";
constexpr dat::RecordId kLevelRecord = 0x11000000;
constexpr dat::RecordId kBody = 0x02000001;

struct LevelFact {
    double gfxObj, least, ideal, most;
};
constexpr std::array<LevelFact, 3> kLevelFacts{
    {{0x01003769, 10, 25, 50}, {0x0100376E, 25, 50, 100}, {0x0100376F, 50, 100, 200}}};

void judgeLevels(const dat::Archive& archive, Ledger& ledger) {
    const auto record = archive.load<dat::DegradeInfo>(kLevelRecord);
    const auto line = [&](const std::string& name, Numbers expected, Notation notation, auto&& read) {
        ledger.judgeRecord(record,
                           {fmt::format("model.{:08X}.{}", kLevelRecord, name), kLevels, std::move(expected),
                            Rule::Equal, 0.0, notation},
                           read);
    };
    line("levels", {4}, Notation::Decimal, [](const dat::DegradeInfo& info) {
        return std::optional(Numbers{static_cast<double>(info.levels.size())});
    });
    Numbers meshes;
    for (const LevelFact& fact : kLevelFacts)
        meshes.push_back(fact.gfxObj);
    meshes.push_back(0);
    line("meshes", meshes, Notation::Hex, [](const dat::DegradeInfo& info) {
        Numbers found;
        for (const dat::DegradeLevel& level : info.levels)
            found.push_back(level.gfxObj);
        return std::optional(found);
    });
    for (std::size_t i = 0; i < kLevelFacts.size(); ++i) {
        const LevelFact& fact = kLevelFacts[i];
        line(fmt::format("level{}", i), {fact.least, fact.ideal, fact.most}, Notation::Decimal,
             [i](const dat::DegradeInfo& info) -> std::optional<Numbers> {
                 if (i >= info.levels.size())
                     return std::nullopt;
                 const dat::DegradeLevel& level = info.levels[i];
                 return Numbers{level.minDistance, level.idealDistance, level.maxDistance};
             });
    }
}

/// Each marker's level 0 is the object itself, with all three distances 0.
void judgeMarkers(const dat::Archive& archive, Ledger& ledger) {
    for (const dat::RecordId marker : markers()) {
        ledger.judgeRecord(archive.load<dat::GfxObj>(marker),
                           Fact{fmt::format("model.{:08X}.neverDrawn", marker),
                                kLevels,
                                {static_cast<double>(marker), 0, 0, 0}}
                               .hex(),
                           [&](const dat::GfxObj& object) -> std::optional<Numbers> {
                               const auto info = archive.load<dat::DegradeInfo>(object.degradeId);
                               if (!info || info->levels.empty())
                                   return std::nullopt;
                               const dat::DegradeLevel& level = info->levels.front();
                               return Numbers{static_cast<double>(level.gfxObj), level.minDistance,
                                              level.idealDistance, level.maxDistance};
                           });
    }
}

/// The number of parts whose level 0 is another mesh.
double denserParts(const dat::Archive& archive, const dat::Setup& setup) {
    return static_cast<double>(std::count_if(setup.parts.begin(), setup.parts.end(), [&](dat::RecordId part) {
        const auto object = archive.load<dat::GfxObj>(part);
        if (!object || object->degradeId == 0)
            return false;
        const auto info = archive.load<dat::DegradeInfo>(object->degradeId);
        return info && !info->levels.empty() && info->levels.front().gfxObj != part;
    }));
}

void judgeSetups(const dat::Archive& archive, Ledger& ledger) {
    const auto body = archive.load<dat::Setup>(kBody);
    ledger.judgeRecord(body, {"model.02000001.parts", kLevels, {34}}, [](const dat::Setup& setup) {
        return std::optional(Numbers{static_cast<double>(setup.parts.size())});
    });
    ledger.judgeRecord(body, {"model.02000001.denserParts", kLevels, {16}}, [&](const dat::Setup& setup) {
        return std::optional(Numbers{denserParts(archive, setup)});
    });
    for (const dat::RecordId id : {0x02000588u, 0x02000589u, 0x02000BA6u})
        ledger.judgeRecord(archive.load<dat::Setup>(id),
                           Fact{fmt::format("model.{:08X}.parts", id), kNamed, {0x010001EC}}.hex(),
                           [](const dat::Setup& setup) {
                               return std::optional(Numbers(setup.parts.begin(), setup.parts.end()));
                           });
    ledger.judgeRecord(archive.load<dat::Setup>(0x02000C39), Fact{"model.02000C39.markerPart", kLevels, {1}},
                       [](const dat::Setup& setup) {
                           const bool has = std::find(setup.parts.begin(), setup.parts.end(), 0x010028CAu) !=
                                            setup.parts.end();
                           return std::optional(Numbers{has ? 1.0 : 0.0});
                       });
}

struct LampFact {
    dat::RecordId setup;
    double rgb;
    std::optional<double> intensity;
};

void judgeLamps(const dat::Archive& archive, Ledger& ledger) {
    for (const LampFact& fact : {LampFact{0x020001B3, 0xC800C8, {}}, LampFact{0x020005D9, 0xFF9650, 100.0}}) {
        const auto setup = archive.load<dat::Setup>(fact.setup);
        ledger.judgeRecord(
            setup, Fact{fmt::format("model.{:08X}.lampColour", fact.setup), kNamed, {fact.rgb}}.hex(),
            [](const dat::Setup& s) -> std::optional<Numbers> {
                if (s.lights.empty())
                    return std::nullopt;
                return Numbers{static_cast<double>(s.lights.front().second.colour.argb & 0xFFFFFFu)};
            });
        if (fact.intensity)
            ledger.judgeRecord(
                setup,
                Fact{fmt::format("model.{:08X}.lampIntensity", fact.setup), kNamed, {*fact.intensity}}.within(
                    0.001),
                [](const dat::Setup& s) -> std::optional<Numbers> {
                    if (s.lights.empty())
                        return std::nullopt;
                    return Numbers{s.lights.front().second.intensity};
                });
    }
}

double openingsOf(const dat::GfxObj& object) {
    double count = 0;
    for (const dat::BspNode& node : object.drawingBsp.nodes)
        count += static_cast<double>(node.portals.size());
    return count;
}

void judgeMeshes(const dat::Archive& archive, Ledger& ledger) {
    const auto openings = [](const dat::GfxObj& object) {
        return std::optional(Numbers{openingsOf(object)});
    };
    ledger.judgeRecord(archive.load<dat::GfxObj>(0x01000830),
                       Fact{"model.01000830.openings", kLevels, {1}}.by(Rule::AtLeast), openings);
    ledger.judgeRecord(archive.load<dat::GfxObj>(0x01000907), Fact{"model.01000907.openings", kLevels, {0}},
                       openings);
    const auto centre = [](const dat::GfxObj& object) {
        return std::optional(Numbers{object.sortCenter.x, object.sortCenter.y, object.sortCenter.z});
    };
    ledger.judgeRecord(archive.load<dat::GfxObj>(0x01001348),
                       Fact{"model.01001348.sortCentre", kNamed, {1050, 0, 0}}.within(0.01), centre);
    ledger.judgeRecord(archive.load<dat::GfxObj>(0x01001F6A),
                       Fact{"model.01001F6A.sortCentre", kNamed, {2066.82, 552.99, 0}}.within(0.01), centre);
    for (const dat::RecordId id : {0x01004C42u, 0x01004C44u}) {
        const auto rain = archive.load<dat::GfxObj>(id);
        ledger.judgeRecord(rain, Fact{fmt::format("model.{:08X}.polygons", id), kNamed, {8}},
                           [](const dat::GfxObj& object) {
                               return std::optional(Numbers{static_cast<double>(object.polygons.size())});
                           });
        ledger.judgeRecord(rain, Fact{fmt::format("model.{:08X}.surfaces", id), kNamed, {0x080000C5}}.hex(),
                           [](const dat::GfxObj& object) {
                               return std::optional(Numbers(object.surfaces.begin(), object.surfaces.end()));
                           });
    }
}

} // namespace

void judgeModels(const dat::Archive& archive, Ledger& ledger) {
    judgeLevels(archive, ledger);
    judgeMarkers(archive, ledger);
    judgeSetups(archive, ledger);
    judgeLamps(archive, ledger);
    judgeMeshes(archive, ledger);
}

} // namespace limen::doctor
