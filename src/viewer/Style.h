#pragma once

#include <filesystem>
#include <optional>

// The look of all pages and panels: colours, distances, letters. The one place that sets them.
namespace limen::viewer {

enum class StyleInk { Text, Dim, Accent, Good, Warning, Bad, KeyCap, Backdrop };
/// A colour of the style, as ImGui's draw lists take it. `opacity` 0..1.
[[nodiscard]] unsigned styleInk(StyleInk ink, float opacity = 1.0f);

/// Sets colours and distances of the current Dear ImGui context. `scale` in screen units.
void applyStyle(float scale);

/// Height of letters at scale 1, in pixels.
inline constexpr float kLetterSize = 16.0f;

/// Replaces the font of the current context. Without a file, or if it cannot be read: ImGui's own bitmap
/// font. Returns whether the file was used. The caller remakes the font's texture.
bool applyFont(const std::optional<std::filesystem::path>& file, float pixels);

} // namespace limen::viewer
