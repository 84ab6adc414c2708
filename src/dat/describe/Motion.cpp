#include "dat/Describe.h"
#include "dat/describe/Json.h"

namespace limen::dat {
namespace {

Json motion(const MotionData& m) {
    Json out = {{"bitfield", m.bitfield},
                {"animations", listOf(m.animations, [](const AnimationRange& range) {
                     return Json{{"animation", hexId(range.animation)},
                                 {"low", range.low},
                                 {"high", range.high},
                                 {"fps", number(range.fps)}};
                 })}};
    if (m.flags & MotionData::kVelocity)
        out["velocity"] = json(m.velocity);
    if (m.flags & MotionData::kOmega)
        out["omega"] = json(m.omega);
    return out;
}

Json motions(const MotionTable::Keyed<MotionData>& list) {
    return listOf(list, [](const auto& keyed) {
        Json out = {{"key", hexId(keyed.first)}};
        out.update(motion(keyed.second));
        return out;
    });
}

} // namespace

std::string describe(const Animation& a) {
    Json out = {{"kind", "Animation"}, {"id", hexId(a.id)}, {"flags", a.flags}, {"parts", a.partCount}};
    if (a.flags & Animation::kPositionFrames)
        out["position_frames"] = listOf(a.positionFrames, [](const Frame& f) { return json(f); });
    out["frames"] = listOf(a.frames, [](const AnimationFrame& f) { return json(f); });
    return pretty(out);
}

std::string describe(const MotionTable& t) {
    return pretty({{"kind", "MotionTable"},
                   {"id", hexId(t.id)},
                   {"default_style", hexId(t.defaultStyle)},
                   {"style_defaults",
                    listOf(t.styleDefaults,
                           [](const auto& keyed) {
                               return Json{{"style", hexId(keyed.first)}, {"substate", hexId(keyed.second)}};
                           })},
                   {"cycles", motions(t.cycles)},
                   {"modifiers", motions(t.modifiers)},
                   {"links", listOf(t.links, [](const auto& keyed) {
                        return Json{{"from", hexId(keyed.first)}, {"to", motions(keyed.second)}};
                    })}});
}

} // namespace limen::dat
