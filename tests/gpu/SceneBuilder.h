#pragma once

#include "frame/FramePlan.h"
#include "frame/SceneUpload.h"

#include <deque>
#include <initializer_list>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace limen::gpu::test {

namespace layout = frame::gpu;

inline constexpr float kNearPlane = 0.02f; ///< of every test camera, metres

/// Options of a quad.
struct QuadOptions {
    std::vector<layout::Member> members{{0, 0}};
    std::uint32_t material = 0;
    frame::Program program = frame::Program::Opaque;
    bool gated = false;
    frame::Turn turn = frame::Turn::After; ///< of plans by finishRootFirst
    std::uint32_t block = 0;
    std::uint32_t highlight = 0;
    std::array<glm::vec4, 3> rows{glm::vec4{1, 0, 0, 0}, glm::vec4{0, 1, 0, 0}, glm::vec4{0, 0, 1, 0}};
    std::array<glm::vec2, 4> uv{glm::vec2{0, 1}, glm::vec2{1, 1}, glm::vec2{1, 0}, glm::vec2{0, 0}};
};

/// Builds small scenes by hand. The camera looks north (+Y) from the eye with a field of view of 90 degrees
/// in both axes. At distance d a square picture shows x and z from -d to d. Material 0 is white; light set 0
/// leaves albedo unchanged.
class SceneBuilder {
public:
    SceneBuilder();

    /// Yields the material's index.
    std::uint32_t addMaterial(const glm::vec4& colour, std::uint32_t texture = layout::kNoTexture,
                              std::uint32_t flags = 0);
    std::uint32_t addTexture(std::uint32_t width, std::uint32_t height, std::vector<std::uint8_t> rgba,
                             bool clamp = true);
    /// A quad by its corners, counter-clockwise seen from its front; the first corner has uv (0,1). Yields
    /// the instance's index.
    std::uint32_t addQuad(std::uint32_t id, const std::array<glm::vec3, 4>& corners,
                          const QuadOptions& options = {});
    /// Several quads as one mesh, in order, with consecutive ids from `id`.
    std::uint32_t addQuads(std::uint32_t id, std::span<const std::array<glm::vec3, 4>> quads,
                           const QuadOptions& options = {});
    /// An upright rectangle that faces the camera (south).
    std::uint32_t addWall(std::uint32_t id, glm::vec2 min, glm::vec2 max, float y,
                          const QuadOptions& options = {});
    /// A wall with a square opening of half-size `half` about x = z = 0; extends `outer` to each side.
    void addWallWithOpening(std::uint32_t id, float outer, float half, float y,
                            const QuadOptions& options = {});
    /// A rectangle of the sky, relative to the eye, with a luminosity of 1. Yields its record.
    layout::SkyInstance& addSky(glm::vec2 min, glm::vec2 max, float y, std::uint32_t material, float opacity);
    /// Draws an instance once more with this program.
    void drawAgain(std::uint32_t instance, frame::Program program, bool gated);

    /// The root visit, in the eye's zone. Call first.
    void root(std::uint32_t zone);
    /// A visit behind a rectangle in the plane y, entered northwards. Yields its number.
    std::uint32_t visitThrough(glm::vec2 min, glm::vec2 max, float y, std::uint32_t zone,
                               std::uint32_t parent, std::uint32_t clipSet = 0);
    /// An opening of an existing visit, as a fan around its middle.
    void addOpening(std::span<const glm::vec3> corners, std::uint32_t visit, std::uint32_t clipSet = 0);

    /// Fills in batches and stages and yields the plan. `allBatches`: one of every program, even if empty.
    const frame::FramePlan& finish(bool allBatches = false);
    /// The same with FrameView::rootFirst, from all batches.
    const frame::FramePlan& finishRootFirst();

    frame::SceneUpload upload;
    frame::FramePlan plan;

private:
    std::deque<std::vector<std::uint8_t>> pixels_; // pixels that the texture uploads refer to
    void addBatch(frame::Program program, bool evenEmpty);
    void addSkyBatch(bool evenEmpty);
    struct Drawn {
        std::uint32_t piece = 0; // one per instance
        bool gated = false;
        frame::Turn turn = frame::Turn::After;
    };
    std::map<frame::Program, std::vector<Drawn>> draws_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> sky_; // pieces and their sky objects
};

/// The id image as text, top row first: '.' void, '~' sky, else the id as a character.
[[nodiscard]] std::vector<std::string> picture(const std::vector<std::uint32_t>& ids, std::size_t width);

} // namespace limen::gpu::test
