#include "worlds/builtin/land/RegionBuilder.h"
#include "worlds/generate/CellPlaces.h"
#include "worlds/generate/ComplexOpenings.h"
#include "worlds/generate/GeneratedKinds.h"
#include "worlds/generate/Land.h"
#include "worlds/generate/Props.h"
#include "worlds/generate/SmallPictures.h"
#include "worlds/records/LandblockWriter.h"
#include "worlds/shapes/Shell.h"
#include "worlds/shapes/SolidCutter.h"

#include <cmath>
#include <numeric>

namespace limen::worlds {

namespace {

constexpr dat::BlockCoord kBlock{0x30, 0x40};
constexpr double kVolume = 60.0; ///< mean volume of a cell, cubic metres
constexpr double kLeastRadius = 0.12;
constexpr int kComplexGround = 40;

OpeningMix mixOf(Random& random) {
    OpeningMix mix;
    mix.inexact = random.chance(0.25) ? 0.3 : 0.0;
    mix.reversed = random.chance(0.5) ? 0.5 : 0.0;
    mix.twins = random.chance(0.3) ? 0.5 : 0.12;
    mix.toGround = random.chance(0.34);
    return mix;
}

/// The cells that are connected so far (union-find).
class Islands {
public:
    explicit Islands(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }
    /// False if they were connected before.
    bool join(std::uint32_t a, std::uint32_t b) {
        a = root(a);
        b = root(b);
        parent_[std::max(a, b)] = std::min(a, b);
        return a != b;
    }

private:
    std::uint32_t root(std::uint32_t i) {
        while (parent_[i] != i)
            i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    std::vector<std::uint32_t> parent_;
};

Material materialOf(const Polygon& points, Random& random) {
    const double up = planeOf(points).n.z;
    if (up > 0.7)
        return random.chance(0.5) ? Material::Flagstones : Material::Planks;
    constexpr std::array kWalls{Material::StoneWall, Material::Brick, Material::InnerPlaster,
                                Material::Rock,      Material::Rug,   Material::Beam};
    return kWalls[random.below(kWalls.size())];
}

/// True for one of the two faces of an opening. Two things at one place would fight for depth.
bool isOurs(const Face& face) {
    const Vec3 n = planeOf(face.points).n;
    return n.x != 0.0 ? n.x > 0.0 : n.y != 0.0 ? n.y > 0.0 : n.z > 0.0;
}

/// Gives some openings pictures: closed doors, leaves, panes. A generator of its own, so that the other worlds
/// of a kind stay as they are.
class Hangings {
public:
    explicit Hangings(std::uint64_t seed) : random_(seed) { share_ = random_.chance(0.4) ? 0.5 : 0.0; }

    void hang(std::vector<Face>& faces) {
        for (Face& face : faces)
            if (face.portal && isOurs(face) && random_.chance(share_))
                face = pictured(face.points);
    }

private:
    Face pictured(const Polygon& points) {
        constexpr std::array kPictures{Material::OldPlanks, Material::Leaves, Material::Glass};
        Face face = planarFace(points, kPictures[random_.below(kPictures.size())]);
        face.portal = face.pictured = true;
        face.twoSided = random_.chance(0.3);
        return face;
    }

    Random random_;
    double share_ = 0.0;
};

class ComplexBuilder {
public:
    ComplexBuilder(const Props& props, const OpeningMix& mix, Random random, const Hangings& hangings)
        : props_(props), mix_(mix), random_(random), hangings_(hangings) {}

    /// The box's floor is z = 0; the plan's origin is its middle.
    BuildingPlan build(std::uint32_t count) {
        const double side = std::ceil(std::cbrt(kVolume * count));
        max_ = Vec3(side / 2, side / 2, side);
        min_ = Vec3(-side / 2, -side / 2, 0.0);
        solids_ = cutBox(min_, max_, count, random_);
        plan_.cells.resize(solids_.size());
        shells_.resize(solids_.size());
        for (std::uint32_t c = 0; c < solids_.size(); ++c)
            for (const Solid::Side& wall : solids_[c].sides)
                shells_[c].walls.push_back({wall.points, materialOf(wall.points, random_)});
        openFaces();
        if (mix_.toGround)
            openOutside();
        for (std::uint32_t c = 0; c < solids_.size(); ++c)
            shell(c);
        if (mix_.toGround)
            addExterior();
        return std::move(plan_);
    }

private:
    /// Opens shared faces in random order: all that connect islands, and some others.
    void openFaces() {
        std::vector<SharedFace> faces = sharedFaces(solids_, kLeastRadius);
        for (std::size_t i = faces.size(); i > 1; --i)
            std::swap(faces[i - 1], faces[random_.below(static_cast<std::uint32_t>(i))]);
        Islands islands(solids_.size());
        for (const SharedFace& face : faces)
            if (islands.join(face.first, face.second) || random_.chance(0.3))
                open(face);
    }

    void open(const SharedFace& face) {
        const std::array<Polygon, 2> walls{solids_[face.first].sides[face.firstSide].points,
                                           solids_[face.second].sides[face.secondSide].points};
        for (const OpeningPair& pair : makeOpenings(face.points, walls, mix_, random_)) {
            const auto a = static_cast<std::uint16_t>(plan_.cells[face.first].links.size());
            const auto b = static_cast<std::uint16_t>(plan_.cells[face.second].links.size());
            add(face.first, pair.first, {face.second, b, pair.exact});
            add(face.second, pair.second, {face.first, a, pair.exact});
        }
    }

