#include "check/EyeContact.h"

#include "check/House.h"

namespace limen::check {
namespace {

struct Contacts {
    test::House house;
    world::DynamicState still;
    PolygonTable polygons{house.world, still};
    [[nodiscard]] EyeContact at(const Vec3& local, world::SpaceIndex root) const {
        return EyeContact(house.world, polygons, root, house.at(local));
    }
};

TEST(EyeContact, anEyeInTheOpenTouchesNothing) {
    const Contacts c;
    EXPECT_TRUE(c.at({93, 83, 11}, c.house.space(c.house.front)).touchesNothing());
    EXPECT_TRUE(c.at({90.001, 83, 11}, c.house.space(c.house.front)).touchesNothing()) << "1 mm from a wall";
}

TEST(EyeContact, anEyeOnAWallIsJudgedOnlyIntoTheRoom) {
    const Contacts c;
    const EyeContact contact = c.at({90, 83, 11}, c.house.space(c.house.front));
    EXPECT_FALSE(contact.touchesNothing());
    EXPECT_TRUE(contact.leadsIntoTheRoot({1, 0.5, 0}));
    EXPECT_FALSE(contact.leadsIntoTheRoot({-1, 0.5, 0}));
    EXPECT_FALSE(contact.leadsIntoTheRoot({0, 1, 0})) << "along the wall";
}

TEST(EyeContact, anEyeBehindAWallOfItsCellIsJudgedOnlyIntoTheRoom) {
    const Contacts c;
    const world::SpaceIndex front = c.house.space(c.house.front);
    const EyeContact contact = c.at({89.9999, 83, 11}, front);
    EXPECT_TRUE(contact.leadsIntoTheRoot({1, 0.5, 0}));
    EXPECT_FALSE(contact.leadsIntoTheRoot({-1, 0.5, 0}));
    EXPECT_TRUE(c.at({90.0001, 83, 11}, front).touchesNothing()) << "before it";
    EXPECT_TRUE(c.at({89.999, 83, 11}, front).touchesNothing()) << "1 mm behind it";
    EXPECT_TRUE(c.at({90.0001, 83, 11}, world::kOutside).touchesNothing())
        << "an exterior is no wall of a cell";
}

TEST(EyeContact, theSameWallSeenFromOutsideLeadsTheOtherWay) {
    const Contacts c;
    const EyeContact contact = c.at({90, 83, 11}, world::kOutside);
    EXPECT_FALSE(contact.touchesNothing());
    EXPECT_TRUE(contact.leadsIntoTheRoot({-1, 0, 0}));
    EXPECT_FALSE(contact.leadsIntoTheRoot({1, 0, 0}));
}

TEST(EyeContact, anEyeOnAnEdgeOfAnOpeningIsJudgedOnlyIntoTheRoom) {
    const Contacts c;
    const EyeContact contact = c.at({96, 82, 11}, c.house.space(c.house.front)); // the door's upright edge
    EXPECT_TRUE(contact.leadsIntoTheRoot({-1, 0, 0}));
    EXPECT_FALSE(contact.leadsIntoTheRoot({1, 0, 0}));
}

TEST(EyeContact, anEyeWithinAnOpeningIsJudgedAllAround) {
    const Contacts c;
    EXPECT_TRUE(c.at({96, 82.5, 11}, c.house.space(c.house.front)).touchesNothing());
}

TEST(EyeContact, theLevelOfAWallElsewhereIsNoContact) {
    const Contacts c;
    EXPECT_TRUE(c.at({96, 90, 11}, world::kOutside).touchesNothing()) << "in the plane of the inner wall";
}

} // namespace
} // namespace limen::check
