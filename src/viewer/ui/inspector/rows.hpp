#pragma once
#include <span>
#include <utility>
#include <vector>

#include "viewer/model/story/inspector.hpp"
#include "viewer/ui/panels.hpp"

namespace glassbox {

/// Two items that belong together, one of the first pixel and one of the second; null if that pixel has none.
template <class T>
using Pair = std::pair<const T*, const T*>;

/// Pairs the items of two lists that have the same name, in the first one's order; then those that only the second one
/// has.
template <class T>
std::vector<Pair<T>> paired(std::span<const T> first, std::span<const T> second, const std::string T::*name) {
    std::vector<Pair<T>> pairs;
    const auto find = [&](std::span<const T> in, const std::string& wanted) -> const T* {
        for (const T& item : in)
            if (item.*name == wanted) return &item;
        return nullptr;
    };
    for (const T& item : first) pairs.emplace_back(&item, find(second, item.*name));
    for (const T& item : second)
        if (!find(first, item.*name)) pairs.emplace_back(nullptr, &item);
    return pairs;
}

/// Draws "✓ ", "✗ " or "? ", and leaves the cursor after it on the same line.
void draw_mark(const Palette& palette, story::Mark mark);

/// Draws a small square of a colour, and leaves the cursor after it on the same line.
void draw_swatch(const Palette& palette, Rgb color);

/// Whether there is too little room to show two pixels' numbers side by side.
bool one_below_the_other();

/// Draws the rows of one pixel; with `comparing` of two, with the differences marked.
void draw_rows(const Frame& frame, std::span<const Pair<InspectorRow>> rows, bool comparing);

}  // namespace glassbox
