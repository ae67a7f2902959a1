#include "render/measure/deciding_triangles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "numerics/as_float.hpp"
#include "numerics/vector_size.hpp"

namespace glassbox {

namespace {

/// A patch of rays as a view has them, which the scalar then rounds.
class PatchOfView {
public:
    PatchOfView(Scalar scalar, const PixelBlock& pixels, int height)
        : is_float_(scalar == Scalar::float_), pixels_(pixels), height_(height) {}

    engine::RayPatch operator()(const FromEye& view) const {
        engine::RayPatch patch = about_middle(view);
        patch.D_right = to_the_right() * view.plane.right;
        patch.D_up = upwards() * view.plane.up;
        patch.D_error = error_in(view.plane);
        if (is_float_) patch.P = as_float(patch.P);
        return patch;
    }

    engine::RayPatch operator()(const Parallel<double>& view) const {
        engine::RayPatch patch = about_middle(view);
        patch.P_right = to_the_right() * view.plane.right;
        patch.P_up = upwards() * view.plane.up;
        patch.P_error = error_in(view.plane);
        if (is_float_) {
            patch.P_error += 0x1p-23 * terms_of(view.plane);
            patch.D = as_float(patch.D);
        }
        return patch;
    }

private:
    double to_the_right() const { return (pixels_.x1 - pixels_.x0 - 1) / 2.0; }
    double upwards() const { return (pixels_.y1 - pixels_.y0 - 1) / 2.0; }

    template <class OneView>
    engine::RayPatch about_middle(const OneView& view) const {
        const Ray<double> middle =
            pixel_ray(view, (pixels_.x0 + pixels_.x1 - 1) / 2.0, height_ - 1 - (pixels_.y0 + pixels_.y1 - 1) / 2.0);
        engine::RayPatch patch{middle.P, middle.D};
        patch.rounding = is_float_ ? engine::rounding_of_floats : engine::rounding_of_doubles;
        return patch;
    }

    /// The sizes of the terms that a pixel's point of the plane is the sum of, together, are no more than that.
    double terms_of(const ViewingPlane<double>& plane) const {
        return sum_of_sizes(plane.corner) + pixels_.x1 * sum_of_sizes(plane.right) + height_ * sum_of_sizes(plane.up);
    }

    /// A pixel's point is rounded four times, the middle's likewise, and the steps from there once; the bounds' own
    /// rounding takes 18 units of it at most. Below all that, the scalar may underflow.
    double error_in(const ViewingPlane<double>& plane) const {
        return 32 * 0x1p-53 * terms_of(plane) + (is_float_ ? 0x1p-149 : 0x1p-1074);
    }

    bool is_float_;
    PixelBlock pixels_;
    int height_;
};

}  // namespace

/// One block's way down to its pixels.
struct DecidingTriangles::Splitting {
    const DecidingTriangles& all;
    const View& view;
    int height;
    Take take;
    std::array<std::vector<engine::EightTriangles>, 34> kept =
        {};  ///< by depth: a picture's side has less than 2³² pixels
    std::vector<double> at_least = {};
    std::vector<std::uint32_t> numbers = {};

    void split(const PixelBlock& pixels, const std::vector<engine::EightTriangles>& triangles, std::size_t depth) {
        std::vector<engine::EightTriangles>& left = kept[depth];
        const double limit = least_of_all(std::visit(PatchOfView(all.scalar_, pixels, height), view), triangles);
        engine::keep_up_to(limit, triangles, at_least, left);
        const auto [x0, x1, y0, y1] = pixels;
        if (x1 - x0 == 1 && y1 - y0 == 1) return give(x0, y0, left);
        const int x = x0 + (x1 - x0 + 1) / 2, y = y0 + (y1 - y0 + 1) / 2;
        for (const auto& [from_y, to_y] : {std::pair(y0, y), std::pair(y, y1)})
            for (const auto& [from_x, to_x] : {std::pair(x0, x), std::pair(x, x1)})
                if (from_x < to_x && from_y < to_y) split({from_x, to_x, from_y, to_y}, left, depth + 1);
    }

    /// What matters has a number up to that. log10, which `margin` is told in, may round two numbers that hardly differ
    /// in the wrong order: of certainties those that are nearly the least matter, too. So do all that decide nothing,
    /// zeros among them: their certainty is below SideRounding::per_S, and the limit never is.
    double least_of_all(const engine::RayPatch& patch, std::span<const engine::EightTriangles> triangles) {
        if (all.asked_ == OfSides::least) return engine::least_sides(patch, triangles, at_least);
        return engine::least_certainties(patch, triangles, at_least) * (1 + 0x1p-7);
    }

    void give(int x, int y, std::span<const engine::EightTriangles> triangles) {
        numbers.clear();
        for (const engine::EightTriangles& block : triangles)
            numbers.insert(numbers.end(), block.surface, block.surface + block.count);
        take(x, y, numbers);
    }
};

DecidingTriangles::DecidingTriangles(std::span<const Triangle<double>> triangles, Scalar scalar, OfSides asked)
    : triangles_(engine::in_blocks(triangles)), scalar_(scalar), asked_(asked) {}

void DecidingTriangles::for_each_pixel(const View& view, int height, const PixelBlock& pixels, Take take) const {
    Splitting splitting{*this, view, height, take};
    if (asked_ != OfSides::all) return splitting.split(pixels, triangles_, 0);
    for (int y = pixels.y0; y < pixels.y1; ++y)
        for (int x = pixels.x0; x < pixels.x1; ++x) splitting.give(x, y, triangles_);
}

}  // namespace glassbox
