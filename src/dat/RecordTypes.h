#pragma once

#include "dat/Codec.h"

#include <type_traits>

// The record types as a list, so that code for all of them is written once.
namespace limen::dat {

template <class... Records>
struct TypeList {
    static constexpr std::size_t kSize = sizeof...(Records);
    /// Calls `visit` with a std::type_identity of each.
    template <class Visit>
    static void forEach(Visit&& visit) {
        (visit(std::type_identity<Records>{}), ...);
    }
    template <template <class...> class Other>
    using As = Other<Records...>;
};

/// In the order of RecordKind.
using RecordTypes =
    TypeList<GfxObj, Setup, Animation, Palette, SurfaceTexture, RenderSurface, Surface, MotionTable,
             Environment, PaletteSet, ClothingTable, DegradeInfo, Scene, Region, ParticleEmitter,
             PhysicsScript, PhysicsScriptTable, LandBlock, LandBlockInfo, EnvCell>;
static_assert(RecordTypes::kSize == static_cast<std::size_t>(RecordKind::Iteration));

namespace detail {
template <class Record, class... Records>
constexpr std::size_t indexIn(TypeList<Records...>) {
    std::size_t index = 0;
    (void)((std::is_same_v<Record, Records> || (++index, false)) || ...);
    return index;
}
} // namespace detail

template <class Record>
inline constexpr auto kKindOf = static_cast<RecordKind>(detail::indexIn<Record>(RecordTypes{}));
static_assert(kKindOf<GfxObj> == RecordKind::GfxObj && kKindOf<DegradeInfo> == RecordKind::DegradeInfo &&
              kKindOf<PhysicsScriptTable> == RecordKind::PhysicsScriptTable &&
              kKindOf<EnvCell> == RecordKind::EnvCell);

/// Calls `visit` with a std::type_identity of the record type of that kind. False if Limen decodes none.
template <class Visit>
bool visitKind(RecordKind kind, Visit&& visit) {
    bool found = false;
    RecordTypes::forEach([&]<class Record>(std::type_identity<Record> type) {
        if (kKindOf<Record> == kind) {
            visit(type);
            found = true;
        }
    });
    return found;
}

} // namespace limen::dat
