#include "dat/File.h"

#include "dat/container/Blocks.h"
#include "dat/container/Format.h"
#include "dat/container/HeaderReader.h"
#include "dat/container/Inflate.h"
#include "dat/container/Mapping.h"
#include "dat/container/Tree.h"

#include <atomic>
#include <fmt/format.h>

namespace limen::dat {

struct File::Impl {
    Impl(Mapping bytes, std::string fileName, Header h, std::vector<std::string> notes)
        : mapping(std::move(bytes)), name(std::move(fileName)), header(h), warnings(std::move(notes)),
          blocks(mapping.bytes(), h.blockSize), tree(blocks, h.root, name) {}

    [[nodiscard]] static Result<std::unique_ptr<Impl>> make(Mapping mapping, std::string name) {
        std::vector<std::string> warnings;
        const auto header = readHeader(mapping.bytes(), name, warnings);
        if (!header)
            return Failure(header.error());
        auto impl = std::make_unique<Impl>(std::move(mapping), std::move(name), *header, std::move(warnings));
        if (auto root = impl->tree.checkRoot(); !root)
            return impl->explained(std::move(root.error()));
        return impl;
    }

    /// The error. Adds that the file is too short if that may be the cause.
    [[nodiscard]] Failure explained(Error error) const {
        const std::size_t length = mapping.bytes().size();
        if (error.code == ErrorCode::Malformed && length < header.fileSize)
            error.what += fmt::format(" (the file is cut short: {} of {} bytes)", length, header.fileSize);
        return Failure(std::move(error));
    }

    [[nodiscard]] Failure bad(const Entry& entry, std::string reason) const {
        return explained(
            {ErrorCode::Malformed, fmt::format("{}, record 0x{:08X}", name, entry.id), std::move(reason)});
    }

    void countRead(std::size_t bytes) const {
        constexpr std::size_t kAroundFault = std::size_t{64} << 10; // that the system maps with each page
        if (mostBytes == 0 || (readBytes += bytes + kAroundFault) <= mostBytes)
            return;
        readBytes = 0;
        mapping.letPagesGo();
    }

    Mapping mapping;
    std::size_t mostBytes = 0;                      ///< of letPagesGoEvery; 0: any number
    mutable std::atomic<std::size_t> readBytes = 0; ///< since pages were let go
    std::string name;
    Header header;
    std::vector<std::string> warnings;
    Blocks blocks;
    Tree tree;
};

File::File(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
File::File(File&&) noexcept = default;
File& File::operator=(File&&) noexcept = default;
File::~File() = default;

Result<File> File::open(const std::filesystem::path& path) {
    auto mapping = Mapping::open(path);
    if (!mapping)
        return Failure(mapping.error());
    return Impl::make(std::move(*mapping), path.string()).map([](auto impl) {
        return File(std::move(impl));
    });
}

Result<File> File::fromBytes(ByteView bytes, std::string name) {
    return Impl::make(Mapping::copyOf(bytes), std::move(name)).map([](auto impl) {
        return File(std::move(impl));
    });
}

const Header& File::header() const {
    return impl_->header;
}
const std::string& File::name() const {
    return impl_->name;
}
FileRole File::role() const {
    return roleOf(impl_->header);
}
const std::vector<std::string>& File::warnings() const {
    return impl_->warnings;
}

void File::letPagesGo() const {
    impl_->mapping.letPagesGo();
}

void File::letPagesGoEvery(std::size_t bytes) {
    impl_->mostBytes = bytes;
}

Result<std::optional<Entry>> File::find(RecordId id) const {
    auto found = impl_->tree.find(id);
    if (!found)
        return impl_->explained(std::move(found.error()));
    return found;
}

Result<void> File::forEach(const std::function<bool(const Entry&)>& visit, std::vector<std::string>* warnings,
                           IndexShape* shape) const {
    auto done = impl_->tree.forEach(visit, warnings, shape);
    if (!done)
        return impl_->explained(std::move(done.error()));
    return done;
}

FreeList File::freeList() const {
    const Header& h = impl_->header;
    const Blocks& blocks = impl_->blocks;
    FreeList list;
    if (h.freeCount == 0)
        return list;
    if (h.freeCount > blocks.blockCount()) {
        list.fault = fmt::format("the header counts {} free blocks, the file has {} blocks", h.freeCount,
                                 blocks.blockCount());
        return list;
    }
    std::uint32_t block = h.firstFree, last = 0;
    while (list.blocks < h.freeCount) {
        if (!blocks.isBlock(block)) {
            list.fault = fmt::format("free block {} of {} is at 0x{:X}, which is not the offset of a block",
                                     list.blocks + 1, h.freeCount, block);
            return list;
        }
        const std::uint32_t link = blocks.link(block);
        if ((link & kFreeBit) == 0) {
            list.fault = fmt::format("the block at 0x{:X} is in the list and not marked as free", block);
            return list;
        }
        ++list.blocks;
        last = block;
        block = link & ~kFreeBit;
        if (block == 0)
            break;
    }
    if (list.blocks != h.freeCount || block != 0)
        list.fault = fmt::format("the header counts {} free blocks, the list has {}", h.freeCount,
                                 block != 0 ? "more" : std::to_string(list.blocks));
    else if (last != h.lastFree)
        list.fault = fmt::format("the list ends at 0x{:X}, the header says 0x{:X}", last, h.lastFree);
    return list;
}

std::uint64_t File::length() const {
    return impl_->mapping.bytes().size();
}

bool File::isInFile(const Entry& entry) const {
    return impl_->blocks.isBlock(entry.offset) && entry.size <= length();
}

Result<ByteView> File::read(const Entry& entry, Bytes& scratch) const {
    impl_->countRead(entry.size);
    const Blocks& blocks = impl_->blocks;
    const bool compressed = (entry.flags & kCompressedFlag) != 0;
    if (!compressed && entry.size <= blocks.capacity() && blocks.isBlock(entry.offset))
        return ByteView{blocks.payload(entry.offset), entry.size};
    if (!compressed) {
        if (const ChainStatus status = blocks.copy(entry.offset, entry.size, scratch); !status.ok())
            return impl_->bad(entry, inWords(status));
        return ByteView{scratch};
    }
    Bytes stored;
    if (const ChainStatus status = blocks.copy(entry.offset, entry.size, stored); !status.ok())
        return impl_->bad(entry, inWords(status));
    if (std::string reason = inflateRecord(stored, scratch); !reason.empty())
        return impl_->bad(entry, std::move(reason));
    return ByteView{scratch};
}

Result<ByteView> File::read(RecordId id, Bytes& scratch) const {
    const auto entry = find(id);
    if (!entry)
        return Failure(entry.error());
    if (!*entry)
        return fail(ErrorCode::NotFound, impl_->name, fmt::format("there is no record 0x{:08X}", id));
    return read(**entry, scratch);
}

} // namespace limen::dat
