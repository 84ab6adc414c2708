#pragma once

#include "dat/Writer.h"
#include "support/TestShapes.h"

#include <deque>
#include <map>

namespace limen::test {

/// Builds small worlds as dat records: convex cells with openings, linked in any way, buildings, terrain,
/// objects.
///
///    TestWorld world;
///    auto a = world.addBox({0, 0, 0}, {4, 4, 3});
///    auto b = world.addBox({4, 0, 0}, {8, 4, 3}, "red");
///    world.link(a, rectangle({4, 1, 0}, {4, 2, 2}), b);            // cuts the door out of both walls
///    auto door = world.openOutside(a, rectangle({0, 1, 0}, {0, 2, 2}));
///    world.addBuilding(boxExterior({-0.2, -0.2, 0}, {8.2, 4.2, 3.2}), {door});
///    world.setFlatTerrain(world.home(), 0);
///    world.write(directory);
///
/// Collision shapes equal the drawn shapes, apart from openings. Positions are block-local metres of the
/// object's own block, `home()` by default. Cells get the ids 0x0100, 0x0101, ... of their block, in order of
/// creation.
class TestWorld {
public:
    using Cell = std::size_t; ///< handle

    struct CellOptions {
        std::optional<dat::BlockCoord> block; ///< home() if not given
        dat::Frame frame; ///< position of the cell in its record; its vertices are relative to it
        bool seenOutside = false;
        bool bsp = true; ///< write the cell BSP, one plane per wall: correct only for convex cells
        std::optional<dat::BspTree> tree; ///< replaces it
    };
    struct LinkOptions {
        bool exact = true;               ///< flag bit 0, on both sides
        bool insideIsPositive = true;    ///< winding of the polygon, and flag bit 1 with it
        bool wrongSideFlag = false;      ///< flag bit 1 contradicts the winding
        bool oneWay = false;             ///< the second cell gets an opening but no link back
        std::vector<Vec3> polygonInB;    ///< a different opening in the second cell; empty: the same
        std::string surface, surfaceInB; ///< of the portal polygons; empty: one without a picture
        bool twoSided = false;           ///< the portal polygons
    };
    /// A portal by its cell and its index in the cell's list.
    struct Portal {
        Cell cell = 0;
        std::uint16_t index = 0;
    };
    struct BuildingOptions {
        std::optional<dat::BlockCoord> block;
        dat::Frame frame;
        Vec3 portalShift{0.0};     ///< moves the building's own portal polygons away from the cells'
        std::string portalSurface; ///< of the portal polygons; empty: one without a picture
        std::vector<dat::DegradeLevel> levels; ///< of detail, of its model; kItself as in addModel
    };

    explicit TestWorld(dat::BlockCoord home = {0x20, 0x30});

    [[nodiscard]] dat::BlockCoord home() const { return home_; }

    // --- surfaces: used by name; an unknown name gets a picture of one colour, which is derived from the name
    /// A surface with a picture of one colour.
    std::uint32_t solid(const std::string& name, std::uint32_t argb, std::uint32_t extraType = 0,
                        float translucency = 0);
    /// A surface without a picture. Cells and buildings do not draw it, objects draw its colour.
    std::uint32_t plain(const std::string& name, std::uint32_t argb, std::uint32_t extraType = 0,
                        float translucency = 0);
    std::uint32_t picture(const std::string& name, const dat::RenderSurface& image, std::uint32_t type);
    std::uint32_t luminous(const std::string& name, float luminosity, float diffuse, std::uint32_t extraType);
    [[nodiscard]] std::uint32_t surfaceId(const std::string& name);
    /// The SurfaceTexture id of the next picture.
    [[nodiscard]] std::uint32_t nextTexture() const { return nextTexture_; }

    // --- cells
    Cell addBox(const Vec3& min, const Vec3& max, const std::string& surface = "grey") {
        return addBox(min, max, surface, CellOptions());
    }
    Cell addBox(const Vec3& min, const Vec3& max, const std::string& surface, const CellOptions& options) {
        return addCell(boxWalls(min, max, surface), options);
    }
    Cell addCell(Walls walls) { return addCell(std::move(walls), CellOptions()); }
    Cell addCell(Walls walls, const CellOptions& options);
    [[nodiscard]] dat::RecordId id(Cell cell) const { return cells_[cell].record.id; }
    [[nodiscard]] Walls& walls(Cell cell) { return cells_[cell].walls; }
    [[nodiscard]] dat::EnvCell& record(Cell cell) {
        return cells_[cell].record;
    } ///< for odd flags, statics, links

