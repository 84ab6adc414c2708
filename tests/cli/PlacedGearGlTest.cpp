#include "cli/ProgramRunner.h"

#include "dat/Archive.h"
#include "dat/Codec.h"
#include "placements/WorldDb.h"
#include "support/MeshRecords.h"
#include "support/TestWorld.h"

#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <png.h>

// A smith with an axe and a shield, a chest, a lever's kind of motion and a travel portal in the hall of the built-in inn: drawn,
// used and checked. Their records are packed into the dat files of the built-in world.
namespace limen::cli {
namespace {

using placements::Content;
using placements::Template;
using test::getText;
using test::ProgramRun;
using test::ProgramRunner;
using test::putText;
using testing::HasSubstr;
using Json = nlohmann::ordered_json;

constexpr dat::RecordId kAxeMesh = 0x01009001, kShieldMesh = 0x01009002, kChestMesh = 0x01009003,
                        kLidMesh = 0x01009004, kGateMesh = 0x01009005;
constexpr dat::RecordId kSmith = 0x02009000, kAxe = 0x02009001, kShield = 0x02009002, kChest = 0x02009003,
                        kGate = 0x02009004, kDarkGate = 0x02009005;
constexpr dat::RecordId kLidTable = 0x09009001, kGateTable = 0x09009002, kLidTurn = 0x03009001,
                        kGateStands = 0x03009002;
constexpr std::uint32_t kStyle = 0x8000003D, kOn = 0x4000000B, kOff = 0x4000000C, kReady = 0x41000003;
constexpr std::uint32_t kFirstGuid = 0x7A9B4900;
enum Row : std::uint32_t { SmithRow = 1, AxeRow, ShieldRow, ChestRow, LockedChestRow, GateRow };

dat::Frame frameAt(const Vec3& origin, double degrees = 0.0, const Vec3f& axis = {1.0f, 0.0f, 0.0f}) {
    const double half = degrees * std::numbers::pi / 360.0;
    const auto sine = static_cast<float>(std::sin(half));
    return {Vec3f(origin),
            Quatf(static_cast<float>(std::cos(half)), axis.x * sine, axis.y * sine, axis.z * sine)};
}

/// Eight bits of red, green and blue.
struct Pixels {
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint8_t> rgb;

    explicit Pixels(const std::filesystem::path& path) {
        png_image image{};
        image.version = PNG_IMAGE_VERSION;
        EXPECT_NE(png_image_begin_read_from_file(&image, path.c_str()), 0) << path;
        image.format = PNG_FORMAT_RGB;
        rgb.resize(PNG_IMAGE_SIZE(image));
        width = image.width;
        height = image.height;
        EXPECT_NE(png_image_finish_read(&image, nullptr, rgb.data(), 0, nullptr), 0);
    }
    /// How much redder and bluer than green the picture is, on average.
    [[nodiscard]] double purple() const {
        double sum = 0.0;
        for (std::size_t i = 0; i + 2 < rgb.size(); i += 3)
            sum += (rgb[i] + rgb[i + 2]) / 2.0 - rgb[i + 1];
        return 3.0 * sum / static_cast<double>(rgb.size());
    }
};

/// The share of the pixels that differ by more than 8 of 255.
double differenceOf(const Pixels& a, const Pixels& b) {
    std::size_t differ = 0;
    for (std::size_t i = 0; i + 2 < std::min(a.rgb.size(), b.rgb.size()); i += 3)
        differ += std::abs(a.rgb[i] - b.rgb[i]) + std::abs(a.rgb[i + 1] - b.rgb[i + 1]) +
                              std::abs(a.rgb[i + 2] - b.rgb[i + 2]) >
                          24
                      ? 1
                      : 0;
    return 3.0 * static_cast<double>(differ) / static_cast<double>(a.rgb.size());
}

class PlacedGear : public testing::Test {
protected:
    static void SetUpTestSuite() {
        runner_.emplace();
        ASSERT_EQ(runner_->run({"demo", "base"}).exit, 0);
        const Json world = Json::parse(getText(work() / "base/world.json"));
        {
            const Result<dat::Archive> archive = dat::Archive::open((work() / "base").string());
            ASSERT_TRUE(archive);
            writeRecords(*archive, world);
        }
        const ProgramRun packed = runner_->run(
            {"dat", "pack", "records", "--base", "base/client_portal.dat", "-o", "gear/client_portal.dat"});
        ASSERT_EQ(packed.exit, 0) << packed.err;
        std::filesystem::copy(work() / "base/client_cell_1.dat", work() / "gear/client_cell_1.dat");
        Json quiet = world;
        quiet["villagers"] = Json::array();
        quiet["emitters"] = Json::array();
        putText(work() / "gear/world.json", quiet.dump());
        std::filesystem::copy(work() / "gear", work() / "bare");
        writeRows(world, "gear");
    }
    static void TearDownTestSuite() { runner_.reset(); }
    static const test::TemporaryDirectory& work() { return runner_->work(); }

