#include "dat/container/Inflate.h"

#include "core/Assert.h"
#include "dat/container/Format.h"

#include <cstring>

#include <fmt/format.h>
#include <zlib.h>

namespace limen::dat {
namespace {

/// The largest possible ratio of unpacked to packed length. ref: zlib's technical notes, 1032:1.
constexpr std::size_t kMaxRatio = 1032;

} // namespace

std::string inflateRecord(ByteView stored, Bytes& out) {
    std::uint32_t size = 0;
    if (stored.size() <= sizeof size)
        return fmt::format("it is marked as compressed, but has only {} bytes", stored.size());
    std::memcpy(&size, stored.data(), sizeof size);
    const ByteView stream = stored.subspan(sizeof size);
    if (size > kMaxInflatedBytes || size > stream.size() * kMaxRatio)
        return fmt::format("it claims to unpack from {} to {} bytes", stream.size(), size);
    out.resize(std::size_t{size} + 1); // one more, to detect a longer stream
    z_stream z{};
    if (inflateInit(&z) != Z_OK)
        return "zlib could not be started";
    z.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(stream.data()));
    z.avail_in = static_cast<uInt>(stream.size());
    z.next_out = reinterpret_cast<Bytef*>(out.data());
    z.avail_out = static_cast<uInt>(out.size());
    const int status = inflate(&z, Z_FINISH);
    const std::size_t made = out.size() - z.avail_out;
    const std::size_t left = z.avail_in;
    inflateEnd(&z);
    if (status != Z_STREAM_END || made != size || left != 0) {
        out.clear();
        return fmt::format("its compressed bytes do not unpack to the {} bytes that it claims", size);
    }
    out.resize(size);
    return {};
}

Bytes deflateRecord(ByteView payload) {
    LIMEN_ASSERT(payload.size() <= kMaxInflatedBytes, "a compressed record has at most 64 MiB");
    const auto size = static_cast<std::uint32_t>(payload.size());
    uLongf packed = compressBound(static_cast<uLong>(payload.size()));
    Bytes out(sizeof size + packed);
    std::memcpy(out.data(), &size, sizeof size);
    static constexpr Bytef kNothing = 0;
    const auto* source = payload.empty() ? &kNothing : reinterpret_cast<const Bytef*>(payload.data());
    const int status = compress2(reinterpret_cast<Bytef*>(out.data() + sizeof size), &packed, source,
                                 static_cast<uLong>(payload.size()), Z_BEST_COMPRESSION);
    LIMEN_ASSERT(status == Z_OK, "compress2 fails only for lack of memory or of room");
    out.resize(sizeof size + packed);
    return out;
}

} // namespace limen::dat
