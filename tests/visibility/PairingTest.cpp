#include "visibility/Pairing.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>

namespace limen::visibility {
namespace {

/// Portals and their vertices, without reciprocals.
struct Portals {
    std::vector<PortalDesc> descs;
    std::vector<Vec3> vertices;

    void add(std::uint32_t space, std::uint32_t destination, const std::vector<Vec3>& polygon) {
        PortalDesc desc;
        desc.space = space;
        desc.destination = destination;
        desc.firstVertex = static_cast<std::uint32_t>(vertices.size());
        desc.vertexCount = static_cast<std::uint32_t>(polygon.size());
        descs.push_back(desc);
        vertices.insert(vertices.end(), polygon.begin(), polygon.end());
    }
    Result<Pairing> pair(double tolerance = kPairTolerance) {
        return pairReciprocals(descs, vertices, tolerance);
    }
};

std::vector<Vec3> square(double x, double y, double side) {
    return {{x, y, 0}, {x + side, y, 0}, {x + side, y, side}, {x, y, side}};
}
std::vector<Vec3> reversed(std::vector<Vec3> polygon, std::size_t turn = 0) {
    std::reverse(polygon.begin(), polygon.end());
    std::rotate(polygon.begin(), polygon.begin() + static_cast<std::ptrdiff_t>(turn % polygon.size()),
                polygon.end());
    return polygon;
}

TEST(Pairing, findsEqualPolygonsFromAnyFirstCorner) {
    for (std::size_t turn = 0; turn < 4; ++turn) {
        Portals portals;
        portals.add(0, 1, square(0, 5, 2));
        portals.add(1, 0, reversed(square(0, 5.004, 2), turn));
        const auto pairing = portals.pair();
        ASSERT_TRUE(pairing);
        EXPECT_EQ(pairing->exact, 1u);
        EXPECT_EQ(portals.descs[0].reciprocal, 1u);
        EXPECT_EQ(portals.descs[1].reciprocal, 0u);
        EXPECT_TRUE(portals.descs[0].exact && portals.descs[1].exact);
    }
}

TEST(Pairing, callsPairsWithOtherPolygonsInexact) {
    Portals portals;
    portals.add(0, 1, square(0, 5, 2));
    portals.add(1, 0, reversed(square(0.5, 5, 2)));
    const auto pairing = portals.pair();
    ASSERT_TRUE(pairing);
    EXPECT_EQ(pairing->inexact, 1u);
    EXPECT_FALSE(portals.descs[0].exact || portals.descs[1].exact);
    EXPECT_EQ(portals.descs[0].reciprocal, 1u);
}

TEST(Pairing, leavesNeighboursOtherPlanesAndOtherSpacesApart) {
    Portals portals;
    portals.add(0, 1, square(0, 5, 2));
    portals.add(1, 0, reversed(square(2, 5, 2)));   // touches it
    portals.add(1, 0, reversed(square(0, 5.5, 2))); // half a metre behind
    portals.add(1, 0, square(0, 5, 2));             // faces the same side
    portals.add(2, 0, reversed(square(0, 5, 2)));   // of another space
    portals.add(0, kNone, square(0, 5, 2));         // leads nowhere
    const auto pairing = portals.pair();
    ASSERT_TRUE(pairing);
    EXPECT_EQ(pairing->exact + pairing->inexact, 0u);
    EXPECT_EQ(pairing->single, 5u);
}

TEST(Pairing, prefersEqualPolygonsThenTheLargestOverlap) {
    Portals portals;
    portals.add(0, 1, square(0, 5, 2));
    portals.add(1, 0, reversed(square(0.2, 5, 2)));
    portals.add(1, 0, reversed(square(0, 5, 2)));
    portals.add(0, 1, square(0.9, 5, 2));
    ASSERT_TRUE(portals.pair());
    EXPECT_EQ(portals.descs[0].reciprocal, 2u);
    EXPECT_EQ(portals.descs[1].reciprocal, 3u);
}

TEST(Pairing, keepsPairsThatAreKnown) {
    Portals portals;
    portals.add(0, 1, square(0, 5, 2));
    portals.add(1, 0, reversed(square(0, 5, 2)));
    portals.add(1, 0, reversed(square(0, 5, 2)));
    portals.descs[0].reciprocal = 2;
    portals.descs[2].reciprocal = 0;
    const auto pairing = portals.pair();
    ASSERT_TRUE(pairing);
    EXPECT_EQ(portals.descs[0].reciprocal, 2u);
    EXPECT_EQ(portals.descs[1].reciprocal, kNone);
    EXPECT_EQ(pairing->single, 1u);
}

TEST(Pairing, refusesWrongArrays) {
    Portals portals;
    portals.add(0, 1, square(0, 5, 2));
    EXPECT_FALSE(portals.pair(-1.0));
    EXPECT_FALSE(portals.pair(NAN));
    portals.descs[0].firstVertex = 2;
    EXPECT_FALSE(portals.pair());
}

/// Convex polygons in a grid of places, so that no two overlap; each a pair, listed in random order.
RC_GTEST_PROP(PairingProperty, findsThePartnerOfEveryPortal, (unsigned seed)) {
    std::mt19937 random(seed);
    const auto below = [&](std::uint32_t count) { return static_cast<std::uint32_t>(random() % count); };
    const std::uint32_t pairs = 1 + below(20);
    struct Side {
        std::uint32_t space, destination;
        std::vector<Vec3> polygon;
        std::uint32_t pair;
    };
    std::vector<Side> sides;
    for (std::uint32_t i = 0; i < pairs; ++i) {
        const std::uint32_t a = below(4), b = below(4), corners = 3 + below(6);
        std::vector<Vec3> polygon;
        const Vec3 across(1.0, 0.3 * i, 0.0), upwards(0.0, 0.2, 1.0),
            middle(3.0 * (i % 5), 3.0 * (i / 5), i % 3);
        for (std::uint32_t c = 0; c < corners; ++c) {
            const double angle = 2.0 * std::numbers::pi * c / corners;
            polygon.push_back(middle +
                              (glm::normalize(across) * std::cos(angle) + upwards * std::sin(angle)));
        }
        sides.push_back({a, b, polygon, i});
        sides.push_back({b, a, reversed(polygon, below(corners)), i});
    }
    std::shuffle(sides.begin(), sides.end(), random);
    Portals portals;
    for (const Side& side : sides)
        portals.add(side.space, side.destination, side.polygon);
    const auto pairing = portals.pair();
    RC_ASSERT(pairing.has_value());
    RC_ASSERT(pairing->exact == pairs && pairing->inexact == 0u && pairing->single == 0u);
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const PortalDesc& portal = portals.descs[i];
        RC_ASSERT(portal.reciprocal < sides.size());
        RC_ASSERT(sides[portal.reciprocal].pair == sides[i].pair && portal.reciprocal != i);
    }
}

} // namespace
} // namespace limen::visibility
