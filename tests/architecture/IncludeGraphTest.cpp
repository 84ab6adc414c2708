#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

// Reads every #include of src/ and fails if a room includes a room that it must not know
// (docs/architecture.md).
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

const fs::path kRoot = LIMEN_SOURCE_DIR;

/// The rooms that each room may include besides itself. The keys are all rooms.
std::map<std::string, Names> allowedRooms() {
    std::map<std::string, Names> allowed{
        {"core", {}},
        {"geometry", {"core"}},
        {"dat", {"core", "geometry"}},
        {"worlds", {"core", "geometry", "dat"}},
        {"placements", {"core"}},
        {"world", {"core", "geometry", "dat"}},
        {"motion", {"core", "geometry", "dat", "world"}},
        {"visibility", {"core", "geometry"}},
        {"frame", {"core", "geometry", "dat", "world", "visibility"}},
        {"gpu", {"core", "geometry", "frame"}},
        {"reference", {"core", "geometry", "dat", "world", "motion"}},
        {"check", {"core", "geometry", "dat", "world", "motion", "reference"}},
        {"engine",
         {"core", "geometry", "dat", "worlds", "world", "motion", "visibility", "frame", "gpu", "reference",
          "check", "placements"}},
    };
    // The rooms above the engine are layers: each may include the one below it and all that this one may include.
    std::string below = "engine";
    for (const char* room : {"output", "play", "viewer", "cli"}) {
        Names names = allowed.at(below);
        names.insert(below);
        allowed.emplace(room, std::move(names));
        below = room;
    }
    // The doctor stands beside the layers: it knows the engine and all that the engine knows, and cli alone knows it.
    Names doctor = allowed.at("engine");
    doctor.insert("engine");
    allowed.emplace("doctor", std::move(doctor));
    allowed.at("cli").insert("doctor");
    return allowed;
}

/// Headers of frame that gpu may include: the plan as plain data. They include nothing else of frame.
bool isPlainFrameHeader(const std::string& include) {
    static const Names kPlain{"frame/FramePlan.h", "frame/GpuLayout.h", "frame/SceneUpload.h",
                              "frame/IdColour.h",
                              "frame/DrawRecords.h"}; // made from the plan and the upload alone
    return kPlain.contains(include);
}

struct Include {
    fs::path file;
    int line = 0;
    std::string name;
    [[nodiscard]] std::string place() const {
        return fs::relative(file, kRoot).string() + ":" + std::to_string(line) + " includes " + name;
    }
};

std::vector<Include> includesOf(const fs::path& file) {
    static const std::regex kPattern(R"(^\s*#\s*include\s*["<]([^">]+)[">])");
    std::vector<Include> found;
    std::ifstream in(file);
    std::string text;
    for (int line = 1; std::getline(in, text); ++line) {
        std::smatch match;
        if (std::regex_search(text, match, kPattern))
            found.push_back({file, line, match[1]});
    }
    return found;
}

std::vector<Include> includesUnder(const fs::path& folder) {
    std::vector<Include> found;
    if (!fs::exists(folder))
        return found;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const std::string extension = entry.path().extension();
        if (extension != ".h" && extension != ".cpp")
            continue;
        const std::vector<Include> more = includesOf(entry.path());
        found.insert(found.end(), more.begin(), more.end());
    }
    return found;
}

/// The folder of a room. Procedural worlds are beside src/; every other room is a folder of src/.
fs::path folderOf(const std::string& room) {
    return room == "worlds" ? kRoot / room : kRoot / "src" / room;
}

/// The room of an include, or "" for a library header. "limen/room/Header.h" is its form in examples.
std::string roomOf(const std::string& given) {
    const std::string include = given.starts_with("limen/") ? given.substr(6) : given;
    const std::string first = include.substr(0, include.find('/'));
    const bool isRoom =
        first.size() < include.size() && !first.starts_with('.') && fs::is_directory(folderOf(first));
    return isRoom ? first : "";
}

std::vector<std::string> roomsThere() {
    std::vector<std::string> rooms{"worlds"};
    for (const auto& entry : fs::directory_iterator(kRoot / "src"))
        if (entry.is_directory())
            rooms.push_back(entry.path().filename());
    return rooms;
}

bool isGlHeader(const std::string& include) {
    static const std::regex kGl(R"(^(epoxy|GL|GLES[23]?|EGL|KHR|GLFW|glad|vulkan)/)");
    return std::regex_search(include, kGl);
}

TEST(IncludeGraph, everyRoomIsKnown) {
    const auto allowed = allowedRooms();
    for (const std::string& room : roomsThere())
        EXPECT_TRUE(allowed.contains(room)) << room << " has no line in the table of allowed includes";
}

TEST(IncludeGraph, noRoomIncludesOneItMayNotKnow) {
    const auto allowed = allowedRooms();
    std::size_t seen = 0;
    for (const std::string& room : roomsThere()) {
        for (const Include& include : includesUnder(folderOf(room))) {
            const std::string other = roomOf(include.name);
            seen += other.empty() ? 0 : 1;
            EXPECT_TRUE(other.empty() || other == room || allowed.at(room).contains(other))
                << include.place();
        }
    }
    EXPECT_GT(seen, 50u) << "too few includes found for the test to mean anything";
}

