#include "dat/Writer.h"

#include "core/Interrupt.h"
#include "core/platform/Process.h"
#include "dat/Iterations.h"
#include "dat/container/Format.h"
#include "dat/container/Inflate.h"
#include "dat/container/TreeBuilder.h"

#include <cstring>
#include <fstream>
#include <system_error>

#include <fmt/format.h>

namespace limen::dat {
namespace {

/// Pack versions of entries. Retail files have version 1 for the iteration record alone.
constexpr std::uint16_t kEntryVersion = 2, kIterationEntryVersion = 1;
constexpr std::int32_t kFirstIteration = 1;

void putWord(Bytes& out, std::size_t offset, std::uint32_t word) {
    std::memcpy(out.data() + offset, &word, sizeof word);
}

/// A file under construction. Blocks are allocated in ascending order.
class BlockSink {
public:
    explicit BlockSink(std::uint32_t blockSize)
        : blockSize_(blockSize), capacity_(blockSize - 4), bytes_(firstUsableOffset(blockSize)) {}

    /// Stores an object in consecutive blocks. Returns the offset of the first one. Without room it stores nothing.
    std::uint32_t store(ByteView object) {
        const std::size_t count = object.empty() ? 1 : (object.size() + capacity_ - 1) / capacity_;
        const std::size_t start = bytes_.size();
        isFull_ = isFull_ || start + count * blockSize_ >= kLargestFile;
        if (isFull_)
            return 0;
        bytes_.resize(start + count * blockSize_);
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t block = start + i * blockSize_;
            const std::size_t done = i * capacity_;
            const std::size_t part = std::min(capacity_, object.size() - done);
            if (i + 1 < count)
                putWord(bytes_, block, static_cast<std::uint32_t>(block + blockSize_));
            if (part != 0)
                std::memcpy(bytes_.data() + block + 4, object.data() + done, part);
        }
        return static_cast<std::uint32_t>(start);
    }
    void reserve(std::size_t size) { bytes_.reserve(size); }
    [[nodiscard]] Bytes& bytes() { return bytes_; }
    [[nodiscard]] bool isFull() const { return isFull_; }

private:
    static constexpr std::uint64_t kLargestFile = std::uint64_t{1} << 31; ///< bytes; a file is smaller

    std::size_t blockSize_;
    std::size_t capacity_;
    Bytes bytes_;
    bool isFull_ = false;
};

Bytes nodeBytes(const NodePlan& node, const std::vector<std::uint32_t>& offsets) {
    Bytes out(kNodeBytes);
    for (std::size_t i = 0; i < node.children.size(); ++i)
        putWord(out, kBranchesAt + i * 4, offsets[node.children[i]]);
    putWord(out, kCountAt, static_cast<std::uint32_t>(node.entries.size()));
    for (std::size_t i = 0; i < node.entries.size(); ++i) {
        const Entry& entry = node.entries[i];
        const std::size_t at = kEntriesAt + i * kEntryBytes;
        putWord(out, at, entry.flags | std::uint32_t{entry.version} << 16);
        putWord(out, at + 4, entry.id);
        putWord(out, at + 8, entry.offset);
        putWord(out, at + 12, entry.size);
        putWord(out, at + 16, entry.date);
        putWord(out, at + 20, static_cast<std::uint32_t>(entry.iteration));
    }
    return out;
}

/// Stores the tree over `entries`. Returns the offset of its root.
std::uint32_t storeTree(BlockSink& sink, const std::vector<Entry>& entries) {
    std::vector<std::uint32_t> offsets;
    for (const NodePlan& node : planTree(entries))
        offsets.push_back(sink.store(nodeBytes(node, offsets)));
    return offsets.back();
}

void putHeader(Bytes& out, const FileTraits& traits, std::uint32_t root) {
    constexpr unsigned char kIdle[4] = {0x00, 0x50, 0x4C, 0x00};
    std::memcpy(out.data() + header::kTransaction, kIdle, sizeof kIdle);
    putWord(out, header::kMagicAt, kMagic);
    putWord(out, header::kBlockSize, traits.blockSize);
    putWord(out, header::kFileSize, static_cast<std::uint32_t>(out.size()));
    putWord(out, header::kType, traits.type);
    putWord(out, header::kSubset, traits.subset);
    putWord(out, header::kRoot, root);
    putWord(out, header::kEngineVersion, traits.engineVersion);
    putWord(out, header::kGameVersion, traits.gameVersion);
    putWord(out, header::kMinorVersion, traits.minorVersion);
}

std::filesystem::path temporaryBeside(const std::filesystem::path& path) {
    std::filesystem::path temporary = path;
    temporary += fmt::format(".{}.part", platform::processId());
    return temporary;
}

} // namespace

