#include "picture/GateFigures.h"

#include "output/OutputFile.h"
#include "picture/Naming.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

namespace limen::test {

namespace {

/// The name of the running test as a part of a file name.
std::string testName() {
    std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    std::replace(name.begin(), name.end(), '/', '-');
    return name;
}

} // namespace

std::optional<GateFigures> GateFigures::fromEnvironment() {
    const char* const name = std::getenv("LIMEN_MEASURED_GATE");
    const char* const file = std::getenv("LIMEN_GATE_FIGURES");
    if (name == nullptr || file == nullptr)
        return {};
    const std::optional<frame::Gate> gate = frame::gateNamed(name);
    if (!gate)
        return {};
    GateFigures figures;
    figures.gate = *gate;
    figures.file = file;
    if (const char* const pictures = std::getenv("LIMEN_GATE_PICTURES"))
        figures.pictures = pictures;
    if (const char* const looks = std::getenv("LIMEN_GATE_SECOND_LOOKS"))
        figures.secondLooks = std::stoul(looks);
    return figures;
}

void GateFigures::add(const world::World& world, const Picture& picture, const check::Comparison& comparison,
                      double milliseconds) const {
    std::set<world::SpaceIndex> wrongSpaces;
    std::map<std::string, std::size_t>
        instead; // wrong pixels by the kind of instance that they show, or by fault
    for (std::size_t i = 0; i < comparison.verdicts.size(); ++i) {
        if (!check::isFinding(comparison.verdicts[i]))
            continue;
        const check::Verdict verdict = comparison.verdicts[i];
        const std::string shown = describeId(world, picture.ids[i]);
        const bool wrongId = verdict != check::Verdict::Layers && verdict != check::Verdict::Depth;
        ++instead[wrongId ? shown.substr(0, shown.find(' '))
                          : std::string(check::kVerdictNames[static_cast<std::size_t>(verdict)])];
        const std::uint32_t instance = instanceOfId(world, picture.ids[i]);
        if (instance != world::kNone)
            wrongSpaces.insert(world.instances[instance].placedIn);
        else if (picture.ids[i] == frame::gpu::kSkyId)
            wrongSpaces.insert(world::kOutside);
    }
    const auto* const test = ::testing::UnitTest::GetInstance()->current_test_info();
    const nlohmann::json line{{"suite", test->test_suite_name()},
                              {"test", test->name()},
                              {"gate", nameOf(gate)},
                              {"pixels", picture.ids.size()},
                              {"wrong", comparison.findings()},
                              {"voids", comparison.count(check::Verdict::Void)},
                              {"spaces", wrongSpaces.size()},
                              {"instead", instead},
                              {"calls", picture.glCalls},
                              {"draws", picture.draws},
                              {"milliseconds", milliseconds}};
    std::ofstream(file, std::ios::app) << line.dump() << '\n';
}

bool GateFigures::wantsPair(const check::Comparison& comparison) const {
    if (pictures.empty())
        return false;
    static std::map<std::string, std::size_t> most; // by test; the environment selects one gate a process
    std::size_t& before = most[testName()];
    if (comparison.findings() <= before)
        return false;
    before = comparison.findings();
    return true;
}

void GateFigures::writePair(const Picture& right, const Picture& gated) const {
    const std::uint32_t width = right.frame.width, height = right.frame.height;
    constexpr std::uint32_t kGap = 8;
    output::Picture pair(2 * width + kGap, height, {255, 255, 255});
    const auto put = [&](const Picture& picture, std::uint32_t left) {
        const output::Picture part = output::pictureFromRgba(width, height, picture.colour);
        for (std::uint32_t y = 0; y < height; ++y)
            for (std::uint32_t x = 0; x < width; ++x)
                pair.set(left + x, y, part.at(x, y));
    };
    put(right, 0);
    put(gated, width + kGap);
    const Result<void> written =
        output::writePicture(pictures / (testName() + "-" + std::string(nameOf(gate)) + ".png"), pair);
    EXPECT_TRUE(written) << written.error().message();
}

} // namespace limen::test
