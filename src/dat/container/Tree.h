#pragma once

#include "dat/File.h"
#include "dat/container/Blocks.h"
#include "dat/container/Format.h"

#include <array>
#include <atomic>

namespace limen::dat {

/// The B-tree of a file, read in place (docs/formats/container.md#b-tree). A node's count and range are checked at
/// every visit; its chain, the order of its keys and its branches are checked once, and two bits store the
/// result. Look-ups write nothing else, so any number of threads may look up at once.
class Tree {
public:
    /// `root` 0 is a tree without entries. Messages contain `name`.
    Tree(const Blocks& blocks, std::uint32_t root, std::string name);

    [[nodiscard]] Result<std::optional<Entry>> find(RecordId id) const;
    [[nodiscard]] Result<void> forEach(const std::function<bool(const Entry&)>& visit,
                                       std::vector<std::string>* warnings, IndexShape* shape) const;
    [[nodiscard]] Result<void> checkRoot() const;

private:
    static constexpr std::size_t kWords = kNodeBytes / 4;
    static constexpr std::size_t kMaxNodeBlocks = (kNodeBytes + kMinBlockSize - 5) / (kMinBlockSize - 4);

    /// The open interval of ids of a subtree.
    struct Range {
        std::int64_t low = -1;
        std::int64_t high = std::int64_t{1} << 32;
    };
    /// A node in place.
    struct Node {
        std::uint32_t offset = 0;
        std::uint32_t count = 0;
        bool isLeaf = true;
        std::array<std::uint32_t, kMaxNodeBlocks> blocks;
    };
    struct Traversal;

    [[nodiscard]] std::uint32_t word(const Node& node, std::size_t index) const {
        return blocks_.word(node.blocks[wordBlock_[index]] + wordOffset_[index]);
    }
    [[nodiscard]] std::uint32_t branch(const Node& node, std::size_t i) const { return word(node, i); }
    [[nodiscard]] RecordId idAt(const Node& node, std::size_t i) const {
        return word(node, kEntriesAt / 4 + i * (kEntryBytes / 4) + 1);
    }
    [[nodiscard]] Entry entryAt(const Node& node, std::size_t i) const;
    /// Index of the first entry whose id is not less than `id`.
    [[nodiscard]] std::size_t lowerBound(const Node& node, RecordId id) const;

    /// Opens the node at `offset`, whose ids must be in `range`. Returns the reason if it is damaged.
    [[nodiscard]] std::string load(std::uint32_t offset, const Range& range, Node& node) const;
    /// Makes the checks that depend on the node's bytes alone.
    [[nodiscard]] std::string inspect(const Node& node) const;
    [[nodiscard]] bool isInOnePiece(const Node& node) const;
    [[nodiscard]] Failure damaged(std::uint32_t offset, std::string reason) const;
    /// Adds a visited node to the shape.
    void note(const Node& node, int depth, IndexShape& shape) const;
    [[nodiscard]] Result<void> traverse(std::uint32_t offset, const Range& range, int depth,
                                        Traversal& traversal) const;

    /// The result of earlier checks of the node at a block. Bits are only ever set.
    enum class State : std::uint64_t { Unknown = 0, Sound = 1, SoundInOnePiece = 3 };
    [[nodiscard]] State stateOf(std::uint32_t offset) const;
    void remember(std::uint32_t offset, State state) const;
    /// Prefetches all cache lines that a search will read.
    void prefetch(std::uint32_t offset) const;

    Blocks blocks_;
    std::uint32_t root_ = 0;
    std::string name_;
    std::size_t blocksPerNode_ = 0;
    std::array<std::uint8_t, kWords>
        wordBlock_{}; ///< index in the chain of the block that holds a word of the node
    std::array<std::uint16_t, kWords> wordOffset_{};       ///< its offset in the block, link included
    std::unique_ptr<std::atomic<std::uint64_t>[]> states_; ///< two bits a block
};

} // namespace limen::dat
