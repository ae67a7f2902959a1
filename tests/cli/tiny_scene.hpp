#pragma once

namespace glassbox::test {

/// Four pixels wide, three high; a red ball of radius 1 whose centre is 500 from the start of the ray in column 1 and
/// row 1 from below. The ray of column j and row i starts in (500, j, i) and runs towards −x, so it meets the ball
/// where (j − 1)² + (i − 1)² <= 1: a cross of five pixels, four of them tangent.
inline constexpr const char* tiny_scene = R"(
[image]
width = 4
height = 3
background = [1, 2, 3]
[[sphere]]
center = [0, 1, 1]
radius = 1
color = [255, 0, 0]
)";

}  // namespace glassbox::test
