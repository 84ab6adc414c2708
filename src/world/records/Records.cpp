#include "world/records/Records.h"

#include "core/Assert.h"

#include <algorithm>
#include <cmath>

namespace limen::world {

void note(std::vector<Finding>& findings, dat::RecordId record, std::string what) {
    findings.push_back({record, std::move(what)});
}

void Records::report(const Finding& finding) {
    LIMEN_ASSERT(!finding.what.empty(), "a finding has a text");
    if (log_.all.emplace(finding.record, finding.what).second)
        log_.findings.push_back(finding);
    LIMEN_ASSERT(log_.all.size() == log_.findings.size(), "both lists have the same findings");
}

void Records::report(const std::vector<Finding>& findings) {
    for (const Finding& finding : findings)
        report(finding);
}

namespace {

/// A greater translucency sets the bit.
constexpr float kLeastTranslucency = 0.0002f;

bool isTranslucent(const dat::Surface& surface) {
    return (surface.type & dat::Surface::kTranslucent) != 0 || surface.translucency > kLeastTranslucency;
}

} // namespace

SurfaceClass surfaceClassOf(const dat::Surface& surface) {
    constexpr std::uint32_t kBlending =
        dat::Surface::kAlpha | dat::Surface::kInvAlpha | dat::Surface::kAdditive;
    if ((surface.type & kBlending) != 0 || isTranslucent(surface))
        return SurfaceClass::Blended;
    return (surface.type & dat::Surface::kBase1ClipMap) != 0 ? SurfaceClass::CutOut : SurfaceClass::Opaque;
}

float alphaOf(const dat::Surface& surface) {
    if (!isTranslucent(surface) || !std::isfinite(surface.translucency))
        return 1.0f;
    return 1.0f - std::clamp(surface.translucency, 0.0f, 1.0f);
}

bool isSplit(const dat::Surface& surface) {
    constexpr std::uint32_t kOther = dat::Surface::kInvAlpha | dat::Surface::kAdditive;
    return (surface.type & dat::Surface::kAlpha) != 0 && (surface.type & kOther) == 0 && surface.hasImage() &&
           alphaOf(surface) == 1.0f;
}

} // namespace limen::world
