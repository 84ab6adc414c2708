#include "doctor/retail/CellBlock.h"
#include "doctor/retail/Judges.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace limen::doctor {
namespace {

constexpr const char* kPortalNotes = "published notes on portals";
constexpr const char* kReader = "test of a public reader against the files";
constexpr const char* kClient = "test of a public client against the files";
using CellNumbers = std::optional<Numbers>;

/// A portal as (flags, polygon, other cell, other portal).
struct CellFact {
    dat::RecordId id;
    double environment, structure;
    std::vector<Numbers> portals;
};
std::vector<CellFact> cellFacts() {
    return {{0xDA550177,
             0x0364,
             0,
             {{3, 34, 0x178, 0}, {1, 36, 0x17E, 1}, {1, 37, 0x17D, 2}, {1, 35, 0x17B, 1}, {1, 33, 0x179, 0}}},
            {0xDA550178, 0x0364, 1, {{1, 7, 0x177, 0}, {7, 6, 0xFFFF, 0xFFFF}}}};
}

void judgeNamedCells(const dat::Archive& archive, Ledger& ledger) {
    for (const CellFact& fact : cellFacts()) {
        const auto cell = archive.load<dat::EnvCell>(fact.id);
        const std::string prefix = fmt::format("cell.{:08X}.", fact.id);
        ledger.judgeRecord(cell,
                           Fact{prefix + "shape", kPortalNotes, {fact.environment, fact.structure}}.hex(),
                           [](const dat::EnvCell& c) {
                               return someNumbers({static_cast<double>(c.environment),
                                                   static_cast<double>(c.cellStructure)});
                           });
        ledger.judgeRecord(
            cell, Fact{prefix + "portals", kPortalNotes, {static_cast<double>(fact.portals.size())}},
            [](const dat::EnvCell& c) { return someNumbers({static_cast<double>(c.portals.size())}); });
        for (std::size_t i = 0; i < fact.portals.size(); ++i)
            ledger.judgeRecord(
                cell, Fact{fmt::format("{}portal{}", prefix, i), kPortalNotes, fact.portals[i]}.hex(),
                [i](const dat::EnvCell& c) -> CellNumbers {
                    if (i >= c.portals.size())
                        return std::nullopt;
                    const dat::CellPortal& p = c.portals[i];
                    return Numbers{static_cast<double>(p.flags), static_cast<double>(p.polygonId),
                                   static_cast<double>(p.otherCellId), static_cast<double>(p.otherPortalId)};
                });
    }
}

const dat::CellStruct* shapeOf(const dat::Environment& environment, std::uint32_t key) {
    const auto found = std::find_if(environment.cells.begin(), environment.cells.end(),
                                    [&](const auto& shape) { return shape.first == key; });
    return found != environment.cells.end() ? &found->second : nullptr;
}
const dat::Polygon* polygonOf(const dat::CellStruct& shape, std::uint16_t id) {
    const auto found = std::find_if(shape.polygons.begin(), shape.polygons.end(),
                                    [&](const auto& polygon) { return polygon.first == id; });
    return found != shape.polygons.end() ? &found->second : nullptr;
}

/// A polygon of a shape: stippling, sides, surface.
struct PolygonFact {
    std::uint32_t shape;
    std::uint16_t polygon;
    Numbers values;
};

void judgeShapes(const dat::Archive& archive, Ledger& ledger) {
    const auto environment = archive.load<dat::Environment>(0x0D000364);
    const std::array<Numbers, 2> portals{{{34, 36, 37, 35, 33}, {7, 6}}};
    for (std::uint32_t key = 0; key < portals.size(); ++key)
        ledger.judgeRecord(environment,
                           Fact{fmt::format("cell.0D000364.{}.portals", key), kPortalNotes, portals[key]},
                           [key](const dat::Environment& e) -> CellNumbers {
                               const dat::CellStruct* shape = shapeOf(e, key);
                               if (shape == nullptr)
                                   return std::nullopt;
                               return Numbers(shape->portalPolygons.begin(), shape->portalPolygons.end());
                           });
    std::vector<PolygonFact> polygons{{1, 6, {4, 0, 10}}, {1, 7, {4, 0, 9}}};
    for (std::uint16_t id = 33; id <= 37; ++id)
        polygons.push_back({0, id, {4, 0, 9}});
    for (const PolygonFact& fact : polygons)
        ledger.judgeRecord(environment,
                           Fact{fmt::format("cell.0D000364.{}.polygon{}", fact.shape, fact.polygon),
                                kPortalNotes, fact.values},
                           [&](const dat::Environment& e) -> CellNumbers {
                               const dat::CellStruct* shape = shapeOf(e, fact.shape);
                               const dat::Polygon* polygon =
                                   shape ? polygonOf(*shape, fact.polygon) : nullptr;
                               if (polygon == nullptr)
                                   return std::nullopt;
                               // The second shape's notes name no sides.
                               const double sides = fact.shape == 0 ? polygon->sides : 0;
                               return Numbers{static_cast<double>(polygon->stippling), sides,
                                              static_cast<double>(polygon->posSurface)};
                           });
}

/// Tag and plane distance of a tree's root.
CellNumbers rootOf(const dat::BspTree& tree) {
    if (tree.nodes.empty())
        return std::nullopt;
    return Numbers{static_cast<double>(tree.nodes.front().tag), tree.nodes.front().plane.d};
}

void judgeSample(const dat::Archive& archive, Ledger& ledger) {
    const auto environment = archive.load<dat::Environment>(0x0D00062E);
    const auto line = [&](const char* name, Numbers expected, double tolerance, auto&& read) {
        ledger.judgeRecord(
            environment,
            Fact{std::string("cell.0D00062E.") + name, kReader, std::move(expected)}.within(tolerance),
            [&](const dat::Environment& e) -> CellNumbers {
                if (e.cells.empty())
                    return std::nullopt;
                return read(e.cells.front().second);
            });
    };
    ledger.judgeRecord(
        environment, Fact{"cell.0D00062E.shapes", kReader, {1}},
        [](const dat::Environment& e) { return someNumbers({static_cast<double>(e.cells.size())}); });
    line("vertices", {8}, 0, [](const dat::CellStruct& s) {
        return someNumbers({static_cast<double>(s.vertexArray.vertices.size())});
    });
    line("vertex0", {4, -0.6, 1.8}, 1e-4, [](const dat::CellStruct& s) -> CellNumbers {
        if (s.vertexArray.vertices.empty())
            return std::nullopt;
        const Vec3f& p = s.vertexArray.vertices.front().second.position;
        return Numbers{p.x, p.y, p.z};
    });
    line("polygons", {6}, 0,
         [](const dat::CellStruct& s) { return someNumbers({static_cast<double>(s.polygons.size())}); });
    line("polygon0", {4, 0, 0, -1, 0, 1, 2, 3}, 0, [](const dat::CellStruct& s) -> CellNumbers {
        if (s.polygons.empty())
            return std::nullopt;
        const dat::Polygon& p = s.polygons.front().second;
        Numbers found{static_cast<double>(p.stippling), static_cast<double>(p.sides),
                      static_cast<double>(p.posSurface), static_cast<double>(p.negSurface)};
        for (const std::uint16_t key : p.vertexKeys)
            found.push_back(key);
        return found;
    });
    const auto tag = [](dat::BspTag t) { return static_cast<double>(t); };
    line("cellTree", {tag(dat::BspTag::BPnn), -1.8}, 1e-4,
         [](const dat::CellStruct& s) { return rootOf(s.cellBsp); });
    line("physicsTree", {tag(dat::BspTag::BPnN), 1.8}, 1e-4,
         [](const dat::CellStruct& s) { return rootOf(s.physicsBsp); });
    line("drawingTree", {tag(dat::BspTag::BPIn), -1.8}, 1e-4,
         [](const dat::CellStruct& s) { return s.drawingBsp ? rootOf(*s.drawingBsp) : std::nullopt; });
}

void judgeAcademy(const dat::Archive& archive, Ledger& ledger) {
    for (const std::uint32_t word : {0x7F03u, 0x8602u, 0x8C04u}) {
        const CellBlock block = readCellBlock(archive, word);
        const auto line = [&](const char* name, Numbers expected, double found) {
            ledger.judge(
                Fact{fmt::format("cell.academy.{:04X}.{}", word, name), kClient, std::move(expected)},
                block.cells > 0 ? std::optional(Numbers{found}) : std::nullopt);
        };
        line("cells", {568}, block.cells);
        line("portalsOutdoors", {0}, block.portalsOutdoors);
        line("untextured", {1372}, block.untextured);
        line("untexturedThatAreNoPortals", {0}, block.untexturedThatAreNoPortals);
    }
}

void judgeHoltburg(const dat::Archive& archive, Ledger& ledger) {
    const auto info = archive.load<dat::LandBlockInfo>(0xA9B4FFFE);
    const CellBlock block = readCellBlock(archive, 0xA9B4);
    ledger.judgeRecord(info, Fact{"cell.A9B4.buildingsWithPortals", kClient, {7}}.by(Rule::AtLeast),
                       [](const dat::LandBlockInfo& i) {
                           return someNumbers({static_cast<double>(
                               std::count_if(i.buildings.begin(), i.buildings.end(),
                                             [](const dat::Building& b) { return !b.portals.empty(); }))});
                       });
    ledger.judgeRecord(
        info, Fact{"cell.A9B4.cottages", kClient, {1}}.by(Rule::AtLeast), [](const dat::LandBlockInfo& i) {
            return someNumbers(
                {static_cast<double>(std::count_if(i.buildings.begin(), i.buildings.end(),
                                                   [](const auto& b) { return b.model == 0x01000830u; }))});
        });
    ledger.judgeRecord(info, Fact{"cell.A9B4.objects", kClient, {114}}, [](const dat::LandBlockInfo& i) {
        return someNumbers({static_cast<double>(i.objects.size())});
    });
    ledger.judge(Fact{"cell.A9B4.roomThings", kClient, {405}},
                 block.cells > 0 ? std::optional(Numbers{block.things}) : std::nullopt);
    ledger.judgeRecord(info, Fact{"cell.A9B4.allThings", kClient, {519}}, [&](const dat::LandBlockInfo& i) {
        return someNumbers({static_cast<double>(i.objects.size()) + block.things});
    });
}

void judgeThings(const dat::Archive& archive, Ledger& ledger) {
    const auto cell = archive.load<dat::EnvCell>(0x860201AD);
    const auto has = [](const dat::EnvCell& c, auto&& test) {
        return someNumbers({std::any_of(c.statics.begin(), c.statics.end(), test) ? 1.0 : 0.0});
    };
    ledger.judgeRecord(cell, Fact{"cell.860201AD.things", kClient, {30}}, [](const dat::EnvCell& c) {
        return someNumbers({static_cast<double>(c.statics.size())});
    });
    ledger.judgeRecord(cell, Fact{"cell.860201AD.marker", kClient, {1}}, [&](const dat::EnvCell& c) {
        return has(c, [](const dat::Stab& stab) {
            return stab.model == 0x02000C39u &&
                   glm::length(stab.frame.origin - Vec3f(12.3199f, -28.482f, 0.0f)) < 0.01f;
        });
    });
    ledger.judgeRecord(cell, Fact{"cell.860201AD.other", kClient, {1}}, [&](const dat::EnvCell& c) {
        return has(c, [](const dat::Stab& stab) { return stab.model == 0x02000943u; });
    });
}

} // namespace

void judgeCells(const dat::Archive& archive, Ledger& ledger) {
    judgeNamedCells(archive, ledger);
    judgeShapes(archive, ledger);
    judgeSample(archive, ledger);
    judgeAcademy(archive, ledger);
    judgeHoltburg(archive, ledger);
    judgeThings(archive, ledger);
}

} // namespace limen::doctor
