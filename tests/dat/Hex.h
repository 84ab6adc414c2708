#pragma once

#include "dat/Codec.h"

#include <string>
#include <string_view>

namespace limen::dat {

/// Bytes from pairs of hexadecimal digits. Skips white space, and text from '#' to the end of the line.
inline Bytes hex(std::string_view text) {
    Bytes out;
    int high = -1;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '#') {
            i = std::min(text.find('\n', i), text.size() - 1);
            continue;
        }
        int digit = -1;
        if (c >= '0' && c <= '9')
            digit = c - '0';
        else if (c >= 'A' && c <= 'F')
            digit = c - 'A' + 10;
        else if (c >= 'a' && c <= 'f')
            digit = c - 'a' + 10;
        if (digit < 0)
            continue;
        if (high < 0) {
            high = digit;
        } else {
            out.push_back(static_cast<std::byte>(high * 16 + digit));
            high = -1;
        }
    }
    return out;
}

/// Hexadecimal digits of bytes, for messages of failed tests.
inline std::string toHex(ByteView bytes) {
    constexpr char kDigits[] = "0123456789ABCDEF";
    std::string out;
    for (const std::byte b : bytes) {
        const auto v = std::to_integer<unsigned>(b);
        out += kDigits[v >> 4];
        out += kDigits[v & 15];
        out += ' ';
    }
    return out;
}

} // namespace limen::dat
