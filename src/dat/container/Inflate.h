#pragma once

#include "dat/Codec.h"

namespace limen::dat {

/// Unpacks a compressed record (u32 size, zlib stream) into `out`; yields the reason if it cannot, else an
/// empty string. A size that the stream cannot possibly unpack to is refused before anything is allocated.
[[nodiscard]] std::string inflateRecord(ByteView stored, Bytes& out);

/// The reverse: u32 size, zlib stream.
[[nodiscard]] Bytes deflateRecord(ByteView payload);

} // namespace limen::dat
