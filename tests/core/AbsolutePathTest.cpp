#include "core/AbsolutePath.h"

#include "core/platform/Files.h"

#include <gtest/gtest.h>

namespace limen {
namespace {

namespace fs = std::filesystem;

TEST(AbsolutePath, beginsAtTheRoot) {
    const fs::path here = fs::current_path();
    EXPECT_EQ(absolutePath("file"), here / "file");
    EXPECT_EQ(absolutePath("/file"), "/file");
    EXPECT_EQ(absolutePath(""), here) << "the working directory";
}

TEST(AbsolutePath, staysRelativeInADirectoryThatIsGone) {
    const fs::path here = fs::current_path(), gone = platform::makeTemporaryDirectory().value();
    fs::current_path(gone);
    fs::remove(gone);
    const fs::path file = absolutePath("file"), none = absolutePath("");
    fs::current_path(here);
    EXPECT_EQ(file, "file");
    EXPECT_EQ(none, "");
}

} // namespace
} // namespace limen
