#pragma once
#include <imgui.h>

namespace glassbox {

/// The fonts of the interface: DejaVu Sans, in which every sign of ours can be drawn (·, ×, −, √, ², ₀, ≥, ≤, ±, ε, Δ,
/// …), and DejaVu Sans Mono for numbers and source.
struct Fonts {
    ImFont* text = nullptr;
    ImFont* mono = nullptr;
};

/// Puts both into the current Dear ImGui context, in place of those before; `size` is a line's height in pixels. Not
/// between NewFrame and Render.
Fonts load_fonts(float size);

}  // namespace glassbox
