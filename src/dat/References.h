#pragma once

#include "dat/RecordTypes.h"

#include <functional>

// Which other records a record names (the format pages of each).
namespace limen::dat {

/// A record of one of these kinds; `kinds` may repeat one. Ids that mean "none" are not told.
struct Reference {
    RecordId id = 0;
    std::array<RecordKind, 2> kinds{RecordKind::Other, RecordKind::Other};
    const char* as = ""; ///< what for, e.g. "a part"

    Reference(RecordId named, RecordKind kind, const char* what) : id(named), kinds{kind, kind}, as(what) {}
    Reference(RecordId named, RecordKind kind, RecordKind other, const char* what)
        : id(named), kinds{kind, other}, as(what) {}
};
using ReferenceVisitor = std::function<void(const Reference&)>;

/// Tells the visitor every reference, in the order of the record. Of a SurfaceTexture's images one is enough: they are not told. Of
/// sounds nothing is told.
template <class Record>
void forEachReference(const Record& record, const ReferenceVisitor& visit);

/// What is written twice: the visitor is handed a model, which is a GfxObj or a Setup.
[[nodiscard]] inline Reference modelReference(RecordId id, const char* as) {
    return {id, RecordKind::GfxObj, RecordKind::Setup, as};
}

} // namespace limen::dat
