#pragma once

#include "output/report/ReportHead.h"

namespace limen::output {

/// One line of a plot: a value for each recorded frame; NaN: unknown.
struct ReportSeries {
    std::string name;
    std::vector<double> values;
};

/// A plot over the recorded frames.
struct ReportPlot {
    std::string title, unit;
    std::string note; ///< one sentence on the meaning of the values
    std::vector<ReportSeries> series;
};

/// The spaces that a tour saw, the openings between them, and the part that each frame saw.
struct ReportGraph {
    struct Node {
        std::string name;
        double x = 0.0, y = 0.0; ///< metres east and north
        bool isOutside = false;
    };
    struct Frame {
        std::uint32_t root = 0;           ///< index into nodes
        std::vector<std::uint32_t> nodes; ///< spaces that the frame saw, the root among them
        std::vector<std::uint32_t> edges; ///< openings between two of them
    };
    std::vector<Node> nodes;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges; ///< indices into nodes
    std::vector<Frame> frames;                                  ///< by recorded frame
};

/// A tour as data. All lists over frames have one entry for each recorded frame.
struct TourReport {
    ReportHead head;
    std::size_t framesDrawn = 0;
    double framesPerSecond = 0.0;     ///< for playing the pictures; 0: unknown
    std::vector<std::size_t> numbers; ///< of the recorded frames
    std::vector<std::string> commands;
    std::vector<ReportPicture> pictures;
    std::vector<std::size_t> pictureFrames; ///< the recorded frame of each picture, ascending
    std::vector<ReportPlot> plots;
    ReportGraph graph;
    std::vector<ReportFinding> findings;   ///< faults
    std::vector<ReportFinding> highlights; ///< extreme frames
};

/// The report as one HTML page without references to other files.
[[nodiscard]] std::string tourPage(const TourReport& report);

} // namespace limen::output
