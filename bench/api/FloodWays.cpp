#include "api/FloodWays.h"

#include "TemporaryDirectory.h"
#include "api/Texts.h"
#include "core/Assert.h"
#include "core/Hash.h"
#include "core/platform/Process.h"
#include "visibility/Flood.h"
#include "visibility/c/visibility.h"

#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sys/wait.h>
#include <unistd.h>

namespace limen::bench {
namespace {

namespace vis = visibility;

constexpr int kNoModule = 3; // exit code of flood.py

/// As measure() of Stopwatch.h, of the processor time of this thread.
template <class Work>
Samples measureThread(int repeats, AllocationCounter counter, Work&& work) {
    Samples samples;
    for (int i = -2; i < repeats; ++i) { // two to warm up
        const std::uint64_t before = counter ? counter() : 0;
        const double start = threadSeconds();
        work();
        if (i >= 0)
            samples.seconds.push_back(threadSeconds() - start);
        samples.allocations = counter ? counter() - before : 0;
    }
    return samples;
}

/// Adds one flood as flood.py writes it.
template <class Visits, class Seen>
void addResult(const Visits& visits, const Seen& seen, Hash& hash) {
    hash.add(static_cast<std::uint32_t>(visits.size()));
    hash.add(static_cast<std::uint32_t>(seen.size()));
    for (const auto& visit : visits)
        for (const std::uint32_t number : {visit.space, visit.parent, visit.portal})
            hash.add(number);
    for (const auto& space : seen)
        hash.add(static_cast<std::uint32_t>(space.space));
}

struct DestroyGraph {
    void operator()(limen_graph* graph) const { limen_graph_destroy(graph); }
};
struct DestroyFlood {
    void operator()(limen_flood* flood) const { limen_flood_destroy(flood); }
};

/// A flood through the C interface, with the caller's arrays.
class CFlood {
public:
    [[nodiscard]] static Result<CFlood> create(const vis::Graph& graph);
    [[nodiscard]] bool run(const limen_view& view) {
        limen_counts counts{};
        if (limen_flood_run(flood_.get(), graph_.get(), nullptr, 0, &view, &counts, nullptr) != LIMEN_OK)
            return false;
        visits_.resize(counts.visits);
        vertices_.resize(counts.vertices);
        seen_.resize(counts.seen);
        return limen_flood_visits(flood_.get(), visits_.data(), visits_.size()) == LIMEN_OK &&
               limen_flood_vertices(flood_.get(), vertices_.data(), vertices_.size()) == LIMEN_OK &&
               limen_flood_seen(flood_.get(), seen_.data(), seen_.size()) == LIMEN_OK;
    }
    [[nodiscard]] const std::vector<limen_visit>& visits() const { return visits_; }
    [[nodiscard]] const std::vector<limen_seen>& seen() const { return seen_; }

private:
    std::unique_ptr<limen_graph, DestroyGraph> graph_;
    std::unique_ptr<limen_flood, DestroyFlood> flood_;
    std::vector<limen_visit> visits_;
    std::vector<limen_vec3> vertices_;
    std::vector<limen_seen> seen_;
};

Result<CFlood> CFlood::create(const vis::Graph& graph) {
    std::vector<limen_space> spaces;
    for (const vis::Graph::Space& space : graph.spaces())
        spaces.push_back({space.firstPortal, space.portalCount, space.zone});
    std::vector<limen_portal> portals;
    std::vector<limen_vec3> vertices;
    for (const vis::Graph::Portal& portal : graph.portals()) {
        portals.push_back({portal.space, portal.destination, portal.reciprocal,
                           static_cast<std::uint32_t>(vertices.size()), portal.vertexCount,
                           portal.exact ? 1u : 0u});
        for (const Vec3& corner : graph.polygon(portal))
            vertices.push_back({corner.x, corner.y, corner.z});
    }
    limen_error error{};
    limen_graph* made = nullptr;
    limen_flood* flood = nullptr;
    CFlood through;
    if (limen_graph_create(spaces.data(), spaces.size(), portals.data(), portals.size(), vertices.data(),
                           vertices.size(), &made, &error) == LIMEN_OK)
        through.graph_.reset(made);
    if (limen_flood_create(&flood, &error) == LIMEN_OK)
        through.flood_.reset(flood);
    if (through.graph_ == nullptr || through.flood_ == nullptr)
        return fail(ErrorCode::BadArgument, "C interface", error.text);
    return through;
}

/// Runs a program and waits. Its exit code; -1: it could not be started, or it was killed.
int exitCodeOf(const std::vector<std::string>& command) {
    const ::pid_t child = ::fork();
    if (child == 0) {
        static_cast<void>(platform::becomeProgram(command.front(), {command.begin() + 1, command.end()}));
        ::_exit(kNoModule); // there is no such program
    }
    int status = 0;
    return child > 0 && ::waitpid(child, &status, 0) == child && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

FloodTimes timesIn(const nlohmann::json& text) {
    FloodTimes times;
    times.samples.seconds = text.at("seconds").get<std::vector<double>>();
    Hash hash;
    for (const nlohmann::json& result : text.at("results"))
        for (const nlohmann::json& number : result)
            hash.add(number.get<std::uint32_t>());
    times.hash = hash.value();
    return times;
}

} // namespace

FloodTimes floodThroughCpp(const House& house, int repeats, AllocationCounter counter) {
    const vis::Graph graph = graphOf(house);
    const std::vector<vis::View> views = viewsOf(house);
    vis::FloodScratch scratch;
    vis::VisibleSet set;
    const auto flood = [&](const vis::View& view) {
        LIMEN_ASSERT(vis::flood(graph, {}, view, {}, scratch, set), "the views are valid");
    };
    FloodTimes times;
    times.samples = measureThread(repeats, counter, [&] {
        for (const vis::View& view : views)
            flood(view);
    });
    Hash hash;
    for (const vis::View& view : views) {
        flood(view);
        addResult(set.visits, set.seen, hash);
    }
    times.hash = hash.value();
    return times;
}

Result<FloodTimes> floodThroughC(const House& house, int repeats, AllocationCounter counter) {
    Result<CFlood> flood = CFlood::create(graphOf(house));
    if (!flood)
        return Failure(flood.error());
    std::vector<limen_view> views;
    for (const vis::LookAt& eye : house.eyes) {
        limen_view view{};
        const limen_status made = limen_look_at(
            {eye.eye.x, eye.eye.y, eye.eye.z}, {eye.target.x, eye.target.y, eye.target.z},
            {eye.up.x, eye.up.y, eye.up.z}, eye.heightDegrees, eye.aspect, eye.root, &view, nullptr);
        LIMEN_ASSERT(made == LIMEN_OK, "the eyes are sound");
        views.push_back(view);
    }
    FloodTimes times;
    bool isDone = true;
    times.samples = measureThread(repeats, counter, [&] {
        for (const limen_view& view : views)
            isDone = flood->run(view) && isDone;
    });
    Hash hash;
    for (const limen_view& view : views) {
        isDone = flood->run(view) && isDone;
        addResult(flood->visits(), flood->seen(), hash);
    }
    times.hash = hash.value();
    if (!isDone)
        return fail(ErrorCode::BadArgument, "C interface", "a flood failed");
    return times;
}

Result<std::optional<FloodTimes>> floodThroughPython(const House& house, int repeats) {
    const TemporaryDirectory directory("bench-api");
    std::error_code error;
    std::filesystem::create_directories(directory.path(), error);
    const std::filesystem::path script = directory.path() / "flood.py",
                                scene = directory.path() / "house.json",
                                result = directory.path() / "result.json";
    std::ofstream(script) << texts::kFloodPy;
    if (Result<void> written = writeHouse(house, scene); !written)
        return Failure(written.error());
    const std::filesystem::path modules = platform::programPath().parent_path() / "python";
    const int exit = exitCodeOf({"/usr/bin/python3", "-B", script.string(), modules.string(), scene.string(),
                                 result.string(), std::to_string(repeats)});
    if (exit == kNoModule)
        return std::optional<FloodTimes>();
    const nlohmann::json text = nlohmann::json::parse(std::ifstream(result), nullptr, false);
    if (exit != 0 || text.is_discarded())
        return fail(ErrorCode::Unreadable, "Python",
                    "the flood failed with exit code " + std::to_string(exit));
    return std::optional(timesIn(text));
}

} // namespace limen::bench
