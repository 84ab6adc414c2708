#pragma once

#include "engine/Session.h"
#include "output/Picture.h"
#include "output/report/TourReport.h"

#include <map>

namespace limen::output {

/// Collects a TourReport while the frames of a tour are drawn. Long tours are thinned: at most 2,000 frames
/// are recorded and at most 120 pictures kept, chosen evenly.
class TourRecorder {
public:
    explicit TourRecorder(std::size_t frameCount) : frameCount_(frameCount) {}

    /// Records a frame that `session` has just drawn. Frames come in order. Errors: those of the encoder.
    [[nodiscard]] Result<void> add(const engine::Session& session, const engine::FrameRequest& request,
                                   std::size_t frame, const Picture& picture);
    /// Adds a fault that belongs to no frame.
    void addFinding(std::string text);
    /// The report of all frames so far.
    [[nodiscard]] TourReport finish(ReportHead head) &&;

private:
    using Edge = std::pair<std::uint32_t, std::uint32_t>;

    void addFigures(const engine::Session& session);
    void addSpaces(const engine::Session& session, const engine::FrameRequest& request);
    void addFaults(const engine::Session& session, const std::string& command);
    /// The series of a plot; made on its first value, with NaN for earlier frames.
    void put(ReportPlot& plot, const std::string& name, double value);
    [[nodiscard]] std::uint32_t nodeOf(const world::World& world, std::uint32_t space);
    void addHighlight(const ReportPlot& plot, const char* text);

    std::size_t frameCount_;
    TourReport report_;
    std::map<dat::RecordId, std::uint32_t> nodes_; ///< by cell; 0: outside
    std::map<Edge, std::uint32_t> edges_;
    ReportPlot processor_{"Processor time",
                          "ms",
                          "Flood, plan, and the submission of each stage of drawing, on the processor.",
                          {}};
    ReportPlot graphics_{"Graphics time", "ms", "Time of each stage on the graphics device.", {}};
    ReportPlot visits_{
        "Visits and spaces", "", "Visits of the eye's rays, and spaces that at least one visit may see.", {}};
    ReportPlot draws_{"Draws", "", "Draw commands of all stages, instances drawn, and calls of OpenGL.", {}};
};

} // namespace limen::output
