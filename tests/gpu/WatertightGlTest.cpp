#include "GlFixture.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <cmath>
#include <random>

namespace limen::gpu::test {
namespace {

constexpr std::uint32_t kSize = 48;
constexpr std::uint32_t kRoom = 1, kNext = 2;

struct Camera {
    glm::vec3 eye{0.0f};
    glm::mat3 worldFromView{1.0f}; // columns: right, up, backwards
};

// One face of a box as a quad, counter-clockwise seen from inside.
void addFace(SceneBuilder& scene, std::uint32_t id, glm::vec3 min, glm::vec3 max, int axis, bool high,
             const QuadOptions& options) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    std::array<glm::vec3, 4> corners;
    for (int i = 0; i < 4; ++i) {
        glm::vec3 p;
        p[axis] = high ? max[axis] : min[axis];
        p[u] = i == 1 || i == 2 ? max[u] : min[u];
        p[v] = i >= 2 ? max[v] : min[v];
        corners[static_cast<std::size_t>(i)] = p; // counter-clockwise seen from the upper side
    }
    if (high)
        std::swap(corners[1], corners[3]);
    scene.addQuad(id, corners, options);
}

// A wall in the plane y = `y` from the outer to the inner rectangle: four trapezoids that share the opening's
// corners.
void addFrame(SceneBuilder& scene, std::uint32_t id, float y, glm::vec2 outer, glm::vec2 inner,
              bool facesSouth, const QuadOptions& options) {
    const std::array<glm::vec2, 4> signs{glm::vec2{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::vec2 a = signs[i], b = signs[(i + 1) % 4];
        std::array<glm::vec3, 4> corners{glm::vec3{a.x * outer.x, y, a.y * outer.y},
                                         {b.x * outer.x, y, b.y * outer.y},
                                         {b.x * inner.x, y, b.y * inner.y},
                                         {a.x * inner.x, y, a.y * inner.y}};
        if (!facesSouth)
            std::swap(corners[1], corners[3]);
        scene.addQuad(id, corners, options);
    }
}

// Two closed rooms that share an opening of 2 x 1.4 m in the plane y = 2. The second is larger, so that both
// overlap around the shared wall when seen through it.
SceneBuilder closedRooms() {
    SceneBuilder scene;
    scene.root(kRoom);
    const QuadOptions first{.members = {{kRoom, 0}}, .gated = true},
        second{.members = {{kNext, 0}}, .gated = true};
    const glm::vec3 min1{-2, -2, -2}, max1{2, 2, 2}, min2{-3, 2, -3}, max2{3, 7, 3};
    for (int axis = 0; axis < 3; ++axis) {
        for (const bool high : {false, true}) {
            if (axis != 1 || !high)
                addFace(scene, 'A', min1, max1, axis, high, first);
            if (axis != 1 || high)
                addFace(scene, 'B', min2, max2, axis, high, second);
        }
    }
    addFrame(scene, 'A', 2, {2, 2}, {1, 0.7f}, true, first);
    addFrame(scene, 'B', 2, {3, 3}, {1, 0.7f}, false, second);
    scene.visitThrough({-1, -0.7f}, {1, 0.7f}, 2, kNext, 0);
    return scene;
}

void look(frame::FramePlan& plan, const Camera& camera) {
    const glm::mat4 clipFromView(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, -1, 0, 0, kNearPlane, 0);
    plan.constants.clipFromEye = clipFromView * glm::mat4(glm::transpose(camera.worldFromView));
    plan.constants.eyeHigh = {camera.eye, 0};
    plan.visits[1].entryPlane = {0, 1, 0, camera.eye.y - 2.0f};
}

Camera randomCamera(std::mt19937& random) {
    std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
    Camera camera;
    camera.eye = glm::vec3{unit(random), unit(random), unit(random)} * 1.9f;
    glm::vec3 forward;
    do {
        forward = {unit(random), unit(random), unit(random)};
    } while (glm::length(forward) < 0.1f || glm::length(forward) > 1.0f);
    forward = glm::normalize(forward);
    const glm::vec3 right = glm::normalize(glm::cross(forward, glm::vec3{unit(random), unit(random), 1.7f}));
    camera.worldFromView = glm::mat3(right, glm::cross(right, forward), -forward);
    return camera;
}

// Distance in metres from the opening's edge, positive inside, of the point where the ray through the pixel's
// centre crosses the plane y = 2. Negative infinity if it never crosses.
double insideOpening(const Camera& camera, std::uint32_t x, std::uint32_t y) {
    const glm::dvec3 view{(x + 0.5) / kSize * 2 - 1, 1 - (y + 0.5) / kSize * 2, -1};
    const glm::dvec3 ray = glm::dmat3(camera.worldFromView) * view;
    if (ray.y <= 0)
        return -INFINITY;
    const glm::dvec3 at = glm::dvec3(camera.eye) + ray * ((2.0 - camera.eye.y) / ray.y);
    return std::min(1.0 - std::abs(at.x), 0.7 - std::abs(at.z));
}

class WatertightGlTest : public GlTest {};

TEST_F(WatertightGlTest, noGapAndNoForeignRoomAlongAnOpening_fromRandomEyes) {
    SceneBuilder scene = closedRooms();
    scene.finish();
    Renderer renderer(*device_);
    ASSERT_TRUE(renderer.upload(scene.upload));
    std::mt19937 random(2);
    std::size_t seenBoth = 0;
    for (int i = 0; i < 300; ++i) {
        const Camera camera = randomCamera(random);
        look(scene.plan, camera);
        const Frame frame = renderWith(renderer, scene.plan, kSize, kSize);
        const auto count = [&](std::uint32_t id) {
            return std::count(frame.ids.begin(), frame.ids.end(), id);
        };
        ASSERT_EQ(count(layout::kVoidId), 0) << "view " << i;
        seenBoth += count('A') > 0 && count('B') > 0;
        for (std::uint32_t p = 0; p < frame.ids.size(); ++p) {
            const double inside = insideOpening(camera, p % kSize, p / kSize);
            if (std::abs(inside) > 2e-3) {
                ASSERT_EQ(frame.ids[p], inside > 0 ? 'B' : 'A')
                    << "view " << i << " pixel " << p % kSize << "," << p / kSize;
            }
        }
    }
    EXPECT_GT(seenBoth, 50u);
}

} // namespace
} // namespace limen::gpu::test
