#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include <triangle.hpp>

namespace glassbox {

/// A triangle that stands for others.
struct CoarserTriangle {
    Triangle<double> triangle;
    std::size_t stands_for;  ///< the first of them, an index
};

/// Returns fewer triangles of about the same shape, at most `most`: corners that lie in one cell of a grid become one,
/// their mean, and triangles without three different ones are gone (Rossignac and Borrel, "Multi-resolution 3D
/// approximations", 1993). Triangles much smaller than the gaps between them may all be gone.
std::vector<CoarserTriangle> coarser(std::span<const Triangle<double>> triangles, std::size_t most);

}  // namespace glassbox
