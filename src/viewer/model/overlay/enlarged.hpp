#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace glassbox {

/// How many pixels a side a single one must be drawn with, to be at least three of the screen's at that zoom.
int side_to_be_seen(double zoom);

/// For each pixel of a picture, row by row, which pixel is drawn there when each with a rank above 0 is drawn as a
/// square of `side` pixels about it, those of higher ranks over those of lower ones: itself where none reaches.
/// `ranks` has `width` numbers a row. Takes as long whatever the ranks are, and only a little longer for a larger side.
std::vector<std::uint32_t> enlarged(std::span<const std::uint8_t> ranks, std::size_t width, int side);

}  // namespace glassbox
