#pragma once

struct ImGuiContext;

namespace glassbox {

/// A Dear ImGui context that draws with the OpenGL context current at its making, in which it must be destroyed, too.
/// It reads and writes no file of settings.
class GuiContext {
public:
    GuiContext();
    ~GuiContext();
    GuiContext(const GuiContext&) = delete;
    GuiContext& operator=(const GuiContext&) = delete;

    void make_current() const;

private:
    ImGuiContext* context_;
};

/// Draws what ImGui::Render left behind into the framebuffer that is bound, of this size in pixels. What no window
/// covers has the colour of windows: clearing costs far less than filling.
void draw_gui(int width, int height);

}  // namespace glassbox
