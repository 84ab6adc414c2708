#include "GlFixture.h"

#include <algorithm>
#include <cstddef>
#include <fmt/format.h>
#include <fstream>
#include <map>

// Compares the driver's offsets of every struct in SharedLayout.h with those of C++.
namespace limen::gpu::test {
namespace {

using Offsets = std::map<std::string, std::size_t>;

struct SharedStruct {
    const char* name = "";
    std::size_t size = 0;
    Offsets members; ///< by the driver's name
};

#define MEMBER(Struct, member)                                                                               \
    { "entries[0]." #member, offsetof(layout::Struct, member) }

std::vector<SharedStruct> sharedStructs() {
    return {
        {"ViewConstants",
         sizeof(layout::ViewConstants),
         {MEMBER(ViewConstants, clipFromEye),     MEMBER(ViewConstants, eyeHigh),
          MEMBER(ViewConstants, eyeLow),          MEMBER(ViewConstants, eyeSteps),
          MEMBER(ViewConstants, sunDirection),    MEMBER(ViewConstants, sunColour),
          MEMBER(ViewConstants, landAmbient),     MEMBER(ViewConstants, skyAmbient),
          MEMBER(ViewConstants, sealedAmbient),   MEMBER(ViewConstants, viewerLight),
          MEMBER(ViewConstants, fogColour),       MEMBER(ViewConstants, fogRange),
          MEMBER(ViewConstants, voidColour),      MEMBER(ViewConstants, skyZenith),
          MEMBER(ViewConstants, detailTextures),  MEMBER(ViewConstants, detailTiling),
          MEMBER(ViewConstants, rootZone),        MEMBER(ViewConstants, visitCount),
          MEMBER(ViewConstants, flags),           MEMBER(ViewConstants, nearPlane),
          MEMBER(ViewConstants, staticInstances), MEMBER(ViewConstants, staticMembers),
          MEMBER(ViewConstants, staticPieces),    MEMBER(ViewConstants, replacementCount)}},
        {"DeviceConstants",
         sizeof(layout::DeviceConstants),
         {MEMBER(DeviceConstants, viewport),      MEMBER(DeviceConstants, rayCorner),
          MEMBER(DeviceConstants, rayRight),      MEMBER(DeviceConstants, rayUp),
          MEMBER(DeviceConstants, flags),         MEMBER(DeviceConstants, pixel),
          MEMBER(DeviceConstants, samplesX),      MEMBER(DeviceConstants, samplesY),
          MEMBER(DeviceConstants, firstBlock),    MEMBER(DeviceConstants, firstVisit),
          MEMBER(DeviceConstants, firstInstance), MEMBER(DeviceConstants, firstMember),
          MEMBER(DeviceConstants, firstPiece),    MEMBER(DeviceConstants, firstReplacement),
          MEMBER(DeviceConstants, firstRect),     MEMBER(DeviceConstants, firstSlotGroup),
          MEMBER(DeviceConstants, firstRun),      MEMBER(DeviceConstants, slotCount),
          MEMBER(DeviceConstants, firstOccludee), MEMBER(DeviceConstants, windowOrigin),
          MEMBER(DeviceConstants, firstLamp),     MEMBER(DeviceConstants, reserved0),
          MEMBER(DeviceConstants, reserved1),     MEMBER(DeviceConstants, reserved2)}},
        {"FrameConstants",
         sizeof(layout::FrameConstants),
         {MEMBER(FrameConstants, view.clipFromEye),     MEMBER(FrameConstants, view.eyeHigh),
          MEMBER(FrameConstants, view.eyeLow),          MEMBER(FrameConstants, view.eyeSteps),
          MEMBER(FrameConstants, view.sunDirection),    MEMBER(FrameConstants, view.sunColour),
          MEMBER(FrameConstants, view.landAmbient),     MEMBER(FrameConstants, view.skyAmbient),
          MEMBER(FrameConstants, view.sealedAmbient),   MEMBER(FrameConstants, view.viewerLight),
          MEMBER(FrameConstants, view.fogColour),       MEMBER(FrameConstants, view.fogRange),
          MEMBER(FrameConstants, view.voidColour),      MEMBER(FrameConstants, view.skyZenith),
          MEMBER(FrameConstants, view.detailTextures),  MEMBER(FrameConstants, view.detailTiling),
          MEMBER(FrameConstants, view.rootZone),        MEMBER(FrameConstants, view.visitCount),
          MEMBER(FrameConstants, view.flags),           MEMBER(FrameConstants, view.nearPlane),
          MEMBER(FrameConstants, view.staticInstances), MEMBER(FrameConstants, view.staticMembers),
          MEMBER(FrameConstants, view.staticPieces),    MEMBER(FrameConstants, view.replacementCount),
          MEMBER(FrameConstants, device.viewport),      MEMBER(FrameConstants, device.rayCorner),
          MEMBER(FrameConstants, device.rayRight),      MEMBER(FrameConstants, device.rayUp),
          MEMBER(FrameConstants, device.flags),         MEMBER(FrameConstants, device.pixel),
          MEMBER(FrameConstants, device.samplesX),      MEMBER(FrameConstants, device.samplesY),
          MEMBER(FrameConstants, device.firstBlock),    MEMBER(FrameConstants, device.firstVisit),
          MEMBER(FrameConstants, device.firstInstance), MEMBER(FrameConstants, device.firstMember),
          MEMBER(FrameConstants, device.firstPiece),    MEMBER(FrameConstants, device.firstReplacement),
          MEMBER(FrameConstants, device.firstRect),     MEMBER(FrameConstants, device.firstSlotGroup),
          MEMBER(FrameConstants, device.firstRun),      MEMBER(FrameConstants, device.slotCount),
          MEMBER(FrameConstants, device.firstOccludee), MEMBER(FrameConstants, device.windowOrigin),
          MEMBER(FrameConstants, device.firstLamp),     MEMBER(FrameConstants, device.reserved0),
          MEMBER(FrameConstants, device.reserved1),     MEMBER(FrameConstants, device.reserved2)}},
        {"Visit",
         sizeof(layout::Visit),
         {MEMBER(Visit, entryPlane), MEMBER(Visit, zone), MEMBER(Visit, parent), MEMBER(Visit, shutBy),
          MEMBER(Visit, reserved)}},
        {"Instance",
         sizeof(layout::Instance),
         {MEMBER(Instance, pose0), MEMBER(Instance, pose1), MEMBER(Instance, pose2), MEMBER(Instance, block),
          MEMBER(Instance, idBase), MEMBER(Instance, firstMaterial), MEMBER(Instance, firstMember),
          MEMBER(Instance, membersAndKind), MEMBER(Instance, level), MEMBER(Instance, highlight),
          MEMBER(Instance, opacity)}},
        {"Member", sizeof(layout::Member), {MEMBER(Member, zone), MEMBER(Member, lightSet)}},
        {"DrawPiece",
         sizeof(layout::DrawPiece),
         {MEMBER(DrawPiece, firstIndex), MEMBER(DrawPiece, triangles), MEMBER(DrawPiece, instance),
          MEMBER(DrawPiece, indicesBefore)}},
        {"RunOffsets", sizeof(layout::RunOffsets), {MEMBER(RunOffsets, piece), MEMBER(RunOffsets, kept)}},
        {"DrawRun",
         sizeof(layout::DrawRun),
         {MEMBER(DrawRun, offsets.piece), MEMBER(DrawRun, offsets.kept), MEMBER(DrawRun, firstSlot),
          MEMBER(DrawRun, rects)}},
        {"SlotGroup",
         sizeof(layout::SlotGroup),
         {MEMBER(SlotGroup, offsets.piece), MEMBER(SlotGroup, offsets.kept), MEMBER(SlotGroup, firstRun),
          MEMBER(SlotGroup, lastRun)}},
        {"Level",
         sizeof(layout::Level),
         {MEMBER(Level, originX), MEMBER(Level, originY), MEMBER(Level, originZ), MEMBER(Level, range)}},
        {"Replacement",
         sizeof(layout::Replacement),
         {MEMBER(Replacement, instance), MEMBER(Replacement, by)}},
        {"Material",
         sizeof(layout::Material),
         {MEMBER(Material, colour), MEMBER(Material, texture), MEMBER(Material, flags),
          MEMBER(Material, luminosity), MEMBER(Material, diffuse)}},
        {"TextureRef", sizeof(layout::TextureRef), {MEMBER(TextureRef, place)}},
        {"TerrainLayer",
         sizeof(layout::TerrainLayer),
         {MEMBER(TerrainLayer, texture), MEMBER(TerrainLayer, alpha), MEMBER(TerrainLayer, rotation),
          MEMBER(TerrainLayer, tiling)}},
        {"TerrainCell",
         sizeof(layout::TerrainCell),
         {MEMBER(TerrainCell, base.texture),         MEMBER(TerrainCell, base.alpha),
          MEMBER(TerrainCell, base.rotation),        MEMBER(TerrainCell, base.tiling),
          MEMBER(TerrainCell, overlays[0].texture),  MEMBER(TerrainCell, overlays[0].alpha),
          MEMBER(TerrainCell, overlays[0].rotation), MEMBER(TerrainCell, overlays[0].tiling),
          MEMBER(TerrainCell, overlays[1].texture),  MEMBER(TerrainCell, overlays[1].alpha),
          MEMBER(TerrainCell, overlays[1].rotation), MEMBER(TerrainCell, overlays[1].tiling),
          MEMBER(TerrainCell, overlays[2].texture),  MEMBER(TerrainCell, overlays[2].alpha),
          MEMBER(TerrainCell, overlays[2].rotation), MEMBER(TerrainCell, overlays[2].tiling),
          MEMBER(TerrainCell, roads[0].texture),     MEMBER(TerrainCell, roads[0].alpha),
          MEMBER(TerrainCell, roads[0].rotation),    MEMBER(TerrainCell, roads[0].tiling),
          MEMBER(TerrainCell, roads[1].texture),     MEMBER(TerrainCell, roads[1].alpha),
          MEMBER(TerrainCell, roads[1].rotation),    MEMBER(TerrainCell, roads[1].tiling)}},
        {"LightSet",
         sizeof(layout::LightSet),
         {MEMBER(LightSet, kind), MEMBER(LightSet, firstLamp), MEMBER(LightSet, lampCount),
          MEMBER(LightSet, sealed)}},
        {"OwnershipVertex",
         sizeof(layout::OwnershipVertex),
         {MEMBER(OwnershipVertex, position), MEMBER(OwnershipVertex, block), MEMBER(OwnershipVertex, visit),
          MEMBER(OwnershipVertex, clipSet), MEMBER(OwnershipVertex, outlineFirst),
          MEMBER(OwnershipVertex, outlineCount), MEMBER(OwnershipVertex, rest),
          MEMBER(OwnershipVertex, clipEdges)}},
        {"PackedCell",
         sizeof(layout::PackedCell),
         {{"entries[0].layers[0]", offsetof(layout::PackedCell, layers)},
          {"entries[0].shown[0]", offsetof(layout::PackedCell, shown)}}},
        {"Lamp", sizeof(layout::Lamp), {MEMBER(Lamp, position), MEMBER(Lamp, colour)}},
        {"DrawRecord",
         sizeof(layout::DrawRecord),
         {MEMBER(DrawRecord, row0), MEMBER(DrawRecord, row1), MEMBER(DrawRecord, row2),
          MEMBER(DrawRecord, rest), MEMBER(DrawRecord, ambient), MEMBER(DrawRecord, sun),
          MEMBER(DrawRecord, look), MEMBER(DrawRecord, members)}},
        {"ClipSet", sizeof(layout::ClipSet), {{"entries[0].planes[0]", offsetof(layout::ClipSet, planes)}}},
        {"SkyInstance",
         sizeof(layout::SkyInstance),
         {MEMBER(SkyInstance, row0), MEMBER(SkyInstance, row1), MEMBER(SkyInstance, row2),
          MEMBER(SkyInstance, firstMaterial), MEMBER(SkyInstance, opacity), MEMBER(SkyInstance, luminosity),
          MEMBER(SkyInstance, uvOffsetX), MEMBER(SkyInstance, uvOffsetY), MEMBER(SkyInstance, diffuse),
          MEMBER(SkyInstance, overLand), MEMBER(SkyInstance, clipSet)}},
    };
}

class SharedLayoutGlTest : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        std::ifstream in(std::string(LIMEN_SOURCE_DIR) + "/shaders/include/SharedLayout.h");
        header_.assign(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
        ASSERT_FALSE(header_.empty());
    }

    /// A program with one storage block, an array of the struct, that uses all members.
    [[nodiscard]] Program programOf(const char* name) const {
        const std::string text =
            fmt::format("#version 450 core\n{}\nlayout(local_size_x = 1) in;\n"
                        "layout(std430, binding = kBindFrame) buffer Block {{ {} entries[]; }};\n"
                        "void main() {{ entries[gl_WorkGroupID.x] = entries[gl_WorkGroupID.x + 1u]; }}\n",
                        header_, name);
        Result<Program> program = Program::link(name, {{GL_COMPUTE_SHADER, name, text}});
        EXPECT_TRUE(program) << program.error().message();
        return program ? std::move(*program) : Program{};
    }

    std::string header_;
};

/// Calls `take(name, values)` for every member of a program's interface, with the values of two properties.
template <class Take>
void readMembers(GLuint program, GLenum interface, const std::array<GLenum, 2>& properties,
                 const Take& take) {
    GLint count = 0;
    glGetProgramInterfaceiv(program, interface, GL_ACTIVE_RESOURCES, &count);
    for (GLuint i = 0; i < static_cast<GLuint>(count); ++i) {
        std::array<GLchar, 128> name{};
        GLsizei length = 0;
        glGetProgramResourceName(program, interface, i, static_cast<GLsizei>(name.size()), &length,
                                 name.data());
        std::array<GLint, 2> values{};
        glGetProgramResourceiv(program, interface, i, static_cast<GLsizei>(properties.size()),
                               properties.data(), static_cast<GLsizei>(values.size()), nullptr,
                               values.data());
        take(std::string(name.data(), static_cast<std::size_t>(length)), values);
    }
}

/// Reads the driver's offsets and array stride.
void read(GLuint program, Offsets& offsets, std::size_t& stride) {
    readMembers(program, GL_BUFFER_VARIABLE, {GL_OFFSET, GL_TOP_LEVEL_ARRAY_STRIDE},
                [&](const std::string& name, const std::array<GLint, 2>& values) {
                    offsets[name] = static_cast<std::size_t>(values[0]);
                    stride = static_cast<std::size_t>(values[1]);
                });
}

TEST_F(SharedLayoutGlTest, everyMemberLiesWhereTheDriverReadsIt) {
    for (const SharedStruct& shared : sharedStructs()) {
        const Program program = programOf(shared.name);
        ASSERT_FALSE(program.empty());
        Offsets reported;
        std::size_t stride = 0;
        read(program.id(), reported, stride);
        EXPECT_EQ(reported, shared.members) << shared.name;
        EXPECT_EQ(stride, shared.size) << shared.name;
    }
}

/// Offsets of the frame's uniform block, by the names of its members behind "entries[0].".
Offsets frameBlockOf(GLuint program) {
    Offsets offsets;
    readMembers(program, GL_UNIFORM, {GL_OFFSET, GL_BLOCK_INDEX},
                [&](const std::string& name, const std::array<GLint, 2>& values) {
                    if (values[1] >= 0) // in a block
                        offsets["entries[0]." + name] = static_cast<std::size_t>(values[0]);
                });
    return offsets;
}

// The frame's constants are read by std140, all other structs by std430.
TEST_F(SharedLayoutGlTest, theFramesUniformBlockHasTheSameLayout) {
    const std::string text =
        fmt::format("#version 450 core\n{}\nlayout(local_size_x = 1) in;\n"
                    "layout(std140, binding = kBindFrame) uniform FrameBlock {{ ViewConstants view; "
                    "DeviceConstants device; }};\n"
                    "layout(std430, binding = 1) buffer Out {{ FrameConstants result; }};\n"
                    "void main() {{ result.view = view; result.device = device; }}\n",
                    header_);
    const Result<Program> program = Program::link("frame", {{GL_COMPUTE_SHADER, "frame", text}});
    ASSERT_TRUE(program) << program.error().message();
    const std::vector<SharedStruct> structs = sharedStructs();
    const auto expected = std::find_if(structs.begin(), structs.end(), [](const SharedStruct& shared) {
        return std::string_view(shared.name) == "FrameConstants";
    });
    ASSERT_NE(expected, structs.end());
    EXPECT_EQ(frameBlockOf(program->id()), expected->members);
}

/// Names of the structs that the header defines.
std::vector<std::string> structsIn(const std::string& header) {
    std::vector<std::string> names;
    for (const std::string& opening : {std::string("\nLIMEN_STRUCT("), std::string("\nstruct ")}) {
        for (std::size_t at = header.find(opening); at != std::string::npos;
             at = header.find(opening, at + 1)) {
            const std::size_t begin = at + opening.size();
            names.push_back(header.substr(begin, header.find_first_of(") ", begin) - begin));
        }
    }
    return names;
}

TEST_F(SharedLayoutGlTest, everyStructOfTheHeaderIsCompared) {
    const std::vector<std::string> names = structsIn(header_);
    EXPECT_GE(names.size(), 20u);
    const std::vector<SharedStruct> compared = sharedStructs();
    for (const std::string& name : names) {
        const bool isThere = std::any_of(compared.begin(), compared.end(),
                                         [&](const SharedStruct& shared) { return name == shared.name; });
        EXPECT_TRUE(isThere) << name;
    }
}

} // namespace
} // namespace limen::gpu::test
