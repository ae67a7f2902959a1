#include "viewer/platform/fed_input.hpp"

#include <cfloat>
#include <utility>

namespace glassbox {
namespace {

constexpr auto no_key = ImGuiKey{};

// Only the letters that text fields use with Ctrl: undo, redo, cut, copy, paste, select all.
constexpr std::pair<char32_t, ImGuiKey> letter_keys[] = {{U'a', ImGuiKey_A}, {U'c', ImGuiKey_C}, {U'v', ImGuiKey_V},
                                                         {U'x', ImGuiKey_X}, {U'y', ImGuiKey_Y}, {U'z', ImGuiKey_Z}};
constexpr std::pair<Key, ImGuiKey> named_keys[] = {
    {Key::left, ImGuiKey_LeftArrow}, {Key::right, ImGuiKey_RightArrow},   {Key::up, ImGuiKey_UpArrow},
    {Key::down, ImGuiKey_DownArrow}, {Key::escape, ImGuiKey_Escape},      {Key::enter, ImGuiKey_Enter},
    {Key::space, ImGuiKey_Space},    {Key::home, ImGuiKey_Home},          {Key::end, ImGuiKey_End},
    {Key::page_up, ImGuiKey_PageUp}, {Key::page_down, ImGuiKey_PageDown},
};

/// Returns Dear ImGui's name of a key; none if it needs only the character that the key types.
ImGuiKey gui_key(const KeyPress& press) {
    const auto named = [](const auto& keys, auto wanted) {
        for (const auto& [ours, theirs] : keys)
            if (ours == wanted) return theirs;
        return no_key;
    };
    if (press.key != Key::character) return named(named_keys, press.key);
    return named(letter_keys, press.control ? press.character : U'\0');
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
