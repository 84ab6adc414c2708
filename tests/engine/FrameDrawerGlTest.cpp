// The engine for other projects: frames without a window, and frames in the context of another program.
#include "engine/FrameDrawer.h"

#include "gpu/device/CurrentContext.h"
#include "gpu/device/GlObjects.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <set>

namespace limen::engine::test {
namespace {

using ::testing::HasSubstr;

constexpr std::uint32_t kWidth = 160, kHeight = 90;

/// The built-in world.
const OpenedWorld& village() {
    static const OpenedWorld world = OpenedWorld::open().value();
    return world;
}

FrameDescription frameAt(const char* place, bool withIds = true) {
    return {.viewpoint = village().viewpoint(place).value(),
            .width = kWidth,
            .height = kHeight,
            .withIds = withIds};
}

// ---- Without a window -----------------------------------------------------------------------------------------------

TEST(FrameDrawer, drawsAPlaceWithoutAWindow) {
    FrameDrawer drawer = FrameDrawer::headless(village()).value();
    const FrameCounts counts = drawer.draw(frameAt("inn.hall")).value();
    EXPECT_GT(counts.visits, 1u);
    EXPECT_GT(counts.cellsSeen, 1u);
    EXPECT_GT(counts.instances, 10u);
    const std::vector<std::uint8_t> colour = drawer.readColour().value();
    ASSERT_EQ(colour.size(), std::size_t{kWidth} * kHeight * 4);
    std::set<std::uint32_t> colours;
    for (std::size_t i = 0; i < colour.size(); i += 4) {
        colours.insert(colour[i] | colour[i + 1] << 8 | colour[i + 2] << 16);
        ASSERT_EQ(colour[i + 3], 255) << "pixel " << i / 4;
    }
    EXPECT_GT(colours.size(), 200u) << "a lit room";
}

TEST(FrameDrawer, reportsTheSurfaceAtAPixel) {
    FrameDrawer drawer = FrameDrawer::headless(village()).value();
    ASSERT_TRUE(drawer.draw(frameAt("inn.hall")));
    const std::vector<std::uint32_t> ids = drawer.readIds().value();
    const std::vector<float> distances = drawer.readDistances().value();
    for (const auto& [x, y] : {std::pair{80u, 45u}, std::pair{10u, 80u}, std::pair{150u, 5u}}) {
        const Surface surface = drawer.surfaceAt(x, y).value();
        EXPECT_FLOAT_EQ(static_cast<float>(surface.distance), distances[y * kWidth + x]);
        EXPECT_GT(ids[y * kWidth + x], 1u);
        EXPECT_THAT(surface.space, HasSubstr("0x")) << "a room of the inn";
        EXPECT_THAT(surface.record, HasSubstr("0x"));
        EXPECT_NE(surface.object, 0u);
    }
    FrameDescription up = frameAt("lane");
    up.viewpoint.pitch = 90.0;
    ASSERT_TRUE(drawer.draw(up));
    const Surface sky = drawer.surfaceAt(80, 45).value();
    EXPECT_EQ(sky.kind, "sky");
    EXPECT_TRUE(std::isinf(sky.distance));
}

TEST(FrameDrawer, drawsEqualDescriptionsAlike) {
    std::vector<std::uint8_t> lane;
    {
        FrameDrawer first = FrameDrawer::headless(village()).value();
        ASSERT_TRUE(first.draw(frameAt("lane")));
        lane = first.readColour().value();
    } // zink on lavapipe crashes when a second context draws while the first one exists (decision 103)
    FrameDrawer second = FrameDrawer::headless(village()).value();
    ASSERT_TRUE(second.draw(frameAt("inn.hall")));
    EXPECT_NE(second.readColour().value(), lane);
    ASSERT_TRUE(second.draw(frameAt("lane")));
    EXPECT_EQ(second.readColour().value(), lane);
}

TEST(FrameDrawer, opensDoorsAndChangesTheTimeOfDay) {
    FrameDrawer drawer = FrameDrawer::headless(village()).value();
    FrameDescription frame = frameAt("inn.hall");
    frame.doors = 0.0;
    const std::uint32_t shut = drawer.draw(frame).value().visits;
    const std::vector<std::uint8_t> day = drawer.readColour().value();
    frame.doors = 1.0;
    EXPECT_GT(drawer.draw(frame).value().visits, shut);
    frame = frameAt("lane");
    ASSERT_TRUE(drawer.draw(frame));
    const std::vector<std::uint8_t> noon = drawer.readColour().value();
    frame.timeOfDay = 0.0;
    ASSERT_TRUE(drawer.draw(frame));
    EXPECT_NE(drawer.readColour().value(), noon);
}

TEST(FrameDrawer, smoothsEdgesWithSeveralSamples) {
    FrameDrawer one = FrameDrawer::headless(village(), {.radius = 1}).value();
    FrameDrawer four = FrameDrawer::headless(village(), {.radius = 1, .samples = 4}).value();
    ASSERT_TRUE(one.draw(frameAt("lane", false)) && four.draw(frameAt("lane", false)));
    EXPECT_NE(one.readColour().value(), four.readColour().value());
    ASSERT_TRUE(one.draw(frameAt("lane")) && four.draw(frameAt("lane")));
    EXPECT_EQ(one.readIds().value(), four.readIds().value()) << "ids have one sample a pixel";
    EXPECT_EQ(one.readColour().value(), four.readColour().value());
}

// ---- Errors ---------------------------------------------------------------------------------------------------------

TEST(FrameDrawer, refusesDescriptionsOutOfRange) {
    FrameDrawer drawer = FrameDrawer::headless(village(), {.radius = 0}).value();
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN(),
                     kInfinite = std::numeric_limits<double>::infinity();
    const FrameDescription good = frameAt("inn.hall");
    const auto expectRefused = [&](const auto& change, const char* member) {
        FrameDescription frame = good;
        change(frame);
        const Result<FrameCounts> drawn = drawer.draw(frame);
        ASSERT_FALSE(drawn) << member;
        EXPECT_EQ(drawn.error().code, ErrorCode::BadArgument) << member;
        EXPECT_THAT(drawn.error().message(), HasSubstr(member));
    };
    for (const double bad : {kNan, kInfinite, -kInfinite, 1e300}) {
        expectRefused([&](FrameDescription& f) { f.viewpoint.eye.y = bad; }, "eye");
        expectRefused([&](FrameDescription& f) { f.viewpoint.pitch = bad; }, "viewpoint");
        expectRefused([&](FrameDescription& f) { f.fovDegrees = bad; }, "fovDegrees");
        expectRefused([&](FrameDescription& f) { f.timeOfDay = bad; }, "timeOfDay");
        expectRefused([&](FrameDescription& f) { f.seconds = bad; }, "seconds");
        expectRefused([&](FrameDescription& f) { f.doors = bad; }, "doors");
    }
    expectRefused([&](FrameDescription& f) { f.viewpoint.yaw = kNan; }, "viewpoint");
    for (const std::uint32_t bad : {0u, 16385u, ~0u}) {
        expectRefused([&](FrameDescription& f) { f.width = bad; }, "width");
        expectRefused([&](FrameDescription& f) { f.height = bad; }, "height");
    }
    EXPECT_TRUE(drawer.draw(good)) << "the drawer still works";
}

TEST(FrameDrawer, refusesOptionsOutOfRange) {
    for (const DrawerOptions& options :
         {DrawerOptions{.radius = -1}, DrawerOptions{.radius = 17}, DrawerOptions{.farRadius = 33},
          DrawerOptions{.samples = 2}, DrawerOptions{.samples = 0}}) {
        const Result<FrameDrawer> drawer = FrameDrawer::headless(village(), options);
        ASSERT_FALSE(drawer);
        EXPECT_EQ(drawer.error().code, ErrorCode::BadArgument);
    }
}

TEST(FrameDrawer, namesPlacesAndCellsThatDoNotExist) {
    const Result<Viewpoint> place = village().viewpoint("inn.hal");
    ASSERT_FALSE(place);
    EXPECT_EQ(place.error().code, ErrorCode::NotFound);
    EXPECT_THAT(place.error().message(), HasSubstr("Did you mean 'inn.hall'"));
    EXPECT_FALSE(village().viewpoint(""));
    EXPECT_FALSE(OpenedWorld::open("/nowhere/at/all"));

    FrameDrawer drawer = FrameDrawer::headless(village(), {.radius = 0}).value();
    FrameDescription frame = frameAt("inn.hall");
    frame.viewpoint.cell = *frame.viewpoint.cell | 0xFFFu;
    const Result<FrameCounts> drawn = drawer.draw(frame);
    ASSERT_FALSE(drawn);
    EXPECT_EQ(drawn.error().code, ErrorCode::NotFound);
    EXPECT_THAT(drawn.error().message(), HasSubstr("viewpoint.cell"));
    EXPECT_FALSE(drawer.readColour()) << "there is no picture after an error";
    frame.viewpoint.eye = {-9e5, 9e5, 0.0};
    frame.viewpoint.cell.reset();
    EXPECT_FALSE(drawer.draw(frame)) << "no block is there";
}

TEST(FrameDrawer, readsOnlyFramesThatHaveTheImage) {
    FrameDrawer drawer = FrameDrawer::headless(village(), {.radius = 0}).value();
    EXPECT_THAT(drawer.readColour().error().message(), HasSubstr("call draw first"));
    EXPECT_THAT(drawer.copyTo(0).error().message(), HasSubstr("call draw first"));
    ASSERT_TRUE(drawer.draw(frameAt("inn.hall", false)));
    EXPECT_TRUE(drawer.readColour());
    EXPECT_THAT(drawer.readIds().error().message(), HasSubstr("withIds"));
    EXPECT_THAT(drawer.readDistances().error().message(), HasSubstr("withIds"));
    EXPECT_THAT(drawer.surfaceAt(0, 0).error().message(), HasSubstr("withIds"));
    EXPECT_THAT(drawer.copyTo(0).error().message(), HasSubstr("headless"));
    EXPECT_THAT(drawer.objects().error().message(), HasSubstr("headless"));
    ASSERT_TRUE(drawer.draw(frameAt("inn.hall")));
    EXPECT_TRUE(drawer.surfaceAt(kWidth - 1, kHeight - 1));
    EXPECT_THAT(drawer.surfaceAt(kWidth, 0).error().message(), HasSubstr("outside"));
    EXPECT_THAT(drawer.surfaceAt(0, kHeight).error().message(), HasSubstr("outside"));
}

TEST(FrameDrawer, refusesCallsAfterItWasMovedAway) {
    FrameDrawer drawer = FrameDrawer::headless(village(), {.radius = 0}).value();
    FrameDrawer other = std::move(drawer);
    EXPECT_THAT(drawer.draw(frameAt("inn.hall")).error().message(), HasSubstr("moved")); // NOLINT: on purpose
    EXPECT_THAT(drawer.load({}).error().message(), HasSubstr("moved"));
    EXPECT_THAT(drawer.readColour().error().message(), HasSubstr("moved"));
    EXPECT_EQ(drawer.driver(), "");
    EXPECT_TRUE(other.draw(frameAt("inn.hall")));
}

// ---- In the context of another program ------------------------------------------------------------------------------

/// Another program's context, current on this thread.
class Caller {
public:
    Caller() : context_(gpu::HeadlessContext::create(true).value()) {}
    void makeCurrent() { ASSERT_TRUE(context_.makeCurrent()); }

private:
    gpu::HeadlessContext context_;
};

GLint number(GLenum query) {
    GLint value = 0;
    glGetIntegerv(query, &value);
    return value;
}

/// A program that fills the screen with one colour.
GLuint fillingProgram() {
    const char* vertex = "#version 450\nvoid main() { gl_Position = vec4(4 * (gl_VertexID & 1) - 1, 2 * "
                         "(gl_VertexID & 2) - 1, 0, 1); }";
    const char* fragment =
        "#version 450\nlayout(location = 0) out vec4 colour; void main() { colour = vec4(1, 0.5, 0, 1); }";
    const GLuint program = glCreateProgram();
    for (const auto& [kind, source] :
         {std::pair{GLenum{GL_VERTEX_SHADER}, vertex}, std::pair{GLenum{GL_FRAGMENT_SHADER}, fragment}}) {
        const GLuint shader = glCreateShader(kind);
        glShaderSource(shader, 1, &source, nullptr);
        glCompileShader(shader);
        glAttachShader(program, shader);
    }
    glLinkProgram(program);
    return program;
}

/// GL objects of another program, which sets every kind of state to something unusual.
struct Foreign {
    GLuint program = fillingProgram(), vertexArray = 0, buffer = 0, texture = 0, array = 0, sampler = 0,
           framebuffer = 0, image = 0;

