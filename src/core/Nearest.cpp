#include "core/Nearest.h"

#include <algorithm>
#include <numeric>

namespace limen {
namespace {

constexpr std::string_view kIgnored = " -_'.";
constexpr std::size_t kLongestName = 64; // letters compared; bounds the cost of a pasted text

char lowerOf(char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

/// The distance of two plain names; none if they do not resemble each other.
constexpr std::size_t kUnlike = ~std::size_t{0};
std::size_t unlikeness(std::string_view wanted, std::string_view candidate) {
    if (wanted.empty() || candidate.empty())
        return kUnlike;
    const std::size_t distance = editDistance(wanted, candidate);
    if (distance <= std::max<std::size_t>(1, wanted.size() / 3))
        return distance;
    constexpr std::size_t kFewestLetters = 3;
    const auto& [shorter, longer] = std::minmax(
        wanted, candidate, [](std::string_view a, std::string_view b) { return a.size() < b.size(); });
    return shorter.size() >= kFewestLetters && longer.find(shorter) != std::string_view::npos
               ? kLongestName + longer.size() - shorter.size()
               : kUnlike;
}

} // namespace

std::string plainName(std::string_view name) {
    std::string plain;
    for (const char letter : name)
        if (kIgnored.find(letter) == std::string_view::npos)
            plain += lowerOf(letter);
    return plain;
}

std::size_t editDistance(std::string_view a, std::string_view b) {
    a = a.substr(0, kLongestName);
    b = b.substr(0, kLongestName);
    // Rows of the table of prefixes: two ago, the last, the next. Ref: optimal string alignment.
    std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), next(b.size() + 1);
    std::iota(last.begin(), last.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        next[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            next[j] =
                std::min({last[j] + 1, next[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0u : 1u)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                next[j] = std::min(next[j], before[j - 2] + 1);
        }
        std::swap(before, last);
        std::swap(last, next);
    }
    return last[b.size()];
}

std::vector<std::string> nearest(std::string_view name, std::span<const std::string> candidates,
                                 std::size_t most) {
    struct Match {
        std::size_t unlikeness, index;
    };
    const std::string wanted = plainName(name);
    std::vector<Match> matches;
    for (std::size_t i = 0; i < candidates.size(); ++i)
        if (const std::size_t distance = unlikeness(wanted, plainName(candidates[i])); distance != kUnlike)
            matches.push_back({distance, i});
    std::stable_sort(matches.begin(), matches.end(),
                     [](const Match& a, const Match& b) { return a.unlikeness < b.unlikeness; });
    std::vector<std::string> names;
    for (std::size_t i = 0; i < std::min(most, matches.size()); ++i)
        names.push_back(candidates[matches[i].index]);
    return names;
}

std::string didYouMean(std::span<const std::string> names) {
    if (names.empty())
        return {};
    std::string text = " Did you mean ";
    for (std::size_t i = 0; i < names.size(); ++i)
        text += (i == 0 ? "'" : i + 1 == names.size() ? " or '" : ", '") + names[i] + "'";
    return text + "?";
}

} // namespace limen
