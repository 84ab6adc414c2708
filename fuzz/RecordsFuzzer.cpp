#include "Check.h"

#include "dat/Describe.h"
#include "dat/RecordTypes.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>

// Input: a byte that selects the type of record, then the payload. A payload that decodes must encode to the
// same bytes, and it can be described. LIMEN_FUZZ_RECORD, a name of RecordKind: all bytes are a payload of
// that type.
namespace {

using namespace limen::dat;

constexpr std::size_t kMaxDescribed = 4096;

template <class Record>
void check(ByteView payload) {
    RecordId id = 0;
    if (payload.size() >= sizeof id)
        std::memcpy(&id, payload.data(), sizeof id);
    const auto record = decode<Record>(id, payload);
    if (!record) {
        FUZZ_CHECK(!record.error().what.empty() && !record.error().where.empty());
        return;
    }
    const Bytes again = *encode(*record);
    FUZZ_CHECK(std::equal(again.begin(), again.end(), payload.begin(), payload.end()));
    if (payload.size() <= kMaxDescribed)
        FUZZ_CHECK(!describe(*record).empty());
}

/// The kind given by the environment, if any.
std::optional<RecordKind> kindFromEnvironment() {
    const char* name = std::getenv("LIMEN_FUZZ_RECORD");
    if (name == nullptr)
        return std::nullopt;
    for (std::size_t kind = 0; kind < RecordTypes::kSize; ++kind)
        if (std::strcmp(name, nameOf(static_cast<RecordKind>(kind))) == 0)
            return static_cast<RecordKind>(kind);
    std::fprintf(stderr, "LIMEN_FUZZ_RECORD=%s: there is no such kind of record\n", name);
    std::exit(2);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0)
        return 0;
    static const std::optional<RecordKind> asked = kindFromEnvironment();
    const RecordKind kind = asked.value_or(static_cast<RecordKind>(data[0] % RecordTypes::kSize));
    visitKind(kind, [&]<class Record>(std::type_identity<Record>) {
        check<Record>({reinterpret_cast<const std::byte*>(data) + 1, size - 1});
    });
    return 0;
}
