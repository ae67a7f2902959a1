#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "scene/orientation.hpp"

namespace glassbox {

/// Cuts the inside of an outline (where its winding number is not 0) into triangles of its corners, in n log n. They
/// run counter-clockwise where the outline does. They fill the inside without overlap, none is flat, and an edge of the
/// outline is cut only at corners that touch it from inside. The outline may touch itself: visit a corner twice, or
/// follow an edge there and back. Returns nothing if two of its edges cross.
std::optional<std::vector<std::array<std::size_t, 3>>> cut_into_mountains(std::span<const Point2> outline);

}  // namespace glassbox
