#include "gates/GateTimes.h"

#include "Stopwatch.h"

#include "core/Hash.h"

#include <epoxy/gl.h>

namespace limen::bench {

namespace {

/// Counts the fragment shader invocations of a frame, where the driver can.
class FragmentCounter {
public:
    FragmentCounter() : isThere_(epoxy_has_gl_extension("GL_ARB_pipeline_statistics_query")) {
        if (isThere_)
            glGenQueries(1, &query_);
    }
    FragmentCounter(const FragmentCounter&) = delete;
    FragmentCounter& operator=(const FragmentCounter&) = delete;
    ~FragmentCounter() {
        if (isThere_)
            glDeleteQueries(1, &query_);
    }
    void begin() const {
        if (isThere_)
            glBeginQuery(GL_FRAGMENT_SHADER_INVOCATIONS_ARB, query_);
    }
    [[nodiscard]] std::optional<double> end() const {
        if (!isThere_)
            return {};
        glEndQuery(GL_FRAGMENT_SHADER_INVOCATIONS_ARB);
        GLuint64 count = 0;
        glGetQueryObjectui64v(query_, GL_QUERY_RESULT, &count);
        return static_cast<double>(count);
    }

private:
    bool isThere_ = false;
    GLuint query_ = 0;
};

/// Floods, plans and draws a place, and waits. Errors: the renderer's.
Result<void> drawPlace(DrawnPart& part, const frame::FrameView& view) {
    part.flood(view);
    part.plan(view);
    Result<void> drawn = part.submit({.wantIds = false});
    glFinish();
    return drawn;
}

Result<void> countFrame(DrawnPart& part, const frame::FrameView& view, const FragmentCounter& counter,
                        GateFrame& frame, Hash& pictures) {
    counter.begin();
    Result<void> drawn = drawPlace(part, view);
    frame.fragments = counter.end();
    if (!drawn)
        return drawn;
    const gpu::FrameReport report = part.renderer().report();
    frame.calls = report.glCalls;
    for (const gpu::StageReport& stage : report.stages)
        frame.draws += stage.draws;
    for (const frame::GatedSpace& space : part.plan().spaces)
        frame.fallbacks += space.fallbacks;
    for (const std::uint8_t byte : part.target().readColour())
        pictures.add(byte);
    return {};
}

Result<void> timePlace(DrawnPart& part, const world::Place& place, const GateEffort& effort,
                       const FragmentCounter& counter, GateFrames& out) {
    const frame::FrameView view = part.viewFrom(place);
    part.move(view);
    auto& frames = out.places.emplace_back();
    std::array<Samples, frame::kGates.size()> samples;
    for (std::size_t g = 0; g < frames.size(); ++g) {
        part.setGate(frame::kGates[g]);
        Hash hash;
        hash.add(out.hashes[g]);
        if (Result<void> counted = countFrame(part, view, counter, frames[g], hash); !counted)
            return counted;
        out.hashes[g] = hash.value();
    }
    for (int i = 0; i < effort.repeats; ++i) {
        for (std::size_t g = 0; g < frames.size(); ++g) {
            part.setGate(frame::kGates[g]);
            Result<void> drawn;
            samples[g].seconds.push_back(secondsOf([&] { drawn = drawPlace(part, view); }));
            if (!drawn)
                return drawn;
        }
    }
    for (std::size_t g = 0; g < frames.size(); ++g)
        frames[g].milliseconds = 1e3 * samples[g].quantile(0.5);
    return {};
}

} // namespace

Result<GateFrames> timeGates(gpu::Device& device, const dat::Archive& archive, const world::WorldFile& file,
                             const std::vector<world::Place>& places, const gpu::RendererOptions& options,
                             const GateEffort& effort) {
    const FragmentCounter counter;
    GateFrames frames;
    for (std::size_t first = 0, last = 0; first < places.size(); first = last) {
        const Result<std::shared_ptr<const engine::LoadedPart>> loaded =
            loadAround(archive, file, places[first]);
        if (!loaded)
            return Failure(loaded.error());
        const Result<std::unique_ptr<DrawnPart>> drawn =
            DrawnPart::of(*loaded, device, effort.width, effort.height, options);
        if (!drawn)
            return Failure(drawn.error());
        for (last = first; last < places.size() && holds(**loaded, places[last]); ++last)
            if (Result<void> timed = timePlace(**drawn, places[last], effort, counter, frames); !timed)
                return Failure(timed.error());
    }
    return frames;
}

} // namespace limen::bench
