#include "dat/Iterations.h"
#include "dat/Writer.h"

#include <gtest/gtest.h>

// Records that the format cannot hold are errors, never the end of the program.
namespace limen::dat {
namespace {

template <class Record>
std::string faultOf(const Record& record) {
    const Result<Bytes> bytes = encode(record);
    EXPECT_FALSE(bytes);
    return bytes ? "" : bytes.error().message();
}

Polygon triangle() {
    Polygon polygon;
    polygon.stippling = kNoPositiveUv;
    polygon.vertexKeys = {0, 1, 2};
    return polygon;
}

GfxObj mesh(Polygon polygon) {
    GfxObj object;
    object.id = 0x01000001;
    object.flags = GfxObj::kDrawing;
    object.polygons = {{0, std::move(polygon)}};
    object.drawingBsp.nodes.emplace_back(); // a leaf
    return object;
}

TEST(EncodeFaults, namesTheRuleThatARecordBreaks) {
    EXPECT_TRUE(encode(mesh(triangle())));
    Polygon line = triangle();
    line.vertexKeys.pop_back();
    EXPECT_EQ(faultOf(mesh(line)), "0x01000001: cannot be encoded: a polygon has 3 to 255 vertices");
    Polygon uvs = triangle();
    uvs.posUv = {0, 0, 0};
    EXPECT_EQ(faultOf(mesh(uvs)),
              "0x01000001: cannot be encoded: kNoPositiveUv says that there are no positive uvs");
    uvs.stippling = 0;
    uvs.posUv.pop_back();
    EXPECT_EQ(faultOf(mesh(uvs)),
              "0x01000001: cannot be encoded: a list must have as many items as the record says elsewhere");
    GfxObj hidden = mesh(triangle());
    hidden.flags = 0;
    EXPECT_EQ(faultOf(hidden), "0x01000001: cannot be encoded: drawing content needs kDrawing");
}

TEST(EncodeFaults, endsAtTreesThatAreNone) {
    GfxObj object = mesh(triangle());
    object.drawingBsp.nodes.clear();
    EXPECT_EQ(
        faultOf(object),
        "0x01000001: cannot be encoded: the format requires a BSP tree here; the smallest is a single leaf");
    BspNode node;
    node.tag = BspTag::BPIN;
    node.positive = node.negative = 7;
    object.drawingBsp.nodes = {node};
    EXPECT_EQ(faultOf(object), "0x01000001: cannot be encoded: a BSP node lacks a child");
    object.drawingBsp.nodes[0].positive = object.drawingBsp.nodes[0].negative = 0;
    EXPECT_EQ(faultOf(object),
              "0x01000001: cannot be encoded: a BSP tree is too deep, or a node is its own descendant");
}

TEST(EncodeFaults, coverRecordsOfAllFiles) {
    EnvCell cell;
    cell.id = 0x01020100;
    cell.statics.emplace_back();
    EXPECT_EQ(faultOf(cell), "0x01020100: cannot be encoded: statics need kHasStatics");
    LandBlockInfo info;
    info.restrictions = {{1, 2}};
    EXPECT_NE(faultOf(info), "");
    Animation animation;
    animation.positionFrames.emplace_back();
    EXPECT_NE(faultOf(animation), "");
    dat::Setup setup;
    setup.parents = {0};
    EXPECT_NE(faultOf(setup), "");
    Region region;
    region.sounds.emplace_back();
    EXPECT_NE(faultOf(region), "");
    PhysicsScript script;
    script.hooks.emplace_back().hook.type = 0x7777;
    EXPECT_NE(faultOf(script), "");
    EXPECT_EQ(encodeIterations({1, {{1, 0}}}).error().message(),
              "iterations: a run has 0 iterations; it needs one or more");
}

TEST(EncodeFaults, areReportedByTheWriter) {
    Writer writer(FileTraits::portal());
    Polygon line = triangle();
    line.vertexKeys.pop_back();
    writer.add(mesh(triangle()));
    EXPECT_TRUE(writer.build());
    writer.add(mesh(line));
    writer.add(mesh(triangle()));
    const auto built = writer.build();
    ASSERT_FALSE(built);
    EXPECT_EQ(built.error().code, ErrorCode::BadArgument);
    EXPECT_EQ(built.error().message(), "0x01000001: cannot be encoded: a polygon has 3 to 255 vertices");
    const std::filesystem::path path = testing::TempDir() + "encode-faults.dat";
    std::filesystem::remove(path);
    EXPECT_FALSE(writer.write(path));
    EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(EncodeFaults, ofWholeFiles) {
    FileTraits traits = FileTraits::portal();
    for (const std::uint32_t size : {0u, 32u, 1000u, 131072u}) {
        traits.blockSize = size;
        const auto built = Writer(traits).build();
        ASSERT_FALSE(built);
        EXPECT_EQ(built.error().message(),
                  "dat file: a block size is a power of two from 64 to 65536, and not " +
                      std::to_string(size));
    }
    Writer writer(FileTraits::portal());
    writer.add(0x06000001, Bytes((std::size_t{64} << 20) + 1), true);
    ASSERT_FALSE(writer.build());
    EXPECT_EQ(writer.build().error().message(),
              "0x06000001: has more than 64 MiB, the most that a compressed record has");
}

} // namespace
} // namespace limen::dat
