#include "peer/Peer.h"

namespace limen::bench {

Result<std::unique_ptr<FrameWay>> makePeerWay(std::uint32_t, std::uint32_t) {
    return nullptr;
}

} // namespace limen::bench
