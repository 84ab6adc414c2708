#pragma once

#include "dat/File.h"

namespace limen::dat {

/// Reads and checks the header of a file. Errors for other files name their content where it is recognised:
/// empty, zeros, text, a dat from before the end of retail. Messages contain `name`. Adds warnings to
/// `warnings`.
[[nodiscard]] Result<Header> readHeader(ByteView file, const std::string& name,
                                        std::vector<std::string>& warnings);

/// The role for type and subset. Requires: a header from readHeader.
[[nodiscard]] FileRole roleOf(const Header& header);

} // namespace limen::dat
