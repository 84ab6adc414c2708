#include "dat/codec/ByteReader.h"

#include <fmt/format.h>

namespace limen::dat {

void ByteReader::failAt(std::size_t offset, std::string reason, ErrorCode code) {
    if (failed_)
        return;
    failed_ = true;
    code_ = code;
    failureOffset_ = offset;
    reason_ = std::move(reason);
    end_ = at_;
}

void ByteReader::tooShort(std::size_t size) {
    if (!failed_)
        fail(fmt::format("the record ends here, but {} more bytes are expected", size - remaining()));
}

std::string ByteReader::negative(long long n, const char* what) {
    return fmt::format("the number of {} is negative ({})", what, n);
}

bool ByteReader::fits(std::size_t count, std::size_t minItemBytes, const char* what) {
    if (failed_)
        return false;
    if (count <= remaining() / minItemBytes)
        return true;
    fail(
        fmt::format("the record has {} {} by its count, but only {} bytes follow", count, what, remaining()));
    return false;
}

std::uint32_t ByteReader::packedCount() {
    const std::size_t start = offset();
    const std::uint32_t b0 = get<std::uint8_t>();
    if ((b0 & 0x80u) == 0)
        return b0;
    const std::uint32_t b1 = get<std::uint8_t>();
    const bool isLong = (b0 & 0x40u) != 0;
    const std::uint32_t value =
        isLong ? ((((b0 & 0x3Fu) << 8) | b1) << 16) | get<std::uint16_t>() : ((b0 & 0x7Fu) << 8) | b1;
    if (value < (isLong ? 0x4000u : 0x80u)) {
        failAt(start, fmt::format("the count {} takes more bytes than it needs", value));
        return 0;
    }
    return value;
}

void ByteReader::text(std::string& out) {
    const std::size_t start = offset();
    std::size_t length = get<std::uint16_t>();
    if (length == 0xFFFF) {
        length = get<std::uint32_t>();
        if (length < 0xFFFF && !failed_) {
            failAt(start, "the length of a string takes more bytes than it needs");
            return;
        }
    }
    const ByteView content = bytes(length);
    out.assign(reinterpret_cast<const char*>(content.data()), content.size());
    alignZero();
}

void ByteReader::alignZero() {
    const std::size_t start = offset();
    for (const std::byte b : bytes((0 - start) & 3))
        if (b != std::byte{0})
            failAt(start, "the padding up to a multiple of four is not zero");
}

ByteView ByteReader::bytes(std::size_t count) {
    if (count > remaining()) {
        tooShort(count);
        return {};
    }
    const ByteView out{at_, count};
    at_ += count;
    return out;
}

} // namespace limen::dat