    /// Draws the hall and yields the picture.
    static Pixels shot(const std::string& directory, const std::vector<std::string>& options) {
        const std::string file = fmt::format("shot-{}.png", ++shots_);
        std::vector<std::string> words{"shot",   "--dat",   directory, "--at", "inn.hall",
                                       "--size", "480x270", "-o",      file};
        words.insert(words.end(), options.begin(), options.end());
        const ProgramRun run = runner_->run(words);
        EXPECT_EQ(run.exit, 0) << run.err;
        if (const char* keep = std::getenv("LIMEN_KEEP_PICTURES"))
            std::filesystem::copy_file(work() / file, std::filesystem::path(keep) / file,
                                       std::filesystem::copy_options::overwrite_existing);
        return Pixels(work() / file);
    }
    static std::string nameOf(Row row) { return fmt::format("{} {:08X}", kNames[row - 1], kFirstGuid + row); }

    static constexpr std::array kNames{"Smith", "Axe", "Shield", "Chest", "Strongbox", "Gateway"};
    static std::optional<ProgramRunner> runner_; ///< the tests change nothing in "gear"
    static int shots_;

private:
    template <class Record>
    static void put(const Record& record) {
        const Result<dat::Bytes> encoded = dat::encode(record);
        ASSERT_TRUE(encoded);
        const dat::Bytes& bytes = *encoded;
        std::ofstream out(work() / fmt::format("records/{:08X}.bin", record.id), std::ios::binary);
        out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        ASSERT_TRUE(out.good());
    }
    static void putMesh(dat::RecordId id, const test::Walls& walls, dat::RecordId surface) {
        test::MeshRecords mesh;
        for (const test::Wall& wall : walls)
            mesh.add(wall.points, 0, true);
        dat::GfxObj model;
        model.id = id;
        model.flags = dat::GfxObj::kDrawing | dat::GfxObj::kPhysics;
        model.physicsPolygons = mesh.polygons;
        model.physicsBsp = test::leafTree();
        model.surfaces = {surface};
        model.vertexArray = std::move(mesh.vertices);
        model.polygons = std::move(mesh.polygons);
        model.drawingBsp = test::leafTree();
        put(model);
    }
    static void putSetup(dat::RecordId id, std::vector<dat::RecordId> parts,
                         const std::vector<dat::Frame>& frames, std::uint32_t placement,
                         dat::RecordId table = 0, const dat::LightInfo* light = nullptr) {
        dat::Setup setup;
        setup.id = id;
        setup.flags = dat::Setup::kPhysicsBsp;
        setup.parts = std::move(parts);
        setup.placementFrames = {{dat::Setup::kPlacementDefault, {frames, {}}}};
        if (placement != dat::Setup::kPlacementDefault)
            setup.placementFrames.push_back({placement, {frames, {}}});
        setup.motionTable = table;
        if (light != nullptr)
            setup.lights = {{0, *light}};
        put(setup);
    }

