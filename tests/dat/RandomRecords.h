#pragma once

#include "dat/Codec.h"

#include <random>

namespace limen::dat {

/// Records with random content of every form that the format allows: NaNs, empty and long lists, repeated
/// keys, nonzero padding. For round trips, corpora of the fuzzers, and the benchmark. The same seed gives the
/// same records.
class RandomRecords {
public:
    explicit RandomRecords(std::uint64_t seed, std::size_t maxList = 6) : random_(seed), maxList_(maxList) {}

    template <class Record>
    [[nodiscard]] Record make();

private:
    [[nodiscard]] std::uint32_t word() { return static_cast<std::uint32_t>(random_()); }
    [[nodiscard]] std::uint16_t half() { return static_cast<std::uint16_t>(random_()); }
    [[nodiscard]] std::uint8_t byte() { return static_cast<std::uint8_t>(random_()); }
    [[nodiscard]] std::size_t below(std::size_t n) { return random_() % n; }
    [[nodiscard]] std::size_t count() { return below(maxList_ + 1); }
    [[nodiscard]] bool coin() { return below(2) == 0; }
    [[nodiscard]] float number();
    [[nodiscard]] Vec3f vec3() { return {number(), number(), number()}; }
    [[nodiscard]] Frame frame();
    [[nodiscard]] SphereF sphere() { return {vec3(), number()}; }
    [[nodiscard]] Stab stab() { return {word(), frame()}; }
    [[nodiscard]] std::string text();
    [[nodiscard]] std::vector<std::uint8_t> octets(std::size_t n);
    template <class List, class Make>
    void fill(List& list, std::size_t n, Make&& make) {
        for (std::size_t i = 0; i < n; ++i)
            list.push_back(make());
    }
    [[nodiscard]] VertexArray vertexArray();
    [[nodiscard]] Polygon polygon();
    [[nodiscard]] PolygonList polygons();
    [[nodiscard]] BspTree bsp(BspKind kind);
    std::int32_t bspNode(BspTree& tree, BspKind kind, int depth);
    [[nodiscard]] CellStruct cellStruct();
    [[nodiscard]] AnimationHook hook();
    [[nodiscard]] AnimationFrame animationFrame(std::size_t parts);
    [[nodiscard]] MotionData motion();
    [[nodiscard]] MotionTable::Keyed<MotionData> motions();
    [[nodiscard]] ScaledVector scaledVector() { return {vec3(), number(), number()}; }
    [[nodiscard]] Fade fade() { return {number(), number(), number()}; }
    [[nodiscard]] Building building();
    [[nodiscard]] DayGroup dayGroup();
    [[nodiscard]] GameTime gameTime();
    [[nodiscard]] TexMerge texMerge();

    std::mt19937_64 random_;
    std::size_t maxList_;
};

template <>
GfxObj RandomRecords::make<GfxObj>();
template <>
Setup RandomRecords::make<Setup>();
template <>
Animation RandomRecords::make<Animation>();
template <>
Palette RandomRecords::make<Palette>();
template <>
SurfaceTexture RandomRecords::make<SurfaceTexture>();
template <>
RenderSurface RandomRecords::make<RenderSurface>();
template <>
Surface RandomRecords::make<Surface>();
template <>
MotionTable RandomRecords::make<MotionTable>();
template <>
Environment RandomRecords::make<Environment>();
template <>
PaletteSet RandomRecords::make<PaletteSet>();
template <>
ClothingTable RandomRecords::make<ClothingTable>();
template <>
DegradeInfo RandomRecords::make<DegradeInfo>();
template <>
Scene RandomRecords::make<Scene>();
template <>
Region RandomRecords::make<Region>();
template <>
ParticleEmitter RandomRecords::make<ParticleEmitter>();
template <>
PhysicsScript RandomRecords::make<PhysicsScript>();
template <>
PhysicsScriptTable RandomRecords::make<PhysicsScriptTable>();
template <>
LandBlock RandomRecords::make<LandBlock>();
template <>
LandBlockInfo RandomRecords::make<LandBlockInfo>();
template <>
EnvCell RandomRecords::make<EnvCell>();

} // namespace limen::dat
