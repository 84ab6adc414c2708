#include "DatBench.h"

#include "Stopwatch.h"

#include "core/Hash.h"
#include "dat/File.h"
#include "dat/Writer.h"

#include <cmath>
#include <filesystem>
#include <random>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

namespace limen::bench {
namespace {

using namespace limen::dat;

constexpr int kDatRepeats = 15;
constexpr RecordId kRecords = 100'001;
constexpr double kLookupTargetNs = 1000.0;
constexpr double kDecodeTargetMBs = 300.0;
constexpr std::size_t kDecodeBytes = std::size_t{8} << 20;

/// Portal ids are in runs with gaps, cell ids are grouped by block. Both cover the whole range.
RecordId lookupId(FileRole role, RecordId i) {
    return role == FileRole::Cell ? ((i / 300) << 16) + 0x100 + i % 300
                                  : ((1 + i / 30000) << 24) + (i % 30000) * 2;
}

/// A file on disk that the destructor removes.
class TemporaryFile {
public:
    explicit TemporaryFile(const Writer& writer, const char* name) {
        std::error_code error;
        const auto directory = std::filesystem::temp_directory_path(error);
        path_ = directory / fmt::format("limen-bench-{}-{}", ::getpid(), name);
        written_ = !error && writer.write(path_).has_value();
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }
    [[nodiscard]] bool written() const { return written_; }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
    bool written_ = false;
};

BenchRow openRow(const std::filesystem::path& path, const std::string& scene, AllocationCounter counter) {
    constexpr int kOpens = 100;
    Hash hash;
    const Samples samples = measure(kDatRepeats, counter, [&] {
        for (int i = 0; i < kOpens; ++i)
            hash.add(File::open(path)->header().root);
    });
    BenchRow row{"dat/open", scene, samples.quantile(0.5) / kOpens * 1e6,
                 samples.quantile(0.95) / kOpens * 1e6, "us"};
    row.allocations = samples.allocations / kOpens;
    row.hash = hash.value();
    return row;
}

BenchRow lookupRow(const File& file, const std::vector<RecordId>& ids, const std::string& scene,
                   AllocationCounter counter) {
    std::uint64_t sum = 0;
    const Samples samples = measure(kDatRepeats, counter, [&] {
        sum = 0;
        for (const RecordId id : ids)
            sum += (*file.find(id))->offset;
    });
    std::vector<RecordId> sorted = ids;
    std::sort(sorted.begin(), sorted.end());
    std::uint64_t found = 0;
    const Samples array = measure(kDatRepeats, nullptr, [&] {
        for (const RecordId id : ids)
            found += static_cast<std::uint64_t>(std::lower_bound(sorted.begin(), sorted.end(), id) -
                                                sorted.begin());
    });
    const double perLookup = 1e9 / static_cast<double>(ids.size());
    BenchRow row{"dat/lookup", scene, samples.quantile(0.5) * perLookup, samples.quantile(0.95) * perLookup,
                 "ns"};
    row.against = {{"binary search in a sorted array", array.quantile(0.5) * perLookup}};
    row.target = kLookupTargetNs;
    row.hasTarget = true;
    row.allocations = samples.allocations;
    Hash hash;
    hash.add(sum);
    hash.add(found);
    row.hash = hash.value();
    return row;
}

void benchFile(FileRole role, AllocationCounter counter, std::vector<BenchRow>& rows) {
    const bool isCell = role == FileRole::Cell;
    Writer writer(isCell ? FileTraits::cell() : FileTraits::portal());
    std::vector<RecordId> ids;
    for (RecordId i = 0; i < kRecords; ++i) {
        ids.push_back(lookupId(role, i));
        writer.add(ids.back(), Bytes(16));
    }
    const TemporaryFile onDisk(writer, isCell ? "cell.dat" : "portal.dat");
    const auto file =
        onDisk.written() ? File::open(onDisk.path()) : File::fromBytes(*writer.build(), "bench.dat");
    const std::string scene =
        fmt::format("{} records, blocks of {}", kRecords,
                    isCell ? FileTraits::cell().blockSize : FileTraits::portal().blockSize);
    if (onDisk.written())
        rows.push_back(openRow(onDisk.path(), scene, counter));
    std::shuffle(ids.begin(), ids.end(), std::mt19937(1));
    rows.push_back(lookupRow(*file, ids, scene, counter));
}

/// A bent sheet of side x side quads, a mesh like those of models and cells.
class Sheet {
public:
    explicit Sheet(std::uint16_t side) : side_(side) {}