    static dat::RecordId modelOf(const Json& text) {
        return static_cast<dat::RecordId>(std::stoul(text.get<std::string>(), nullptr, 16));
    }
    /// The first surface of a part of a Setup.
    static dat::RecordId surfaceOf(const dat::Archive& archive, dat::RecordId setup, std::size_t part) {
        const Result<dat::Setup> model = archive.load<dat::Setup>(setup);
        EXPECT_TRUE(model && part < model->parts.size());
        const Result<dat::GfxObj> mesh = archive.load<dat::GfxObj>(model->parts[part]);
        EXPECT_TRUE(mesh && !mesh->surfaces.empty());
        return mesh->surfaces[0];
    }

    /// A person of the built-in world with holding locations, the items, a chest with a lid, and a gateway that turns.
    static void writeRecords(const dat::Archive& archive, const Json& world) {
        std::filesystem::create_directory(work() / "records");
        std::filesystem::create_directory(work() / "gear");
        Result<dat::Setup> person = archive.load<dat::Setup>(modelOf(world["villagers"][1]["model"]));
        ASSERT_TRUE(person && person->parts.size() >= 4);
        const dat::RecordId iron =
                                surfaceOf(archive, modelOf(world["villagers"][4]["model"]), 6), // a lantern
            wood = surfaceOf(archive, modelOf(world["doors"][0]["leaves"][0]["model"]), 0);
        person->id = kSmith;
        person->holdingLocations = {{1, 3, frameAt({0.0, 0.05, -0.6})}, {3, 2, frameAt({-0.1, 0.1, -0.4})}};
        put(*person);

        test::Walls axe = test::boxExterior({-0.02, -0.1, -0.02}, {0.02, 0.6, 0.02}),
                    blade = test::boxExterior({-0.01, 0.4, -0.2}, {0.01, 0.6, 0.15});
        axe.insert(axe.end(), blade.begin(), blade.end());
        putMesh(kAxeMesh, axe, iron);
        putMesh(kShieldMesh, test::boxExterior({-0.03, -0.3, -0.4}, {0.03, 0.3, 0.4}), wood);
        putMesh(kChestMesh, test::boxExterior({-0.5, -0.3, 0}, {0.5, 0.3, 0.5}), wood);
        putMesh(kLidMesh, test::boxExterior({-0.5, -0.6, 0.001}, {0.5, 0, 0.1}), wood);
        putMesh(kGateMesh, test::boxExterior({-0.6, -0.05, 0.2}, {0.6, 0.05, 2.2}), wood);
        putSetup(kAxe, {kAxeMesh}, {frameAt({0, 0, 0})}, 1);
        putSetup(kShield, {kShieldMesh}, {frameAt({0, 0, 0})}, 6);
        putSetup(kChest, {kChestMesh, kLidMesh}, {frameAt({0, 0, 0}), frameAt({0, 0.3, 0.5})},
                 dat::Setup::kPlacementDefault, kLidTable);
        dat::LightInfo light;
        light.frame = frameAt({0, 0, 1.2});
        light.colour = {0xFFC800C8u};
        light.intensity = 100.0f;
        light.falloff = 6.0f;
        putSetup(kGate, {kGateMesh}, {frameAt({0, 0, 0})}, dat::Setup::kPlacementDefault, kGateTable, &light);
        putSetup(kDarkGate, {kGateMesh}, {frameAt({0, 0, 0})}, dat::Setup::kPlacementDefault, kGateTable);
        writeMotions();
    }
    static dat::MotionData motionOf(dat::RecordId animation, int low, int high) {
        dat::MotionData data;
        data.animations = {{animation, low, high, 15.0f}};
        return data;
    }
    static void writeMotions() {
        constexpr int kFrames = 15;
        dat::Animation lid;
        lid.id = kLidTurn;
        lid.partCount = 2;
        for (int i = 0; i <= kFrames; ++i)
            lid.frames.push_back({{frameAt({0, 0, 0}), frameAt({0, 0.3, 0.5}, -100.0 * i / kFrames)}, {}});
        put(lid);
        dat::MotionTable chest;
        chest.id = kLidTable;
        chest.defaultStyle = kStyle;
        chest.styleDefaults = {{kStyle, kOff}};
        const std::uint32_t off = dat::motionKey(kStyle, kOff), on = dat::motionKey(kStyle, kOn);
        chest.cycles = {{on, motionOf(kLidTurn, kFrames, kFrames)}, {off, motionOf(kLidTurn, 0, 0)}};
        chest.links = {{off, {{kOn, motionOf(kLidTurn, 1, kFrames)}}}};
        put(chest);
        dat::Animation still;
        still.id = kGateStands;
        still.partCount = 1;
        still.frames = {{{frameAt({0, 0, 0})}, {}}};
        put(still);
        dat::MotionTable gate;
        gate.id = kGateTable;
        gate.defaultStyle = kStyle;
        gate.styleDefaults = {{kStyle, kReady}};
        dat::MotionData turning = motionOf(kGateStands, 0, 0);
        turning.flags = dat::MotionData::kOmega;
        turning.omega = {0.0f, 0.0f, 1.5f};
        gate.cycles = {{dat::motionKey(kStyle, kReady), turning}};
        put(gate);
    }

