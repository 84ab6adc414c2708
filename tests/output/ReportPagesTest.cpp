#include "output/report/CheckReport.h"
#include "output/report/TourReport.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <regex>

namespace limen::output {
namespace {

using testing::HasSubstr;
using testing::Not;

std::size_t countOf(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size()))
        ++count;
    return count;
}

ReportHead hostileHead() {
    ReportHead head;
    head.world = "</title><script>alert(1)</script>";
    head.driver = "\"quotes\" & 'signs'";
    head.command = "limen tour --at '<b>'";
    return head;
}

TourReport smallTour() {
    TourReport report;
    report.head = hostileHead();
    report.framesDrawn = 3;
    report.numbers = {0, 1, 2};
    report.commands = {"limen shot </script>", "b", "c"};
    report.pictures = {{"Frame 0", "image/webp", {std::byte{1}}, 4, 2},
                       {"Frame 2", "image/webp", {std::byte{2}}, 4, 2}};
    report.pictureFrames = {0, 2};
    report.plots = {
        {"Processor time",
         "ms",
         "A note.",
         {{"flood", {1.0, 2.0, 6.0}}, {"plan", {0.5, std::numeric_limits<double>::quiet_NaN(), 1.5}}}}};
    report.graph.nodes = {{"outside", 0, 0, true}, {"0xA9B40100", 5, 5, false}};
    report.graph.edges = {{0, 1}};
    report.graph.frames = {{0, {0}, {}}, {0, {0, 1}, {0}}, {1, {1}, {}}};
    return report;
}

/// No reference to another file or server in any attribute or style.
void expectSelfContained(const std::string& page) {
    EXPECT_FALSE(std::regex_search(page, std::regex("(src|href)=\"(?!data:|#)")));
    EXPECT_THAT(page, Not(HasSubstr("@import")));
    EXPECT_THAT(page, Not(HasSubstr("url(")));
    EXPECT_THAT(page, HasSubstr("default-src 'none'"));
}

TEST(TourPage, holdsAllPartsAndNothingFromOutside) {
    const std::string page = tourPage(smallTour());
    expectSelfContained(page);
    EXPECT_EQ(countOf(page, "data:image/webp;base64,AQ=="), 2u) << "in the film and in the strip";
    EXPECT_EQ(countOf(page, "data:image/webp;base64,Ag=="), 1u);
    EXPECT_THAT(page, HasSubstr("No finding"));
    EXPECT_THAT(page, HasSubstr("<td>flood</td><td class=\"left soft\">Processor "
                                "time</td><td>ms</td><td>3</td><td>2</td><td>2</td><td>6</td>"));
    EXPECT_THAT(page, HasSubstr("[0.5,null,1.5]")) << "an unknown time";
    EXPECT_THAT(page, HasSubstr("\"edges\":[[0,1]]"));
}

TEST(TourPage, textOfAWorldCannotBecomeMarkup) {
    const std::string page = tourPage(smallTour());
    EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
    EXPECT_EQ(countOf(page, "</script>"), 2u) << "the data and the program";
    EXPECT_THAT(page, HasSubstr("&lt;b&gt;"));
}

TEST(TourPage, findingsComeWithTheirCommand) {
    TourReport report = smallTour();
    report.findings = {{"Frame 1: <limit>", "limen shot --at a", 1}, {"The data has a fault", "", {}}};
    const std::string page = tourPage(report);
    EXPECT_THAT(page, HasSubstr("2 findings"));
    EXPECT_THAT(page, HasSubstr("Frame 1: &lt;limit&gt;"));
    EXPECT_THAT(page, HasSubstr("<code>limen shot --at a</code>"));
    EXPECT_EQ(countOf(page, "data-goto=\"1\""), 1u);
}

TEST(TourPage, aTourWithoutFramesIsAPage) {
    EXPECT_THAT(tourPage(TourReport{}), HasSubstr("</html>"));
}

TEST(CheckPage, aRightRunSaysSo) {
    CheckReport report;
    report.head = hostileHead();
    check::Comparison comparison;
    comparison.counts[0] = 100;
    report.totals.add({}, 0, comparison, 0);
    const std::string page = checkPage(report);
    expectSelfContained(page);
    EXPECT_THAT(page, HasSubstr("Every pixel is right"));
    EXPECT_THAT(page, Not(HasSubstr("class=\"fault\"")));
    EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
}

TEST(CheckPage, aFindingShowsItsPicturesAndItsCommand) {
    CheckReport report;
    check::Comparison comparison;
    comparison.counts[static_cast<std::size_t>(check::Verdict::Disagrees)] = 1234;
    report.totals.add({}, 7, comparison, 0);
    CheckedView view;
    view.number = 7;
    view.kind = "random";
    view.about = "in <cell>";
    view.command = "limen shot --eye 1,2,3";
    view.counts = comparison.counts;
    view.pictures = {{"Drawn", "image/png", {std::byte{1}}, 4, 2},
                     {"Traced", "image/png", {std::byte{2}}, 4, 2},
                     {"Difference", "image/png", {std::byte{3}}, 4, 2}};
    report.findings = {view};
    report.totals.viewsWithFindings = 3;
    const std::string page = checkPage(report);
    EXPECT_THAT(page, HasSubstr("1,234 wrong pixels in 3 of 1 views"));
    EXPECT_THAT(page, HasSubstr("View 7: 1,234 wrong ids"));
    EXPECT_THAT(page, HasSubstr("in &lt;cell&gt;"));
    EXPECT_THAT(page, HasSubstr("<code>limen shot --eye 1,2,3</code>"));
    EXPECT_THAT(page, HasSubstr("<td class=\"fault\">1,234</td>"));
    EXPECT_THAT(page, HasSubstr("2 further views"));
    EXPECT_EQ(countOf(page, "<figure>"), 3u);
}

} // namespace
} // namespace limen::output
