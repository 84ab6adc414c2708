#pragma once

#include "dat/RecordTypes.h"

#include <functional>

// The references from records to other records (docs/formats).
namespace limen::dat {

/// A reference to a record of one of two kinds, which may be equal. Ids that mean "none" are not references.
struct Reference {
    RecordId id = 0;
    std::array<RecordKind, 2> kinds{RecordKind::Other, RecordKind::Other};
    const char* as = ""; ///< its purpose, e.g. "a part"

    Reference(RecordId named, RecordKind kind, const char* what) : id(named), kinds{kind, kind}, as(what) {}
    Reference(RecordId named, RecordKind kind, RecordKind other, const char* what)
        : id(named), kinds{kind, other}, as(what) {}
};
using ReferenceVisitor = std::function<void(const Reference&)>;

/// Visits every reference in the order of the record. Omits sounds, and the images of a SurfaceTexture,
/// because one existing image is enough.
template <class Record>
LIMEN_API void forEachReference(const Record& record, const ReferenceVisitor& visit);

/// A reference to a model: a GfxObj or a Setup.
[[nodiscard]] inline Reference modelReference(RecordId id, const char* as) {
    return {id, RecordKind::GfxObj, RecordKind::Setup, as};
}

} // namespace limen::dat
