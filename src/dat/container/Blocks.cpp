#include "dat/container/Blocks.h"

#include "dat/container/Format.h"

#include <algorithm>

#include <fmt/format.h>

namespace limen::dat {

std::string inWords(const ChainStatus& status) {
    switch (status.fault) {
    case ChainFault::None:
        break;
    case ChainFault::BadOffset:
        return fmt::format("0x{:X} is not the offset of a block of this file", status.offset);
    case ChainFault::EndsEarly:
        return fmt::format("its chain of blocks ends too early, at 0x{:X}", status.offset);
    case ChainFault::Repeats:
        return fmt::format("its chain of blocks comes back to 0x{:X}", status.offset);
    case ChainFault::TooLarge:
        return "it claims to be larger than the file";
    }
    return "nothing is wrong";
}

Blocks::Blocks(ByteView file, std::uint32_t blockSize)
    : file_(file), blockSize_(blockSize), capacity_(blockSize - 4),
      firstUsable_(static_cast<std::uint32_t>(firstUsableOffset(blockSize))) {
    // Offsets with the top bit mark free blocks and are never followed, so blocks beyond 2 GiB are
    // unreachable.
    const std::uint64_t reach = std::min<std::uint64_t>(file.size(), std::uint64_t{1} << 31);
    const std::uint64_t whole = reach / blockSize * blockSize;
    lastBlock_ = whole >= blockSize ? static_cast<std::uint32_t>(whole - blockSize) : 0;
}

ChainStatus Blocks::offsets(std::uint32_t first, std::size_t count, std::uint32_t* out) const {
    std::uint32_t at = first;
    std::uint32_t before = first;
    for (std::size_t i = 0; i < count; ++i) {
        if (!isBlock(at)) {
            if (i > 0 && at == 0)
                return {ChainFault::EndsEarly, before};
            return {ChainFault::BadOffset, at};
        }
        out[i] = at;
        before = at;
        at = link(at);
    }
    return {};
}

ChainStatus Blocks::copy(std::uint32_t first, std::size_t size, Bytes& out) const {
    const std::size_t count = blocksFor(size);
    if (size > file_.size() || count > blockCount())
        return {ChainFault::TooLarge, first};
    if (!isBlock(first))
        return {ChainFault::BadOffset, first};
    out.resize(size);
    std::uint32_t at = first;
    bool ascending = true;
    for (std::size_t done = 0;;) {
        const std::size_t part = std::min(capacity_, size - done);
        if (part != 0)
            std::memcpy(out.data() + done, payload(at), part);
        done += part;
        if (done == size)
            break;
        const std::uint32_t next = link(at);
        if (!isBlock(next))
            return next == 0 ? ChainStatus{ChainFault::EndsEarly, at}
                             : ChainStatus{ChainFault::BadOffset, next};
        ascending = ascending && next > at;
        at = next;
    }
    // An ascending chain cannot repeat a block. Others, which are rare, are checked.
    return ascending ? ChainStatus{} : checkNoRepeat(first, count);
}

ChainStatus Blocks::checkNoRepeat(std::uint32_t first, std::size_t count) const {
    std::vector<std::uint32_t> all(count);
    if (const ChainStatus status = offsets(first, count, all.data()); !status.ok())
        return status;
    std::sort(all.begin(), all.end());
    const auto twice = std::adjacent_find(all.begin(), all.end());
    return twice == all.end() ? ChainStatus{} : ChainStatus{ChainFault::Repeats, *twice};
}

} // namespace limen::dat
