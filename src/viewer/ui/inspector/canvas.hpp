#pragma once
#include <string_view>

#include "viewer/ui/panels.hpp"

namespace glassbox {

/// A rectangle of the open window to draw into; clips what reaches beyond. The destructor ends the drawing.
class Canvas {
public:
    Canvas(const Frame& frame, ImVec2 size);
    ~Canvas();
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;

    const Palette& palette() const { return palette_; }
    ImDrawList& list() const { return *list_; }
    ImVec2 size() const { return size_; }
    float unit() const { return unit_; }  ///< the height of a line of text

    /// Returns a position on the screen; (0, 0) is the canvas's top left.
    ImVec2 at(float x, float y) const { return {corner_.x + x, corner_.y + y}; }

    void line(ImVec2 from, ImVec2 to, ImU32 color, float thickness = 1) const;
    void dashed(ImVec2 from, ImVec2 to, ImU32 color) const;
    void arrow(ImVec2 from, ImVec2 to, ImU32 color, float thickness = 2) const;
    /// The head of an arrow that ends at `tip`.
    void arrow_head(ImVec2 from, ImVec2 tip, ImU32 color) const;
    void dot(ImVec2 middle, ImU32 color, bool filled = true) const;
    void box(ImVec2 low, ImVec2 high, ImU32 fill) const;
    /// `anchor` is the position of `where` in the text's own box: (0, 0) its top left, (1, 1) its bottom right. The
    /// text is moved to stay inside.
    void text(ImVec2 where, ImVec2 anchor, ImU32 color, std::string_view text) const;
    float text_width(std::string_view text) const;

private:
    const Palette& palette_;
    ImDrawList* list_;
    ImVec2 corner_, size_;
    float unit_, pixel_;  ///< of a line's thickness
};

ImU32 to_color(Rgb color, int opacity = 255);

}  // namespace glassbox
