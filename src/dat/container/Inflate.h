#pragma once

#include "dat/Codec.h"

namespace limen::dat {

/// Unpacks a compressed record (u32 size, zlib stream) into `out`. Returns the reason of a failure, or an
/// empty string. A size that the stream cannot unpack to is refused before anything is allocated.
[[nodiscard]] std::string inflateRecord(ByteView stored, Bytes& out);

/// Packs a payload: u32 size, zlib stream.
[[nodiscard]] Bytes deflateRecord(ByteView payload);

} // namespace limen::dat
