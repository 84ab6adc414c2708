#include "dat/File.h"
#include "dat/RandomRecords.h"
#include "dat/RecordTypes.h"
#include "dat/Writer.h"

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <span>

// Writes corpora for the fuzzers: fuzz_make_corpus DIRECTORY makes DIRECTORY/container, DIRECTORY/records,
// DIRECTORY/world_file, DIRECTORY/lines, DIRECTORY/sql, and DIRECTORY/kinds/NAME for each kind of record.
namespace {

using namespace limen::dat;
namespace fs = std::filesystem;

bool save(const fs::path& path, const Bytes& bytes) {
    std::ofstream out(path, std::ios::binary);
    out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return static_cast<bool>(out);
}

bool save(const fs::path& path, std::string_view text) {
    Bytes bytes(text.size());
    std::memcpy(bytes.data(), text.data(), text.size());
    return save(path, bytes);
}

/// Writes records of one type, each behind the byte that selects the type in RecordsFuzzer.
template <class Record>
bool saveRecords(const fs::path& directory, std::uint8_t pick) {
    bool good = true;
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        Bytes bytes{static_cast<std::byte>(pick)};
        const Bytes payload = *encode(RandomRecords(seed, seed < 4 ? 1 : 3).make<Record>());
        bytes.insert(bytes.end(), payload.begin(), payload.end());
        good = save(directory / (std::to_string(pick) + "-" + std::to_string(seed)), bytes) && good;
    }
    return good;
}

bool saveFiles(const fs::path& directory) {
    bool good = true;
    for (const std::uint32_t blockSize : {64u, 256u, 1024u}) {
        for (const RecordId count : {0u, 1u, 5u, 70u, 130u}) {
            FileTraits traits = blockSize == 256 ? FileTraits::cell() : FileTraits::portal();
            traits.blockSize = blockSize;
            Writer writer(traits);
            for (RecordId id = 1; id <= count; ++id)
                writer.add(id * 3, Bytes(id % 7 == 0 ? 150 : id % 5, static_cast<std::byte>(id)),
                           id % 4 == 0);
            good = save(directory / (std::to_string(blockSize) + "-" + std::to_string(count)),
                        *writer.build()) &&
                   good;
        }
    }
    return good;
}

/// Saves each text as a file of its own, named by its number.
bool saveAll(const fs::path& directory, std::span<const char* const> texts) {
    bool good = true;
    int number = 0;
    for (const char* text : texts)
        good = save(directory / std::to_string(number++), text) && good;
    return good;
}

bool saveWorldFiles(const fs::path& directory) {
    constexpr const char* texts[] = {
        R"({"places":{"a":{"eye":[1,2,3],"yaw":90,"pitch":-5,"cell":"0x00010100"}},"tour":[{"x":1,"y":2,"z":3}]})",
        R"({"doors":[{"name":"d","cell":"0x00010100","portal":0,"opaque":true,"open":0.5,"leaves":[{"model":"0x01000001","hinge":[1,2,3],"yaw":0,"swing":90}]}]})",
        R"({"routes":{"r":{"points":[{"at":[1,2,3],"cell":0},{"at":[4,5,6],"cell":0}]}},"villagers":[{"name":"v","route":"r","model":"0x02000001","speed":1}]})"};
    return saveAll(directory, texts);
}

bool saveLines(const fs::path& directory) {
    // The first byte selects the parser in LinesFuzzer.
    constexpr const char* texts[] = {
        R"(0{"format":"limen walk","version":1,"start":"--eye 1,2,3"}
{"forward":1.0,"seconds":0.03,"size":[64,36],"decided":"0123456789abcdef"}
)",
        "1--eye 1,2,3 --yaw 90 --pitch -5 --time 0.3 --weather rain",
        "1--at 42.1N,33.6E --root outside --doors half --body 1,2,3 --door d=0.5"};
    return saveAll(directory, texts);
}

bool saveSql(const fs::path& directory) {
    constexpr const char* rows = "\100DELETE FROM `weenie` WHERE `class_Id` = 5;\nINSERT INTO `weenie` "
                                 "(`class_Id`, `class_Name`, `type`) VALUES (5, "
                                 "'it''s', 19) /* Door */;\nINSERT INTO `weenie_properties_bool` VALUES (1, "
                                 "5, 2, True), (2, 5, 3, b'0');";
    constexpr const char* placed = "\x01INSERT INTO `landblock_instance` (`guid`, `weenie_Class_Id`, "
                                   "`obj_Cell_Id`, `origin_X`, `origin_Y`, `origin_Z`, "
                                   "`angles_W`, `angles_X`, `angles_Y`, `angles_Z`, `is_Link_Child`) VALUES "
                                   "(0x7A000001, 5, 0xA9B40100, 1.5, -2e1, 0, 1, "
                                   "0, 0, 0, False);\nINSERT INTO landblock_instance_link (parent_GUID, "
                                   "child_GUID) VALUES (0x7A000001, 2);";
    constexpr const char* quoted = "\x10INSERT INTO weenie VALUES (7,'a\\'b',1,NOW());-- x\nINSERT INTO "
                                   "weenie_properties_string VALUES (1,7,1,\"n\");";
    constexpr const char* url = "\x20mariadb://ann@host:3306/world?socket=/run/s";
    constexpr const char* texts[] = {rows, placed, quoted, url};
    return saveAll(directory, texts);
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: fuzz_make_corpus DIRECTORY\n");
        return 2;
    }
    std::error_code error;
    const auto made = [&](const char* name) {
        const fs::path directory = fs::path(argv[1]) / name;
        fs::create_directories(directory, error);
        return directory;
    };
    const fs::path records = made("records");
    bool good = saveWorldFiles(made("world_file")) && saveLines(made("lines")) && saveSql(made("sql")) &&
                saveFiles(made("container"));
    RecordTypes::forEach([&]<class Record>(std::type_identity<Record>) {
        constexpr RecordKind kKind = kKindOf<Record>;
        const fs::path alone = fs::path(argv[1]) / "kinds" / nameOf(kKind);
        fs::create_directories(alone, error);
        for (const fs::path& directory : {records, alone})
            good = saveRecords<Record>(directory, static_cast<std::uint8_t>(kKind)) && good;
    });
    if (!good)
        std::fprintf(stderr, "fuzz_make_corpus: cannot write to %s\n", argv[1]);
    return good ? 0 : 2;
}
