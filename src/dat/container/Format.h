#pragma once

#include "dat/Ids.h"

#include <cstddef>
#include <cstdint>

// Numbers of the container (docs/formats/container.md), shared by reader and writer.
namespace limen::dat {

inline constexpr std::size_t kHeaderBytes = 400;
inline constexpr std::uint32_t kMagic = 0x5442; ///< "BT"

/// Offsets of header fields.
namespace header {
inline constexpr std::size_t kTransaction = 0x100, kMagicAt = 0x140, kBlockSize = 0x144, kFileSize = 0x148,
                             kType = 0x14C, kSubset = 0x150, kFirstFree = 0x154, kLastFree = 0x158,
                             kFreeCount = 0x15C, kRoot = 0x160, kMasterMap = 0x170, kEngineVersion = 0x174,
                             kGameVersion = 0x178, kMajorVersion = 0x17C, kMinorVersion = 0x18C;
/// The offset of the same magic in files from before the end of retail.
inline constexpr std::size_t kOldMagicAt = 0x12C;
} // namespace header

inline constexpr std::uint32_t kTypePortal = 1, kTypeCell = 2, kTypeLocal = 3;
inline constexpr std::uint32_t kHighresSubset = 0x69466948; ///< "HiFi"

inline constexpr std::uint32_t kMinBlockSize = 64, kMaxBlockSize = 65536;

/// B-tree nodes.
inline constexpr std::uint32_t kMaxEntries = 61, kMaxBranches = 62;
inline constexpr std::size_t kBranchesAt = 0, kCountAt = 4 * kMaxBranches, kEntriesAt = kCountAt + 4,
                             kEntryBytes = 24;
inline constexpr std::size_t kNodeBytes = kEntriesAt + kMaxEntries * kEntryBytes;
static_assert(kNodeBytes == 1716);
/// The content of unused branches in files of one writer.
inline constexpr std::uint32_t kNoBranchFill = 0xCDCDCDCD;
inline constexpr int kMaxDepth = 16;

/// In the link of a free block.
inline constexpr std::uint32_t kFreeBit = 0x80000000;

inline constexpr std::uint16_t kCompressedFlag = 1;
inline constexpr std::size_t kMaxInflatedBytes = std::size_t{64} << 20;

/// Offset of the first block behind the header.
[[nodiscard]] constexpr std::uint64_t firstUsableOffset(std::uint32_t blockSize) {
    return (kHeaderBytes + blockSize - 1) / blockSize * blockSize;
}

} // namespace limen::dat
