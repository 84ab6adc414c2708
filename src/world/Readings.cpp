#include "world/Readings.h"

#include "core/Assert.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fmt/format.h>

namespace limen::world {
namespace {

/// The names of an enum's values, in their order.
template <std::size_t N>
using Names = std::array<std::string_view, N>;

struct Limits {
    double low = 0.0, high = 1.0;
};

/// Calls `visit` with the name, the names of the values or the limits, and the value of each reading.
template <class AnyReadings, class Visit>
void eachReading(AnyReadings& readings, const Visit& visit) {
    visit("sky-place", Names<3>{"eye", "block", "cell"}, readings.skyPlace);
    visit("sky-particles", Names<3>{"around", "eye", "none"}, readings.skyParticles);
    visit("cell-fog", Names<2>{"world", "none"}, readings.cellFog);
    visit("wall-emission", Names<2>{"added", "replaced"}, readings.wallEmission);
    visit("surface-diffuse", Names<2>{"none", "sun"}, readings.surfaceDiffuse);
    visit("wall-grey", Limits{0.0, 1.0}, readings.wallGrey);
    visit("normals", Names<3>{"unit", "scaled", "divided"}, readings.normals);
    visit("details", Names<2>{"on", "off"}, readings.details);
    visit("grain", Names<2>{"lit", "unlit"}, readings.grain);
    visit("level-bias", Limits{-1.0, 1.0}, readings.levelBias);
}

struct AddFacts {
    std::vector<ReadingFacts>& facts;
    template <std::size_t N, class Value>
    void operator()(std::string_view name, const Names<N>& names, const Value&) const {
        facts.push_back({name, {names.begin(), names.end()}, 0.0, 0.0});
    }
    void operator()(std::string_view name, const Limits& limits, double) const {
        facts.push_back({name, {}, limits.low, limits.high});
    }
};

struct SetValue {
    std::string_view wanted, text;
    bool& isSet;
    template <std::size_t N, class Value>
    void operator()(std::string_view name, const Names<N>& names, Value& value) const {
        const auto found = std::find(names.begin(), names.end(), text);
        if (name != wanted || found == names.end())
            return;
        value = static_cast<Value>(found - names.begin());
        isSet = true;
    }
    void operator()(std::string_view name, const Limits& limits, double& value) const {
        double number = 0.0;
        const char* const end = text.data() + text.size();
        const auto [rest, error] = std::from_chars(text.data(), end, number);
        if (name != wanted || error != std::errc() || rest != end ||
            !(number >= limits.low && number <= limits.high))
            return;
        value = number;
        isSet = true;
    }
};

struct AddText {
    std::string& text;
    void add(std::string_view name, std::string_view value) const {
        text += fmt::format("{}{}={}", text.empty() ? "" : ",", name, value);
    }
    template <std::size_t N, class Value>
    void operator()(std::string_view name, const Names<N>& names, const Value& value) const {
        const auto index = static_cast<std::size_t>(value);
        LIMEN_ASSERT(index < N, "every value has a name");
        if (index != 0)
            add(name, names[index]);
    }
    void operator()(std::string_view name, const Limits& limits, double value) const {
        if (value != limits.high)
            add(name, fmt::format("{}", value));
    }
};

} // namespace

std::vector<ReadingFacts> readingFacts() {
    std::vector<ReadingFacts> facts;
    const Readings defaults;
    eachReading(defaults, AddFacts{facts});
    return facts;
}

bool setReading(Readings& readings, std::string_view name, std::string_view value) {
    bool isSet = false;
    eachReading(readings, SetValue{name, value, isSet});
    return isSet;
}

std::string textOf(const Readings& readings) {
    std::string text;
    eachReading(readings, AddText{text});
    return text;
}

} // namespace limen::world
