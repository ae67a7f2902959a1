#include "engine/side_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/side_bounds.cpp"
#include <hwy/foreach_target.h>
// Highway's own order: the header comes after the loop over targets.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox::engine::HWY_NAMESPACE {

#include "engine/vectors.inl"

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The core's scalar Magnitude, several at once: a formula evaluated in it sums the sizes of its terms.
struct Sizes {
    Doubles size;

    friend HWY_ATTR Sizes operator+(const Sizes& a, const Sizes& b) { return {a.size + b.size}; }
    friend HWY_ATTR Sizes operator-(const Sizes& a, const Sizes& b) { return {a.size + b.size}; }
    friend HWY_ATTR Sizes operator*(const Sizes& a, const Sizes& b) { return {a.size * b.size}; }
};

/// The sizes of middle + x right + y up along each axis, −1 ≤ x, y ≤ 1, if they are off by `error`.
struct SizesInPatch {
    glassbox::Vec3<double> least, most;

    SizesInPatch(const glassbox::Vec3<double>& middle, const glassbox::Vec3<double>& right,
                 const glassbox::Vec3<double>& up, double error) {
        const auto along = [&](double glassbox::Vec3<double>::*axis) {
            const double size = std::abs(middle.*axis);
            const double about = (std::abs(right.*axis) + std::abs(up.*axis) + error) * (1 + 0x1p-40);
            least.*axis = std::max(size * (1 - 0x1p-50) - about, 0.0);
            most.*axis = size + about;
        };
        along(&glassbox::Vec3<double>::x);
        along(&glassbox::Vec3<double>::y);
        along(&glassbox::Vec3<double>::z);
    }
};

inline HWY_ATTR Vec3<Sizes> broadcast_sizes(const glassbox::Vec3<double>& v) {
    return {{Doubles(v.x)}, {Doubles(v.y)}, {Doubles(v.z)}};
}

/// What the bounds of a patch ask of it again and again.
struct Patch {
    bool starts_move, directions_move;
    Vec3<Doubles> P, D, P_right, P_up, D_right, D_up;
    Vec3<Sizes> least_D, most_D;
    Vec3<Doubles> moved;  ///< how far from P rays start, at most
    Doubles rounding, underflow, farthest;
    Doubles error0, error1, error2;  ///< of a side product, times m⁰, m¹ and m²: see PatchSides

    explicit HWY_ATTR Patch(const RayPatch& from)
        : starts_move(!(from.P_right == glassbox::Vec3<double>{} && from.P_up == glassbox::Vec3<double>{})),
          directions_move(!(from.D_right == glassbox::Vec3<double>{} && from.D_up == glassbox::Vec3<double>{})),
          P(broadcast(from.P)),
          D(broadcast(from.D)),
          P_right(broadcast(from.P_right)),
          P_up(broadcast(from.P_up)),
          D_right(broadcast(from.D_right)),
          D_up(broadcast(from.D_up)) {
        const SizesInPatch direction(from.D, from.D_right, from.D_up, from.D_error);
        const auto& [per_S, its_underflow, its_farthest, longest] = from.rounding;
        least_D = broadcast_sizes(direction.least);
        most_D = broadcast_sizes(direction.most);
        moved = broadcast(SizesInPatch({}, from.P_right, from.P_up, from.P_error).most);
        const double D_size = direction.most.x + direction.most.y + direction.most.z;
        rounding = Doubles(per_S);
        underflow = Doubles(its_underflow);
        farthest = Doubles(D_size < longest && is_finite(from.P) ? its_farthest : 0);
        error0 = Doubles(2 * from.P_error * from.P_error * D_size + its_underflow * (1 + D_size));
        error1 = Doubles(4 * from.P_error * D_size);
        error2 = Doubles(6 * from.D_error + 0x1p-100 * D_size);
    }
};

/// A corner as seen from P; and the sizes of its coordinates as seen from any ray's start.
struct SeenCorner {
    Vec3<Doubles> seen;
    Vec3<Sizes> least, most;

    HWY_ATTR SeenCorner(const Patch& patch, const double (&of)[3][fan_out], std::size_t at)
        : seen(load(of, at) - patch.P) {
        const auto below = [](const Doubles& x, const Doubles& by)
                               HWY_ATTR { return Sizes{max(abs(x) * (1 - 0x1p-50) - by, Doubles(0.0))}; };
        const auto above = [](const Doubles& x, const Doubles& by) HWY_ATTR { return Sizes{abs(x) + by}; };
        const auto& [x, y, z] = patch.moved;
        least = {below(seen.x, x), below(seen.y, y), below(seen.z, z)};
        most = {above(seen.x, x), above(seen.y, y), above(seen.z, z)};
    }

