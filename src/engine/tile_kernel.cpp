#include "engine/sight.hpp"
#include "engine/tile.hpp"
#include "engine/tile_rays.hpp"
#include "engine/visits.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/tile_kernel.cpp"
#include <hwy/foreach_target.h>
// Highway's own order: the header comes after the loop over targets.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox::engine::HWY_NAMESPACE {

#include "engine/vectors.inl"

/// A tile's rays from the middle of it: where each is, in pixels to the right and upwards.
struct Offsets {
    alignas(64) float right[tile_size], up[tile_size];

    constexpr Offsets() : right(), up() {
        for (std::uint32_t y = 0; y < tile_side; ++y)
            for (std::uint32_t x = 0; x < tile_side; ++x) {
                right[place_in_tile(x, y)] = static_cast<float>(x) - (tile_side - 1) * 0.5f;
                up[place_in_tile(x, y)] = static_cast<float>(y) - (tile_side - 1) * 0.5f;
            }
    }
};
inline constexpr Offsets offsets;
/// From a tile's middle to that of its first part, and from the middle of a part to its rays.
inline constexpr float to_first_part = (tile_side - part_side) * 0.5f, half_part = (part_side - 1) * 0.5f;

#include "engine/sphere_roots.inl"
#include "engine/tile_sphere.inl"
#include "engine/tile_triangles.inl"

/// What is linear in x, in the corner of each child's box where it is least, or most: see Bounds.
HWY_INLINE HWY_ATTR FanOfFloats least_in_boxes(const Bounds& b, const Node& node, std::size_t at) {
    FanOfFloats sum = b.low;
    for (int k = 0; k < 3; ++k)
        sum = multiply_add(b.w[k], FanOfFloats::load(node.side[b.w[k] > 0 ? Node::lo : Node::hi][k] + at), sum);
    return sum;
}
HWY_INLINE HWY_ATTR FanOfFloats most_in_boxes(const Bounds& b, const Node& node, std::size_t at) {
    FanOfFloats sum = b.high;
    for (int k = 0; k < 3; ++k)
        sum = multiply_add(b.w[k], FanOfFloats::load(node.side[b.w[k] > 0 ? Node::hi : Node::lo][k] + at), sum);
    return sum;
}

/// How far from the tile's middle a box begins and ends, in pixels to the right or upwards.
struct Extent {
    FanOfFloats from, to;
};

/// In a pinhole's view what is linear in x is t times that, and t ranges from the box's nearest corner to its farthest.
/// A box around the rays' start lies everywhere.
HWY_INLINE HWY_ATTR Extent in_perspective(const Extent& times_t, const FanOfFloats& t_least,
                                          const FanOfFloats& t_most) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const FanOfFloats by_near = 1.0f / t_least, by_far = 1.0f / t_most;
    const auto around_start = t_least < 0x1p-100f;
    return {select(around_start, -infinity, min(times_t.from * by_near, times_t.from * by_far)),
            select(around_start, infinity, max(times_t.to * by_near, times_t.to * by_far))};
}

/// Is one of the tile's columns, or rows, between the two? They are 0 to 15 pixels from the first; what rounding may
/// move is allowed for twice, for the ray and for the box.
HWY_INLINE HWY_ATTR Mask<FanOfFloats::Tag> holds_a_ray(const Extent& extent, double off_by) {
    constexpr auto first = static_cast<float>(half_tile);
    const auto slack = static_cast<float>(2 * off_by);
    const FanOfFloats from = max(extent.from + (first - slack), 0.0f);
    const FanOfFloats to = min(extent.to + (first + slack), tile_side - 1.0f);
    return ceil(from) <= floor(to);
}

/// The children whose boxes are not within the engine's near reach: of these `Bounds` say nothing.
HWY_INLINE HWY_ATTR std::uint32_t beyond_reach(const Node& node, float near_reach, std::size_t at) {
    FanOfFloats most = 0.0f;
    for (int k = 0; k < 3; ++k)
        most = max(
            most, max(-FanOfFloats::load(node.side[Node::lo][k] + at), FanOfFloats::load(node.side[Node::hi][k] + at)));
    return bits_of((most > near_reach) & (most < std::numeric_limits<float>::infinity()));
}

