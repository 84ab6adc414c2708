#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// Parts that all reports share. Plain data.
namespace limen::output {

/// The facts at the top of a report.
struct ReportHead {
    std::string world;                                      ///< "built-in world" or the directory
    std::string version;                                    ///< of the program
    std::string driver;                                     ///< in one line
    std::string made;                                       ///< date and time, as text
    std::string command;                                    ///< the command line that made the report
    std::vector<std::pair<std::string, std::string>> facts; ///< further names and values
};

/// A picture as the bytes of a file.
struct ReportPicture {
    std::string caption;
    std::string mediaType; ///< such as "image/webp"
    std::vector<std::byte> bytes;
    std::uint32_t width = 0, height = 0; ///< pixels
};

/// A fault, or a frame that deserves a look.
struct ReportFinding {
    std::string text;
    std::string command; ///< draws it again; empty: none
    std::optional<std::size_t> frame;
};

} // namespace limen::output
