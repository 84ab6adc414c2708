#include "GlFixture.h"
#include "gpu/scene/Programs.h"

namespace limen::gpu::test {
namespace {

class ShadersGlTest : public GlTest {
protected:
    /// The variants that `Programs::create` does not build.
    static void buildVariants(Programs& programs) {
        for (std::size_t program = 0; program < frame::kProgramCount; ++program) {
            for (unsigned bits = 0; bits < 1024; ++bits) {
                if ((bits & 129) == 129)
                    continue; // clipped programs have no ownership test
                const ProgramVariant variant{.gated = (bits & 1) != 0,
                                             .flat = (bits & 2) != 0,
                                             .multisampled = (bits & 4) != 0,
                                             .lamps = (bits & 8) != 0,
                                             .details = (bits & 32) != 0,
                                             .pixelLamps = (bits & 64) != 0,
                                             .ids = (bits & 16) != 0,
                                             .clipped = (bits & 128) != 0,
                                             .memberLists = (bits & 512) != 0,
                                             .shells = (bits & 256) == 0};
                const Result<void> made = programs.prepare(static_cast<frame::Program>(program), variant);
                EXPECT_TRUE(made) << made.error().message();
            }
        }
    }
};

TEST_F(ShadersGlTest, everyVariantBuilds) {
    std::vector<TextureBinding> bindings{
        {false, 0}, {false, 1}, {false, device_->capabilities().textureUnits - frame::gpu::kUnitFirstPage}};
    if (device_->capabilities().bindless)
        bindings.push_back({true, 0, {}});
    for (const Drawing drawing : {Drawing::Exact, Drawing::Fast}) {
        for (const TextureBinding& binding : bindings) {
            Result<Programs> programs = Programs::create(*device_, drawing, {binding, binding});
            ASSERT_TRUE(programs) << programs.error().message();
            buildVariants(*programs);
        }
    }
}

// `get` requires that a program is there.
TEST_F(ShadersGlTest, programsOfLitFramesAreBuiltAtOnce) {
    const TextureBinding pages{false, 1};
    for (const Drawing drawing : {Drawing::Exact, Drawing::Fast}) {
        const bool isExact = drawing == Drawing::Exact;
        Result<Programs> programs = Programs::create(*device_, drawing, {pages, pages});
        ASSERT_TRUE(programs) << programs.error().message();
        for (const frame::Program program : {frame::Program::Opaque, frame::Program::CutOut,
                                             frame::Program::Terrain, frame::Program::Blended})
            for (const bool gated : {false, true})
                for (const bool changed : {false, true})
                    EXPECT_NE(programs->get(program, {.gated = gated,
                                                      .ids = isExact,
                                                      .memberLists = !isExact && gated && changed,
                                                      .shells = !(isExact && changed)}),
                              ProgramHandle::Invalid);
    }
}

TEST_F(ShadersGlTest, failureNamesFileLineAndDriver) {
    ProgramSource source =
        programSource(Drawing::Exact, frame::Program::Opaque, {.gated = true}, {false, 1, {0}});
    source.defines.emplace_back("walkChain"); // breaks include/gate.glsl at the function's definition
    const Result<ProgramHandle> program = device_->createProgram(source);
    ASSERT_FALSE(program);
    EXPECT_EQ(program.error().code, ErrorCode::Driver);
    EXPECT_NE(program.error().what.find("include/gate.glsl:"), std::string::npos) << program.error().what;
    EXPECT_NE(program.error().what.find(device_->capabilities().renderer), std::string::npos);
    debug_->clear(); // the driver repeats it as a debug message
}

TEST_F(ShadersGlTest, targetOfAbsurdSizeIsRefused) {
    EXPECT_FALSE(RenderTarget::create(*device_, 0, 5));
    EXPECT_FALSE(RenderTarget::create(*device_, 100000, 100000));
}

} // namespace
} // namespace limen::gpu::test
