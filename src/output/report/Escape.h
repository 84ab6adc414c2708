#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

// Text and bytes in the forms that an HTML page needs. All functions are pure.
namespace limen::output {

/// Text for element content and quoted attributes: & < > " ' become character references. Control characters
/// that HTML forbids become U+FFFD.
[[nodiscard]] std::string escapeHtml(std::string_view text);

/// JSON for a script element: "<" becomes \u003c, so that no text can end the element or begin a comment.
[[nodiscard]] std::string escapeScriptJson(std::string_view json);

/// Base64 of RFC 4648, with padding, without line breaks.
[[nodiscard]] std::string base64(std::span<const std::byte> bytes);

/// A "data:" URI with the bytes of a file. `mediaType`: such as "image/webp".
[[nodiscard]] std::string dataUri(std::string_view mediaType, std::span<const std::byte> bytes);

} // namespace limen::output
