#pragma once

#include "core/Error.h"
#include "engine/stream/Streamer.h"
#include "play/PlayInput.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

// A recorded walk, for replay. The text form is JSON lines: first the start, then one line per frame.
namespace limen::play {

struct RecordedFrame {
    PlayInput input;
    std::uint64_t decided = 0; ///< decisionHash of the resulting frame; 0: not compared
    /// The streamed part shown from this frame on. Its zone option is not recorded.
    std::optional<engine::PartTarget> shown;
    bool isRefused = false; ///< the destination could not be loaded
};

struct WalkRecord {
    std::string start; ///< options of `limen shot`
    /// Load options of a streamed walk; its frames name the shown parts. None: blocks were loaded at once
    /// when the eye came near an edge. The zone option is not recorded.
    std::optional<world::LoadOptions> streamed;
    std::vector<RecordedFrame> frames;
};

/// The first line and the line of a frame, each with its line end.
[[nodiscard]] std::string beginningLine(const std::string& start,
                                        const std::optional<world::LoadOptions>& streamed = {});
[[nodiscard]] std::string frameLine(const RecordedFrame& frame);

/// `name` appears in messages. Errors: a malformed line, with its number; no frame.
[[nodiscard]] Result<WalkRecord> parseWalk(const std::string& text, const std::string& name);
[[nodiscard]] Result<WalkRecord> readWalk(const std::filesystem::path& file);

} // namespace limen::play