    /// Objects ahead of the eye in the hall: smith, chest, strongbox and gateway from left to right.
    static void writeRows(const Json& world, const std::string& directory) {
        const Json& hall = world["places"]["inn.hall"];
        const Vec3 eye(hall["x"].get<double>(), hall["y"].get<double>(), hall["z"].get<double>());
        const double yaw = hall["yaw"].get<double>() * std::numbers::pi / 180.0;
        const auto cell =
            static_cast<std::uint32_t>(std::stoul(hall["cell"].get<std::string>(), nullptr, 16));
        const Vec3 ahead(std::sin(yaw), std::cos(yaw), 0.0), right(ahead.y, -ahead.x, 0.0);
        const Vec3 block((cell >> 24) * 192.0, (cell >> 16 & 0xFF) * 192.0, 0.0);
        Content content;
        const auto add = [&](Row row, std::int32_t type, dat::RecordId setup, dat::RecordId table,
                             double metresRight) -> Template& {
            Template& of = content.templates[row];
            of.id = row;
            of.className = of.name = kNames[row - 1];
            of.type = type;
            of.setup = setup;
            of.motionTable = table;
            if (row == AxeRow || row == ShieldRow)
                return of;
            const Vec3 at = eye + ahead * 2.6 + right * metresRight - Vec3(0.0, 0.0, 1.6) - block;
            const double aside = row == SmithRow ? 0.6 : 0.0;           // radians: he shows his axe
            const double half = (std::numbers::pi + aside - yaw) / 2.0; // towards the eye
            content.landblocks[cell >> 16].placements.push_back(
                {kFirstGuid + row,
                 row,
                 {cell,
                  {static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z)},
                  {static_cast<float>(std::cos(half)), 0.0f, 0.0f, static_cast<float>(std::sin(half))}},
                 false});
            return of;
        };
        add(AxeRow, 6, kAxe, 0, 0.0).validLocations = 0x100000;
        Template& shield = add(ShieldRow, 1, kShield, 0, 0.0);
        shield.validLocations = 0x200000;
        shield.itemType = 2;
        add(SmithRow, 10, kSmith, 0, -1.2).items = {{2, AxeRow, 0, 0.0f}, {2, ShieldRow, 0, 0.0f}};
        add(ChestRow, 20, kChest, kLidTable, -0.1);
        add(LockedChestRow, 20, kChest, kLidTable, 1.1).locked = true;
        add(GateRow, 7, kGate, kGateTable, 2.2).destination =
            placements::Spot{cell, {1.0f, 1.0f, 1.0f}, {1.0f, 0.0f, 0.0f, 0.0f}};
        const auto written = placements::writeWorldDb(work() / directory / placements::kWorldDbName, content,
                                                      {"the test", ""});
        ASSERT_TRUE(written) << written.error().message();
    }
};
std::optional<ProgramRunner> PlacedGear::runner_;
int PlacedGear::shots_ = 0;

TEST_F(PlacedGear, isInThePicture) {
    const Pixels empty = shot("bare", {}), full = shot("gear", {});
    EXPECT_GT(differenceOf(empty, full), 0.05) << "smith, chests and gateway";
    // Without its items the smith is another picture: an axe of 0.7 m and a shield of 0.6 m at 2.6 m.
    std::filesystem::copy(work() / "gear", work() / "unarmed");
    Result<placements::WorldDb> database = placements::WorldDb::open(work() / "gear/world.db");
    ASSERT_TRUE(database);
    Result<Content> content = database->readAll();
    ASSERT_TRUE(content);
    content->templates[SmithRow].items.clear();
    ASSERT_TRUE(placements::writeWorldDb(work() / "unarmed/world.db", *content, {"the test", ""}));
    const double items = differenceOf(shot("unarmed", {}), full);
    EXPECT_GT(items, 0.004);
    EXPECT_LT(items, 0.2);
}

TEST_F(PlacedGear, chestsOpenByTheirNames) {
    const Pixels shut = shot("gear", {"--door", nameOf(ChestRow) + "=0"}),
                 half = shot("gear", {"--door", nameOf(ChestRow) + "=0.5"}),
                 open = shot("gear", {"--door", nameOf(ChestRow) + "=1"}),
                 all = shot("gear", {"--doors", "open"});
    EXPECT_GT(differenceOf(shut, half), 0.002);
    EXPECT_GT(differenceOf(half, open), 0.002);
    EXPECT_GT(differenceOf(open, all), 0.002) << "the strongbox, too";
    EXPECT_EQ(differenceOf(shot("gear", {}), shut), 0.0);
}

TEST_F(PlacedGear, aTravelPortalTurnsAndGlows) {
    const Pixels now = shot("gear", {"--seconds", "0"}), later = shot("gear", {"--seconds", "0.5"});
    EXPECT_GT(differenceOf(now, later), 0.002) << "it turns by 43 degrees";
    EXPECT_LT(differenceOf(shot("bare", {"--seconds", "0"}), shot("bare", {"--seconds", "0.5"})), 0.0002)
        << "but for flames, nothing else moves in the hall";
    // Its purple lamp lights the hall at night.
    std::filesystem::copy(work() / "gear", work() / "unlit");
    Result<placements::WorldDb> database = placements::WorldDb::open(work() / "gear/world.db");
    ASSERT_TRUE(database);
    Result<Content> content = database->readAll();
    ASSERT_TRUE(content);
    content->templates[GateRow].setup = kDarkGate;
    ASSERT_TRUE(placements::writeWorldDb(work() / "unlit/world.db", *content, {"the test", ""}));
    const double lit = shot("gear", {"--time", "0"}).purple(),
                 unlit = shot("unlit", {"--time", "0"}).purple();
    EXPECT_GT(lit - unlit, 1.5) << "of 255, over the whole picture";
}

TEST_F(PlacedGear, passesTheCheck) {
    for (const char* doors : {"rest", "half", "open"}) {
        const ProgramRun run =
            runner_->run({"check", "--dat", "gear", "--block", "A9B4", "--views", "40", "--kinds",
                          "random,path,sweep", "--doors", doors, "--size", "96x54", "--seed", "11"});
        EXPECT_EQ(run.exit, 0) << doors << ": " << run.out << run.err;
    }
}

TEST_F(PlacedGear, isThePlaceOfATurnTable) {
    for (const std::string& name : {std::string("smith"), nameOf(ChestRow)}) {
        const ProgramRun run = runner_->run({"tour", "--turn-table", "--dat", "gear", "--at", name,
                                             "--frames", "2", "--size", "64x36", "-o", "round"});
        EXPECT_EQ(run.exit, 0) << run.err;
    }
    const ProgramRun unknown = runner_->run({"tour", "--turn-table", "--dat", "gear", "--at", "nobody",
                                             "--frames", "2", "--size", "64x36", "-o", "nowhere"});
    EXPECT_EQ(unknown.exit, 2);
    EXPECT_THAT(unknown.err, HasSubstr("unknown place 'nobody'"));
}

} // namespace
} // namespace limen::cli
