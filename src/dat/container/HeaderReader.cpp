#include "dat/container/HeaderReader.h"

#include "dat/container/Format.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include <fmt/format.h>

namespace limen::dat {
namespace {

std::uint32_t wordAt(ByteView file, std::size_t offset) {
    std::uint32_t word = 0;
    std::memcpy(&word, file.data() + offset, sizeof word);
    return word;
}

bool isZeros(ByteView bytes) {
    return std::all_of(bytes.begin(), bytes.end(), [](std::byte b) { return b == std::byte{0}; });
}

/// True if there are no control characters except tab, line feed, form feed and carriage return.
bool isText(ByteView bytes) {
    return std::all_of(bytes.begin(), bytes.end(), [](std::byte b) {
        const auto c = std::to_integer<unsigned>(b);
        return c >= 0x20 || c == '\t' || c == '\n' || c == '\f' || c == '\r';
    });
}

/// True if the magic is at another aligned offset: a file of the same family with another layout. Files from
/// before the end of retail have it at 0x12C.
bool isOlderDat(ByteView start) {
    if (wordAt(start, header::kOldMagicAt) == kMagic)
        return true;
    for (std::size_t at = header::kTransaction; at + 4 <= start.size(); at += 4) {
        const std::uint32_t next = at + 8 <= start.size() ? wordAt(start, at + 4) : 0;
        if (wordAt(start, at) == kMagic && (next == 1024 || next == 256))
            return true;
    }
    return false;
}

Failure notADat(ByteView file, const std::string& name) {
    const ByteView start = file.first(std::min(file.size(), kHeaderBytes));
    if (file.empty())
        return fail(ErrorCode::Malformed, name, "the file is empty, not a dat file; copy it again");
    if (isZeros(start))
        return fail(ErrorCode::Malformed, name,
                    "the file begins with nothing but zeros, so its copy is damaged; copy it again");
    if (isText(start))
        return fail(ErrorCode::Malformed, name, "this is a text file, not a dat file; choose another file");
    if (file.size() < kHeaderBytes)
        return fail(ErrorCode::Malformed, name,
                    fmt::format("the file has {} bytes; the header of a dat file takes {}", file.size(),
                                kHeaderBytes));
    if (isOlderDat(start))
        return fail(
            ErrorCode::Unsupported, name,
            "this game file is older than the end of retail (its header is laid out differently); only "
            "end-of-retail files (2013 to 2017) can be read");
    return fail(ErrorCode::Malformed, name,
                fmt::format("offset 0x{:X} holds 0x{:08X} where a dat file has the magic 0x{:08X}",
                            header::kMagicAt, wordAt(file, header::kMagicAt), kMagic));
}

/// The reason why the header is invalid, or an empty string.
std::string fault(const Header& h, std::size_t length) {
    if (!std::has_single_bit(h.blockSize) || h.blockSize < kMinBlockSize || h.blockSize > kMaxBlockSize)
        return fmt::format("the block size is {}; a power of two from {} to {} was expected", h.blockSize,
                           kMinBlockSize, kMaxBlockSize);
    const std::uint64_t first = firstUsableOffset(h.blockSize);
    if (first + h.blockSize > length)
        return fmt::format("the file ends at 0x{:X}, before the end of its first block at 0x{:X}", length,
                           first);
    if (h.type < kTypePortal || h.type > kTypeLocal)
        return fmt::format("the file type is {}; 1 (portal), 2 (cell) or 3 (local) was expected", h.type);
    return {};
}

} // namespace

Result<Header> readHeader(ByteView file, const std::string& name, std::vector<std::string>& warnings) {
    if (file.size() < kHeaderBytes || wordAt(file, header::kMagicAt) != kMagic)
        return notADat(file, name);
    Header h;
    h.blockSize = wordAt(file, header::kBlockSize);
    h.fileSize = wordAt(file, header::kFileSize);
    h.type = wordAt(file, header::kType);
    h.subset = wordAt(file, header::kSubset);
    h.root = wordAt(file, header::kRoot);
    h.engineVersion = wordAt(file, header::kEngineVersion);
    h.gameVersion = wordAt(file, header::kGameVersion);
    h.minorVersion = wordAt(file, header::kMinorVersion);
    h.firstFree = wordAt(file, header::kFirstFree);
    h.lastFree = wordAt(file, header::kLastFree);
    h.freeCount = wordAt(file, header::kFreeCount);
    h.masterMap = wordAt(file, header::kMasterMap);
    std::memcpy(h.majorVersion.data(), file.data() + header::kMajorVersion, h.majorVersion.size());
    if (std::string reason = fault(h, file.size()); !reason.empty())
        return fail(ErrorCode::Malformed, name, std::move(reason));
    if (h.fileSize != file.size())
        warnings.push_back(
            fmt::format("{}: the header says {} bytes, the file has {}", name, h.fileSize, file.size()));
    return h;
}

FileRole roleOf(const Header& header) {
    if (header.type == kTypeCell)
        return FileRole::Cell;
    if (header.type == kTypeLocal)
        return FileRole::Local;
    return header.subset == 0 ? FileRole::Portal : FileRole::Highres;
}

} // namespace limen::dat
