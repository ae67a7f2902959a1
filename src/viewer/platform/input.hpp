#pragma once
#include <string>
#include <vector>

namespace glassbox {

/// A key that the interface uses; `character` is any key that types one.
enum class Key {
    character,
    left,
    right,
    up,
    down,
    escape,
    enter,
    space,
    home,
    end,
    page_up,
    page_down,
    f6,
};

/// A key that went down, or is held and repeats.
struct KeyPress {
    Key key = Key::character;
    char32_t character = 0;  ///< what it types, a letter in lower case: 'd', '?', '1'
    bool control = false;    ///< with Ctrl, or Command on a Mac
    bool shift = false;

    bool operator==(const KeyPress&) const = default;
};

/// The mouse, in the coordinates of the interface: from the top left, in pixels.
struct Pointer {
    float x = -1, y = -1;  ///< -1: elsewhere
    bool left = false, right = false, middle = false;
    float wheel = 0;  ///< notches turned since the last frame, away from you positive
};

/// What happened since the last frame, besides what Dear ImGui receives by itself.
struct Input {
    std::vector<KeyPress> keys;
    double time = 0;                     ///< seconds since the start
    std::vector<std::string> dropped{};  ///< files that were dropped on the window
};

}  // namespace glassbox