    [[nodiscard]] VertexArray vertices() const {
        VertexArray out;
        for (int i = 0; i < (side_ + 1) * (side_ + 1); ++i) {
            const auto x = static_cast<float>(i % (side_ + 1)), y = static_cast<float>(i / (side_ + 1));
            Vertex v{{x, y, std::sin(x) * std::cos(y)}, {0.0f, 0.0f, 1.0f}, {{x, y}}};
            for (int k = 0; k < i % 3; ++k) // a vertex that several surfaces share has a uv for each
                v.uvs.push_back({x * 0.5f, y * 0.5f});
            out.vertices.emplace_back(static_cast<std::uint16_t>(i), v);
        }
        return out;
    }

    /// Quads; every third one is cut into two triangles.
    [[nodiscard]] PolygonList polygons(bool textured) const {
        PolygonList out;
        const auto add = [&](SmallVec<std::uint16_t, 8> keys) {
            Polygon p;
            p.posSurface = 0;
            p.stippling = textured ? 0 : kNoPositiveUv;
            if (textured)
                p.posUv.resize(keys.size());
            p.vertexKeys = std::move(keys);
            out.emplace_back(static_cast<std::uint16_t>(out.size()), std::move(p));
        };
        for (int y = 0; y < side_; ++y) {
            for (int x = 0; x < side_; ++x) {
                const auto a = key(x, y), b = key(x + 1, y), c = key(x + 1, y + 1), d = key(x, y + 1);
                if ((x + y) % 3 == 0) {
                    add({a, b, c});
                    add({a, c, d});
                } else {
                    add({a, b, c, d});
                }
            }
        }
        return out;
    }

    /// A balanced tree with a few polygons in each leaf.
    [[nodiscard]] BspTree tree(BspKind kind) const {
        BspTree out;
        addNode(out, kind, 0, static_cast<std::uint16_t>(side_ * side_));
        return out;
    }

private:
    [[nodiscard]] std::uint16_t key(int x, int y) const {
        return static_cast<std::uint16_t>(y * (side_ + 1) + x);
    }

    std::int32_t addNode(BspTree& tree, BspKind kind, std::uint16_t first, std::uint16_t last) const {
        const auto index = static_cast<std::int32_t>(tree.nodes.size());
        BspNode node;
        const bool isLeaf = last - first <= 4;
        node.tag = isLeaf ? BspTag::Leaf : BspTag::BPIN;
        node.plane = {{0.0f, 1.0f, 0.0f}, static_cast<float>(first)};
        const bool listed = kind == BspKind::Physics ? isLeaf : kind == BspKind::Drawing && !isLeaf;
        for (int i = first; listed && i < last && i < first + 4; ++i)
            node.polygonIds.push_back(static_cast<std::uint16_t>(i));
        tree.nodes.push_back(node);
        if (!isLeaf) {
            const auto middle = static_cast<std::uint16_t>((first + last) / 2);
            const auto positive = addNode(tree, kind, first, middle);
            const auto negative = addNode(tree, kind, middle, last);
            tree.nodes[static_cast<std::size_t>(index)].positive = positive;
            tree.nodes[static_cast<std::size_t>(index)].negative = negative;
        }
        return index;
    }

