#include "check/Totals.h"

#include "core/Hash.h"

#include <algorithm>

namespace limen::check {

std::uint64_t KindTotals::disagreeing() const {
    return count(Verdict::EdgeOn) + count(Verdict::Disagrees) + count(Verdict::Void);
}

std::uint64_t KindTotals::findings() const {
    return disagreeing() + count(Verdict::Depth) + count(Verdict::Layers) + moved;
}

void KindTotals::add(const KindTotals& other) {
    views += other.views;
    pixels += other.pixels;
    moved += other.moved;
    for (std::size_t i = 0; i < kVerdictCount; ++i)
        counts[i] += other.counts[i];
}

void Totals::add(const View& view, std::uint64_t number, const Comparison& comparison, std::uint64_t moved,
                 std::uint64_t picture) {
    Hash hash;
    hash.add(pictures);
    hash.add(picture);
    pictures = hash.value();
    const KindTotals one{1, comparison.verdicts.size(), comparison.counts, moved};
    kinds[static_cast<std::size_t>(view.kind)].add(one);
    if (one.findings() == 0)
        return;
    ++viewsWithFindings;
    const Finding finding{view, one.findings(), number, comparison.counts, moved};
    const auto isWorse = [](const Finding& a, const Finding& b) {
        return a.grave() != b.grave() ? a.grave() > b.grave() : a.count > b.count;
    };
    const auto place = std::upper_bound(worst.begin(), worst.end(), finding, isWorse);
    worst.insert(place, finding);
    if (worst.size() > kWorst)
        worst.pop_back();
}

KindTotals Totals::sum() const {
    KindTotals all;
    for (const KindTotals& kind : kinds)
        all.add(kind);
    return all;
}

} // namespace limen::check
