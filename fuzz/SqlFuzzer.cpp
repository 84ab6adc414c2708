#include "Check.h"

#include "placements/ExportSql.h"
#include "placements/server/ServerUrl.h"
#include "placements/sql/Statements.h"

#include <algorithm>
#include <cstring>

// Input: a byte with the size of the pieces that are read, then a file of SQL. Every refusal has a reason, the size of the
// pieces does not matter, and content that was read is the same after an export. Rows of several files can be in one input.
namespace {

using namespace limen;
using namespace limen::placements;

Result<Content> contentOf(std::string_view text, std::size_t step) {
    std::size_t at = 0;
    Tokens tokens(
        [&](std::span<char> out) -> Result<std::size_t> {
            const std::size_t count = std::min({step, out.size(), text.size() - at});
            std::memcpy(out.data(), text.data() + at, count);
            at += count;
            return count;
        },
        "sql");
    ContentBuilder builder;
    return executeSql(tokens, builder).map([&] { return builder.finish(); });
}

std::string exported(const Content& content) {
    std::string text;
    for (const auto& [id, of] : content.templates)
        text += sqlOf(of).text;
    for (const auto& [id, landblock] : content.landblocks)
        text += sqlOf(id, landblock).text;
    return text;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0)
        return 0;
    const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
    const Result<ServerUrl> url = parseServerUrl(std::string(text.substr(0, 200)));
    FUZZ_CHECK(url.has_value() || !url.error().what.empty());
    const Result<Content> content = contentOf(text, std::size_t{data[0]} + 1);
    FUZZ_CHECK(content.has_value() ||
               (!content.error().what.empty() && content.error().what.find('\n') == std::string::npos));
    const Result<Content> whole = contentOf(text, text.size() + 1);
    FUZZ_CHECK(whole.has_value() == content.has_value());
    if (!content)
        return 0;
    FUZZ_CHECK(*content == *whole);
    const Result<Content> again = contentOf(exported(*content), 4096);
    FUZZ_CHECK(again.has_value() && *again == *content);
    return 0;
}