/// The children whose boxes some ray of the tile may meet, not beyond t_max; and the least t in each.
HWY_INLINE HWY_ATTR std::uint32_t children_met(const Node& node, const Sight& sight, float t_max,
                                               float (&entries)[fan_out]) {
    std::uint32_t met = 0;
    for (std::size_t at = 0; at < fan_out; at += FanOfFloats::count()) {
        const FanOfFloats t_least = least_in_boxes(sight.t, node, at), t_most = most_in_boxes(sight.t, node, at);
        const auto extent = [&](const Bounds& b) HWY_ATTR {
            const Extent seen{least_in_boxes(b, node, at), most_in_boxes(b, node, at)};
            return sight.pinhole ? in_perspective(seen, t_least, t_most) : seen;
        };
        const auto ahead = (t_most >= 0.0f) & (t_least <= t_max);
        // Of boxes around the rays' start the smallest first: what is in them is nearest.
        select(t_least < 0.0f, 1.0f / t_least, t_least).store(entries + at);
        const auto some_ray =
            holds_a_ray(extent(sight.right), sight.off_by) & holds_a_ray(extent(sight.up), sight.off_by);
        met |= bits_of(ahead & some_ray) << at;
        if (!sight.some_beyond) continue;
        for (std::uint32_t beyond = beyond_reach(node, sight.near_reach, at) << at; beyond != 0; beyond &= beyond - 1) {
            const auto child = static_cast<std::uint32_t>(__builtin_ctz(beyond));
            met |= 1u << child;
            entries[child] = -std::numeric_limits<float>::infinity();
        }
    }
    return met;
}

/// Traces one tile.
class TileKernel {
    using Floats = Numbers<hn::ScalableTag<float>>;
    using Words = Numbers<hn::RebindToUnsigned<Floats::Tag>>;

public:
    HWY_ATTR TileKernel(const Engine& engine, const Grid& grid, int column, int row, Tile& tile)
        : engine_(engine), grid_(grid), tile_(tile) {
        const double j = column + half_tile, i = row + half_tile;
        const glassbox::Vec3<double> at = grid.corner + j * grid.right + i * grid.up;
        middle_.P = grid.pinhole ? grid.eye : at;
        middle_.D = grid.pinhole ? at : grid.direction;
        const float nothing_yet = grid.pinhole ? 0 : -std::numeric_limits<float>::infinity();
        fill(no_surface, nothing_yet);
    }

    HWY_ATTR void operator()() {
        find_keys();
        const auto key_of_t = static_cast<float>(grid_.key_of_t);
        for (std::size_t i = 0; i < tile_size; i += Floats::count()) {
            const Floats key = 0.5f * Floats::load(key_low_ + i) + 0.5f * Floats::load(key_high_ + i);
            (grid_.pinhole ? key_of_t / key : -key * (1 / key_of_t)).store(tile_.t + i);
        }
    }

private:
    HWY_ATTR void find_keys() {
        const Hierarchy& hierarchy = engine_.hierarchy();
        if (!engine_.loose().empty()) return fill(not_told, 0);  // they are tested in doubles, ray by ray
        if (hierarchy.nodes.empty()) return;
        const std::optional<Sight> seen = sight(engine_, grid_, {middle_.P - engine_.middle(), middle_.D});
        if (!seen) return fill(not_told, 0);
        float t_max = std::numeric_limits<float>::infinity();
        Visits visits({0, -std::numeric_limits<float>::infinity()});
        while (!visits.is_empty()) {
            const auto [child, entry] = visits.pop();
            if (entry > t_max) continue;
            if (Child::is_leaf(child)) {
                if (test(child)) t_max = beyond(t_of_key(least_key_));
                if (given_up_) return fill(not_told, 0);
                continue;
            }
            const Node& node = hierarchy.nodes[child];
            alignas(32) float entries[fan_out];
            const std::uint32_t met = children_met(node, *seen, t_max, entries);
            visits.push(node, met, entries);
        }
    }

    double t_of_key(float key) const {
        const auto k = static_cast<double>(key);
        return grid_.pinhole ? grid_.key_of_t / k : -k / grid_.key_of_t;
    }

    HWY_ATTR void fill(std::uint32_t surface, float key) {
        for (std::size_t i = 0; i < tile_size; i += Floats::count()) {
            Floats(key).store(key_low_ + i);
            Floats(key).store(key_high_ + i);
            Words(surface).store(tile_.surface + i);
        }
        least_key_ = key;
        std::fill(std::begin(least_keys_), std::end(least_keys_), key);
    }

    /// Tests a leaf's surfaces against all rays; true if all rays have now met something nearer than before.
    HWY_ATTR bool test(std::uint32_t leaf) {
        if (Child::is_of_spheres(leaf)) {
            const auto [first, count] = engine_.hierarchy().sphere_leaves[Child::index(leaf)];
            for (std::uint32_t i = 0; i < count; ++i) test_sphere(engine_.hierarchy().surfaces[first + i]);
        } else {
            test_triangles(Child::index(leaf));
        }
        const float before = least_key_;
        least_key_ = *std::min_element(std::begin(least_keys_), std::end(least_keys_));
        return least_key_ > before;
    }

    /// What the rays of some lanes may meet: whether they may, whether they do for sure, and between which keys.
    struct Found {
        Mask<Floats::Tag> live, sure;
        Floats low, high;
    };

