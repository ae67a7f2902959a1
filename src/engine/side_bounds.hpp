#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <ray.hpp>
#include <triangle.hpp>

#include "engine/hierarchy.hpp"

// What can be said of a triangle's side products for a whole patch of a picture's rays at once: enough to pass over
// nearly all triangles where only the one counts whose side product, or whose certainty, is the least.

namespace glassbox::engine {

/// Up to eight triangles, coordinate by coordinate, as vectors read them. Places that are left over repeat the last.
struct alignas(64) EightTriangles {
    double A[3][fan_out], B[3][fan_out], C[3][fan_out];
    std::uint32_t surface[fan_out];
    std::uint32_t count;

    Triangle<double> triangle(std::uint32_t at) const {
        return {{A[0][at], A[1][at], A[2][at]}, {B[0][at], B[1][at], B[2][at]}, {C[0][at], C[1][at], C[2][at]}};
    }
};

/// How exactly a scalar computes side products.
struct SideRounding {
    /// What one may be off, over the sum S of its terms' sizes, with what the bounds are off themselves. Each term is
    /// rounded seven times, see filter::sides_error, and D perhaps once more. Here, in doubles, s is off by 7 units,
    /// what it changes to the right and upwards by 6 each, and sums of the three by 4.
    double per_S;
    double underflow;          ///< underflow does not matter to a side product above (1 + |D|) times this
    double farthest, longest;  ///< corners nearer than that, as seen from P, and shorter directions cannot overflow

    static constexpr SideRounding with_unit(double unit, double underflow, double farthest, double longest) {
        return {10 * unit + 32 * 0x1p-53, underflow, farthest, longest};
    }
};

/// Of scalars that hold all doubles, too: nothing is computed here more exactly than in doubles.
inline constexpr SideRounding rounding_of_doubles = SideRounding::with_unit(0x1p-53, 0x1p-900, 0x1p250, 0x1p200);
inline constexpr SideRounding rounding_of_floats = SideRounding::with_unit(0x1p-24, 0x1p-80, 0x1p30, 0x1p30);

/// The rays of a patch of a picture, and how exactly they lie where they should: each starts at P + x P_right + y P_up
/// and runs along D + x D_right + y D_up, −1 ≤ x, y ≤ 1, but for errors. As in Grid, all start in one point, or all run
/// one way: P_right and P_up are 0, or D_right and D_up.
struct RayPatch {
    Vec3<double> P, D;
    Vec3<double> P_right = {}, P_up = {}, D_right = {}, D_up = {};
    /// How far rays are off, along each axis, and besides: 16 units of P_right and P_up, and 2 of D, which the bounds
    /// round. That the scalar rounds D's numbers is in `rounding`, but for underflow.
    double P_error = 0, D_error = 0;
    SideRounding rounding = rounding_of_doubles;
};

/// For the triangles of all blocks, in this order, fills in what their least side product, by size, is at least
/// anywhere in the patch, as the scalar computes it; −∞ where nothing is known. Returns what it is at most, for the
/// triangle where that is the least: ∞ where nothing is known of any.
double least_sides(const RayPatch& patch, std::span<const EightTriangles> blocks, std::vector<double>& at_least);

/// The same of a triangle's least certain deciding side product over S: of a hit, the least of the three; of a miss,
/// the lesser of the greatest positive and the greatest negative one. The most is never less than `per_S`.
double least_certainties(const RayPatch& patch, std::span<const EightTriangles> blocks, std::vector<double>& at_least);

/// Triangles in blocks, in the order given; `surface` numbers them from 0.
std::vector<EightTriangles> in_blocks(std::span<const Triangle<double>> triangles);

/// Fills `kept` with those of the triangles whose number in the list is `limit` or less, in the same order.
void keep_up_to(double limit, std::span<const EightTriangles> blocks, std::span<const double> at_least,
                std::vector<EightTriangles>& kept);

}  // namespace glassbox::engine
