#pragma once
#include "explain/timeline.hpp"
#include "viewer/ui/panels.hpp"

namespace glassbox {

// The parts of the steps page. Those that take only a frame need a timeline that is not empty, and state.step on it.

void draw_transport(const Frame& frame);                   ///< buttons, slider and speed
void draw_predict(const Frame& frame);                     ///< the question, and how the last one went
void draw_hidden(const Frame& frame);                      ///< that some steps are hidden, and a way out; else nothing
void draw_event_list(const Frame& frame, float height);    ///< the events around the current one
void draw_values(const Frame& frame, const Event& event);  ///< its numbers, which lead to where they come from

// What lies below, one of the panes. Each fills the open child.
void draw_source(const Frame& frame, const Event& event);   ///< the call stack, and the source
void draw_formula(const Frame& frame, const Event& event);  ///< what the source says of the formula
void draw_losses(const Frame& frame);                       ///< the steps that lose most
void draw_nudge(const Frame& frame);                        ///< the inputs of a test, and what flips

/// "Watch it trace", which needs no pinned pixel.
void draw_watch(const Frame& frame);
float watch_height(const Frame& frame);

/// The sign of a step, and its colour: ✗ something that failed, ✓ a condition that holds, "no" one that does not, ⚠ a
/// cancellation that is not to be guessed; else "".
struct Sign {
    const char* text;
    ImU32 color;
};
Sign sign_of(const Frame& frame, std::size_t step);

/// Continues on the same line, if there is room for this width.
void same_line_if_fits(float width);

}  // namespace glassbox
