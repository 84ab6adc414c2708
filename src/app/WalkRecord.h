#pragma once

#include "app/PlayInput.h"
#include "core/Error.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

// A walk as it was played, to be played again. As text: JSON lines, the first of them where it began, then one for each frame.
namespace limen::app {

struct RecordedFrame {
    PlayInput input;
    std::uint64_t decided = 0; ///< decisionHash of the frame it led to
};

struct WalkRecord {
    std::string start; ///< options of `limen shot`
    std::vector<RecordedFrame> frames;
};

/// The first line, and those of frames; each ended.
[[nodiscard]] std::string beginningLine(const std::string& start);
[[nodiscard]] std::string frameLine(const RecordedFrame& frame);

/// `name` is for messages. Errors: a line that is not of this shape, with its number; no frame.
[[nodiscard]] Result<WalkRecord> parseWalk(const std::string& text, const std::string& name);
[[nodiscard]] Result<WalkRecord> readWalk(const std::filesystem::path& file);

} // namespace limen::app
