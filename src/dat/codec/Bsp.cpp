#include "dat/codec/Mesh.h"

namespace limen::dat {
namespace {

struct Children {
    bool positive = false;
    bool negative = false;
};

/// A tag that is none of the enumerators has no children, as in the original.
Children childrenOf(BspTag tag) {
    switch (tag) {
    case BspTag::BPnn:
    case BspTag::BPIn:
        return {true, false};
    case BspTag::BpIN:
    case BspTag::BpnN:
        return {false, true};
    case BspTag::Port:
    case BspTag::BPIN:
    case BspTag::BPnN:
        return {true, true};
    case BspTag::Leaf:
    case BspTag::BPOL:
    case BspTag::BPFL:
        return {};
    }
    return {};
}

/// The fields of a leaf behind its tag.
template <class IO, class Node>
void leafBody(IO& io, Node& node, BspKind kind) {
    io.value(node.leafIndex);
    if (kind != BspKind::Physics)
        return;
    io.value(node.solid);
    sphere(io, node.sphere);
    values<std::uint32_t>(io, node.polygonIds, "polygon ids");
}

template <class IO, class Ref>
void portalRef(IO& io, Ref& ref) {
    io.value(ref.polygonId);
    io.value(ref.portalIndex);
}

void portalLists(ByteReader& io, BspNode& node) {
    const auto polygonCount = io.count<std::uint32_t>("polygon ids");
    const auto portalCount = io.count<std::uint32_t>("portals");
    io.array(node.polygonIds, polygonCount);
    io.items(node.portals, portalCount, sizeof(PortalRef), "portals",
             [&](PortalRef& ref) { portalRef(io, ref); });
}

void portalLists(ByteWriter& io, const BspNode& node) {
    io.count<std::uint32_t>(node.polygonIds.size());
    io.count<std::uint32_t>(node.portals.size());
    io.array(node.polygonIds, node.polygonIds.size());
    for (const PortalRef& ref : node.portals)
        portalRef(io, ref);
}

/// The fields of an inner node behind its children.
template <class IO, class Node>
void innerTail(IO& io, Node& node, BspKind kind) {
    const bool isPortal = node.tag == BspTag::Port;
    if (kind == BspKind::Drawing) {
        sphere(io, node.sphere);
        if (isPortal)
            portalLists(io, node);
        else
            values<std::uint32_t>(io, node.polygonIds, "polygon ids");
    } else if (kind == BspKind::Physics && !isPortal) {
        sphere(io, node.sphere);
    }
}

/// Reads a node and its subtree. Returns its index. Nodes are addressed by index, because the array grows
/// while it is read.
std::int32_t readNode(ByteReader& io, BspTree& tree, BspKind kind, int depth) {
    const std::size_t start = io.offset();
    const auto tag = io.get<BspTag>();
    if (io.failed())
        return -1;
    if (depth >= kMaxBspDepth) {
        io.failAt(start, fmt::format("the BSP tree is deeper than {} nodes", kMaxBspDepth));
        return -1;
    }
    const auto index = tree.nodes.size();
    {
        BspNode& node = tree.nodes.emplace_back();
        node.tag = tag;
        if (tag == BspTag::Leaf) {
            leafBody(io, node, kind);
            return static_cast<std::int32_t>(index);
        }
        plane(io, node.plane);
    }
    const Children children = childrenOf(tag);
    if (children.positive) {
        const std::int32_t child = readNode(io, tree, kind, depth + 1);
        tree.nodes[index].positive = child;
    }
    if (children.negative) {
        const std::int32_t child = readNode(io, tree, kind, depth + 1);
        tree.nodes[index].negative = child;
    }
    innerTail(io, tree.nodes[index], kind);
    return static_cast<std::int32_t>(index);
}

void writeNode(ByteWriter& io, const BspTree& tree, std::int32_t index, BspKind kind, int depth) {
    io.require(index >= 0 && static_cast<std::size_t>(index) < tree.nodes.size(), "a BSP node lacks a child");
    io.require(depth < kMaxBspDepth, "a BSP tree is too deep, or a node is its own descendant");
    if (io.failed())
        return;
    const BspNode& node = tree.nodes[static_cast<std::size_t>(index)];
    io.value(node.tag);
    if (node.tag == BspTag::Leaf) {
        leafBody(io, node, kind);
        return;
    }
    plane(io, node.plane);
    const Children children = childrenOf(node.tag);
    if (children.positive)
        writeNode(io, tree, node.positive, kind, depth + 1);
    if (children.negative)
        writeNode(io, tree, node.negative, kind, depth + 1);
    innerTail(io, node, kind);
}

} // namespace

void bsp(ByteReader& io, BspTree& out, BspKind kind) {
    if (!io.failed())
        readNode(io, out, kind, 0);
}

void bsp(ByteWriter& io, const BspTree& in, BspKind kind) {
    io.require(!in.nodes.empty(), "the format requires a BSP tree here; the smallest is a single leaf");
    writeNode(io, in, 0, kind, 0);
}

} // namespace limen::dat
