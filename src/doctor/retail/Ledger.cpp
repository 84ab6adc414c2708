#include "doctor/retail/Ledger.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace limen::doctor {
namespace {

bool agrees(const Fact& fact, const Numbers& found) {
    if (fact.rule == Rule::OneOf)
        return found.size() == 1 &&
               std::find(fact.expected.begin(), fact.expected.end(), found[0]) != fact.expected.end();
    if (found.size() != fact.expected.size())
        return false;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const double expected = fact.expected[i];
        const bool fits = fact.rule == Rule::AtLeast  ? found[i] >= expected
                          : fact.rule == Rule::AtMost ? found[i] <= expected
                                                      : std::abs(found[i] - expected) <= fact.tolerance;
        if (!fits)
            return false;
    }
    return true;
}

std::string numberText(double number, Notation notation) {
    const bool isWord = number >= 0.0 && number <= 4294967295.0 && number == std::floor(number);
    if (notation == Notation::Hex && isWord)
        return fmt::format("{:08X}", static_cast<std::uint32_t>(number));
    if (number == std::floor(number) && std::abs(number) < 1e15)
        return fmt::format("{:.0f}", number);
    return fmt::format("{:.6g}", number);
}

} // namespace

const char* nameOf(Verdict verdict) {
    constexpr std::array<const char*, 3> kNames{"right", "wrong", "not there"};
    return kNames.at(static_cast<std::size_t>(verdict));
}

std::string_view areaOf(const Fact& fact) {
    const std::string_view id = fact.id;
    return id.substr(0, id.find('.'));
}

std::string textOf(const Numbers& numbers, Notation notation, std::size_t most) {
    if (numbers.empty())
        return "nothing";
    std::string text;
    for (std::size_t i = 0; i < std::min(numbers.size(), most); ++i)
        text += (i > 0 ? " " : "") + numberText(numbers[i], notation);
    if (numbers.size() > most)
        text += fmt::format(" ... ({} numbers)", numbers.size());
    return text;
}

std::string expectationOf(const Fact& fact) {
    const std::string numbers = textOf(fact.expected, fact.notation);
    switch (fact.rule) {
    case Rule::OneOf:
        return "one of " + numbers;
    case Rule::AtLeast:
        return "at least " + numbers;
    case Rule::AtMost:
        return "at most " + numbers;
    case Rule::Equal:
        break;
    }
    return fact.tolerance > 0.0 ? fmt::format("{} (+-{:g})", numbers, fact.tolerance) : numbers;
}

void Ledger::judge(Fact fact, std::optional<Numbers> found) {
    const Verdict verdict = !found                 ? Verdict::NotThere
                            : agrees(fact, *found) ? Verdict::Right
                                                   : Verdict::Wrong;
    lines_.push_back({std::move(fact), found ? std::move(*found) : Numbers{}, verdict});
}

void Ledger::damaged(Fact fact) {
    lines_.push_back({std::move(fact), {}, Verdict::Wrong});
}

std::size_t Ledger::count(Verdict verdict) const {
    return static_cast<std::size_t>(std::count_if(lines_.begin(), lines_.end(),
                                                  [&](const Line& line) { return line.verdict == verdict; }));
}

} // namespace limen::doctor
