#include "gpu/texture/PageLayout.h"

#include "core/Assert.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace limen::gpu {
namespace {

// Textures with a common shape, by index.
struct Group {
    TextureClass shape;
    std::vector<std::uint32_t> members;

    [[nodiscard]] std::uint64_t texels() const {
        return std::uint64_t{shape.width} * shape.height * members.size();
    }
    [[nodiscard]] std::size_t pages(std::uint32_t maxLayers) const {
        return (members.size() + maxLayers - 1) / maxLayers;
    }
};

TextureClass unionOf(const TextureClass& a, const TextureClass& b) {
    return {std::max(a.width, b.width), std::max(a.height, b.height), a.clamp};
}

std::vector<Group> groupByClass(std::span<const TextureClass> textures) {
    std::vector<Group> groups;
    for (std::uint32_t i = 0; i < textures.size(); ++i) {
        const auto same = [&](const Group& group) { return group.shape == textures[i]; };
        const auto found = std::find_if(groups.begin(), groups.end(), same);
        if (found != groups.end())
            found->members.push_back(i);
        else
            groups.push_back({textures[i], {i}});
    }
    return groups;
}

std::size_t pageCount(std::span<const Group> groups, std::uint32_t maxLayers) {
    std::size_t count = 0;
    for (const Group& group : groups)
        count += group.pages(maxLayers);
    return count;
}

struct Merge {
    std::size_t into = 0, from = 0;
};

// The pair that saves a page and whose union adds the fewest texels.
std::optional<Merge> cheapestMerge(std::span<const Group> groups, std::uint32_t maxLayers) {
    std::optional<Merge> best;
    std::uint64_t bestCost = std::numeric_limits<std::uint64_t>::max();
    for (std::size_t a = 0; a < groups.size(); ++a) {
        for (std::size_t b = a + 1; b < groups.size(); ++b) {
            const std::size_t layers = groups[a].members.size() + groups[b].members.size();
            const bool saves = (layers + maxLayers - 1) / maxLayers <
                               groups[a].pages(maxLayers) + groups[b].pages(maxLayers);
            if (groups[a].shape.clamp != groups[b].shape.clamp || !saves)
                continue;
            const TextureClass both = unionOf(groups[a].shape, groups[b].shape);
            const std::uint64_t cost =
                std::uint64_t{both.width} * both.height * layers - groups[a].texels() - groups[b].texels();
            if (cost < bestCost) {
                bestCost = cost;
                best = Merge{a, b};
            }
        }
    }
    return best;
}

void mergeUntilItFits(std::vector<Group>& groups, std::uint32_t maxPages, std::uint32_t maxLayers) {
    while (pageCount(groups, maxLayers) > maxPages) {
        const std::optional<Merge> merge = cheapestMerge(groups, maxLayers);
        if (!merge)
            return;
        Group& into = groups[merge->into];
        Group& from = groups[merge->from];
        into.shape = unionOf(into.shape, from.shape);
        into.members.insert(into.members.end(), from.members.begin(), from.members.end());
        std::sort(into.members.begin(), into.members.end());
        groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(merge->from));
    }
}

/// Puts each texture into the first page of its shape with room; appends new pages.
PageLayout extendPages(std::span<const TextureClass> before, std::span<const TextureClass> textures,
                       std::uint32_t maxLayers) {
    PageLayout layout;
    for (const TextureClass& shape : before)
        layout.pages.push_back({shape, 0});
    for (const TextureClass& texture : textures) {
        const auto hasRoom = [&](const PageLayout::Page& page) {
            return page.shape == texture && page.layers < maxLayers;
        };
        auto page = std::find_if(layout.pages.begin(), layout.pages.end(), hasRoom);
        if (page == layout.pages.end())
            page = layout.pages.insert(page, {texture, 0});
        layout.locations.push_back({static_cast<std::uint32_t>(page - layout.pages.begin()), page->layers++});
    }
    return layout;
}

} // namespace

PageLayout layOutPages(std::span<const TextureClass> textures, std::uint32_t maxPages,
                       std::uint32_t maxLayers, std::span<const TextureClass> before) {
    LIMEN_ASSERT(maxPages >= 2 && maxLayers >= 1, "at least a page for each wrapping mode");
    if (!before.empty()) {
        PageLayout extended = extendPages(before, textures, maxLayers);
        if (extended.pages.size() <= maxPages)
            return extended;
    }
    std::vector<Group> groups = groupByClass(textures);
    mergeUntilItFits(groups, maxPages, maxLayers);
    PageLayout layout;
    layout.locations.resize(textures.size());
    for (const Group& group : groups) {
        for (std::size_t i = 0; i < group.members.size(); ++i) {
            if (i % maxLayers == 0)
                layout.pages.push_back({group.shape, 0});
            const std::uint32_t texture = group.members[i];
            layout.locations[texture] = {static_cast<std::uint32_t>(layout.pages.size() - 1),
                                         layout.pages.back().layers++};
            layout.resampled += textures[texture] == group.shape ? 0u : 1u;
        }
    }
    return layout;
}

} // namespace limen::gpu
