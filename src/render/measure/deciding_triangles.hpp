#pragma once
#include <span>
#include <vector>

#include <triangle.hpp>

#include "engine/function_ref.hpp"
#include "engine/side_bounds.hpp"
#include "render/measure/of_sides.hpp"
#include "render/options.hpp"
#include "render/view.hpp"

namespace glassbox {

/// A rectangle of a picture's pixels, as it is counted from the top left; the ends are not in it.
struct PixelBlock {
    int x0, x1, y0, y1;
};

/// Finds, for each ray of a picture, the few triangles that matter to what is asked about all of them: bounds prove of
/// the others that they cannot be the least. A block of pixels is asked about at once, then each of its quarters about
/// those that are left, and so on.
class DecidingTriangles {
public:
    /// The triangles in the order in which they are tested, their numbers those of the scalar that tests them.
    DecidingTriangles(std::span<const Triangle<double>> triangles, Scalar scalar, OfSides asked);

    /// Is given the triangles that matter to a pixel's ray, by number, in ascending order.
    using Take = engine::FunctionRef<void(int x, int y, std::span<const std::uint32_t>)>;

    /// Calls `take` once for each pixel of the block.
    void for_each_pixel(const View& view, int height, const PixelBlock& pixels, Take take) const;

private:
    struct Splitting;

    std::vector<engine::EightTriangles> triangles_;
    Scalar scalar_;
    OfSides asked_;
};

}  // namespace glassbox
