#pragma once
#include <imgui.h>

namespace glassbox {

/// The fonts of the interface: DejaVu Sans, which has all signs that we use (·, ×, −, √, ², ₀, ≥, ≤, ±, ε, Δ, …), and
/// DejaVu Sans Mono for numbers and source.
struct Fonts {
    ImFont* text = nullptr;
    ImFont* mono = nullptr;
};

/// Loads both into the current Dear ImGui context, in place of the previous ones; `size` is a line's height in pixels.
/// Do not call it between NewFrame and Render.
Fonts load_fonts(float size);

}  // namespace glassbox
