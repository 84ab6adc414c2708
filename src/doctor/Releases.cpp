#include "doctor/Releases.h"

#include <algorithm>
#include <array>

namespace limen::doctor {
namespace {

constexpr std::uint32_t kLastMinorVersion = 6657;
constexpr std::array<std::uint8_t, 16> kLastMajorVersion{0xD2, 0xD7, 0xA7, 0x34, 0x2F, 0x72, 0x46, 0x4C,
                                                         0x8A, 0xB4, 0xEF, 0x51, 0x4F, 0x85, 0x6F, 0xFD};

/// Figures of the end-of-retail files (docs/formats/container.md). Two numbers of records of the cell file are known.
struct KnownFile {
    std::uint32_t engineVersion;
    std::uint64_t length;
    std::array<std::uint64_t, 2> records;
};
constexpr std::array<KnownFile, 4> kEndOfRetail{{{110, 926941184, {79694, 79694}},
                                                 {22, 348127232, {805348, 805003}},
                                                 {110, 133169152, {2295, 2295}},
                                                 {110, 1048576, {118, 118}}}}; // by FileRole

} // namespace

FileIdentity identityOf(const dat::File& file, std::uint64_t records) {
    const dat::Header& h = file.header();
    return {file.role(), h.engineVersion, h.minorVersion, h.majorVersion, file.length(), records};
}

Release releaseOf(const FileIdentity& file) {
    const KnownFile& known = kEndOfRetail.at(static_cast<std::size_t>(file.role));
    if (file.minorVersion != kLastMinorVersion || file.majorVersion != kLastMajorVersion ||
        file.engineVersion != known.engineVersion)
        return Release::Unknown;
    const bool counted = file.records != 0;
    const bool fits =
        std::find(known.records.begin(), known.records.end(), file.records) != known.records.end();
    if (file.length == known.length && (!counted || fits))
        return Release::EndOfRetail;
    return Release::EndOfRetailChanged;
}

Release releaseOf(const FileIdentity& portal, const FileIdentity& cell) {
    return std::max(releaseOf(portal), releaseOf(cell));
}

std::string nameOf(Release release) {
    switch (release) {
    case Release::EndOfRetail:
        return "end of retail";
    case Release::EndOfRetailChanged:
        return "end of retail, with other contents";
    case Release::Unknown:
        break;
    }
    return "unknown release";
}

} // namespace limen::doctor
