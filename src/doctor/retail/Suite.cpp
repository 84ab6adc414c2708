#include "doctor/retail/Suite.h"

#include "doctor/retail/Judges.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace limen::doctor {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kAbout =
    "Facts about the original files, judged by Limen. This report contains ids of facts, the numbers that "
    "were "
    "expected, the verdicts, the numbers that were found where a verdict is wrong, and the program's "
    "version. It "
    "contains no bytes, text, pictures or names from the files, and no path of this computer.";

const char* nameOfRule(Rule rule) {
    constexpr std::array<const char*, 4> kNames{"equal", "one of", "at least", "at most"};
    return kNames.at(static_cast<std::size_t>(rule));
}

Json jsonOf(const Numbers& numbers, Notation notation) {
    Json array = Json::array();
    for (const double number : numbers) {
        const bool isWord = number >= 0 && number <= 4294967295.0 && number == std::floor(number);
        if (notation == Notation::Hex && isWord)
            array.push_back(fmt::format("{:08X}", static_cast<std::uint32_t>(number)));
        else if (number == std::floor(number) && std::abs(number) < 1e15)
            array.push_back(static_cast<std::int64_t>(number));
        else
            array.push_back(number);
    }
    return array;
}

Json jsonOf(const Line& line) {
    Json json{{"id", line.fact.id}, {"expected", jsonOf(line.fact.expected, line.fact.notation)}};
    if (line.fact.rule != Rule::Equal)
        json["rule"] = nameOfRule(line.fact.rule);
    if (line.fact.tolerance > 0)
        json["tolerance"] = line.fact.tolerance;
    json["verdict"] = nameOf(line.verdict);
    if (line.verdict == Verdict::Wrong)
        json["found"] = jsonOf(line.found, line.fact.notation);
    return json;
}

std::string lineText(const Line& line) {
    std::string text = fmt::format("{:<9}  {}\n", nameOf(line.verdict), line.fact.id);
    if (line.verdict == Verdict::Wrong)
        text += fmt::format("           expected {}, found {} ({})\n", expectationOf(line.fact),
                            textOf(line.found, line.fact.notation), line.fact.source);
    return text;
}

} // namespace

Result<SuiteResult> runSuite(const dat::Archive& archive, const CensusProgress& progress) {
    const Result<Census> census = takeCensus(archive, progress);
    if (!census)
        return Failure(census.error());
    SuiteResult result;
    const auto identity = [&](const dat::File& file) {
        return identityOf(file, census->files[static_cast<std::size_t>(file.role())].entries);
    };
    result.release = releaseOf(identity(archive.portal()), identity(archive.cell()));
    judgeContainer(archive, *census, result.ledger);
    judgeCounts(*census, result.ledger);
    judgeSurfaces(archive, result.ledger);
    judgeModels(archive, result.ledger);
    judgeLand(archive, result.ledger);
    judgeCalendar(archive, result.ledger);
    judgeSky(archive, result.ledger);
    judgeCells(archive, result.ledger);
    judgePlaces(archive, result.ledger);
    judgeEffects(archive, result.ledger);
    judgeRules(result.ledger);
    return result;
}

std::vector<AreaSum> sumsOf(const Ledger& ledger) {
    std::vector<AreaSum> sums;
    for (const Line& line : ledger.lines()) {
        const std::string_view area = areaOf(line.fact);
        auto sum = std::find_if(sums.begin(), sums.end(), [&](const AreaSum& s) { return s.area == area; });
        if (sum == sums.end())
            sum = sums.insert(sums.end(), AreaSum{area});
        sum->right += line.verdict == Verdict::Right;
        sum->wrong += line.verdict == Verdict::Wrong;
        sum->notThere += line.verdict == Verdict::NotThere;
    }
    return sums;
}

std::string reportJson(const SuiteResult& result, const std::string& program) {
    Json areas = Json::object();
    for (const AreaSum& sum : sumsOf(result.ledger))
        areas[std::string(sum.area)] = {
            {"right", sum.right}, {"wrong", sum.wrong}, {"not there", sum.notThere}};
    Json lines = Json::array();
    for (const Line& line : result.ledger.lines())
        lines.push_back(jsonOf(line));
    const Json report{{"format", "limen-retail-report"},
                      {"version", kReportVersion},
                      {"about", kAbout},
                      {"program", program},
                      {"release", nameOf(result.release)},
                      {"right", result.ledger.count(Verdict::Right)},
                      {"wrong", result.ledger.count(Verdict::Wrong)},
                      {"notThere", result.ledger.count(Verdict::NotThere)},
                      {"areas", areas},
                      {"lines", lines}};
    return report.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string reportText(const SuiteResult& result, std::size_t most, bool all) {
    std::string text = fmt::format("{:<12} {:>7} {:>7} {:>9}\n", "area", "right", "wrong", "not there");
    for (const AreaSum& sum : sumsOf(result.ledger))
        text += fmt::format("{:<12} {:>7} {:>7} {:>9}\n", sum.area, sum.right, sum.wrong, sum.notThere);
    text += "\n";
    std::size_t shown = 0, left = 0;
    for (const Verdict verdict : {Verdict::Wrong, Verdict::NotThere, Verdict::Right}) {
        if (verdict == Verdict::Right && !all)
            continue;
        for (const Line& line : result.ledger.lines()) {
            if (line.verdict != verdict)
                continue;
            if (all || shown < most) {
                text += lineText(line);
                ++shown;
            } else {
                ++left;
            }
        }
    }
    if (left > 0)
        text += fmt::format("... and {} more; --all prints every line\n", left);
    text += fmt::format("{}{} facts: {} right, {} wrong, {} not there\n", shown > 0 ? "\n" : "",
                        result.ledger.lines().size(), result.ledger.count(Verdict::Right),
                        result.ledger.count(Verdict::Wrong), result.ledger.count(Verdict::NotThere));
    return text;
}

} // namespace limen::doctor
