#include "core/platform/windows/Text.h"

#include <algorithm>
#include <codecvt>
#include <iterator>
#include <locale>
#include <string>

// Narrow text is UTF-8. std::filesystem::path decodes it with std::codecvt<wchar_t, char, std::mbstate_t>, whose own functions
// use the C locale. The linker takes these five before it looks into the archive libstdc++.a
// (docs/decisions/0187-narrow-text-becomes-a-path-by-our-codecvt.md).

namespace {

using Utf8 = std::codecvt_utf8_utf16<wchar_t>;

} // namespace

/// Malformed parts become U+FFFD. Converts the whole text or nothing: paths are whole, and no stream here is wide.
std::codecvt_base::result
std::codecvt<wchar_t, char, std::mbstate_t>::do_in(std::mbstate_t& /*state*/, const char* from,
                                                   const char* fromEnd, const char*& fromNext, wchar_t* to,
                                                   wchar_t* toEnd, wchar_t*& toNext) const {
    const std::wstring wide = limen::platform::wideText({from, fromEnd});
    const bool isFit = std::ssize(wide) <= toEnd - to;
    fromNext = isFit ? fromEnd : from;
    toNext = isFit ? std::copy(wide.begin(), wide.end(), to) : to;
    return isFit ? ok : partial;
}

std::codecvt_base::result
std::codecvt<wchar_t, char, std::mbstate_t>::do_out(std::mbstate_t& state, const wchar_t* from,
                                                    const wchar_t* fromEnd, const wchar_t*& fromNext,
                                                    char* to, char* toEnd, char*& toNext) const {
    return Utf8().out(state, from, fromEnd, fromNext, to, toEnd, toNext);
}

int std::codecvt<wchar_t, char, std::mbstate_t>::do_encoding() const noexcept {
    return Utf8().encoding();
}

int std::codecvt<wchar_t, char, std::mbstate_t>::do_length(std::mbstate_t& state, const char* from,
                                                           const char* end, std::size_t most) const {
    return Utf8().length(state, from, end, most);
}

int std::codecvt<wchar_t, char, std::mbstate_t>::do_max_length() const noexcept {
    return Utf8().max_length();
}
