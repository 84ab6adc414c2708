#include "picture/GateFigures.h"

#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>

namespace limen::test {

std::optional<GateFigures> GateFigures::fromEnvironment() {
    const char* const name = std::getenv("LIMEN_MEASURED_GATE");
    const char* const file = std::getenv("LIMEN_GATE_FIGURES");
    if (name == nullptr || file == nullptr)
        return {};
    const std::optional<frame::Gate> gate = frame::gateNamed(name);
    return gate ? std::make_optional(GateFigures{*gate, file}) : std::nullopt;
}

void GateFigures::add(const world::World& world, const Picture& picture, const check::Comparison& comparison,
                      double milliseconds) const {
    std::set<world::SpaceIndex> wrongSpaces;
    for (std::size_t i = 0; i < comparison.verdicts.size(); ++i) {
        if (!check::isFinding(comparison.verdicts[i]))
            continue;
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
                              {"calls", picture.glCalls},
                              {"draws", picture.draws},
                              {"milliseconds", milliseconds}};
    std::ofstream(file, std::ios::app) << line.dump() << '\n';
}

} // namespace limen::test
