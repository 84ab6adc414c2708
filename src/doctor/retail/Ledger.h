#pragma once

#include "core/Error.h"

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Facts about the original files, and their verdicts.
namespace limen::doctor {

/// The value of a fact or a finding. Record ids, offsets and colours are numbers, too.
using Numbers = std::vector<double>;
[[nodiscard]] inline std::optional<Numbers> someNumbers(std::initializer_list<double> numbers) {
    return Numbers(numbers);
}

/// How a found value must compare with the expected one.
enum class Rule : std::uint8_t {
    Equal,   ///< as many numbers, each within the tolerance
    OneOf,   ///< one number, equal to one of the expected ones
    AtLeast, ///< each number at least as large
    AtMost   ///< each number at most as large
};

enum class Notation : std::uint8_t { Decimal, Hex };

/// A statement about the original files.
struct Fact {
    std::string id;          ///< "area.subject.property"
    std::string_view source; ///< its origin in a few words
    Numbers expected;
    Rule rule = Rule::Equal;
    double tolerance = 0.0;
    Notation notation = Notation::Decimal;

    [[nodiscard]] Fact hex() && {
        notation = Notation::Hex;
        return std::move(*this);
    }
    [[nodiscard]] Fact within(double by) && {
        tolerance = by;
        return std::move(*this);
    }
    [[nodiscard]] Fact by(Rule other) && {
        rule = other;
        return std::move(*this);
    }
};

enum class Verdict : std::uint8_t { Right, Wrong, NotThere };
[[nodiscard]] const char* nameOf(Verdict verdict);

/// A judged fact. `found` is empty if the record is missing or damaged.
struct Line {
    Fact fact;
    Numbers found;
    Verdict verdict = Verdict::NotThere;
};

/// The part of an id before its first full stop.
[[nodiscard]] std::string_view areaOf(const Fact& fact);
/// The numbers in the fact's notation, with blanks between them; at most `most` numbers.
[[nodiscard]] std::string textOf(const Numbers& numbers, Notation notation, std::size_t most = 8);
/// The condition that the fact states, e.g. "at least 7".
[[nodiscard]] std::string expectationOf(const Fact& fact);

/// Collects judged facts.
class Ledger {
public:
    /// Compares. Nothing found: the verdict is NotThere.
    void judge(Fact fact, std::optional<Numbers> found);
    /// The record is there and lacks the value, or does not decode: Wrong.
    void damaged(Fact fact);
    /// Judges a value of a record. A missing record gives NotThere; a damaged one, and one without the value
    /// (`read` returns nothing), gives Wrong.
    template <class Record, class Read>
    void judgeRecord(const Result<Record>& record, Fact fact, Read&& read) {
        if (!record && record.error().code == ErrorCode::NotFound)
            return judge(std::move(fact), std::nullopt);
        std::optional<Numbers> found;
        if (record)
            found = read(*record);
        if (!found)
            return damaged(std::move(fact));
        judge(std::move(fact), std::move(found));
    }

    [[nodiscard]] const std::vector<Line>& lines() const { return lines_; }
    [[nodiscard]] std::size_t count(Verdict verdict) const;

private:
    std::vector<Line> lines_;
};

} // namespace limen::doctor
