#include "Check.h"

#include "dat/File.h"
#include "dat/Writer.h"

// Input: the bytes of a dat file. Opening, visiting, looking up and reading may fail, but must agree with
// each other. A file that can be read completely is the same after it was written again.
namespace {

using namespace limen::dat;

constexpr std::size_t kMaxRewritten = 1 << 20;

bool same(const Entry& a, const Entry& b) {
    return a.id == b.id && a.flags == b.flags && a.offset == b.offset && a.size == b.size &&
           a.date == b.date && a.iteration == b.iteration && a.version == b.version;
}

void checkRewritten(const Writer& writer, const std::vector<std::pair<RecordId, Bytes>>& records) {
    const auto again = File::fromBytes(*writer.build(), "again.dat");
    FUZZ_CHECK(again.has_value());
    Bytes scratch;
    for (const auto& [id, payload] : records) {
        const auto read = again->read(id, scratch);
        FUZZ_CHECK(read.has_value());
        FUZZ_CHECK(std::equal(read->begin(), read->end(), payload.begin(), payload.end()));
    }
}

void check(const File& file) {
    Writer writer(FileTraits::cell());
    std::vector<std::pair<RecordId, Bytes>> records;
    std::size_t total = 0;
    std::vector<std::string> warnings;
    Bytes scratch;
    std::int64_t last = -1;
    const auto walked = file.forEach(
        [&](const Entry& entry) {
            FUZZ_CHECK(entry.id > last);
            last = entry.id;
            const auto found = file.find(entry.id);
            FUZZ_CHECK(found && *found && same(**found, entry));
            const auto payload = file.read(entry, scratch);
            if (payload && total + payload->size() < kMaxRewritten) {
                total += payload->size();
                records.emplace_back(entry.id, Bytes(payload->begin(), payload->end()));
                writer.add(entry.id, records.back().second, entry.id % 2 == 0);
            }
            return true;
        },
        &warnings);
    if (!walked)
        FUZZ_CHECK(!walked.error().what.empty() &&
                   walked.error().where.find("fuzz.dat") != std::string::npos);
    for (const RecordId id : {0u, 0x01000001u, 0x7FFFFFFFu, 0x80000000u, kIterationId, 0xFFFFFFFFu})
        (void)file.read(id, scratch);
    checkRewritten(writer, records);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto file = File::fromBytes({reinterpret_cast<const std::byte*>(data), size}, "fuzz.dat");
    if (file)
        check(*file);
    else
        FUZZ_CHECK(!file.error().what.empty());
    return 0;
}
