#include "cli/Choices.h"
#include "cli/help/Completions.h"
#include "cli/help/ManPage.h"
#include "cli/help/ParseFailure.h"
#include "cli/help/ValueKind.h"

#include <CLI/CLI.hpp>
#include <gmock/gmock.h>

namespace limen::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// A small program with a verb "draw", and a verb "dat" that has "ls".
class SmallProgram {
public:
    SmallProgram() {
        app_.set_help_flag("-h,--help", "print this help");
        app_.require_subcommand(0, 1);
        app_.footer("A note.\nExamples:\n  small draw");
        CLI::App* draw = app_.add_subcommand("draw", "draw a [picture]: it's a test");
        draw->add_option("-o,--output", output_, "write here")->required()->type_name("FILE");
        draw->add_option("--weather", weather_, "set it (clear)")
            ->type_name("clear|rain|0..1")
            ->check(oneOf({"clear", "rain"}));
        draw->add_option("--radius", radius_, "set it (4)")->type_name("N")->check(within(0, 16));
        draw->add_flag("--json", json_, "print JSON");
        CLI::App* dat = app_.add_subcommand("dat", "records");
        dat->require_subcommand(1);
        dat->add_subcommand("ls", "list")->add_option("PATH", paths_, "list this")->type_name("");
    }
    [[nodiscard]] CommandFacts facts() const { return factsOf(app_, {"small"}); }
    /// The message for a refused command line; empty: it was accepted.
    std::string refusal(std::vector<std::string> words) {
        std::reverse(words.begin(), words.end());
        try {
            app_.parse(std::move(words));
        } catch (const CLI::ParseError& error) {
            return parseFailure(app_, error).message();
        }
        return {};
    }

private:
    CLI::App app_{"draws things", "small"};
    std::string output_, weather_;
    int radius_ = 0;
    bool json_ = false;
    std::vector<std::string> paths_;
};

const OptionFacts& optionNamed(const CommandFacts& command, const std::string& name) {
    const auto found =
        std::find_if(command.options.begin(), command.options.end(), [&](const OptionFacts& o) {
            return std::find(o.names.begin(), o.names.end(), name) != o.names.end();
        });
    EXPECT_NE(found, command.options.end()) << name;
    return *found;
}

TEST(CommandFacts, haveEveryVerbAndOption) {
    const CommandFacts facts = SmallProgram().facts();
    ASSERT_EQ(facts.commands.size(), 2u);
    const CommandFacts* draw = commandAt(facts, {"draw"});
    ASSERT_NE(draw, nullptr);
    EXPECT_EQ(draw->joined('-'), "small-draw");
    const OptionFacts& output = optionNamed(*draw, "--output");
    EXPECT_THAT(output.names, ElementsAre("-o", "--output"));
    EXPECT_EQ(output.value, "FILE");
    EXPECT_TRUE(output.isRequired);
    EXPECT_EQ(optionNamed(*draw, "--json").value, "");
    EXPECT_EQ(optionNamed(*draw, "--radius").value, "N") << "a check must not change the notation";
    const CommandFacts* ls = commandAt(facts, {"dat", "ls"});
    ASSERT_NE(ls, nullptr);
    EXPECT_TRUE(optionNamed(*ls, "PATH").isPositional);
    EXPECT_TRUE(optionNamed(*ls, "PATH").isRepeatable);
    EXPECT_EQ(commandAt(facts, {"dat", "draw"}), nullptr);
}

TEST(CommandFacts, choicesAreTheFixedValuesOfANotation) {
    const CommandFacts facts = SmallProgram().facts();
    const CommandFacts& draw = *commandAt(facts, {"draw"});
    EXPECT_THAT(optionNamed(draw, "--weather").choices, ElementsAre("clear", "rain"));
    EXPECT_EQ(valueKindOf(optionNamed(draw, "--weather")), ValueKind::Choice);
    EXPECT_EQ(valueKindOf(optionNamed(draw, "--output")), ValueKind::File);
    EXPECT_EQ(valueKindOf(optionNamed(draw, "--json")), ValueKind::None);
    EXPECT_EQ(valueKindOf(optionNamed(draw, "--radius")), ValueKind::Other);
}

