// Which names can be text, on Windows. Prints each expectation that fails; the exit code is their number.
#include "core/platform/Files.h"
#include "core/platform/windows/Text.h"

#include <cstdio>

namespace {

int failures = 0;

void expect(bool isFit, const wchar_t* text, const char* name) {
    const bool found = limen::platform::isWellFormed(text);
    if (found == isFit && limen::platform::isText(text) == isFit)
        return;
    std::printf("%s: expected %d\n", name, static_cast<int>(isFit));
    ++failures;
}

} // namespace

int main() {
    expect(true, L"", "empty");
    expect(true,
           L"Stra\x00DF"
           L"e.txt",
           "umlaut");
    expect(true, L"\xD83D\xDE00.txt", "a pair");
    expect(true, L"a\xD83D\xDE00\xD83D\xDE00", "two pairs");
    expect(true, L"\xFFFD\xE000\xD7FF", "neighbours of the range");
    expect(false, L"half\xD83D.txt", "first half");
    expect(false, L"half\xD83D", "first half at the end");
    expect(false, L"\xDE00.txt", "second half");
    expect(false, L"\xDE00\xD83D", "halves in the wrong order");
    expect(false, L"\xD83D\xD83D\xDE00", "a first half before a pair");
    expect(false, L"\xD83D\xDE00\xDE00", "a second half after a pair");
    return failures;
}
