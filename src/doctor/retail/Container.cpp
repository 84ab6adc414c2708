#include "doctor/retail/Judges.h"

#include <array>
#include <cstring>

namespace limen::doctor {
namespace {

constexpr const char* kHeader = "header of an end-of-retail file";
constexpr const char* kIndex = "index of an end-of-retail file";

/// Header fields of a file; negative: not known.
struct HeaderFact {
    const char* name;
    dat::FileRole role;
    double blockSize, fileSize, type, subset, firstFree, lastFree, freeCount, root, masterMap, engine;
    Numbers records;
};

std::vector<HeaderFact> headerFacts() {
    using Role = dat::FileRole;
    return {
        {"portal",
         Role::Portal,
         1024,
         926941184,
         1,
         0,
         926443520,
         926424064,
         2052,
         36885504,
         620756992,
         110,
         {79694}},
        {"cell",
         Role::Cell,
         256,
         348127232,
         2,
         1,
         347298304,
         348126976,
         3238,
         28800000,
         0,
         22,
         {805348, 805003}},
        {"local", Role::Local, 1024, 1048576, 3, 1, -1, -1, 270, 176128, -1, 110, {118}},
        {"highres", Role::Highres, 1024, 133169152, 1, 0x69466948, -1, -1, 363, 109123584, -1, 110, {2295}},
    };
}

struct FieldFact {
    const char* name;
    double HeaderFact::*expected;
    std::uint32_t dat::Header::*found;
    Notation notation = Notation::Decimal;
};
constexpr auto kFields = std::to_array<FieldFact>({
    {"blockSize", &HeaderFact::blockSize, &dat::Header::blockSize},
    {"fileSize", &HeaderFact::fileSize, &dat::Header::fileSize},
    {"type", &HeaderFact::type, &dat::Header::type},
    {"subset", &HeaderFact::subset, &dat::Header::subset, Notation::Hex},
    {"firstFree", &HeaderFact::firstFree, &dat::Header::firstFree, Notation::Hex},
    {"lastFree", &HeaderFact::lastFree, &dat::Header::lastFree, Notation::Hex},
    {"freeCount", &HeaderFact::freeCount, &dat::Header::freeCount},
    {"root", &HeaderFact::root, &dat::Header::root, Notation::Hex},
    {"masterMap", &HeaderFact::masterMap, &dat::Header::masterMap, Notation::Hex},
    {"engineVersion", &HeaderFact::engine, &dat::Header::engineVersion},
});

/// Keys and branches of a root node.
struct RootFact {
    const char* name;
    dat::FileRole role;
    Numbers keys, branches;
};
std::vector<RootFact> rootFacts() {
    return {
        {"cell",
         dat::FileRole::Cell,
         {0x003A044F, 0x006D019B, 0x00B20199, 0x00F904EA, 0x014101B4, 0x01960386, 0x01EF03C2,
          0x028301A9, 0x02C902E3, 0x0336013B, 0x1FF8FFFF, 0x52530120, 0x545C03B6, 0x5775014C,
          0x5C4F075E, 0x604B028E, 0x7900025E, 0x8402016D, 0x8D0001EC, 0x9BD80106, 0xC95B0159},
         {0x000E8B00, 0x10046C00, 0x10F87800, 0x11F49800, 0x01B77B00, 0x0284E100, 0x0341AE00, 0x04180700,
          0x04D77500, 0x05924A00, 0x06403A00, 0x06E95E00, 0x07B3D800, 0x086C6D00, 0x09256900, 0x09F08500,
          0x0AB48300, 0x0C48BD00, 0x0D173600, 0x0DDDDE00, 0x0E826E00, 0x12D8BA00}},
        {"highres", dat::FileRole::Highres, {0x060043BE}, {0x0034FC00, 0x06812000}},
        {"local", dat::FileRole::Local, {0x21000026, 0x21000045}, {0x00000400, 0x0002B800, 0x000D9000}},
    };
}

const dat::File* fileOf(const dat::Archive& archive, dat::FileRole role) {
    switch (role) {
    case dat::FileRole::Portal:
        return &archive.portal();
    case dat::FileRole::Cell:
        return &archive.cell();
    case dat::FileRole::Highres:
        return archive.highres();
    case dat::FileRole::Local:
        break;
    }
    return archive.local();
}

/// The GUID as four words, in the order of its bytes.
Numbers guidWords(const dat::Header& header) {
    Numbers words;
    for (std::size_t i = 0; i < header.majorVersion.size(); i += 4)
        words.push_back(header.majorVersion[i] * 16777216.0 + header.majorVersion[i + 1] * 65536.0 +
                        header.majorVersion[i + 2] * 256.0 + header.majorVersion[i + 3]);
    return words;
}

void judgeHeader(const HeaderFact& expected, const dat::File* file, const FileCensus& census,
                 Ledger& ledger) {
    const std::string prefix = std::string("container.") + expected.name + ".";
    const auto line = [&](const char* name, Numbers numbers, Notation notation, Rule rule, auto&& read) {
        std::optional<Numbers> found;
        if (file != nullptr)
            found = read(*file);
        ledger.judge({prefix + name, kHeader, std::move(numbers), rule, 0.0, notation}, std::move(found));
    };
    for (const FieldFact& field : kFields) {
        if (expected.*field.expected < 0)
            continue;
        line(field.name, {expected.*field.expected}, field.notation, Rule::Equal,
             [&](const dat::File& f) { return Numbers{static_cast<double>(f.header().*field.found)}; });
    }
    line("gameVersion", {0}, Notation::Decimal, Rule::Equal,
         [](const dat::File& f) { return Numbers{static_cast<double>(f.header().gameVersion)}; });
    line("minorVersion", {6657}, Notation::Decimal, Rule::Equal,
         [](const dat::File& f) { return Numbers{static_cast<double>(f.header().minorVersion)}; });
    line("majorVersion", {0xD2D7A734, 0x2F72464C, 0x8AB4EF51, 0x4F856FFD}, Notation::Hex, Rule::Equal,
         [](const dat::File& f) { return guidWords(f.header()); });
    line("length", {expected.fileSize}, Notation::Decimal, Rule::Equal,
         [](const dat::File& f) { return Numbers{static_cast<double>(f.length())}; });
    line("records", expected.records, Notation::Decimal, Rule::OneOf,
         [&](const dat::File&) { return Numbers{static_cast<double>(census.entries)}; });
    line("freeBlocks", {expected.freeCount}, Notation::Decimal, Rule::Equal, [](const dat::File& f) {
        const dat::FreeList list = f.freeList();
        return list.fault.empty() ? Numbers{static_cast<double>(list.blocks)} : Numbers{};
    });
}

void judgeRoot(const RootFact& expected, const FileCensus& census, Ledger& ledger) {
    const std::string prefix = std::string("container.") + expected.name + ".";
    std::optional<Numbers> keys, branches;
    if (census.isThere) {
        keys.emplace(census.shape.rootKeys.begin(), census.shape.rootKeys.end());
        branches.emplace(census.shape.rootBranches.begin(), census.shape.rootBranches.end());
    }
    ledger.judge(Fact{prefix + "rootKeys", kIndex, expected.keys}.hex(), std::move(keys));
    ledger.judge(Fact{prefix + "rootBranches", kIndex, expected.branches}.hex(), std::move(branches));
}

/// The iteration record of the portal file, and its entry.
void judgeIteration(const dat::File& portal, Ledger& ledger) {
    const Result<std::optional<dat::Entry>> entry = portal.find(dat::kIterationId);
    std::optional<Numbers> words, place;
    if (entry && *entry) {
        dat::Bytes scratch;
        const Result<dat::ByteView> payload = portal.read(**entry, scratch);
        words.emplace();
        for (std::size_t at = 0; payload && at + 4 <= payload->size(); at += 4) {
            std::uint32_t word = 0;
            std::memcpy(&word, payload->data() + at, sizeof word);
            words->push_back(word);
        }
        place = Numbers{static_cast<double>((*entry)->offset), static_cast<double>((*entry)->version),
                        static_cast<double>((*entry)->iteration)};
    }
    ledger.judge(Fact{"container.portal.iteration", kIndex, {0x818, 0xFFFFF7E8, 1}}.hex(), std::move(words));
    ledger.judge(Fact{"container.portal.iterationEntry", kIndex, {0x37386400, 1, 1}}.hex(), std::move(place));
}

} // namespace

void judgeContainer(const dat::Archive& archive, const Census& census, Ledger& ledger) {
    for (const HeaderFact& fact : headerFacts())
        judgeHeader(fact, fileOf(archive, fact.role), census.files[static_cast<std::size_t>(fact.role)],
                    ledger);
    for (const RootFact& fact : rootFacts())
        judgeRoot(fact, census.files[static_cast<std::size_t>(fact.role)], ledger);
    const FileCensus& cell = census.files[static_cast<std::size_t>(dat::FileRole::Cell)];
    ledger.judge({"container.cell.nodes", kIndex, {26657}},
                 cell.isThere ? std::optional(Numbers{static_cast<double>(cell.shape.nodes)}) : std::nullopt);
    judgeIteration(archive.portal(), ledger);
}

} // namespace limen::doctor
