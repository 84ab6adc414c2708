#include "dat/codec/ByteWriter.h"

namespace limen::dat {

Result<Bytes> ByteWriter::takeNamed(std::string name) {
    if (broken_ != nullptr)
        return fail(ErrorCode::BadArgument, std::move(name), std::string("cannot be encoded: ") + broken_);
    return std::move(bytes_);
}

void ByteWriter::packedCount(std::size_t n) {
    require(n <= 0x3FFFFFFF, "a packed count has 30 bits");
    const auto v = static_cast<std::uint32_t>(n);
    if (v < 0x80) {
        value(static_cast<std::uint8_t>(v));
    } else if (v < 0x4000) {
        value(static_cast<std::uint8_t>((v >> 8) | 0x80));
        value(static_cast<std::uint8_t>(v & 0xFF));
    } else {
        value(static_cast<std::uint8_t>((v >> 24) | 0xC0));
        value(static_cast<std::uint8_t>((v >> 16) & 0xFF));
        value(static_cast<std::uint16_t>(v & 0xFFFF));
    }
}

void ByteWriter::text(const std::string& in) {
    if (in.size() < 0xFFFF) {
        value(static_cast<std::uint16_t>(in.size()));
    } else {
        require(in.size() <= 0xFFFFFFFF, "a string's length has 32 bits");
        value(std::uint16_t{0xFFFF});
        value(static_cast<std::uint32_t>(in.size()));
    }
    put(in.data(), in.size());
    alignZero();
}

} // namespace limen::dat