    std::uint16_t side_;
};

GfxObj makeGfxObj(RecordId id, std::uint16_t side) {
    const Sheet sheet(side);
    GfxObj g;
    g.id = id;
    g.flags = GfxObj::kPhysics | GfxObj::kDrawing;
    g.surfaces = {0x08000001, 0x08000002};
    g.vertexArray = sheet.vertices();
    g.polygons = sheet.polygons(true);
    g.drawingBsp = sheet.tree(BspKind::Drawing);
    g.physicsPolygons = sheet.polygons(false);
    g.physicsBsp = sheet.tree(BspKind::Physics);
    return g;
}

Environment makeEnvironment(RecordId id, std::uint16_t side) {
    Environment e;
    e.id = id;
    for (std::uint32_t key = 0; key < 4; ++key) {
        const Sheet sheet(static_cast<std::uint16_t>(2 + (side + key) % 6));
        CellStruct cell;
        cell.vertexArray = sheet.vertices();
        cell.polygons = sheet.polygons(true);
        cell.portalPolygons = {0, 1};
        for (int i = 0; i < 6; ++i) // a chain of half-spaces
            cell.cellBsp.nodes.push_back(
                {BspTag::BPnn, 0, 0, {{1.0f, 0.0f, 0.0f}, 2.0f}, {}, i + 1, -1, {}, {}});
        cell.cellBsp.nodes.push_back({});
        cell.physicsPolygons = sheet.polygons(false);
        cell.physicsBsp = sheet.tree(BspKind::Physics);
        cell.drawingBsp = sheet.tree(BspKind::Drawing);
        e.cells.emplace_back(key, std::move(cell));
    }
    return e;
}

EnvCell makeEnvCell(RecordId id, std::uint16_t size) {
    EnvCell c;
    c.id = id;
    c.flags = EnvCell::kSeenOutside | EnvCell::kHasStatics;
    c.surfaces.assign(4 + size % 5u, 0x10C);
    c.portals.assign(1 + size % 4u, CellPortal{3, 4, 0x101, 1});
    c.visibleCells.assign(8 + size % 12u, 0x102);
    c.statics.assign(size % 6u, Stab{0x02000001, {}});
    return c;
}

template <class Record>
BenchRow decodeRow(const std::string& name, AllocationCounter counter,
                   Record (*make)(RecordId, std::uint16_t)) {
    std::vector<std::pair<RecordId, Bytes>> payloads;
    std::size_t total = 0;
    for (RecordId id = 0x01000001; total < kDecodeBytes; ++id) {
        payloads.emplace_back(id, *encode(make(id, static_cast<std::uint16_t>(4 + id % 13))));
        total += payloads.back().second.size();
    }
    std::size_t decoded = 0;
    const Samples samples = measure(kDatRepeats, counter, [&] {
        decoded = 0;
        for (const auto& [id, bytes] : payloads)
            decoded += decode<Record>(id, bytes).has_value() ? 1 : 0;
    });
    Bytes target(std::size_t{1} << 20);
    unsigned copied = 0;
    const Samples copy = measure(kDatRepeats, nullptr, [&] {
        for (const auto& [id, bytes] : payloads) {
            std::memcpy(target.data(), bytes.data(), bytes.size());
            copied += std::to_integer<unsigned>(target[bytes.size() / 2]);
        }
    });
    const double megabytes = static_cast<double>(total) * 1e-6;
    BenchRow row{"dat/decode-" + name, fmt::format("{} records, {:.1f} MB", payloads.size(), megabytes),
                 megabytes / samples.quantile(0.5), megabytes / samples.quantile(0.95), "MB/s"};
    row.against = {{"memcpy", megabytes / copy.quantile(0.5)}};
    row.target = kDecodeTargetMBs;
    row.hasTarget = true;
    row.lowerIsBetter = false;
    row.allocations = samples.allocations / payloads.size();
    Hash hash;
    hash.add(decoded);
    hash.add(copied);
    for (const auto& [id, bytes] : payloads) {
        const Bytes again = *encode(*decode<Record>(id, bytes));
        for (const std::byte b : again)
            hash.add(b);
    }
    row.hash = hash.value();
    return row;
}

} // namespace

std::vector<BenchRow> benchDat(AllocationCounter counter) {
    std::vector<BenchRow> rows;
    benchFile(FileRole::Portal, counter, rows);
    benchFile(FileRole::Cell, counter, rows);
    rows.push_back(decodeRow<GfxObj>("gfxobj", counter, makeGfxObj));
    rows.push_back(decodeRow<Environment>("environment", counter, makeEnvironment));
    rows.push_back(decodeRow<EnvCell>("envcell", counter, makeEnvCell));
    return rows;
}

} // namespace limen::bench
