#include "viewer/platform/context.hpp"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include "viewer/platform/opengl.hpp"

namespace glassbox {

GuiContext::GuiContext() : context_(ImGui::CreateContext()) {
    make_current();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::GetIO().LogFilename = nullptr;
    ImGui_ImplOpenGL3_Init("#version 330 core");
}

GuiContext::~GuiContext() {
    make_current();
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext(context_);
}

void GuiContext::make_current() const { ImGui::SetCurrentContext(context_); }

void draw_gui(int width, int height) {
    glViewport(0, 0, width, height);
    const ImVec4 background = ImGui::GetStyle().Colors[ImGuiCol_WindowBg];
    glClearColor(background.x, background.y, background.z, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace glassbox
