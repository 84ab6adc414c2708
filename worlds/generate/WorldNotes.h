#pragma once

#include "dat/Ids.h"
#include "geometry/Vec.h"

#include <nlohmann/json.hpp>
#include <span>
#include <string>

namespace limen::worlds {

/// Converts a landblock's metres to global metres.
[[nodiscard]] inline Vec3 blockToGlobal(dat::BlockCoord coord, const Vec3& local) {
    return local + Vec3(coord.x * 192.0, coord.y * 192.0, 0.0);
}

/// Collects the places and doors of `world.json` (docs/world-file.md).
class WorldNotes {
public:
    WorldNotes();

    /// Adds a viewpoint that looks at `target`; both in global metres. `cell` 0 is outside.
    void addPlace(const std::string& name, const Vec3& eye, const Vec3& target, dat::RecordId cell);

    struct Leaf {
        dat::RecordId model = 0;
        Vec3 hinge{0.0};    ///< global
        double yaw = 0.0;   ///< compass degrees of the leaf's +y when closed
        double swing = 0.0; ///< degrees clockwise when open
    };
    struct Door {
        dat::RecordId cell = 0;
        std::uint16_t portal = 0;
        bool opaque = true;
        double open = 0.0;
    };
    void addDoor(const Door& door, std::span<const Leaf> leaves);
    [[nodiscard]] std::size_t doorCount() const { return json_["doors"].size(); }
    [[nodiscard]] std::size_t placeCount() const { return json_["places"].size(); }

    [[nodiscard]] nlohmann::ordered_json take() { return std::move(json_); }

private:
    nlohmann::ordered_json json_;
};

} // namespace limen::worlds