    /// What the rays of some lanes have met so far, as the kernel keeps it.
    struct Best {
        Floats low, high;
        Words surface;

        static HWY_ATTR Best load(const TileKernel& of, std::size_t i) {
            return {Floats::load(of.key_low_ + i), Floats::load(of.key_high_ + i), Words::load(of.tile_.surface + i)};
        }
        HWY_ATTR void store(TileKernel& to, std::size_t i) const {
            low.store(to.key_low_ + i);
            high.store(to.key_high_ + i);
            surface.store(to.tile_.surface + i);
        }

        /// Takes what was found where it is nearer for sure; where nobody can tell, says so.
        HWY_ATTR void take(const Found& found, std::uint32_t number) {
            const Words::Tag w;
            const auto nearer = found.sure & (found.low > high);
            low = select(found.sure, max(low, found.low), low);
            high = select(nearer, found.high, select(found.live, max(high, found.high), high));
            const Mask<Words::Tag> unsure_here = hn::RebindMask(w, found.live.m),
                                   this_one = hn::RebindMask(w, nearer.m);
            surface = select(this_one, number, select(unsure_here, not_told, surface));
        }
    };

    /// Part by part, those in which it may be the nearest so far.
    HWY_ATTR void test_sphere(std::uint32_t surface) {
        const glassbox::Sphere<double>& sphere = engine_.scaled_spheres()[surface];
        std::optional<QuickSphere> quick;
        if (grid_.pinhole) {
            if (!longest_) {
                find_squares();
                longest_ = longest_direction(grid_, middle_);
            }
            quick = quick_sphere(grid_, middle_, sphere, *longest_);
        }
        for (int q = 0; q < parts; ++q) {
            const auto begin = static_cast<std::size_t>(q * part_size);
            if (quick && !may_be_nearer(*quick, begin)) continue;
            const SphereKeys keys = sphere_keys(grid_, middle_, sphere, begin);
            Floats least = std::numeric_limits<float>::infinity();
            for (std::size_t i = 0; i < part_size; i += Floats::count()) {
                Best best = Best::load(*this, begin + i);
                const auto is = [&](const float* marks) HWY_ATTR { return Floats::load(marks + i) > 0.0f; };
                const Floats low = Floats::load(keys.low + i), high = Floats::load(keys.high + i);
                const auto live = is(keys.live) & (high >= best.low);
                best.take({live, live & is(keys.sure), low, high}, surface);
                best.store(*this, begin + i);
                least = min(least, best.low);
            }
            least_keys_[q] = least_of_all(least);
        }
    }

    /// Whether, of the rays of the part that begins there, some may meet a sphere before all that they have met.
    HWY_ATTR bool may_be_nearer(const QuickSphere& sphere, std::size_t begin) const {
        for (std::size_t i = begin; i < begin + part_size; i += Floats::count()) {
            const Floats dj = Floats::load(offsets.right + i), di = Floats::load(offsets.up + i);
            const Floats D2 = Floats::load(squares_ + i), key = Floats::load(key_low_ + i);
            if (!none(!missed_or_behind(sphere, dj, di, D2, key))) return true;
        }
        return false;
    }

    /// D² of all rays, for `missed_or_behind`.
    HWY_ATTR void find_squares() {
        const Vec3<Doubles> middle = broadcast(grid_.direction_scale * middle_.D);
        const Vec3<Doubles> right = broadcast(grid_.direction_scale * grid_.right),
                            up = broadcast(grid_.direction_scale * grid_.up);
        for (std::size_t i = 0; i < tile_size; i += Doubles::count()) {
            const Vec3<Doubles> D =
                middle + load_as_doubles(offsets.right + i) * right + load_as_doubles(offsets.up + i) * up;
            store_as_floats(dot(D, D), squares_ + i);
        }
    }

    HWY_ATTR void test_triangles(std::uint32_t number) {
        const Block& block = engine_.blocks()[number];
        const TileRays rays = tile_rays(grid_, middle_, block);
        if (!rays.are_within_floats()) {
            given_up_ = true;
            return;
        }
        Triangles triangles = set_up(rays, block, least_key_, [&](std::uint32_t at) {
            return precise_key(rays, block, engine_.blocks().triangle(number, at), middle_.P);
        });
        if (triangles.left == 0) return;
        std::uint32_t in_part[parts];
        sort_out(triangles, in_part);
        for (int q = 0; q < parts; ++q)
            if (in_part[q] != 0) draw(triangles, in_part[q], block, q);
        for (std::uint32_t rest = triangles.unoriented; rest != 0; rest &= rest - 1) {
            triangles.turn_over(static_cast<std::size_t>(__builtin_ctz(rest)));
            for (int q = 0; q < parts; ++q) draw(triangles, rest & (~rest + 1), block, q);
        }
    }

