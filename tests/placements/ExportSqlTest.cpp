#include "SampleContent.h"
#include "SqlTestFiles.h"
#include "placements/Import.h"

#include <gtest/gtest.h>

namespace {

using namespace limen;
using namespace limen::test;

TEST(ExportSql, anImportOfTheFilesGivesTheSameContent) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const placements::Content content = SampleContent(seed).make(6, 25);
        const TemporaryDirectory directory;
        putContent(directory.path(), content);
        const Result<placements::Content> again = placements::importSqlFiles({directory.path()});
        ASSERT_TRUE(again.has_value()) << again.error().message();
        EXPECT_TRUE(*again == content) << "seed " << seed;
    }
}

TEST(ExportSql, theNameOfAFileHoldsNoPath) {
    placements::Template of;
    of.id = 7;
    of.name = "../../etc/passwd\n'";
    EXPECT_EQ(placements::sqlOf(of).path, "9 WeenieDefaults/00007 ______etc_passwd__.sql");
}

} // namespace
