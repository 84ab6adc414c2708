#pragma once

#include "dat/Codec.h"

#include <cstring>

namespace limen::dat {

enum class ChainFault { None, BadOffset, EndsEarly, Repeats, TooLarge };

/// A fault of a chain of blocks, and its offset.
struct ChainStatus {
    ChainFault fault = ChainFault::None;
    std::uint32_t offset = 0;
    [[nodiscard]] bool ok() const { return fault == ChainFault::None; }
};

[[nodiscard]] std::string inWords(const ChainStatus& status);

/// The blocks of a file and the chains that they form (docs/formats/container.md#blocks). Every offset is checked
/// before its block is touched.
class Blocks {
public:
    Blocks(ByteView file, std::uint32_t blockSize);

    [[nodiscard]] std::uint32_t blockSize() const { return blockSize_; }
    [[nodiscard]] std::size_t capacity() const { return capacity_; } ///< payload bytes of a block
    [[nodiscard]] std::size_t blockCount() const { return file_.size() / blockSize_; }
    [[nodiscard]] std::uint32_t firstUsable() const { return firstUsable_; }

    /// True for the offset of a block: behind the header, aligned, inside the file, top bit clear.
    [[nodiscard]] bool isBlock(std::uint32_t offset) const {
        return offset >= firstUsable_ && offset <= lastBlock_ && (offset & (blockSize_ - 1)) == 0;
    }
    [[nodiscard]] std::uint32_t link(std::uint32_t block) const { return word(block); }
    [[nodiscard]] const std::byte* payload(std::uint32_t block) const { return file_.data() + block + 4; }
    /// Prefetches the cache line at an offset. Requires: it is inside the file.
    void prefetch(std::size_t offset) const { __builtin_prefetch(file_.data() + offset); }
    [[nodiscard]] std::uint32_t word(std::size_t offset) const {
        std::uint32_t out = 0;
        std::memcpy(&out, file_.data() + offset, sizeof out);
        return out;
    }

    /// The number of blocks of an object of `size` bytes.
    [[nodiscard]] std::size_t blocksFor(std::size_t size) const {
        return size == 0 ? 1 : (size + capacity_ - 1) / capacity_;
    }
    /// Writes the offsets of a chain's first `count` blocks to `out`. Does not check for repetitions.
    [[nodiscard]] ChainStatus offsets(std::uint32_t first, std::size_t count, std::uint32_t* out) const;
    /// Copies `size` bytes of a chain. Before it allocates, refuses sizes larger than the file, and chains
    /// that visit a block twice.
    [[nodiscard]] ChainStatus copy(std::uint32_t first, std::size_t size, Bytes& out) const;

private:
    [[nodiscard]] ChainStatus checkNoRepeat(std::uint32_t first, std::size_t count) const;

    ByteView file_;
    std::uint32_t blockSize_ = 0;
    std::size_t capacity_ = 0;
    std::uint32_t firstUsable_ = 0;
    std::uint32_t lastBlock_ = 0; ///< the last offset of a whole block; 0 if there is none
};

} // namespace limen::dat
