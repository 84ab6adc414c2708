#pragma once

#include "check/Comparison.h"

#include <functional>
#include <limits>

namespace limen::check::test {

/// An answer of the reference: an id at a depth of 4 m; sky at infinity, void nowhere.
inline reference::Answer answer(std::uint32_t id, double t = 4.0) {
    reference::Answer a;
    a.id = id;
    a.t = id == 0   ? std::numeric_limits<double>::quiet_NaN()
          : id == 1 ? std::numeric_limits<double>::infinity()
                    : t;
    return a;
}

/// A traced picture of one id everywhere.
inline reference::Picture tracedOf(std::uint32_t width, std::uint32_t height, std::uint32_t id) {
    reference::Picture picture;
    picture.width = width;
    picture.height = height;
    picture.answers.assign((width + 2) * (height + 2), answer(id));
    return picture;
}

inline reference::Answer& at(reference::Picture& picture, int x, int y) {
    return picture
        .answers[static_cast<std::size_t>(y + 1) * (picture.width + 2) + static_cast<std::size_t>(x + 1)];
}

/// A drawn picture of one id everywhere, at a depth of 4 m.
inline DrawnImages drawnOf(std::uint32_t width, std::uint32_t height, std::uint32_t id) {
    DrawnImages images;
    images.width = width;
    images.height = height;
    images.ids.assign(width * height, id);
    images.depth.assign(width * height, id < 2 ? 0.0f : static_cast<float>(images.depthUnit / 4.0));
    return images;
}

/// Second looks answered by functions. A function that is not set excuses nothing.
struct HandMadeRetracer final : Retracer {
    std::function<std::uint32_t(double, double)> exactId, byZoneId;
    std::function<bool(double, double)> into;
    std::function<bool(std::uint32_t)> edgeOn, depth;
    std::function<double(std::uint32_t)> rounding;
    std::vector<std::uint32_t> near;
    std::size_t finerRays = 0;

    reference::Answer exact(double x, double y) override {
        ++finerRays;
        return answer(exactId ? exactId(x, y) : 99);
    }
    reference::Answer byZone(double x, double y) override { return answer(byZoneId ? byZoneId(x, y) : 99); }
    bool leadsIntoTheRoot(double x, double y) override { return !into || into(x, y); }
    bool isEdgeOn(double, double, std::uint32_t id, double) override { return edgeOn && edgeOn(id); }
    double outlineRounding(double, double, std::uint32_t id) override {
        return rounding ? rounding(id) : 0.0;
    }
    void polygonsAlong(double, double, std::vector<std::uint32_t>& ids) override { ids = near; }
    bool mayHaveDepth(int, int, std::uint32_t id, double) override { return depth && depth(id); }
};

} // namespace limen::check::test
