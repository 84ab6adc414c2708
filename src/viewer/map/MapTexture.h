#pragma once

#include "engine/map/LandscapeMap.h"

#include <cstdint>

namespace limen::viewer {

/// A map on the device, for Dear ImGui. Requires a current GL context.
class MapTexture {
public:
    MapTexture() = default;
    ~MapTexture();
    MapTexture(const MapTexture&) = delete;
    MapTexture& operator=(const MapTexture&) = delete;

    void write(const engine::LandscapeMap& map);
    /// The GL name; 0: nothing was written.
    [[nodiscard]] std::uint32_t name() const { return name_; }

private:
    std::uint32_t name_ = 0, width_ = 0, height_ = 0;
};

} // namespace limen::viewer
