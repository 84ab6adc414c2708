#pragma once

#include "dat/File.h"

namespace limen::dat {

/// Reads and checks the header of a file; says of a foreign file what it is, where that can be told: empty,
/// zeros, text, a dat of the years before the end of retail. `name` stands in messages. Warnings go to
/// `warnings`.
[[nodiscard]] Result<Header> readHeader(ByteView file, const std::string& name,
                                        std::vector<std::string>& warnings);

/// The role that type and subset stand for; readHeader lets no others pass.
[[nodiscard]] FileRole roleOf(const Header& header);

} // namespace limen::dat