    Foreign() {
        glCreateVertexArrays(1, &vertexArray);
        glCreateBuffers(1, &buffer);
        glNamedBufferStorage(buffer, 1 << 16, nullptr, GL_DYNAMIC_STORAGE_BIT);
        glCreateTextures(GL_TEXTURE_2D, 1, &texture);
        glTextureStorage2D(texture, 1, GL_RGBA8, 4, 4);
        glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &array);
        glTextureStorage3D(array, 1, GL_RGBA8, 4, 4, 2);
        glCreateSamplers(1, &sampler);
        glCreateTextures(GL_TEXTURE_2D, 1, &image);
        glTextureStorage2D(image, 1, GL_RGBA8, kWidth, kHeight);
        glCreateFramebuffers(1, &framebuffer);
        glNamedFramebufferTexture(framebuffer, GL_COLOR_ATTACHMENT0, image, 0);
    }
    void bind() const {
        glUseProgram(program);
        glBindVertexArray(vertexArray);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        for (const GLenum target : {GL_DRAW_INDIRECT_BUFFER, GL_PIXEL_PACK_BUFFER, GL_PIXEL_UNPACK_BUFFER,
                                    GL_SHADER_STORAGE_BUFFER})
            glBindBuffer(target, buffer);
        glBindBufferRange(GL_UNIFORM_BUFFER, 0, buffer, 256, 512);
        for (GLuint i = 0; i < 8; ++i)
            glBindBufferRange(GL_SHADER_STORAGE_BUFFER, i, buffer, 1024, 256 * (i + 1));
        for (GLuint unit = 0; unit < 16; ++unit) {
            glActiveTexture(GL_TEXTURE0 + unit);
            glBindTexture(GL_TEXTURE_2D, texture);
            glBindTexture(GL_TEXTURE_2D_ARRAY, array);
            glBindSampler(unit, sampler);
        }
        glActiveTexture(GL_TEXTURE5);
    }
    static void setState() {
        for (const GLenum name :
             {GL_CULL_FACE, GL_STENCIL_TEST, GL_BLEND, GL_SCISSOR_TEST, GL_POLYGON_OFFSET_FILL,
              GL_RASTERIZER_DISCARD, GL_DEPTH_CLAMP, GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_MASK,
              GL_COLOR_LOGIC_OP, GL_PRIMITIVE_RESTART, GL_FRAMEBUFFER_SRGB, GL_CLIP_DISTANCE3,
              GL_SAMPLE_SHADING})
            glEnable(name);
        for (const GLenum name : {GL_DEPTH_TEST, GL_DITHER, GL_MULTISAMPLE})
            glDisable(name);
        glViewport(3, 5, 7, 11);
        glScissor(0, 0, 1, 1);
        glSampleMaski(0, 0);
        glLogicOp(GL_CLEAR);
        glDepthRange(0.25, 0.5);
        glDepthFunc(GL_NEVER);
        glDepthMask(GL_FALSE);
        glCullFace(GL_FRONT_AND_BACK);
        glFrontFace(GL_CW);
        glProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
        glClipControl(GL_UPPER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
        glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
        glPolygonOffset(5.0f, 7.0f);
        glBlendFuncSeparate(GL_DST_COLOR, GL_ZERO, GL_ONE, GL_DST_ALPHA);
        glBlendEquationSeparate(GL_FUNC_SUBTRACT, GL_MAX);
        glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
        glColorMaski(1, GL_TRUE, GL_FALSE, GL_FALSE, GL_FALSE);
        for (const GLenum side : {GL_PACK_ROW_LENGTH, GL_UNPACK_ROW_LENGTH})
            glPixelStorei(side, 3);
        for (const GLenum side :
             {GL_PACK_SKIP_PIXELS, GL_PACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_ROWS})
            glPixelStorei(side, 2);
        for (const GLenum side : {GL_PACK_ALIGNMENT, GL_UNPACK_ALIGNMENT})
            glPixelStorei(side, 8);
        glPixelStorei(GL_UNPACK_SWAP_BYTES, GL_TRUE);
    }
};

/// All state of a context that can be read and that drawing may depend on, as numbers.
std::vector<double> allState() {
    std::vector<double> state;
    for (const GLenum name : {GL_CULL_FACE,
                              GL_DEPTH_TEST,
                              GL_DITHER,
                              GL_STENCIL_TEST,
                              GL_COLOR_LOGIC_OP,
                              GL_DEPTH_CLAMP,
                              GL_FRAMEBUFFER_SRGB,
                              GL_LINE_SMOOTH,
                              GL_POLYGON_OFFSET_FILL,
                              GL_POLYGON_OFFSET_LINE,
                              GL_POLYGON_OFFSET_POINT,
                              GL_POLYGON_SMOOTH,
                              GL_PRIMITIVE_RESTART,
                              GL_PRIMITIVE_RESTART_FIXED_INDEX,
                              GL_PROGRAM_POINT_SIZE,
                              GL_RASTERIZER_DISCARD,
                              GL_SAMPLE_ALPHA_TO_COVERAGE,
                              GL_SAMPLE_ALPHA_TO_ONE,
                              GL_SAMPLE_COVERAGE,
                              GL_SAMPLE_MASK,
                              GL_SAMPLE_SHADING,
                              GL_MULTISAMPLE,
                              GL_TEXTURE_CUBE_MAP_SEAMLESS,
                              GL_DEBUG_OUTPUT,
                              GL_DEBUG_OUTPUT_SYNCHRONOUS})
        state.push_back(glIsEnabled(name));
    for (GLenum i = 0; i < 8; ++i)
        state.push_back(glIsEnabled(GL_CLIP_DISTANCE0 + i));
    for (const GLenum name : {GL_DEPTH_FUNC,
                              GL_DEPTH_WRITEMASK,
                              GL_CULL_FACE_MODE,
                              GL_FRONT_FACE,
                              GL_PROVOKING_VERTEX,
                              GL_CLIP_ORIGIN,
                              GL_CLIP_DEPTH_MODE,
                              GL_LOGIC_OP_MODE,
                              GL_CURRENT_PROGRAM,
                              GL_PROGRAM_PIPELINE_BINDING,
                              GL_VERTEX_ARRAY_BINDING,
                              GL_DRAW_FRAMEBUFFER_BINDING,
                              GL_READ_FRAMEBUFFER_BINDING,
                              GL_RENDERBUFFER_BINDING,
                              GL_ACTIVE_TEXTURE,
                              GL_ARRAY_BUFFER_BINDING,
                              GL_ELEMENT_ARRAY_BUFFER_BINDING,
                              GL_DRAW_INDIRECT_BUFFER_BINDING,
                              GL_DISPATCH_INDIRECT_BUFFER_BINDING,
                              GL_PIXEL_PACK_BUFFER_BINDING,
                              GL_PIXEL_UNPACK_BUFFER_BINDING,
                              GL_UNIFORM_BUFFER_BINDING,
                              GL_SHADER_STORAGE_BUFFER_BINDING,
                              GL_COPY_READ_BUFFER_BINDING,
                              GL_COPY_WRITE_BUFFER_BINDING,
                              GL_PRIMITIVE_RESTART_INDEX,
                              GL_STENCIL_FUNC,
                              GL_STENCIL_REF,
                              GL_STENCIL_WRITEMASK,
                              GL_STENCIL_CLEAR_VALUE,
                              GL_PATCH_VERTICES,
                              GL_PACK_SWAP_BYTES,
                              GL_PACK_ROW_LENGTH,
                              GL_PACK_SKIP_ROWS,
                              GL_PACK_SKIP_PIXELS,
                              GL_PACK_ALIGNMENT,
                              GL_PACK_IMAGE_HEIGHT,
                              GL_PACK_SKIP_IMAGES,
                              GL_UNPACK_SWAP_BYTES,
                              GL_UNPACK_LSB_FIRST,
                              GL_UNPACK_ROW_LENGTH,
                              GL_UNPACK_SKIP_ROWS,
                              GL_UNPACK_SKIP_PIXELS,
                              GL_UNPACK_ALIGNMENT,
                              GL_UNPACK_IMAGE_HEIGHT,
                              GL_UNPACK_SKIP_IMAGES})
        state.push_back(number(name));
    std::array<GLdouble, 4> four{};
    for (const GLenum name :
         {GL_COLOR_CLEAR_VALUE, GL_BLEND_COLOR, GL_POLYGON_OFFSET_FACTOR, GL_POLYGON_OFFSET_UNITS,
          GL_DEPTH_CLEAR_VALUE, GL_LINE_WIDTH, GL_POINT_SIZE, GL_MIN_SAMPLE_SHADING_VALUE}) {
        glGetDoublev(name, four.data());
        state.insert(state.end(), four.begin(), four.end());
    }
    std::array<GLint, 2> mode{};
    glGetIntegerv(GL_POLYGON_MODE, mode.data());
    state.push_back(mode[0]);
    for (GLuint i = 0; i < static_cast<GLuint>(number(GL_MAX_VIEWPORTS)); ++i) {
        std::array<GLint, 4> scissor{};
        glGetDoublei_v(GL_VIEWPORT, i, four.data());
        state.insert(state.end(), four.begin(), four.end());
        glGetDoublei_v(GL_DEPTH_RANGE, i, four.data());
        state.insert(state.end(), four.begin(), four.begin() + 2);
        glGetIntegeri_v(GL_SCISSOR_BOX, i, scissor.data());
        state.insert(state.end(), scissor.begin(), scissor.end());
        state.push_back(glIsEnabledi(GL_SCISSOR_TEST, i));
    }
    const auto indexed = [&](GLenum query, GLuint index) {
        GLint64 value = 0;
        glGetInteger64i_v(query, index, &value);
        state.push_back(static_cast<double>(value));
    };
    for (GLuint i = 0; i < static_cast<GLuint>(number(GL_MAX_DRAW_BUFFERS)); ++i) {
        state.push_back(glIsEnabledi(GL_BLEND, i));
        for (const GLenum name : {GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB, GL_BLEND_SRC_ALPHA, GL_BLEND_DST_ALPHA,
                                  GL_BLEND_EQUATION_RGB, GL_BLEND_EQUATION_ALPHA})
            indexed(name, i);
        std::array<GLboolean, 4> mask{};
        glGetBooleani_v(GL_COLOR_WRITEMASK, i, mask.data());
        state.insert(state.end(), mask.begin(), mask.end());
    }
    for (GLuint i = 0; i < 16; ++i)
        for (const GLenum name :
             {GL_SHADER_STORAGE_BUFFER_BINDING, GL_SHADER_STORAGE_BUFFER_START, GL_SHADER_STORAGE_BUFFER_SIZE,
              GL_UNIFORM_BUFFER_BINDING, GL_UNIFORM_BUFFER_START, GL_UNIFORM_BUFFER_SIZE})
            indexed(name, i);
    const GLint active = number(GL_ACTIVE_TEXTURE);
    for (GLint unit = 0; unit < number(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS); ++unit) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        for (const GLenum name :
             {GL_TEXTURE_BINDING_1D, GL_TEXTURE_BINDING_2D, GL_TEXTURE_BINDING_3D,
              GL_TEXTURE_BINDING_1D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY, GL_TEXTURE_BINDING_RECTANGLE,
              GL_TEXTURE_BINDING_CUBE_MAP, GL_TEXTURE_BINDING_CUBE_MAP_ARRAY, GL_TEXTURE_BINDING_BUFFER,
              GL_TEXTURE_BINDING_2D_MULTISAMPLE, GL_TEXTURE_BINDING_2D_MULTISAMPLE_ARRAY, GL_SAMPLER_BINDING})
            state.push_back(number(name));
    }
    glActiveTexture(static_cast<GLenum>(active));
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    return state;
}

std::vector<std::uint8_t> pictureOf(const FrameDescription& frame) {
    FrameDrawer drawer = FrameDrawer::headless(village(), {.radius = 1}).value();
    EXPECT_TRUE(drawer.draw(frame));
    return drawer.readColour().value();
}

/// States how two pictures differ, and which of them a third drawing repeats: on zink `expected` was once wrong.
std::string difference(const std::vector<std::uint8_t>& drawn, const std::vector<std::uint8_t>& expected,
                       const FrameDescription& frame) {
    const std::vector<std::uint8_t> again = pictureOf(frame);
    std::size_t count = 0, sumDrawn = 0, sumExpected = 0;
    int largest = 0;
    for (std::size_t i = 0; i < std::min(drawn.size(), expected.size()); ++i) {
        const int apart = std::abs(int{drawn[i]} - int{expected[i]});
        count += apart != 0 ? 1 : 0;
        largest = std::max(largest, apart);
        sumDrawn += drawn[i];
        sumExpected += expected[i];
    }
    return std::to_string(count) + " of " + std::to_string(drawn.size()) + " bytes differ, by up to " +
           std::to_string(largest) + "; sums " + std::to_string(sumDrawn) + " and " +
           std::to_string(sumExpected) +
           "; a third drawing equals the first: " + (again == drawn ? "yes" : "no") +
           ", the second: " + (again == expected ? "yes" : "no");
}

TEST(FrameDrawerInAContext, leavesAllStateOfTheCallerAndDrawsTheSame) {
    const FrameDescription frame = frameAt("inn.hall");
    const std::vector<std::uint8_t> expected = pictureOf(frame);
    Caller caller;
    const std::vector<double> initial = allState();
    const Foreign foreign;
    foreign.bind();
    Foreign::setState();
    const std::vector<double> before = allState();
    ASSERT_NE(before, initial);
    std::vector<std::uint8_t> drawn;
    {
        FrameDrawer drawer = FrameDrawer::onCurrentContext(village(), {.radius = 1}).value();
        EXPECT_EQ(allState(), before) << "after its creation";
        ASSERT_TRUE(drawer.load(frame.viewpoint));
        EXPECT_EQ(allState(), before) << "after loading";
        ASSERT_TRUE(drawer.draw(frame));
        EXPECT_EQ(allState(), before) << "after a frame";
        drawn = drawer.readColour().value();
        ASSERT_TRUE(drawer.surfaceAt(80, 45));
        ASSERT_TRUE(drawer.copyTo(foreign.framebuffer));
        EXPECT_EQ(allState(), before) << "after reading and copying";
    }
    EXPECT_EQ(allState(), before) << "after its end";
    EXPECT_TRUE(drawn == expected) << difference(drawn, expected, frame);
}

/// The pixels of a framebuffer's image, top row first.
std::vector<std::uint8_t> pixelsOf(GLuint image) {
    std::vector<std::uint8_t> pixels(std::size_t{kWidth} * kHeight * 4), turned;
    glGetTextureImage(image, 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(pixels.size()),
                      pixels.data());
    for (std::size_t y = kHeight; y-- > 0;)
        turned.insert(turned.end(), pixels.begin() + static_cast<std::ptrdiff_t>(y * kWidth * 4),
                      pixels.begin() + static_cast<std::ptrdiff_t>((y + 1) * kWidth * 4));
    return turned;
}

TEST(FrameDrawerInAContext, takesTurnsWithDrawingOfTheCaller) {
    const FrameDescription frame = frameAt("lane", false);
    const std::vector<std::uint8_t> expected = pictureOf(frame);
    Caller caller;
    const Foreign foreign;
    glUseProgram(foreign.program);
    glBindVertexArray(foreign.vertexArray);
    glBindFramebuffer(GL_FRAMEBUFFER, foreign.framebuffer);
    glViewport(0, 0, kWidth, kHeight / 2);
    FrameDrawer drawer = FrameDrawer::onCurrentContext(village(), {.radius = 1}).value();
    for (int repeat = 0; repeat < 3; ++repeat) {
        ASSERT_TRUE(drawer.draw(frame));
        ASSERT_TRUE(drawer.copyTo(foreign.framebuffer));
        EXPECT_EQ(pixelsOf(foreign.image), expected) << "frame " << repeat;
        glDrawArrays(GL_TRIANGLES, 0,
                     3); // with the program, vertex array, framebuffer and viewport of before
        const std::vector<std::uint8_t> both = pixelsOf(foreign.image);
        EXPECT_TRUE(std::equal(both.begin(), both.begin() + kWidth * (kHeight / 2) * 4, expected.begin()))
            << "the upper half";
        const std::size_t lower = std::size_t{kWidth} * (kHeight - 1) * 4;
        EXPECT_EQ(both[lower], 255);
        EXPECT_EQ(both[lower + 2], 0);
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    }
}

TEST(FrameDrawerInAContext, copiesToAPlaceOfAFramebuffer) {
    Caller caller;
    const Foreign foreign;
    FrameDrawer drawer = FrameDrawer::onCurrentContext(village(), {.radius = 0}).value();
    FrameDescription frame = frameAt("inn.hall", false);
    frame.width = 40;
    frame.height = 20;
    ASSERT_TRUE(drawer.draw(frame));
    const std::vector<std::uint8_t> small = drawer.readColour().value();
    const std::array<GLubyte, 4> blue{0, 0, 255, 255};
    glClearTexImage(foreign.image, 0, GL_RGBA, GL_UNSIGNED_BYTE, blue.data());
    ASSERT_TRUE(drawer.copyTo(foreign.framebuffer, 100, 80)) << "ten rows are above the framebuffer";
    const std::vector<std::uint8_t> shown = pixelsOf(foreign.image);
    for (std::size_t y = 0; y < kHeight; ++y)
        for (std::size_t x = 0; x < kWidth; ++x) {
            const bool isInside = y < 10 && x >= 100 && x < 140;
            const std::uint8_t* expected = isInside ? &small[((y + 10) * 40 + (x - 100)) * 4] : blue.data();
            ASSERT_TRUE(std::equal(expected, expected + 4, &shown[(y * kWidth + x) * 4])) << x << ", " << y;
        }
    EXPECT_EQ(drawer.copyTo(12345).error().code, ErrorCode::BadArgument);
    GLuint empty = 0;
    glCreateFramebuffers(1, &empty);
    EXPECT_THAT(drawer.copyTo(empty).error().message(), HasSubstr("not complete"));
}

TEST(FrameDrawerInAContext, givesItsImagesToOtherCode) {
    Caller caller;
    FrameDrawer drawer = FrameDrawer::onCurrentContext(village(), {.radius = 0}).value();
    FrameDescription frame = frameAt("inn.hall");
    frame.viewpoint.pitch = 0.0;
    ASSERT_TRUE(drawer.draw(frame));
    const FrameObjects objects = drawer.objects().value();
    std::vector<float> depth(std::size_t{kWidth} * kHeight);
    glGetTextureImage(objects.depth, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                      static_cast<GLsizei>(depth.size() * sizeof(float)), depth.data());
    std::vector<std::uint32_t> ids(depth.size());
    glGetTextureImage(objects.ids, 0, GL_RED_INTEGER, GL_UNSIGNED_INT,
                      static_cast<GLsizei>(ids.size() * sizeof(std::uint32_t)), ids.data());
    // At the middle of the picture, the distance along the ray is that along the axis.
    const std::size_t x = kWidth / 2, y = kHeight / 2;
    const double axis = objects.nearPlane / static_cast<double>(depth[(kHeight - 1 - y) * kWidth + x]);
    EXPECT_NEAR(axis, drawer.readDistances().value()[y * kWidth + x], 1e-3 * axis);
    EXPECT_EQ(ids[(kHeight - 1 - y) * kWidth + x], drawer.readIds().value()[y * kWidth + x]);
    EXPECT_EQ(glIsTexture(objects.colour), GL_TRUE);
    EXPECT_EQ(glIsFramebuffer(objects.framebuffer), GL_TRUE);
}

TEST(FrameDrawerInAContext, refusesAnotherContext) {
    Caller first;
    std::optional<FrameDrawer> drawer(FrameDrawer::onCurrentContext(village(), {.radius = 0}).value());
    ASSERT_TRUE(drawer->draw(frameAt("inn.hall")));
    Caller second;
    EXPECT_THAT(drawer->draw(frameAt("inn.hall")).error().message(), HasSubstr("another OpenGL context"));
    EXPECT_THAT(drawer->readColour().error().message(), HasSubstr("another OpenGL context"));
    first.makeCurrent();
    EXPECT_TRUE(drawer->readColour());
    second.makeCurrent();
    GLuint texture = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &texture);
    drawer.reset(); // its names may be those of the second context's objects
    EXPECT_EQ(glIsTexture(texture), GL_TRUE);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST(FrameDrawerInAContext, needsAContext) {
    ASSERT_EQ(gpu::currentContext(), nullptr);
    const Result<FrameDrawer> drawer = FrameDrawer::onCurrentContext(village());
    ASSERT_FALSE(drawer);
    EXPECT_EQ(drawer.error().code, ErrorCode::BadArgument);
    const gpu::HeadlessContext compatible =
        gpu::HeadlessContext::create(false, gpu::ContextProfile::Compatibility).value();
    EXPECT_THAT(FrameDrawer::onCurrentContext(village()).error().message(), HasSubstr("core profile"));
}

TEST(FrameDrawer, headlessLeavesTheCurrentContext) {
    {
        FrameDrawer drawer = FrameDrawer::headless(village(), {.radius = 0}).value();
        ASSERT_TRUE(drawer.draw(frameAt("inn.hall")));
        EXPECT_EQ(gpu::currentContext(), nullptr);
    }
    EXPECT_EQ(gpu::currentContext(), nullptr);
    const Caller caller;
    void* const callers = gpu::currentContext();
    ASSERT_NE(callers, nullptr);
    const GLuint program = fillingProgram();
    glUseProgram(program);
    {
        FrameDrawer drawer = FrameDrawer::headless(village(), {.radius = 0}).value();
        EXPECT_EQ(gpu::currentContext(), callers);
        ASSERT_TRUE(drawer.draw(frameAt("inn.hall")));
        ASSERT_TRUE(drawer.readColour());
        EXPECT_EQ(gpu::currentContext(), callers);
    }
    EXPECT_EQ(gpu::currentContext(), callers);
    EXPECT_EQ(number(GL_CURRENT_PROGRAM), static_cast<GLint>(program));
}

} // namespace
} // namespace limen::engine::test
