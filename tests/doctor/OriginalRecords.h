#pragma once

#include "dat/Archive.h"
#include "dat/Writer.h"

// Made-up records that have the values of the facts about the original files, and no other content of them.
namespace limen::test {

/// Which values the records hold.
enum class Values { AsStated, Changed };

/// Writes the records that the judges name into two files. Changed: every value that a fact states is another one.
class OriginalRecords {
public:
    explicit OriginalRecords(Values values);
    [[nodiscard]] dat::Archive archive() const;
    [[nodiscard]] const dat::Writer& portal() const { return portal_; }

private:
    /// A stated value, or another one.
    template <class T>
    [[nodiscard]] T v(T value) const {
        return values_ == Values::AsStated ? value : static_cast<T>(value + T{1});
    }
    void addSurfaces();
    void addModels();
    void addLampsAndParts();
    void addMeshes();
    void addRegion();
    void addSky(dat::Region& region) const;
    void addBlocks();
    void addNamedCells();
    void addShapes();
    void addAcademy();
    void addHoltburg();
    void addScripts();

    Values values_;
    dat::Writer portal_{dat::FileTraits::portal()}, cell_{dat::FileTraits::cell()};
};

/// Two files without records.
[[nodiscard]] dat::Archive emptyArchive();
[[nodiscard]] dat::Archive archiveOf(const dat::Writer& portal, const dat::Writer& cell);
/// A tree of one leaf, and a tree of one plane with leaves below.
[[nodiscard]] dat::BspTree leafTree();
[[nodiscard]] dat::BspTree planeTree(dat::BspTag tag, float d);
/// A triangle without texture coordinates.
[[nodiscard]] dat::Polygon bareTriangle(std::int16_t surface);

} // namespace limen::test
