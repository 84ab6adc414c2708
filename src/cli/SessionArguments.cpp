#include "cli/SessionArguments.h"

#include "cli/Choices.h"
#include "cli/ReadingsArgument.h"
#include "engine/Quality.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <limits>

namespace limen::cli {

void addSessionOptions(CLI::App& command, engine::SessionOptions& options) {
    command // first, so that single options override it
        .add_option_function<std::string>(
            "--quality",
            [&options](const std::string& text) {
                engine::applyQuality(*engine::qualityNamed(text), options);
            },
            "set --radius, --far and --detail together; with a graphics card also --msaa and anisotropic "
            "filtering, "
            "in the window also the limits of --scale auto (none)")
        ->type_name("low|medium|high|ultra")
        ->check(oneOf({"low", "medium", "high", "ultra"}))
        ->group("World");
    command
        .add_option("--dat", options.dat,
                    "load the world from this directory of client_portal.dat and client_cell_1.dat (the "
                    "built-in world)")
        ->type_name("DIR")
        ->group("World")
        ->check(notEmpty());
    command
        .add_option_function<std::string>(
            "--zones", [&options](const std::string& text) { options.load.mergeZones = text == "merged"; },
            "choose the zones; merged: cells that cannot hide each other share a zone; cells: one zone per "
            "cell; pictures are equal, but where an object pokes through a wall within its zone (merged)")
        ->type_name("merged|cells")
        ->check(oneOf({"merged", "cells"}))
        ->group("World");
    command
        .add_option("--radius", options.load.radius,
                    "load this many landblocks in each direction around the eye (4)")
        ->type_name("N")
        ->check(within(0, 16))
        ->group("World");
    command
        .add_option("--far", options.load.farRadius,
                    "load the ground alone of landblocks beyond --radius, up to this many in each direction "
                    "(0: none)")
        ->type_name("N")
        ->check(within(0, 32))
        ->group("World");
    command
        .add_option("--detail", options.load.detail,
                    "multiply the distances of levels of detail by this factor (1); inf: always the finest")
        ->type_name("F")
        ->check(within(0.01, std::numeric_limits<double>::infinity()))
        ->group("World");
    addReadings(command, options.load.readings);
    command
        .add_option_function<std::string>(
            "--textures",
            [&options](const std::string& text) {
                options.textures = text == "bindless" ? gpu::TextureMode::Bindless
                                   : text == "pages"  ? gpu::TextureMode::ArrayPages
                                                      : gpu::TextureMode::Auto;
            },
            "bind textures by handle or as array pages (auto: bindless where the driver has it)")
        ->type_name("auto|bindless|pages")
        ->check(oneOf({"auto", "bindless", "pages"}))
        ->group("World");
    command
        .add_option_function<std::string>(
            "--culling",
            [&options](const std::string& text) {
                options.culling = text == "none"     ? gpu::Culling::None
                                  : text == "unseen" ? gpu::Culling::Unseen
                                                     : gpu::Culling::Hidden;
            },
            "skip triangles that cover no pixel (unseen), also those behind walls and ground (hidden), or "
            "none; pictures are equal; without effect on --draw fast (hidden)")
        ->type_name("none|unseen|hidden")
        ->check(oneOf({"none", "unseen", "hidden"}))
        ->group("World");
    command
        .add_option_function<std::uint32_t>(
            "--msaa", [&options](std::uint32_t samples) { options.samples = std::max(samples, 1u); },
            "set the samples per pixel (1); ids and depth always have one")
        ->type_name("1|4")
        ->check(oneOf({"0", "1", "4"}))
        ->group("World");
}

void addGate(CLI::App& command, engine::SessionOptions& options) {
    command
        .add_option_function<std::string>(
            "--gate",
            [&options](const std::string& text) {
                options.gate = frame::gateNamed(text).value_or(frame::Gate::Ownership);
            },
            "choose the way to keep each space within its openings; ownership: exact; planes: clip planes; "
            "depth: drawing order and depth, as the original did (ownership)")
        ->type_name("ownership|planes|depth")
        ->check(oneOf({"ownership", "planes", "depth"}))
        ->group("World");
}

void addDrawing(CLI::App& command, engine::SessionOptions& options, gpu::Drawing usual,
                const std::string& usualText) {
    options.drawing = usual;
    command
        .add_option_function<std::string>(
            "--draw",
            [&options](const std::string& text) {
                options.drawing = text == "fast" ? gpu::Drawing::Fast : gpu::Drawing::Exact;
            },
            fmt::format(
                "choose the way of drawing; exact: each pixel shows the surface that its ray meets; fast: "
                "edges may be off by a pixel ({})",
                usualText))
        ->type_name("exact|fast")
        ->check(oneOf({"exact", "fast"}))
        ->group("World");
}

} // namespace limen::cli
