#pragma once

#include "dat/Codec.h"

#include <cstring>

namespace limen::dat {

/// What can be wrong with a chain of blocks.
enum class ChainFault { None, BadOffset, EndsEarly, Repeats, TooLarge };

/// A fault and the offset at which it was met.
struct ChainStatus {
    ChainFault fault = ChainFault::None;
    std::uint32_t offset = 0;
    [[nodiscard]] bool ok() const { return fault == ChainFault::None; }
};

/// The fault in words.
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

    /// True if a block may start here: behind the header, aligned, inside the file, top bit clear.
    [[nodiscard]] bool isBlock(std::uint32_t offset) const {
        return offset >= firstUsable_ && offset <= lastBlock_ && (offset & (blockSize_ - 1)) == 0;
    }
    [[nodiscard]] std::uint32_t link(std::uint32_t block) const { return word(block); }
    [[nodiscard]] const std::byte* payload(std::uint32_t block) const { return file_.data() + block + 4; }
    /// Asks for the cache line at an offset that lies inside the file.
    void prefetch(std::size_t offset) const { __builtin_prefetch(file_.data() + offset); }
    [[nodiscard]] std::uint32_t word(std::size_t offset) const {
        std::uint32_t out = 0;
        std::memcpy(&out, file_.data() + offset, sizeof out);
        return out;
    }

    /// Blocks that an object of `size` bytes takes.
    [[nodiscard]] std::size_t blocksFor(std::size_t size) const {
        return size == 0 ? 1 : (size + capacity_ - 1) / capacity_;
    }
    /// The offsets of a chain's first `count` blocks into `out`. Repetitions are not looked for.
    [[nodiscard]] ChainStatus offsets(std::uint32_t first, std::size_t count, std::uint32_t* out) const;
    /// Copies `size` bytes of a chain. Refuses, before it allocates, what is larger than the file, and chains
    /// that visit a block twice.
    [[nodiscard]] ChainStatus copy(std::uint32_t first, std::size_t size, Bytes& out) const;

private:
    [[nodiscard]] ChainStatus checkNoRepeat(std::uint32_t first, std::size_t count) const;

    ByteView file_;
    std::uint32_t blockSize_ = 0;
    std::size_t capacity_ = 0;
    std::uint32_t firstUsable_ = 0;
    std::uint32_t lastBlock_ = 0; ///< the last offset at which a whole block fits; 0 if none does
};

} // namespace limen::dat