TEST(IncludeGraph, relativeIncludesDoNotClimbOut) {
    for (const std::string& room : roomsThere()) {
        for (const Include& include : includesUnder(folderOf(room))) {
            const bool climbs = include.name.starts_with("..");
            const bool isShared = include.name == "../../shaders/include/SharedLayout.h" ||
                                  include.name == "../../../shaders/include/AtlasLayout.h" ||
                                  include.name == "../../shaders/include/Tolerances.h";
            EXPECT_TRUE(!climbs || isShared) << include.place();
        }
    }
}

TEST(IncludeGraph, onlyGpuAndViewerKnowOpenGl) {
    for (const std::string& room : roomsThere()) {
        if (room == "gpu" || room == "viewer")
            continue;
        for (const Include& include : includesUnder(folderOf(room)))
            EXPECT_FALSE(isGlHeader(include.name)) << include.place();
    }
}

TEST(IncludeGraph, benchmarksDrawThroughTheEngine) {
    const Names above{"output", "play", "viewer", "cli"};
    std::size_t seen = 0;
    for (const Include& include : includesUnder(kRoot / "bench")) {
        // The program prints as limen does; the benchmarks themselves know the engine and the rooms below it.
        const bool isProgram = include.file.filename() == "Main.cpp" && include.name == "cli/Console.h";
        seen += roomOf(include.name) == "engine" ? 1 : 0;
        EXPECT_TRUE(isProgram || !above.contains(roomOf(include.name))) << include.place();
    }
    EXPECT_GT(seen, 0u) << "no benchmark includes the engine";
}

TEST(IncludeGraph, gpuSeesOfFrameOnlyThePlan) {
    for (const Include& include : includesUnder(kRoot / "src" / "gpu"))
        EXPECT_TRUE(roomOf(include.name) != "frame" || isPlainFrameHeader(include.name)) << include.place();
}

TEST(IncludeGraph, thePlansHeadersKnowNoOtherRoom) {
    for (const char* header : {"FramePlan.h", "GpuLayout.h", "SceneUpload.h"}) {
        for (const Include& include : includesOf(kRoot / "src" / "frame" / header)) {
            const std::string room = roomOf(include.name);
            EXPECT_TRUE(room.empty() || room == "frame" || room == "geometry" || room == "core")
                << include.place();
        }
    }
}

TEST(IncludeGraph, theAllowedGraphHasNoCycle) {
    // Remove rooms without dependencies until none can be removed. The remaining rooms contain a cycle.
    auto left = allowedRooms();
    for (bool moved = true; moved;) {
        moved = false;
        for (auto it = left.begin(); it != left.end();) {
            const bool free = std::none_of(it->second.begin(), it->second.end(),
                                           [&](const std::string& room) { return left.contains(room); });
            it = free ? left.erase(it) : std::next(it);
            moved = moved || free;
        }
    }
    for (const auto& [room, needs] : left)
        ADD_FAILURE() << room << " is part of a cycle";
}

/// The rooms that a CMakeLists.txt links.
Names linkedRooms(const fs::path& cmakeLists) {
    static const std::regex kTarget(R"(limen_room::(\w+))");
    std::ifstream in(cmakeLists);
    const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    Names rooms;
    for (std::sregex_iterator it(text.begin(), text.end(), kTarget), end; it != end; ++it)
        rooms.insert((*it)[1]);
    return rooms;
}

TEST(LinkGraph, noRoomLinksOneItMayNotKnow) {
    const auto allowed = allowedRooms();
    std::size_t links = 0;
    for (const std::string& room : roomsThere()) {
        for (const std::string& other : linkedRooms(folderOf(room) / "CMakeLists.txt")) {
            // gpu may link only frame's headers, because the library depends on world and visibility.
            EXPECT_TRUE(other == room || allowed.at(room).contains(other))
                << room << " links limen_room::" << other;
            ++links;
        }
    }
    EXPECT_GT(links, 30u) << "too few links found for the test to mean anything";
}

TEST(Examples, theFloodNeedsOnlyVisibilityGeometryAndCore) {
    const Names allowed{"visibility", "geometry", "core"};
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / "examples"))
        if (entry.path().filename().string().starts_with("flood") && entry.is_regular_file())
            files.push_back(entry.path());
    for (const fs::path& file : files) {
        for (const Include& include : includesOf(file)) {
            const std::string room = roomOf(include.name);
            EXPECT_TRUE(room.empty() || allowed.contains(room)) << include.place();
            EXPECT_FALSE(isGlHeader(include.name)) << include.place();
        }
    }
}

TEST(Examples, theFloodsTargetLinksOnlyVisibilityGeometryAndCore) {
    // The target_link_libraries line of a target flood* or example_flood* in examples/CMakeLists.txt.
    static const std::regex kLine(R"(target_link_libraries\(\s*((?:example_)?flood\w*)([^)]*)\))");
    static const std::regex kTarget(R"(limen::(\w+))");
    std::ifstream in(kRoot / "examples" / "CMakeLists.txt");
    const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    const Names allowed{"visibility", "geometry", "core"};
    for (std::sregex_iterator it(text.begin(), text.end(), kLine), end; it != end; ++it) {
        const std::string links = (*it)[2];
        for (std::sregex_iterator target(links.begin(), links.end(), kTarget); target != end; ++target)
            EXPECT_TRUE(allowed.contains((*target)[1])) << (*it)[1] << " links limen::" << (*target)[1];
    }
}

} // namespace
