#pragma once
#include <imgui.h>

#include <string>
#include <string_view>

namespace glassbox {

/// Returns the text in lines at most as wide as the room that is left, broken between words only: Dear ImGui's own
/// wrapping breaks after every dot, also within 11.9973. A single word may be wider.
std::string wrapped(std::string_view text);
std::string wrapped(std::string_view text, float room);

/// The text, or as much of it as fits into one line, with "…" at its end.
std::string fitting(const std::string& text, float width);

/// Draws the wrapped text.
void draw_wrapped(std::string_view text);
void draw_wrapped(ImU32 color, std::string_view text);

}  // namespace glassbox