    /// Opens `polygon` (any winding) between two cells of one block and links them both ways.
    std::pair<Portal, Portal> link(Cell a, std::vector<Vec3> polygon, Cell b) {
        return link(a, std::move(polygon), b, LinkOptions());
    }
    std::pair<Portal, Portal> link(Cell a, std::vector<Vec3> polygon, Cell b, const LinkOptions& options);
    /// Opens `polygon` to the outdoors.
    Portal openOutside(Cell cell, std::vector<Vec3> polygon) {
        return openOutside(cell, std::move(polygon), LinkOptions());
    }
    Portal openOutside(Cell cell, std::vector<Vec3> polygon, const LinkOptions& options);
    /// The polygon of a portal as stored: block-local, with the winding of LinkOptions.
    [[nodiscard]] const std::vector<Vec3>& polygon(Portal portal) const {
        return cells_[portal.cell].portals[portal.index].points;
    }

    // --- outdoors
    /// A building with `exits` cut out of its walls (seen from outside). Yields the model's id.
    std::uint32_t addBuilding(Walls exterior, std::vector<Portal> exits) {
        return addBuilding(std::move(exterior), std::move(exits), BuildingOptions());
    }
    std::uint32_t addBuilding(Walls exterior, std::vector<Portal> exits, const BuildingOptions& options);
    [[nodiscard]] dat::LandBlock& terrain(dat::BlockCoord block); ///< created (all zero) on first use
    void setFlatTerrain(dat::BlockCoord block, std::uint8_t heightIndex, std::uint8_t type = 0);
    [[nodiscard]] dat::LandBlockInfo& info(dat::BlockCoord block); ///< created on first use
    [[nodiscard]] dat::Region& region() {
        return region_;
    } ///< heights[i] = 2 i; types 0..3 and the road exist
    void omitRegion() { writeRegion_ = false; }
    void add(const dat::Scene& scene) { portalFile_.add(scene); }

    // --- objects
    std::uint32_t addModel(const Walls& walls) { return addModel(walls, {}); } ///< a GfxObj in its own space
    /// A model with levels of detail; kItself as `gfxObj` stands for its own id.
    std::uint32_t addModel(const Walls& walls, std::vector<dat::DegradeLevel> levels);
    static constexpr std::uint32_t kItself = 1;
    std::uint32_t addSetup(dat::Setup setup); ///< its id is filled in
    void addObject(std::uint32_t model, const dat::Frame& frame) { addObject(home_, model, frame); }
    void addObject(dat::BlockCoord block, std::uint32_t model, const dat::Frame& frame);
    void addStatic(Cell cell, std::uint32_t model, const dat::Frame& frame);

    [[nodiscard]] dat::Writer& portalFile() {
        return portalFile_;
    } ///< for records without a builder function
    [[nodiscard]] dat::Writer& cellFile() { return cellFile_; }

    /// Writes client_portal.dat and client_cell_1.dat to `directory`, which is created if missing.
    [[nodiscard]] Result<void> write(const std::filesystem::path& directory);

private:
    struct PortalPolygon {
        std::vector<Vec3> points;
        std::string surface;
        bool twoSided = false;
    };
    struct CellData {
        dat::EnvCell record;
        dat::BlockCoord block;
        Walls walls;
        std::vector<PortalPolygon> portals;
        bool bsp = true;
        std::optional<dat::BspTree> tree;
    };
    Portal addPortal(Cell cell, std::vector<Vec3> polygon, const LinkOptions& options,
                     std::uint16_t otherCell);
    [[nodiscard]] dat::CellStruct cellStruct(CellData& cell);
    void addLevels(std::vector<dat::DegradeLevel> levels, dat::GfxObj& model);
    std::uint32_t addPictured(const std::string& name, const dat::RenderSurface& image, dat::Surface surface);
    /// The name, or that of a surface without a picture.
    std::string portalSurface(const std::string& name);
    void addSolidTexture(std::uint32_t texture, std::uint32_t image, std::uint32_t argb);
    void makeRegion();

    dat::BlockCoord home_;
    dat::Writer portalFile_, cellFile_;
    std::deque<CellData> cells_; ///< a deque, so that record() stays valid
    std::map<std::string, std::uint32_t> surfaces_;
    std::map<dat::RecordId, dat::LandBlock> terrain_;
    std::map<dat::RecordId, dat::LandBlockInfo> infos_;
    std::map<dat::RecordId, std::uint32_t> cellCounts_;
    dat::Region region_;
    bool writeRegion_ = true;
    std::uint32_t nextSurface_ = 0x08000001, nextModel_ = 0x01000001, nextSetup_ = 0x02000001;
    std::uint32_t nextDegrade_ = 0x11000100;
    std::uint32_t nextTexture_ = 0x05000100, nextImage_ = 0x06000100;
};

/// A solid block: the outside of a box-shaped building.
[[nodiscard]] inline Walls boxExterior(const Vec3& min, const Vec3& max,
                                       const std::string& surface = "stone") {
    return insideOut(boxWalls(min, max, surface));
}

/// A frame: origin, and a turn about +z in degrees, counter-clockwise seen from above.
[[nodiscard]] dat::Frame frameAt(const Vec3& origin, double turnDegrees = 0.0);

/// An image of one colour in A8R8G8B8.
[[nodiscard]] dat::RenderSurface solidImage(std::int32_t width, std::int32_t height, std::uint32_t argb);

} // namespace limen::test
