#pragma once
#include <imgui.h>

namespace glassbox {

/// A child window whose buttons the arrow keys reach from those around it. End it with ImGui::EndChild().
inline void begin_part(const char* name, ImVec2 size) {
#if IMGUI_VERSION_NUM >= 19090
    ImGui::BeginChild(name, size, ImGuiChildFlags_NavFlattened);
#else
    ImGui::BeginChild(name, size, false, ImGuiWindowFlags_NavFlattened);
#endif
}

/// Lets the keyboard work the buttons, or leaves it to the keys of our own table. Call it between frames.
inline void let_keyboard_work(bool buttons) {
    ImGuiIO& io = ImGui::GetIO();
    if (buttons) io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    else io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
}

/// Begins with the buttons of this window, if the keyboard is not among buttons yet.
inline void take_keyboard() {
    if (!ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows)) ImGui::SetWindowFocus();
}

}  // namespace glassbox
