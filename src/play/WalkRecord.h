#pragma once

#include "core/Error.h"
#include "engine/Streamer.h"
#include "play/PlayInput.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

// A walk as it was played, to be played again. As text: JSON lines, the first of them where it began, then one for each frame.
namespace limen::play {

struct RecordedFrame {
    PlayInput input;
    std::uint64_t decided = 0; ///< decisionHash of the frame it led to
    std::optional<engine::PartTarget>
        shown;              ///< what was streamed and is shown from this frame on; zones are not told
    bool isRefused = false; ///< the place that was to be gone to could not be loaded
};

struct WalkRecord {
    std::string start; ///< options of `limen shot`
    /// How the world was loaded where it was streamed: frames say what was shown when. None: it was loaded at once whenever the eye
    /// came near an edge. Zones are not told.
    std::optional<world::LoadOptions> streamed;
    std::vector<RecordedFrame> frames;
};

/// The first line, and those of frames; each ended.
[[nodiscard]] std::string beginningLine(const std::string& start,
                                        const std::optional<world::LoadOptions>& streamed = {});
[[nodiscard]] std::string frameLine(const RecordedFrame& frame);

/// `name` is for messages. Errors: a line that is not of this shape, with its number; no frame.
[[nodiscard]] Result<WalkRecord> parseWalk(const std::string& text, const std::string& name);
[[nodiscard]] Result<WalkRecord> readWalk(const std::filesystem::path& file);

} // namespace limen::play