TEST(HelpPage, wrapsAndKeepsExamples) {
    const CommandFacts facts = SmallProgram().facts();
    const std::string page = helpPage(facts, 40);
    EXPECT_THAT(page, HasSubstr("Usage: small [OPTIONS] VERB"));
    EXPECT_THAT(page, HasSubstr("Examples:\n  small draw\n"));
    std::istringstream lines(helpPage(*commandAt(facts, {"draw"}), 50));
    for (std::string line; std::getline(lines, line);)
        EXPECT_LE(line.size(), 50u) << line;
    EXPECT_THAT(helpPage(*commandAt(facts, {"draw"})), HasSubstr("small draw -o FILE [OPTIONS]"));
}

TEST(ManPage, escapesTheTextOfOptions) {
    const CommandFacts facts = SmallProgram().facts();
    const std::string page = manPage(*commandAt(facts, {"draw"}), facts, "1.2.3");
    EXPECT_THAT(page, HasSubstr(".TH SMALL\\-DRAW 1"));
    EXPECT_THAT(page, HasSubstr("\\fB\\-o\\fR, \\fB\\-\\-output\\fR \\fIFILE\\fR"));
    EXPECT_THAT(page, HasSubstr("it\\(aqs a test"));
    EXPECT_THAT(page, HasSubstr(".BR small (1)"));
}

TEST(ManPage, noTextLineBeginsARequest) {
    CommandFacts facts{{"small"}, "brief", "Text:\n.so /etc/passwd\n.sh is a suffix\n'quoted'", {}, {}};
    std::istringstream lines(manPage(facts, facts, "1"));
    for (std::string line; std::getline(lines, line);)
        EXPECT_THAT(line, testing::AllOf(Not(testing::StartsWith(".sh")), Not(testing::StartsWith("'")),
                                         Not(testing::StartsWith(".so"))))
            << line;
}

TEST(Completions, nameVerbsOptionsAndValues) {
    const CommandFacts facts = SmallProgram().facts();
    const std::vector<std::string> places{"hill"};
    const std::string bash = bashCompletions(facts, places);
    EXPECT_THAT(bash, HasSubstr("'small draw:--weather') _limen_words 'clear rain'; return"));
    EXPECT_THAT(bash, HasSubstr("'small dat ls'"));
    const std::string zsh = zshCompletions(facts, places);
    EXPECT_THAT(zsh, HasSubstr("'draw:draw a \\[picture\\]\\: it'\\''s a test'"));
    EXPECT_THAT(zsh, HasSubstr("'--weather[set it (clear)]:clear|rain|0..1:(clear rain)'"));
}

TEST(ParseFailure, suggestsTheNearestName) {
    const auto refusal = [](std::vector<std::string> words) {
        return SmallProgram().refusal(std::move(words));
    };
    EXPECT_EQ(refusal({"darw"}), "unknown verb 'darw'. Did you mean 'draw'?");
    EXPECT_EQ(refusal({"dat", "sl"}), "dat: unknown verb 'sl'. Did you mean 'ls'?");
    EXPECT_EQ(refusal({"draw", "-o", "a", "--waether=rain"}),
              "draw: unknown option '--waether'. Did you mean '--weather'?");
    EXPECT_EQ(refusal({"draw", "-o", "a", "--weather", "rian"}),
              "draw: --weather: unknown value 'rian'. Did you mean 'rain'?");
}

TEST(ParseFailure, namesTheNextStep) {
    const auto refusal = [](std::vector<std::string> words) {
        return SmallProgram().refusal(std::move(words));
    };
    EXPECT_EQ(refusal({"zzz"}), "unknown verb 'zzz'; see limen help");
    EXPECT_EQ(refusal({"dat"}), "dat: no verb given; choose one from limen help dat");
    EXPECT_EQ(refusal({"draw", "-o", "a", "stray"}),
              "draw: unexpected argument 'stray'; see limen help draw");
    EXPECT_THAT(refusal({"draw"}), HasSubstr("--output is required; see limen help draw"));
    EXPECT_EQ(refusal({"draw", "-o", "a", "--weather", "zzz"}),
              "draw: --weather: unknown value 'zzz'; choose from clear, rain");
    EXPECT_EQ(refusal({"draw", "-o", "a", "--radius", "17"}),
              "draw: --radius: '17' is not a number from 0 to 16");
    EXPECT_EQ(refusal({"draw", "-o", "a"}), "");
}

} // namespace
} // namespace limen::cli