    /// What is linear in the tile where it is greatest in a part: to be asked row by row, and then along the row.
    struct GreatestInParts {
        FanOfFloats at_first, right, up;

        HWY_INLINE HWY_ATTR GreatestInParts(const Linear& linear, std::size_t at)
            : right(FanOfFloats::load(linear.right + at)), up(FanOfFloats::load(linear.up + at)) {
            at_first = FanOfFloats::load(linear.value + at) + (abs(right) + abs(up)) * half_part;
        }
        HWY_INLINE HWY_ATTR FanOfFloats in_row(int y) const {
            return multiply_add(up, static_cast<float>(y * part_side) - to_first_part, at_first);
        }
        HWY_INLINE HWY_ATTR FanOfFloats in_part(const FanOfFloats& row, int x) const {
            return multiply_add(right, static_cast<float>(x * part_side) - to_first_part, row);
        }
    };

    /// Which of the triangles rays of a part may hit, before all that was met there: by the greatest numbers there.
    HWY_ATTR void sort_out(const Triangles& triangles, std::uint32_t (&in_part)[parts]) const {
        std::fill(std::begin(in_part), std::end(in_part), 0u);
        for (std::size_t at = 0; at < fan_out; at += FanOfFloats::count()) {
            const GreatestInParts a(triangles.edge[0], at), b(triangles.edge[1], at), c(triangles.edge[2], at),
                key(triangles.key, at);
            const FanOfFloats key_error = FanOfFloats::load(triangles.key_error + at);
            for (int y = 0; y < parts_across; ++y) {
                const FanOfFloats a_row = a.in_row(y), b_row = b.in_row(y), c_row = c.in_row(y),
                                  key_row = key.in_row(y) + key_error;
                for (int x = 0; x < parts_across; ++x) {
                    const int part = y * parts_across + x;
                    const auto inside = min(min(a.in_part(a_row, x), b.in_part(b_row, x)), c.in_part(c_row, x));
                    const auto met = (inside >= 0.0f) & (key.in_part(key_row, x) >= least_keys_[part]);
                    in_part[part] |= bits_of(met) << at;
                }
            }
        }
        for (std::uint32_t& some : in_part) some &= triangles.left;
    }

    /// Tests triangles against the rays of a part.
    HWY_ATTR void draw(const Triangles& triangles, std::uint32_t which, const Block& block, int part) {
        const Floats behind = grid_.pinhole ? std::numeric_limits<float>::infinity() : 0.0f;
        Floats least = std::numeric_limits<float>::infinity();
        const auto begin = static_cast<std::size_t>(part * part_size);
        for (std::size_t i = begin; i < begin + part_size; i += Floats::count()) {
            const Floats dj = Floats::load(offsets.right + i), di = Floats::load(offsets.up + i);
            Best best = Best::load(*this, i);
            for (std::uint32_t rest = which; rest != 0; rest &= rest - 1) {
                const auto at = static_cast<std::size_t>(__builtin_ctz(rest));
                const auto number = [&](const Linear& linear) HWY_ATTR {
                    return multiply_add(di, linear.up[at], multiply_add(dj, linear.right[at], linear.value[at]));
                };
                const Floats a = number(triangles.edge[0]), b = number(triangles.edge[1]),
                             c = number(triangles.edge[2]);
                const Floats innermost = min(min(a, b), c);
                const auto possible = innermost >= 0.0f;
                if (none(possible)) continue;
                const Floats key = number(triangles.key), key_error = triangles.key_error[at];
                const Floats low = key - key_error, high = key + key_error;
                const auto live = possible & (high >= best.low) & (low < behind);
                const auto sure = live & (high < behind) & (innermost > triangles.sure[at]);
                best.take({live, sure, low, high}, block.surface[at]);
            }
            best.store(*this, i);
            least = min(least, best.low);
        }
        least_keys_[part] = least_of_all(least);
    }

    const Engine& engine_;
    const Grid& grid_;
    Tile& tile_;
    alignas(64) float key_low_[tile_size], key_high_[tile_size];  ///< of what each ray has met; its key lies between
    glassbox::Ray<double> middle_;
    float least_key_ = 0, least_keys_[parts];
    bool given_up_ = false;  ///< the rays are to be traced one by one
    alignas(64) float squares_[tile_size];
    std::optional<double> longest_;  ///< direction; found, and the squares, with the first sphere
};

HWY_ATTR void TraceTile(const Engine& engine, const Grid& grid, int column, int row, Tile& tile) {
    TileKernel(engine, grid, column, row, tile)();
}

}  // namespace glassbox::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glassbox::engine {

HWY_EXPORT(TraceTile);

void trace_tile(const Engine& engine, const Grid& grid, int column, int row, Tile& tile) {
    HWY_DYNAMIC_DISPATCH(TraceTile)(engine, grid, column, row, tile);
}

}  // namespace glassbox::engine
#endif
