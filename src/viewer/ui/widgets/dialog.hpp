#pragma once
#include <cstddef>
#include <functional>
#include <string>

#include "viewer/ui/panels.hpp"

namespace glassbox {

/// Draws a window in the middle, so many letters wide and high, as far as there is room; as high as its content for a
/// height of 0. `content()` draws into it. Its cross clears `shown`.
void draw_dialog(const char* title, bool& shown, float width, float height, const std::function<void()>& content);

/// Draws a field, as wide as there is room, for a text that takes the keyboard whenever nothing else has it; `renewed`
/// counts how often the text was set by something else than typing; Tab makes it `completed()`, if that is given.
/// Returns the text.
std::string typed_text(const char* hint, const std::string& text, int renewed,
                       const std::function<std::string()>& completed = {});

/// Draws a row that can be chosen by `content()`, with a sign before the chosen one, which scrolls into sight when
/// another one than before is chosen. `number` tells the rows of a window apart. Returns whether it was clicked.
bool draw_row(const Frame& frame, std::size_t number, bool chosen, const std::function<void()>& content);

/// Draws a text in lines that are broken between words, where a word is not longer than a line.
void draw_lines(const std::string& text, float room);

/// Draws a text in the colour that says that something failed, wrapped.
void draw_failure(const Frame& frame, const std::string& text);

/// The height of a text that is wrapped in the room that is left.
float wrapped_height(const char* text);

}  // namespace glassbox
