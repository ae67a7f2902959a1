#pragma once

struct ImGuiContext;

namespace glassbox {

/// A Dear ImGui context that draws with the OpenGL context that is current when it is made; the same one must be
/// current when it is destroyed. Reads and writes no settings file.
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

/// Draws the result of ImGui::Render into the bound framebuffer, of this size in pixels. Where there is no ImGui window
/// it has the colour of windows: clearing costs far less than filling.
void draw_gui(int width, int height);

}  // namespace glassbox
