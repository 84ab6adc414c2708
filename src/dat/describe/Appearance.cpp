#include "dat/Describe.h"
#include "dat/describe/Json.h"

namespace limen::dat {
namespace {

Json partChange(const PartChange& p) {
    return {{"part", p.part},
            {"gfx_obj", hexId(p.gfxObj)},
            {"textures", listOf(p.textures, [](const TextureChange& change) {
                 return Json{{"from", hexId(change.from)}, {"to", hexId(change.to)}};
             })}};
}

Json paletteChange(const PaletteChange& p) {
    return {{"palettes", hexId(p.palettes)},
            {"ranges", listOf(p.ranges, [](const PaletteRange& range) {
                 return Json{{"offset", range.offset}, {"count", range.count}};
             })}};
}

} // namespace

std::string describe(const PaletteSet& s) {
    return pretty({{"kind", "PaletteSet"}, {"id", hexId(s.id)}, {"palettes", hexIds(s.palettes)}});
}

std::string describe(const ClothingTable& t) {
    return pretty(
        {{"kind", "ClothingTable"},
         {"id", hexId(t.id)},
         {"parts",
          listOf(
              t.parts.entries,
              [](const auto& keyed) {
                  return Json{{"setup", hexId(keyed.first)}, {"changes", listOf(keyed.second, partChange)}};
              })},
         {"palettes", listOf(t.palettes.entries, [](const auto& keyed) {
              return Json{{"template", keyed.first},
                          {"icon", hexId(keyed.second.icon)},
                          {"changes", listOf(keyed.second.changes, paletteChange)}};
          })}});
}

} // namespace limen::dat
