#include "dat/container/Tree.h"

#include <algorithm>

#include <fmt/format.h>

namespace limen::dat {
namespace {

constexpr std::size_t kStatesPerWord = 32;

} // namespace

/// The state of forEach.
struct Tree::Traversal {
    const std::function<bool(const Entry&)>& visit;
    std::vector<bool> seen; ///< by block number
    IndexShape shape;
    int leafDepth = -1;
    bool unevenLeaves = false;
    bool stopped = false;
};

Tree::Tree(const Blocks& blocks, std::uint32_t root, std::string name)
    : blocks_(blocks), root_(root), name_(std::move(name)), blocksPerNode_(blocks.blocksFor(kNodeBytes)),
      states_(std::make_unique<std::atomic<std::uint64_t>[]>(blocks.blockCount() / kStatesPerWord + 1)) {
    for (std::size_t i = 0; i < kWords; ++i) {
        wordBlock_[i] = static_cast<std::uint8_t>(i * 4 / blocks.capacity());
        wordOffset_[i] = static_cast<std::uint16_t>(4 + i * 4 % blocks.capacity());
    }
}

Entry Tree::entryAt(const Node& node, std::size_t i) const {
    const std::size_t at = kEntriesAt / 4 + i * (kEntryBytes / 4);
    const std::uint32_t first = word(node, at);
    Entry entry;
    entry.flags = static_cast<std::uint16_t>(first & 0xFFFF);
    entry.version = static_cast<std::uint16_t>(first >> 16);
    entry.id = word(node, at + 1);
    entry.offset = word(node, at + 2);
    entry.size = word(node, at + 3);
    entry.date = word(node, at + 4);
    entry.iteration = static_cast<std::int32_t>(word(node, at + 5));
    return entry;
}

std::size_t Tree::lowerBound(const Node& node, RecordId id) const {
    std::size_t first = 0;
    std::size_t count = node.count;
    while (count > 0) {
        const std::size_t half = count / 2;
        if (idAt(node, first + half) < id) {
            first += half + 1;
            count -= half + 1;
        } else {
            count = half;
        }
    }
    return first;
}

Tree::State Tree::stateOf(std::uint32_t offset) const {
    const std::size_t block = offset / blocks_.blockSize();
    const std::uint64_t word = states_[block / kStatesPerWord].load(std::memory_order_relaxed);
    return static_cast<State>((word >> (block % kStatesPerWord * 2)) & 3);
}

void Tree::remember(std::uint32_t offset, State state) const {
    const std::size_t block = offset / blocks_.blockSize();
    const std::uint64_t bits = static_cast<std::uint64_t>(state) << (block % kStatesPerWord * 2);
    states_[block / kStatesPerWord].fetch_or(bits, std::memory_order_relaxed);
}

void Tree::prefetch(std::uint32_t offset) const {
    constexpr std::size_t kStep =
        kWords / 9; // first branch, count, and the first ids that a search of 61 compares
    for (std::size_t i = 0; i < kWords; i += kStep)
        blocks_.prefetch(offset + wordBlock_[i] * blocks_.blockSize() + wordOffset_[i]);
}

std::string Tree::inspect(const Node& node) const {
    for (std::size_t i = 1; i < node.count; ++i)
        if (idAt(node, i) <= idAt(node, i - 1))
            return fmt::format("id 0x{:08X} comes after 0x{:08X}", idAt(node, i), idAt(node, i - 1));
    if (node.isLeaf)
        return {};
    if (node.count == 0)
        return "it has a branch but no entries";
    for (std::size_t i = 0; i <= node.count; ++i)
        if (!blocks_.isBlock(branch(node, i)))
            return fmt::format("branch {} is 0x{:X}, which is not the offset of a block", i, branch(node, i));
    return {};
}

bool Tree::isInOnePiece(const Node& node) const {
    for (std::size_t i = 1; i < blocksPerNode_; ++i)
        if (node.blocks[i] != node.blocks[i - 1] + blocks_.blockSize())
            return false;
    return true;
}

std::string Tree::load(std::uint32_t offset, const Range& range, Node& node) const {
    node.offset = offset;
    const State state = blocks_.isBlock(offset) ? stateOf(offset) : State::Unknown;
    if (state == State::SoundInOnePiece) {
        prefetch(offset);
        for (std::size_t i = 0; i < blocksPerNode_; ++i)
            node.blocks[i] = offset + static_cast<std::uint32_t>(i) * blocks_.blockSize();
    } else if (const ChainStatus status = blocks_.offsets(offset, blocksPerNode_, node.blocks.data());
               !status.ok()) {
        return inWords(status);
    }
    node.count = word(node, kCountAt / 4);
    if (node.count > kMaxEntries)
        return fmt::format("it claims {} entries; {} fit", node.count, kMaxEntries);
    const std::uint32_t first = branch(node, 0);
    node.isLeaf = first == 0 || first == kNoBranchFill;
    if (state == State::Unknown) {
        if (std::string reason = inspect(node); !reason.empty())
            return reason;
        remember(offset, isInOnePiece(node) ? State::SoundInOnePiece : State::Sound);
    }
    if (node.count > 0 && (idAt(node, 0) <= range.low || idAt(node, node.count - 1) >= range.high))
        return fmt::format("its ids 0x{:08X} to 0x{:08X} are out of the order of the tree", idAt(node, 0),
                           idAt(node, node.count - 1));
    return {};
}

Failure Tree::damaged(std::uint32_t offset, std::string reason) const {
    return fail(ErrorCode::Malformed, fmt::format("{}, index node at 0x{:X}", name_, offset),
                std::move(reason));
}

Result<std::optional<Entry>> Tree::find(RecordId id) const {
    std::uint32_t offset = root_;
    Range range;
    if (offset == 0)
        return std::nullopt;
    Node node;
    for (int depth = 0; depth < kMaxDepth; ++depth) {
        if (std::string reason = load(offset, range, node); !reason.empty())
            return damaged(offset, std::move(reason));
        const std::size_t at = lowerBound(node, id);
        if (at < node.count && idAt(node, at) == id)
            return entryAt(node, at);
        if (node.isLeaf)
            return std::nullopt;
        if (at > 0)
            range.low = idAt(node, at - 1);
        if (at < node.count)
            range.high = idAt(node, at);
        offset = branch(node, at);
    }
    return damaged(offset, fmt::format("the index is deeper than {} nodes", kMaxDepth));
}

Result<void> Tree::checkRoot() const {
    if (root_ == 0)
        return {};
    Node node;
    if (std::string reason = load(root_, {}, node); !reason.empty())
        return damaged(root_, std::move(reason));
    return {};
}

void Tree::note(const Node& node, int depth, IndexShape& shape) const {
    ++shape.nodes;
    shape.depth = std::max(shape.depth, depth + 1);
    if (depth > 0)
        return;
    for (std::size_t i = 0; i < node.count; ++i)
        shape.rootKeys.push_back(idAt(node, i));
    for (std::size_t i = 0; !node.isLeaf && i <= node.count; ++i)
        shape.rootBranches.push_back(branch(node, i));
}

Result<void> Tree::traverse(std::uint32_t offset, const Range& range, int depth, Traversal& traversal) const {
    if (depth >= kMaxDepth)
        return damaged(offset, fmt::format("the index is deeper than {} nodes", kMaxDepth));
    Node node;
    if (std::string reason = load(offset, range, node); !reason.empty())
        return damaged(offset, std::move(reason));
    const std::size_t block = offset / blocks_.blockSize();
    if (traversal.seen[block])
        return damaged(offset, "two branches lead to it");
    traversal.seen[block] = true;
    note(node, depth, traversal.shape);
    if (node.isLeaf) {
        traversal.unevenLeaves =
            traversal.unevenLeaves || (traversal.leafDepth >= 0 && traversal.leafDepth != depth);
        traversal.leafDepth = depth;
    }
    Range below{range.low, range.high};
    for (std::size_t i = 0; i <= node.count && !traversal.stopped; ++i) {
        below.high = i < node.count ? std::int64_t{idAt(node, i)} : range.high;
        if (!node.isLeaf) {
            if (auto done = traverse(branch(node, i), below, depth + 1, traversal); !done)
                return done;
        }
        if (i == node.count || traversal.stopped)
            break;
        traversal.stopped = !traversal.visit(entryAt(node, i));
        below.low = idAt(node, i);
    }
    return {};
}

Result<void> Tree::forEach(const std::function<bool(const Entry&)>& visit, std::vector<std::string>* warnings,
                           IndexShape* shape) const {
    if (root_ == 0)
        return {};
    Traversal traversal{visit, std::vector<bool>(blocks_.blockCount()), {}, -1, false, false};
    auto done = traverse(root_, {}, 0, traversal);
    if (done && traversal.unevenLeaves && warnings != nullptr)
        warnings->push_back(fmt::format("{}: the leaves of the index are at unequal depths", name_));
    if (shape != nullptr)
        *shape = std::move(traversal.shape);
    return done;
}

} // namespace limen::dat