    HWY_ATTR Doubles largest() const { return max(max(most.x.size, most.y.size), most.z.size); }
};

/// The side product s of an edge for all rays of the patch: within `spread` of `middle`; and between which S is.
struct PatchSide {
    Doubles middle, spread, least_S, most_S;

    /// s changes along a step (p, d) of start and direction by d·(B × A) + p·((B − A) × D): see Grid.
    HWY_ATTR PatchSide(const Patch& patch, const SeenCorner& A, const SeenCorner& B)
        : least_S(side(patch.least_D, A.least, B.least).size), most_S(side(patch.most_D, A.most, B.most).size) {
        const Vec3<Doubles> V = cross(B.seen, A.seen);
        middle = dot(patch.D, V);
        spread = Doubles(0.0);
        if (patch.directions_move) spread = abs(dot(patch.D_right, V)) + abs(dot(patch.D_up, V));
        if (patch.starts_move) {
            const Vec3<Doubles> W = cross(B.seen - A.seen, patch.D);
            spread = spread + abs(dot(patch.P_right, W)) + abs(dot(patch.P_up, W));
        }
    }
};

/// A number of each of several triangles: between which it lies anywhere in the patch.
struct Between {
    Doubles least, most;
};

/// The three side products of several triangles. With m the largest coordinate of their corners as seen from the rays,
/// D's error moves s by 6m² of it at most, B × A being 2m² along each axis, and P's error δ by |D|(4mδ + 2δ²); what is
/// rounded moves it by `rounding` S. Where s surely exceeds 2⁻¹⁰⁰ m²|D| + `underflow` (1 + |D|), so does S, and what
/// underflows is less than 2⁻²⁰ of what is rounded: that much is added to the error.
struct PatchSides {
    PatchSide a, b, c;
    Mask<Doubles::Tag> known;
    Doubles error;  ///< besides that in proportion to S

    static HWY_ATTR PatchSides of(const Patch& patch, const EightTriangles& block, std::size_t at) {
        const SeenCorner A(patch, block.A, at), B(patch, block.B, at), C(patch, block.C, at);
        const Doubles m = max(max(A.largest(), B.largest()), C.largest());
        return {PatchSide(patch, B, C), PatchSide(patch, C, A), PatchSide(patch, A, B), m < patch.farthest,
                m * (m * patch.error2 + patch.error1) + patch.error0};
    }

    HWY_ATTR Doubles error_of(const Patch& patch, const PatchSide& s) const {
        return patch.rounding * s.most_S + error;
    }
};

HWY_INLINE HWY_ATTR Between least_side(const Patch& patch, const PatchSides& sides) {
    const auto size = [&](const PatchSide& s) HWY_ATTR {
        const Doubles off = s.spread + sides.error_of(patch, s);
        return Between{abs(s.middle) - off, abs(s.middle) + off};
    };
    const Between a = size(sides.a), b = size(sides.b), c = size(sides.c);
    return {select(sides.known, min(min(a.least, b.least), c.least), Doubles(-infinity)),
            select(sides.known, min(min(a.most, b.most), c.most), Doubles(infinity))};
}

/// The certainty of three numbers, l ≤ … ≤ h, is max(l, −h, min(−l, h)), and never below 0. To bound s/S from below, s
/// is divided by the greatest S, which is right where it is positive; where it is negative, so is its term, and does
/// not count. From above likewise, by the least S.
HWY_INLINE HWY_ATTR Between least_certainty(const Patch& patch, const PatchSides& sides) {
    struct Ratio {
        Doubles least, least_of_negative, most, most_of_negative;
    };
    const auto ratio = [&](const PatchSide& s) HWY_ATTR {
        const Doubles off = s.spread + sides.error_of(patch, s);
        const Doubles per_most_S = 1.0 / (s.most_S + sides.error), per_least_S = 1.0 / s.least_S;
        return Ratio{(s.middle - off) * per_most_S, (-s.middle - off) * per_most_S, (s.middle + off) * per_least_S,
                     (-s.middle + off) * per_least_S};
    };
    const Ratio a = ratio(sides.a), b = ratio(sides.b), c = ratio(sides.c);
    const auto certainty =
        [](const Doubles& all_positive, const Doubles& all_negative, const Doubles& positive, const Doubles& negative)
            HWY_ATTR { return max(max(all_positive, all_negative), min(positive, negative)); };
    const Doubles least = certainty(
        min(min(a.least, b.least), c.least), min(min(a.least_of_negative, b.least_of_negative), c.least_of_negative),
        max(max(a.least, b.least), c.least), max(max(a.least_of_negative, b.least_of_negative), c.least_of_negative));
    const Doubles most = certainty(
        min(min(a.most, b.most), c.most), min(min(a.most_of_negative, b.most_of_negative), c.most_of_negative),
        max(max(a.most, b.most), c.most), max(max(a.most_of_negative, b.most_of_negative), c.most_of_negative));
    const auto bounded = sides.known & (min(min(sides.a.least_S, sides.b.least_S), sides.c.least_S) > patch.underflow);
    return {select(sides.known, least, Doubles(-infinity)), select(bounded, most, Doubles(infinity))};
}

