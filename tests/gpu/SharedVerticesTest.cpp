#include "gpu/scene/SharedVertices.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numeric>
#include <set>

namespace limen::gpu {
namespace {

namespace layout = frame::gpu;

layout::Vertex vertexAt(float x, float y) {
    layout::Vertex vertex;
    vertex.position = {x, y, 1.0f};
    vertex.uv = {x, y};
    return vertex;
}

/// Two triangles of a square, with vertices of their own.
std::vector<layout::Vertex> square() {
    std::vector<layout::Vertex> vertices;
    for (const auto& [x, y] :
         {std::pair{0.0f, 0.0f}, {1.0f, 0.0f}, {1.0f, 1.0f}, {0.0f, 0.0f}, {1.0f, 1.0f}, {0.0f, 1.0f}})
        vertices.push_back(vertexAt(x, y));
    for (std::size_t i = 0; i < vertices.size(); ++i)
        vertices[i].polygonSurface = static_cast<std::uint32_t>(i / 3); // another polygon each, one surface
    return vertices;
}

std::vector<std::uint32_t> inOrder(std::size_t count) {
    std::vector<std::uint32_t> indices(count);
    std::iota(indices.begin(), indices.end(), 0u);
    return indices;
}

TEST(SharedVertices, trianglesOfOneSurfaceShareTheirCorners) {
    const std::vector<std::uint32_t> shared = shareVertices(square(), inOrder(6));
    EXPECT_EQ(shared, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 5}));
}

TEST(SharedVertices, cornersThatLookDifferentStayApart) {
    const auto counted = [](auto&& change) {
        std::vector<layout::Vertex> vertices = square();
        change(vertices[3]); // the first triangle's corner 0
        const std::vector<std::uint32_t> shared = shareVertices(vertices, inOrder(6));
        return std::set<std::uint32_t>(shared.begin(), shared.end()).size();
    };
    EXPECT_EQ(counted([](layout::Vertex&) {}), 4u);
    EXPECT_EQ(counted([](layout::Vertex& v) { v.uv.x = 0.5f; }), 5u);
    EXPECT_EQ(counted([](layout::Vertex& v) { v.normal = 7; }), 5u);
    EXPECT_EQ(counted([](layout::Vertex& v) { v.position.z = 2.0f; }), 5u);
    EXPECT_EQ(counted([](layout::Vertex& v) { v.rest.x = 1.0e-7f; }), 5u);
    EXPECT_EQ(counted([](layout::Vertex& v) { v.polygonSurface = 1u << 16; }), 5u);
    EXPECT_EQ(counted([](layout::Vertex& v) { v.facet.x = 1.0f; }), 4u) << "no fast shader reads the facet";
}

RC_GTEST_PROP(SharedVertices, everyIndexIsOfAnEqualVertex, ()) {
    const auto count = *rc::gen::inRange<std::size_t>(0, 200);
    std::vector<layout::Vertex> vertices;
    for (std::size_t i = 0; i < count; ++i) // few different ones
        vertices.push_back(vertexAt(static_cast<float>(*rc::gen::inRange(0, 4)),
                                    static_cast<float>(*rc::gen::inRange(0, 4))));
    const std::vector<std::uint32_t> shared = shareVertices(vertices, inOrder(count));
    RC_ASSERT(shared.size() == count);
    std::set<std::uint32_t> distinct(shared.begin(), shared.end());
    RC_ASSERT(distinct.size() <= 16u);
    for (std::size_t i = 0; i < count; ++i)
        RC_ASSERT(vertices[shared[i]].position == vertices[i].position);
}

} // namespace
} // namespace limen::gpu