FileTraits FileTraits::portal() {
    return {1024, kTypePortal, 0, 110, 0, 6657};
}
FileTraits FileTraits::cell() {
    return {256, kTypeCell, 1, 22, 0, 6657};
}
FileTraits FileTraits::highres() {
    return {1024, kTypePortal, kHighresSubset, 110, 0, 6657};
}
FileTraits FileTraits::local() {
    return {1024, kTypeLocal, 1, 110, 0, 6657};
}

void Writer::add(RecordId id, Bytes payload, bool compressed) {
    if (compressed && payload.size() > kMaxInflatedBytes)
        return refuse({ErrorCode::BadArgument, idText(id),
                       "has more than 64 MiB, the most that a compressed record has"});
    records_[id] = {compressed ? deflateRecord(payload) : std::move(payload), compressed};
}

void Writer::addEncoded(RecordId id, Result<Bytes> encoded) {
    if (!encoded)
        return refuse({ErrorCode::BadArgument, idText(id), std::move(encoded.error().what)});
    add(id, *std::move(encoded));
}

void Writer::refuse(Error fault) {
    if (!fault_)
        fault_ = std::move(fault);
}

Result<Bytes> Writer::build() const {
    if (fault_)
        return Failure(*fault_);
    const std::uint32_t size = traits_.blockSize;
    if (size < kMinBlockSize || size > kMaxBlockSize || (size & (size - 1)) != 0)
        return fail(ErrorCode::BadArgument, "dat file",
                    fmt::format("a block size is a power of two from 64 to 65536, and not {}", size));
    BlockSink sink(size);
    std::vector<Entry> entries;
    entries.reserve(records_.size() + 1);
    const auto store = [&](RecordId id, const Bytes& bytes, bool compressed) {
        const auto flags = static_cast<std::uint16_t>(compressed ? kCompressedFlag : 0);
        const auto length = static_cast<std::uint32_t>(bytes.size());
        const std::uint16_t version = id == kIterationId ? kIterationEntryVersion : kEntryVersion;
        entries.push_back({id, flags, version, sink.store(bytes), length, 0, kFirstIteration});
    };
    const Result<Bytes> iterations =
        encodeIterations({kFirstIteration, {{kFirstIteration, kFirstIteration}}});
    bool iterationDue = !records_.contains(kIterationId);
    for (const auto& [id, stored] : records_) {
        if (iterationDue && id > kIterationId) {
            store(kIterationId, *iterations, false);
            iterationDue = false;
        }
        store(id, stored.bytes, stored.compressed);
    }
    if (iterationDue)
        store(kIterationId, *iterations, false);
    const std::uint32_t root = storeTree(sink, entries);
    if (sink.isFull())
        return fail(ErrorCode::BadArgument, "dat file",
                    "the records need 2 GiB or more, and a file has less; divide them");
    putHeader(sink.bytes(), traits_, root);
    return std::move(sink.bytes());
}

Result<void> Writer::write(const std::filesystem::path& path) const {
    const Result<Bytes> built = build();
    if (!built)
        return Failure(built.error());
    const Bytes& bytes = *built;
    const UninterruptedWrite whole;
    const std::filesystem::path temporary = temporaryBeside(path);
    {
        std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
        if (!out)
            return fail(ErrorCode::Unreadable, path.string(),
                        "the file cannot be created there; choose another directory");
        out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        out.close();
        if (!out) {
            std::error_code ignored;
            std::filesystem::remove(temporary, ignored);
            return fail(ErrorCode::Unreadable, path.string(),
                        "the file cannot be written; check the free space of the disk");
        }
    }
    std::error_code error;
    std::filesystem::rename(temporary, path, error);
    if (!error)
        return {};
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    return fail(ErrorCode::Unreadable, path.string(),
                "the finished file cannot be put in place: " + error.message());
}

} // namespace limen::dat