template <class Bound>
HWY_INLINE HWY_ATTR double bound_all(const RayPatch& rays, std::span<const EightTriangles> blocks, double* at_least,
                                     const Bound& bound) {
    const Patch patch(rays);
    Doubles most(infinity);
    for (const EightTriangles& block : blocks)
        for (std::size_t at = 0; at < fan_out; at += Doubles::count()) {
            const Between its = bound(patch, PatchSides::of(patch, block, at));
            hn::StoreU(its.least.v, Doubles::Tag(), at_least);
            at_least += Doubles::count();
            most = min(most, its.most);
        }
    // Not least_of_all: with emulated vectors that is never infinity.
    alignas(64) double lanes[fan_out];
    most.store(lanes);
    return *std::min_element(lanes, lanes + Doubles::count());
}

HWY_ATTR double LeastSides(const RayPatch& patch, std::span<const EightTriangles> blocks, double* at_least) {
    return bound_all(patch, blocks, at_least,
                     [](const Patch& p, const PatchSides& sides) HWY_ATTR { return least_side(p, sides); });
}

HWY_ATTR double LeastCertainties(const RayPatch& patch, std::span<const EightTriangles> blocks, double* at_least) {
    return bound_all(patch, blocks, at_least,
                     [](const Patch& p, const PatchSides& sides) HWY_ATTR { return least_certainty(p, sides); });
}

}  // namespace glassbox::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glassbox::engine {

HWY_EXPORT(LeastSides);
HWY_EXPORT(LeastCertainties);

double least_sides(const RayPatch& patch, std::span<const EightTriangles> blocks, std::vector<double>& at_least) {
    at_least.resize(blocks.size() * fan_out);
    return HWY_DYNAMIC_DISPATCH(LeastSides)(patch, blocks, at_least.data());
}

double least_certainties(const RayPatch& patch, std::span<const EightTriangles> blocks, std::vector<double>& at_least) {
    at_least.resize(blocks.size() * fan_out);
    return HWY_DYNAMIC_DISPATCH(LeastCertainties)(patch, blocks, at_least.data());
}

namespace {

/// Puts triangles into blocks, one after the other.
class Filling {
public:
    explicit Filling(std::vector<EightTriangles>& blocks) : blocks_(blocks) { blocks.clear(); }

    void add(const Triangle<double>& triangle, std::uint32_t number) {
        if (blocks_.empty() || blocks_.back().count == fan_out) blocks_.emplace_back();
        EightTriangles& block = blocks_.back();
        put(block, block.count, triangle);
        block.surface[block.count++] = number;
    }

    /// Places that are left over repeat the last triangle.
    void finish() {
        if (blocks_.empty()) return;
        EightTriangles& block = blocks_.back();
        const Triangle<double> last = block.triangle(block.count - 1);
        for (std::uint32_t at = block.count; at < fan_out; ++at) put(block, at, last);
    }

private:
    static void put(EightTriangles& block, std::uint32_t at, const Triangle<double>& triangle) {
        const auto& [A, B, C] = triangle;
        put(block.A, at, A);
        put(block.B, at, B);
        put(block.C, at, C);
    }
    static void put(double (&to)[3][fan_out], std::uint32_t at, const Vec3<double>& corner) {
        to[0][at] = corner.x;
        to[1][at] = corner.y;
        to[2][at] = corner.z;
    }

    std::vector<EightTriangles>& blocks_;
};

}  // namespace

std::vector<EightTriangles> in_blocks(std::span<const Triangle<double>> triangles) {
    std::vector<EightTriangles> blocks;
    Filling filling(blocks);
    for (std::uint32_t number = 0; const Triangle<double>& triangle : triangles) filling.add(triangle, number++);
    filling.finish();
    return blocks;
}

void keep_up_to(double limit, std::span<const EightTriangles> blocks, std::span<const double> at_least,
                std::vector<EightTriangles>& kept) {
    Filling filling(kept);
    for (std::size_t first = 0; const EightTriangles& block : blocks) {
        for (std::uint32_t at = 0; at < block.count; ++at)
            if (at_least[first + at] <= limit) filling.add(block.triangle(at), block.surface[at]);
        first += fan_out;
    }
    filling.finish();
}

}  // namespace glassbox::engine
#endif
