#include "doctor/retail/CensusParts.h"

#include "doctor/retail/Hooks.h"

#include <algorithm>
#include <cmath>

namespace limen::doctor {
namespace {

constexpr float kLeastTilt = 0.0009f; // of the forward vector: 0.05 degrees
constexpr std::uint8_t kUnusedStippling = 8;
constexpr std::size_t kPaletteColours = 2048;

/// True if a JPEG's frame header says that it is progressive.
bool isProgressive(const std::vector<std::uint8_t>& bytes) {
    std::size_t at = 2; // behind the start-of-image marker
    while (at + 4 <= bytes.size() && bytes[at] == 0xFF) {
        const std::uint8_t marker = bytes[at + 1];
        if (marker == 0xC2)
            return true;
        if (marker == 0xDA) // the picture's data begins
            return false;
        at += 2u + (std::size_t{bytes[at + 2]} << 8 | bytes[at + 3]);
    }
    return false;
}

bool isPalettised(dat::PixelFormat format) {
    return format == dat::PixelFormat::P8 || format == dat::PixelFormat::Index16;
}

std::optional<Tally> clipFormat(dat::PixelFormat format) {
    switch (format) {
    case dat::PixelFormat::Dxt5:
        return Tally::ClipDxt5;
    case dat::PixelFormat::Dxt3:
        return Tally::ClipDxt3;
    case dat::PixelFormat::Dxt1:
        return Tally::ClipDxt1;
    case dat::PixelFormat::A8R8G8B8:
        return Tally::ClipArgb;
    case dat::PixelFormat::A4R4G4B4:
        return Tally::ClipArgb4;
    case dat::PixelFormat::R8G8B8:
        return Tally::ClipRgb;
    default:
        return std::nullopt;
    }
}

std::optional<Tally> clipBlending(std::uint32_t type) {
    using S = dat::Surface;
    switch (type & (S::kTranslucent | S::kAlpha | S::kAdditive)) {
    case 0:
        return Tally::ClipPlain;
    case S::kTranslucent:
        return Tally::ClipTranslucent;
    case S::kAlpha:
        return Tally::ClipAlpha;
    case S::kAlpha | S::kAdditive:
        return Tally::ClipAlphaAdditive;
    case S::kAdditive:
        return Tally::ClipAdditive;
    case S::kTranslucent | S::kAlpha | S::kAdditive:
        return Tally::ClipAll;
    default:
        return std::nullopt;
    }
}

} // namespace

double animatedOf(const SetupSet& setups, const std::unordered_map<dat::RecordId, SetupTraits>& traits) {
    return static_cast<double>(std::count_if(setups.begin(), setups.end(), [&](dat::RecordId id) {
        const auto found = traits.find(id);
        return found != traits.end() && found->second.isAnimated;
    }));
}

void PortalCensus::countPolygons(const dat::PolygonList& polygons) {
    for (const auto& [id, polygon] : polygons) {
        census_[Tally::TwoSurfaceSides] += polygon.sides == static_cast<int>(dat::Sides::Both);
        census_[Tally::UvBit8] += (polygon.stippling & kUnusedStippling) != 0;
    }
}

void PortalCensus::add(const dat::GfxObj& object) {
    ++census_[Tally::GfxObjs];
    std::size_t zero = 0;
    for (const auto& [key, vertex] : object.vertexArray.vertices)
        zero += vertex.normal == Vec3f(0.0f);
    census_[Tally::Vertices] += static_cast<double>(object.vertexArray.vertices.size());
    census_[Tally::ZeroNormals] += static_cast<double>(zero);
    census_[Tally::ObjectsWithZeroNormals] += zero > 0;
    countPolygons(object.polygons);
    if (object.degradeId != 0)
        levelsOf_[object.id] = object.degradeId;
}

void PortalCensus::add(const dat::Setup& setup) {
    ++census_[Tally::Setups];
    ++census_[setup.script != 0 ? Tally::SetupsWithScript : Tally::SetupsWithoutScript];
    census_[Tally::SetupsWithLamps] += !setup.lights.empty();
    SetupTraits& traits = setups_[setup.id];
    traits.hasMarker = std::any_of(setup.parts.begin(), setup.parts.end(), isMarker);
    traits.isAnimated = setup.animation != 0;
    traits.hasDefaultPlacementOnly =
        !setup.placementFrames.empty() &&
        std::all_of(setup.placementFrames.begin(), setup.placementFrames.end(),
                    [](const auto& frame) { return frame.first == dat::Setup::kPlacementDefault; });
    for (const auto& [key, light] : setup.lights)
        traits.lamps.emplace_back(light.intensity, light.falloff);
}

void PortalCensus::add(const dat::Palette& palette) {
    ++census_[Tally::Palettes];
    census_[Tally::OtherPalettes] += palette.colours.size() != kPaletteColours;
}

void PortalCensus::add(const dat::Surface& surface) {
    ++census_[Tally::Surfaces];
    census_[Tally::GlowFlags] += (surface.type & (dat::Surface::kDiffuse | dat::Surface::kLuminous)) != 0;
    census_[Tally::InverseAlpha] += (surface.type & dat::Surface::kInvAlpha) != 0;
    if ((surface.type & dat::Surface::kBase1ClipMap) != 0)
        countClipMap(surface);
}

void PortalCensus::countClipMap(const dat::Surface& surface) {
    ++census_[Tally::ClipMaps];
    if (const std::optional<Tally> blending = clipBlending(surface.type))
        ++census_[*blending];
    const Result<dat::SurfaceTexture> texture = archive_.load<dat::SurfaceTexture>(surface.texture);
    const Result<dat::RecordId> image = texture ? archive_.imageOf(*texture) : Failure(texture.error());
    const Result<dat::RenderSurface> picture =
        image ? archive_.load<dat::RenderSurface>(*image) : Failure(image.error());
    if (!picture)
        return;
    ++census_[isPalettised(picture->format) ? Tally::PalettisedClipMaps : Tally::OtherClipMaps];
    if (const std::optional<Tally> format = clipFormat(picture->format))
        ++census_[*format];
}

void PortalCensus::add(const dat::Environment& environment) {
    ++census_[Tally::Environments];
    for (const auto& [key, shape] : environment.cells) {
        ++census_[Tally::CellShapes];
        shapeVertices_.push_back(shape.vertexArray.vertices.size());
        countPolygons(shape.polygons);
    }
}

void PortalCensus::add(const dat::DegradeInfo& info) {
    ++census_[Tally::DegradeInfos];
    constexpr std::size_t kFirst = static_cast<std::size_t>(Tally::LevelMode1);
    for (const dat::DegradeLevel& level : info.levels)
        if (level.mode >= 1 && level.mode <= 5)
            ++census_.tallies[kFirst + level.mode - 1];
    if (!info.levels.empty())
        levels_[info.id] = {info.levels.front().gfxObj, info.levels.front().mode};
}

void PortalCensus::add(const dat::Scene& scene) {
    ++census_[Tally::SceneRecords];
    for (const dat::SceneObject& object : scene.objects) {
        const bool isSetup = object.object >> 24 == 0x02;
        if (isSetup)
            scenery_.insert(object.object);
        const Vec3f forward = object.baseLoc.orientation * Vec3f(0.0f, 1.0f, 0.0f);
        if (std::abs(forward.z) > kLeastTilt) {
            ++census_[Tally::TiltedScenery];
            tilted_.insert(object.object);
        }
    }
}

void PortalCensus::add(const dat::ParticleEmitter& emitter) {
    ++census_[Tally::Emitters];
    if (emitter.gfxObj != 0)
        emitterMeshes_.insert(emitter.gfxObj);
}

void PortalCensus::countHook(const dat::AnimationHook& hook) {
    const std::optional<ScriptCall> call = scriptCallOf(hook);
    if (!call)
        return;
    ++census_[Tally::ScriptCalls];
    if (call->pause < kImmediatePause)
        return;
    const bool isFirst = census_[Tally::ScriptCallsWithPause]++ == 0;
    double& least = census_[Tally::LeastPause];
    double& most = census_[Tally::MostPause];
    least = isFirst ? call->pause : std::min<double>(least, call->pause);
    most = std::max<double>(most, call->pause);
}

void PortalCensus::add(const dat::PhysicsScript& script) {
    ++census_[Tally::Scripts];
    for (const dat::ScriptedHook& hook : script.hooks)
        countHook(hook.hook);
}

void PortalCensus::add(const dat::Animation& animation) {
    for (const dat::AnimationFrame& frame : animation.frames)
        for (const dat::AnimationHook& hook : frame.hooks)
            countHook(hook);
}

void PortalCensus::add(const dat::RenderSurface& picture) {
    ++census_[Tally::HighresPictures];
    if (picture.format != dat::PixelFormat::RawJpeg)
        return;
    ++census_[Tally::JpegPictures];
    census_[Tally::ProgressiveJpegs] += isProgressive(picture.pixels);
}

void PortalCensus::countEmitterMeshes() {
    census_[Tally::EmitterMeshes] = static_cast<double>(emitterMeshes_.size());
    for (const dat::RecordId mesh : emitterMeshes_) {
        const auto named = levelsOf_.find(mesh);
        const auto levels = named != levelsOf_.end() ? levels_.find(named->second) : levels_.end();
        if (levels == levels_.end())
            continue;
        ++census_[Tally::EmitterMeshesWithLevels];
        census_[Tally::EmitterMode1] += levels->second.mode == 1;
        census_[Tally::EmitterMode2] += levels->second.mode == 2;
        census_[Tally::EmitterMode5] += levels->second.mode == 5;
    }
}

void PortalCensus::countOtherLevels() {
    std::set<dat::RecordId> own; // records whose level 0 names them
    std::set<dat::RecordId> used;
    for (const auto& [object, record] : levelsOf_) {
        const auto levels = levels_.find(record);
        if (levels == levels_.end())
            continue;
        used.insert(record);
        if (levels->second.first == object)
            own.insert(record);
    }
    census_[Tally::OtherLevel0] = static_cast<double>(used.size() - own.size());
}

void PortalCensus::finish() {
    countEmitterMeshes();
    countOtherLevels();
    census_[Tally::ScenerySetups] = static_cast<double>(scenery_.size());
    census_[Tally::AnimatedScenery] = animatedOf(scenery_, setups_);
    census_[Tally::TiltedScenerySetups] = static_cast<double>(tilted_.size());
    std::sort(shapeVertices_.begin(), shapeVertices_.end());
    for (const std::size_t count : shapeVertices_)
        census_[Tally::CellShapeVertices] += static_cast<double>(count);
    if (!shapeVertices_.empty()) {
        census_[Tally::MedianShapeVertices] = static_cast<double>(shapeVertices_[shapeVertices_.size() / 2]);
        census_[Tally::MostShapeVertices] = static_cast<double>(shapeVertices_.back());
    }
}

} // namespace limen::doctor
