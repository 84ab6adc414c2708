#include "gpu/RenderTarget.h"

#include "core/Assert.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace limen::gpu {

Result<RenderTarget> RenderTarget::create(Device& device, std::uint32_t width, std::uint32_t height,
                                          const TargetOptions& asked) {
    TargetOptions options = asked;
    options.samples = options.samples > 1 ? options.samples : 0;
    const Result<TargetHandle> handle = device.createTarget(width, height, options);
    if (!handle)
        return Failure(handle.error());
    RenderTarget target(device, *handle, width, height, options);
    if (options.samples > 0)
        target.samples_ = device.samplePositions(*handle);
    return target;
}

RenderTarget::RenderTarget(RenderTarget&& other) noexcept
    : device_(other.device_), handle_(std::exchange(other.handle_, TargetHandle::Invalid)),
      width_(other.width_), height_(other.height_), options_(other.options_), tile_(other.tile_),
      samples_(std::move(other.samples_)) {}

RenderTarget& RenderTarget::operator=(RenderTarget&& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(handle_, other.handle_);
    std::swap(width_, other.width_);
    std::swap(height_, other.height_);
    std::swap(options_, other.options_);
    std::swap(tile_, other.tile_);
    std::swap(samples_, other.samples_);
    return *this;
}

RenderTarget::~RenderTarget() {
    if (handle_ != TargetHandle::Invalid)
        device_->destroyTarget(handle_);
}

template <class T>
std::vector<T> RenderTarget::read(TargetImage image, std::size_t perPixel) const {
    const std::size_t row = std::size_t{width_} * perPixel;
    std::vector<T> pixels(row * height_);
    device_->readTarget(handle_, image, std::as_writable_bytes(std::span(pixels)));
    for (std::size_t y = 0; y < height_ / 2; ++y) {
        const auto top = pixels.begin() + static_cast<std::ptrdiff_t>(y * row);
        const auto bottom = pixels.end() - static_cast<std::ptrdiff_t>((y + 1) * row);
        std::swap_ranges(top, top + static_cast<std::ptrdiff_t>(row), bottom);
    }
    return pixels;
}

namespace {

/// View depth ratio of a stored depth: 0 for the sky and voids, and scaled back for fringes (SharedLayout.h).
float depthOfStored(float stored) {
    const auto power = [](std::uint32_t exponent) { return std::ldexp(1.0f, -static_cast<int>(exponent)); };
    const float sky = power(frame::gpu::kSkyExponent), empty = power(frame::gpu::kVoidExponent);
    if (stored > empty)
        return stored;
    return stored == sky || stored == empty
               ? 0.0f
               : std::ldexp(stored, static_cast<int>(frame::gpu::kFringeExponent));
}

} // namespace

std::vector<glm::vec2> RenderTarget::samplePositions() const {
    std::vector<glm::vec2> positions = samples_;
    for (glm::vec2& position : positions)
        position = {position.x - 0.5f, 0.5f - position.y};
    return positions;
}

Viewport RenderTarget::viewport() const {
    if (!isTile())
        return {0, 0, width_, height_};
    return {-static_cast<std::int32_t>(tile_.x), -static_cast<std::int32_t>(tile_.y), tile_.pictureWidth,
            tile_.pictureHeight};
}

void RenderTarget::place(const frame::gpu::ViewConstants& view, frame::gpu::DeviceConstants& device) const {
    const Viewport whole = viewport();
    const double width = whole.width, height = whole.height;
    device.windowOrigin = tile_.x | tile_.y << 16;
    device.viewport = {width, height, 1.0 / width, 1.0 / height};
    // Rows for x, y and w of the clip position. The direction of view depth 1 through (x, y) of the window
    // solves rows * direction = (x, y, 1).
    const glm::dmat4 clip(view.clipFromEye);
    const glm::dmat3 eyeFromWindow = glm::inverse(glm::dmat3(
        clip[0].x, clip[0].y, clip[0].w, clip[1].x, clip[1].y, clip[1].w, clip[2].x, clip[2].y, clip[2].w));
    device.rayCorner = glm::vec4(eyeFromWindow * glm::dvec3(-1.0, -1.0, 1.0), 0.0);
    device.rayRight = glm::vec4(eyeFromWindow[0] * (2.0 / width), 0.0);
    device.rayUp = glm::vec4(eyeFromWindow[1] * (2.0 / height), 0.0);
    device.pixel = std::max(glm::length(glm::vec3(device.rayRight)), glm::length(glm::vec3(device.rayUp)));
    for (std::size_t i = 0; i < samples_.size(); ++i) {
        device.samplesX |= static_cast<std::uint32_t>(samples_[i].x * 256.0f) << (8 * i);
        device.samplesY |= static_cast<std::uint32_t>(samples_[i].y * 256.0f) << (8 * i);
    }
}

std::vector<std::uint8_t> RenderTarget::readColour() const {
    return read<std::uint8_t>(TargetImage::Colour, 4);
}

std::vector<std::uint32_t> RenderTarget::readIds() const {
    return read<std::uint32_t>(TargetImage::Id, 1);
}

std::vector<float> RenderTarget::readDepth() const {
    std::vector<float> depths = read<float>(TargetImage::Depth, 1);
    std::transform(depths.begin(), depths.end(), depths.begin(), depthOfStored);
    return depths;
}

std::vector<std::uint32_t> RenderTarget::readOwnership() const {
    std::vector<std::uint32_t> visits = read<std::uint32_t>(TargetImage::Ownership, 1);
    for (std::uint32_t& visit : visits)
        visit &= ~frame::gpu::kOwnedOutside;
    return visits;
}

std::vector<LayerSum> RenderTarget::readLayers() const {
    const std::vector<float> sums = read<float>(TargetImage::Layers, 2);
    std::vector<LayerSum> layers(sums.size() / 2);
    for (std::size_t i = 0; i < layers.size(); ++i)
        layers[i] = {static_cast<std::uint32_t>(sums[2 * i]), static_cast<std::uint32_t>(sums[2 * i + 1])};
    return layers;
}

std::vector<float> RenderTarget::readDistances(const frame::gpu::ViewConstants& view) const {
    LIMEN_ASSERT(!isTile(), "distances are read from whole pictures");
    std::vector<float> values = readDepth();
    const glm::dmat4 eyeFromClip = glm::inverse(glm::dmat4(view.clipFromEye));
    for (std::uint32_t y = 0; y < height_; ++y) {
        for (std::uint32_t x = 0; x < width_; ++x) {
            float& value = values[std::size_t{y} * width_ + x];
            const glm::dvec2 at = glm::dvec2(x + 0.5, y + 0.5) + frame::gpu::kPixelPlace;
            const glm::dvec2 ndc{at.x / width_ * 2.0 - 1.0, 1.0 - at.y / height_ * 2.0};
            const glm::dvec4 point = eyeFromClip * glm::dvec4(ndc, static_cast<double>(value), 1.0);
            value = value > 0.0f ? static_cast<float>(glm::length(glm::dvec3(point) / point.w))
                                 : std::numeric_limits<float>::infinity();
        }
    }
    return values;
}

} // namespace limen::gpu