    void add(std::uint32_t cell, const Polygon& polygon, CellLink portal) {
        portal.insidePositive = !random_.chance(mix_.reversed);
        plan_.cells[cell].links.push_back(portal);
        shells_[cell].openings.push_back(polygon);
    }

    /// Opens at least one exit through the upright sides of the box.
    void openOutside() {
        exterior_ = boxShell(min_, max_, Material::StoneWall);
        struct Spot {
            std::uint32_t cell, side;
        };
        std::vector<Spot> spots;
        for (std::uint32_t c = 0; c < solids_.size(); ++c) {
            for (std::uint32_t k = 0; k < solids_[c].sides.size(); ++k) {
                const Solid::Side& side = solids_[c].sides[k];
                if (side.cut < 4 && edgeDistance(side.points, centroidOf(side.points)) > 0.4)
                    spots.push_back({c, k});
            }
        }
        for (std::size_t i = 0; i < spots.size(); ++i) {
            if (i > 0 && !random_.chance(0.35))
                continue;
            const Polygon& side = solids_[spots[i].cell].sides[spots[i].side].points;
            const auto index = static_cast<std::uint16_t>(plan_.cells[spots[i].cell].links.size());
            const Polygon opening = roundOpening(side, random_);
            add(spots[i].cell, opening, {CellLink::kOutside, dat::kNoPortal});
            plan_.exits.push_back({spots[i].cell, index});
            exterior_.openings.push_back(opening);
        }
    }

    void addExterior() {
        std::vector<Face> faces = facesOf(exterior_, true);
        hangings_.hang(faces);
        for (Face& face : faces)
            plan_.exterior.add(std::move(face));
    }

    void shell(std::uint32_t c) {
        CellPlan& cell = plan_.cells[c];
        cell.eye = middleOf(solids_[c]);
        cell.faces = facesOf(shells_[c]);
        furnish(cell);
        hangings_.hang(cell.faces);
    }

    /// Puts props into the middle of the cell and into some of its openings.
    void furnish(CellPlan& cell) {
        if (random_.chance(0.4)) {
            const std::array<dat::RecordId, 6> things{props_.crate,  props_.rod,  props_.pole,
                                                      props_.screen, props_.pane, props_.lamp};
            cell.statics.push_back({things[random_.below(things.size())],
                                    {cell.eye + Vec3(0.35, 0.2, -0.6), random_.between(0.0, 360.0)}});
        }
        for (const Face& face : cell.faces) {
            const Vec3 n = planeOf(face.points).n;
            if (face.portal && isOurs(face) && random_.chance(0.16)) {
                const bool upright = std::abs(n.z) > 0.7;
                cell.statics.push_back(
                    {upright ? props_.pole : props_.rod,
                     {centroidOf(face.points), upright ? 0.0 : std::atan2(n.y, n.x) * 57.29577951308232}});
            }
        }
    }

    const Props& props_;
    OpeningMix mix_;
    Random random_;
    Hangings hangings_;
    Vec3 min_{0.0}, max_{0.0};
    std::vector<Solid> solids_;
    std::vector<Shell> shells_; ///< by cell
    Shell exterior_;
    BuildingPlan plan_;
};

} // namespace

namespace {

/// `grid`: of all corners, metres; 0: the finest that floats hold.
WorldRecords complexWith(const GeneratedSpec& spec, double grid) {
    WorldRecords records;
    addGeneratedMaterials(records, spec.furnished);
    ModelWriter writer(records);
    const Props props = addProps(writer, spec.furnished);
    Random random(seedOf(spec));
    const OpeningMix mix = mixOf(random);
    const Land land(kBlock, 1, 1, mix.toGround ? kComplexGround : 0);
    // Without land the block is a dungeon.
    const Placement at{{96.0, 96.0, heightOfIndex(kComplexGround) + 0.125},
                       mix.toGround ? random.between(0.0, 360.0) : 0.0};
    constexpr std::uint64_t kOfHangings = 0x68616E67;
    BuildingPlan plan =
        ComplexBuilder(props, mix, random, Hangings(seedOf(spec) ^ kOfHangings)).build(spec.size);
    WorldNotes notes;
    const std::vector<CellPlan> cells = plan.cells;
    LandblockWriter block(writer, kBlock, kGeneratedCells);
    const dat::RecordId first =
        block
            .add(grid > 0.0 ? withRoundedCorners(std::move(plan), grid) : withClosedSeams(std::move(plan)),
                 at)
            .front();
    if (mix.toGround) {
        addRegion(writer, addGeneratedPlants(writer, spec.furnished));
        const double away = 12.0 + std::cbrt(kVolume * spec.size);
        notes.addPlace("outside", blockToGlobal(kBlock, at.origin + Vec3(away, -away, 0.7 * away)),
                       blockToGlobal(kBlock, at.origin + Vec3(0.0, 0.0, 0.3 * away)), 0);
    }
    notePlaces({"cell", kBlock, at, first}, cells, notes);
    block.finish();
    land.addTo(records);
    records.worldFile = notes.take();
    return records;
}

} // namespace

WorldRecords buildComplex(const GeneratedSpec& spec) {
    return complexWith(spec, 0.0);
}

WorldRecords buildSkewed(const GeneratedSpec& spec) {
    constexpr int kFinest = 14, kCoarsest = 9; // negative powers of two: 0.06 to 2 mm
    return complexWith(
        spec, std::ldexp(1.0, -(kCoarsest + static_cast<int>(spec.seed) % (kFinest - kCoarsest + 1))));
}

} // namespace limen::worlds
