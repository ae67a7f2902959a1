#include "viewer/platform/fed_input.hpp"

#include <cfloat>

namespace glassbox {
namespace {

constexpr auto no_key = ImGuiKey{};

// Only the letters that text fields use with Ctrl: undo, redo, cut, copy, paste, select all.
ImGuiKey letter_key(char32_t letter) {
    switch (letter) {
        case 'a':
            return ImGuiKey_A;
        case 'c':
            return ImGuiKey_C;
        case 'v':
            return ImGuiKey_V;
        case 'x':
            return ImGuiKey_X;
        case 'y':
            return ImGuiKey_Y;
        case 'z':
            return ImGuiKey_Z;
        default:
            return no_key;
    }
}

/// Returns Dear ImGui's name of a key; none if it needs only the character that the key types.
ImGuiKey gui_key(const KeyPress& press) {
    switch (press.key) {
        case Key::character:
            return press.control ? letter_key(press.character) : no_key;
        case Key::left:
            return ImGuiKey_LeftArrow;
        case Key::right:
            return ImGuiKey_RightArrow;
        case Key::up:
            return ImGuiKey_UpArrow;
        case Key::down:
            return ImGuiKey_DownArrow;
        case Key::escape:
            return ImGuiKey_Escape;
        case Key::enter:
            return ImGuiKey_Enter;
        case Key::space:
            return ImGuiKey_Space;
        case Key::home:
            return ImGuiKey_Home;
        case Key::end:
            return ImGuiKey_End;
        case Key::page_up:
            return ImGuiKey_PageUp;
        case Key::page_down:
            return ImGuiKey_PageDown;
    }
    return no_key;
}

unsigned typed_character(const KeyPress& press) {
    if (press.control) return 0;
    if (press.key == Key::space) return ' ';
    if (press.key != Key::character) return 0;
    const bool capital = press.shift && press.character >= 'a' && press.character <= 'z';
    return press.character - (capital ? U'a' - U'A' : 0);
}

// Since version 1.87 Dear ImGui has functions instead of fields to write to.
#if IMGUI_VERSION_NUM >= 18700
void set_mouse(ImGuiIO& io, float x, float y, const bool (&buttons)[3], float wheel) {
    io.AddMousePosEvent(x, y);
    for (int button = 0; button < 3; ++button) io.AddMouseButtonEvent(button, buttons[button]);
    if (wheel != 0) io.AddMouseWheelEvent(0, wheel);
}

void set_key(ImGuiIO& io, ImGuiKey key, bool down) { io.AddKeyEvent(key, down); }

void set_modifiers(ImGuiIO& io, bool control, bool shift) {
#if IMGUI_VERSION_NUM >= 18900
    io.AddKeyEvent(ImGuiMod_Ctrl, control);
    io.AddKeyEvent(ImGuiMod_Shift, shift);
#else
    io.AddKeyEvent(ImGuiKey_ModCtrl, control);
    io.AddKeyEvent(ImGuiKey_ModShift, shift);
#endif
}

void set_up(ImGuiIO& io) { io.ConfigInputTrickleEventQueue = false; }  // all fed input belongs to one frame
#else
void set_mouse(ImGuiIO& io, float x, float y, const bool (&buttons)[3], float wheel) {
    io.MousePos = {x, y};
    for (int button = 0; button < 3; ++button) io.MouseDown[button] = buttons[button];
    io.MouseWheel = wheel;
}

void set_key(ImGuiIO& io, ImGuiKey key, bool down) { io.KeysDown[key] = down; }

void set_modifiers(ImGuiIO& io, bool control, bool shift) {
    io.KeyCtrl = control;
    io.KeyShift = shift;
}

void set_up(ImGuiIO& io) {
    for (int key = 0; key < ImGuiKey_COUNT; ++key) io.KeyMap[key] = key;
}
#endif

}  // namespace

FedInput::FedInput() { set_up(ImGui::GetIO()); }

void FedInput::feed(const Pointer& pointer, std::span<const KeyPress> keys) {
    ImGuiIO& io = ImGui::GetIO();
    const bool elsewhere = pointer.x < 0 || pointer.y < 0;
    set_mouse(io, elsewhere ? -FLT_MAX : pointer.x, elsewhere ? -FLT_MAX : pointer.y,
              {pointer.left, pointer.right, pointer.middle}, pointer.wheel);

    for (const ImGuiKey key : down_) set_key(io, key, false);
    down_.clear();
    bool control = false, shift = false;
    for (const KeyPress& press : keys) {
        control = control || press.control;
        shift = shift || press.shift;
        if (const ImGuiKey key = gui_key(press); key != no_key) down_.push_back(key);
        if (const unsigned typed = typed_character(press); typed != 0) io.AddInputCharacter(typed);
    }
    set_modifiers(io, control, shift);
    for (const ImGuiKey key : down_) set_key(io, key, true);
}

}  // namespace glassbox
