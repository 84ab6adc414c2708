#pragma once

#include "BenchRow.h"
#include "frames/FrameTimes.h"

namespace limen::bench {

/// Measures whole frames along the built-in world's tour at 1280×720.
///
/// `frame/cpu`: processor time of this thread on the null device, from the dynamic state to the last call,
/// median over all way points. The other rows are those of `compareFrames`, over eight way points in cells and
/// eight outside; without OpenGL there are none. Takes some minutes with a software driver. Writes the
/// built-in world to the system's temporary directory and removes it.
[[nodiscard]] std::vector<BenchRow> benchFrame(AllocationCounter counter = nullptr);
/// Also writes a picture of each place and way into the directory `pictures`.
[[nodiscard]] std::vector<BenchRow> benchFrameWith(AllocationCounter counter, const std::string& pictures);

/// Compares whole frames with a driver: Limen's ways of drawing, the same program without visibility, the
/// plain renderer (plain/PlainWay.h), and the scene graph where it is built (peer/Peer.h). One of frames/FrameRows.h
/// for each kind and place, and `frame/ownership`. A failure gives one row that misses its target.
[[nodiscard]] std::vector<BenchRow> compareFrames(const dat::Archive& archive, const world::WorldFile& file,
                                                  const std::vector<world::Place>& places,
                                                  const FrameEffort& effort);

} // namespace limen::bench
