#include "placements/server/ServerUrl.h"

#include <gtest/gtest.h>

namespace {

using limen::placements::isServerUrl;
using limen::placements::parseServerUrl;

TEST(ServerUrl, hasUserHostPortDatabaseAndSocket) {
    const auto url = parseServerUrl("mariadb://ann@example.org:3307/world");
    ASSERT_TRUE(url.has_value());
    EXPECT_EQ(url->user, "ann");
    EXPECT_EQ(url->host, "example.org");
    EXPECT_EQ(url->port, 3307u);
    EXPECT_EQ(url->database, "world");
    const auto local = parseServerUrl("mysql:///ace%20world?socket=/run/a%2Fb.sock");
    ASSERT_TRUE(local.has_value());
    EXPECT_EQ(local->user, "");
    EXPECT_EQ(local->host, "");
    EXPECT_EQ(local->port, 0u);
    EXPECT_EQ(local->database, "ace world");
    EXPECT_EQ(local->socket, "/run/a/b.sock");
}

TEST(ServerUrl, refusesAPasswordBecauseOthersCouldReadIt) {
    const auto url = parseServerUrl("mariadb://ann:secret@localhost/world");
    ASSERT_FALSE(url.has_value());
    EXPECT_EQ(url.error().message().find("secret"), std::string::npos);
    EXPECT_NE(url.error().message().find("MYSQL_PWD"), std::string::npos);
}

TEST(ServerUrl, refusesMistakes) {
    for (const char* text :
         {"http://a/b", "mariadb://a", "mariadb://a/", "mariadb://a:0/b", "mariadb://a:65536/b",
          "mariadb://a:x/b", "mariadb://a/b?x=1", "mariadb://a/b?socket", "mariadb://a/b?socket="})
        EXPECT_FALSE(parseServerUrl(text).has_value()) << text;
}

TEST(ServerUrl, isKnownByItsScheme) {
    EXPECT_TRUE(isServerUrl("mariadb://x"));
    EXPECT_TRUE(isServerUrl("mysql://x"));
    EXPECT_FALSE(isServerUrl("/home/mysql"));
}

} // namespace
