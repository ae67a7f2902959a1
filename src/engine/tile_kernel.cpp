#include "engine/prefetch.hpp"
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
#include "engine/tile_boxes.inl"
#include "engine/tile_sphere.inl"
#include "engine/tile_triangles.inl"

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
        rays_ = tile_rays(grid, middle_);
        D_ = in_floats(rays_.D);
        const float nothing_yet = grid.pinhole ? 0 : -std::numeric_limits<float>::infinity();
        fill(no_surface, nothing_yet);
        tile_.leaves = 0;
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
        VisitStack<TileVisit> visits({0, -std::numeric_limits<float>::infinity(), all_parts});
        // A leaf is tested when the next one is reached, so that it has the time to come from memory.
        TileVisit leaf{Child::nothing, 0, all_parts};
        ChildrenMet met;
        while (!visits.is_empty() && !given_up_) {
            const TileVisit visit = visits.pop();
            if (visit.entry > t_max_) continue;
            if (Child::is_leaf(visit.child)) {
                if (leaf.child != Child::nothing) test(leaf);
                leaf = visit;
                continue;
            }
            const Node& node = hierarchy.nodes[visit.child];
            find_children_met(node, *seen, t_max_, met);
            for (std::uint32_t rest = met.which; rest != 0; rest &= rest - 1)
                prefetch(engine_, node.child[__builtin_ctz(rest)]);
            visits.push(met.which, [&](std::uint32_t i) {
                return TileVisit{node.child[i], met.entry[i], {met.seen_in[i]}};
            });
        }
        if (leaf.child != Child::nothing && !given_up_) test(leaf);
        if (given_up_) fill(not_told, 0);
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

    /// Tests a leaf's surfaces against the rays.
    HWY_ATTR void test(const TileVisit& leaf) {
        if (leaf.entry > t_max_) return;
        if (++tile_.leaves > most_leaves) {
            given_up_ = true;
            return;
        }
        if (Child::is_of_spheres(leaf.child)) {
            const auto [first, count] = engine_.hierarchy().sphere_leaves[Child::index(leaf.child)];
            for (std::uint32_t i = 0; i < count; ++i) test_sphere(engine_.hierarchy().surfaces[first + i]);
        } else {
            test_triangles(engine_.blocks()[Child::index(leaf.child)], leaf.seen_in);
        }
        if (!least_rose_) return;
        least_rose_ = false;
        least_key_ = *std::min_element(std::begin(least_keys_), std::end(least_keys_));
        t_max_ = beyond(t_of_key(least_key_));
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
            for (std::size_t i = 0; i < part_size; i += Floats::count()) {
                Best best = Best::load(*this, begin + i);
                const auto is = [&](const float* marks) HWY_ATTR { return Floats::load(marks + i) > 0.0f; };
                const Floats low = Floats::load(keys.low + i), high = Floats::load(keys.high + i);
                const auto live = is(keys.live) & (high >= best.low);
                best.take({live, live & is(keys.sure), low, high}, surface);
                best.store(*this, begin + i);
            }
            find_least_key(static_cast<std::size_t>(q));
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

    /// D² of all rays of a pinhole's view, for `missed_or_behind`.
    HWY_ATTR void find_squares() {
        const Vec3<Doubles> middle = broadcast(rays_.D.value), right = broadcast(rays_.D.right),
                            up = broadcast(rays_.D.up);
        for (std::size_t i = 0; i < tile_size; i += Doubles::count()) {
            const Vec3<Doubles> D =
                middle + load_as_doubles(offsets.right + i) * right + load_as_doubles(offsets.up + i) * up;
            store_as_floats(dot(D, D), squares_ + i);
        }
    }

    HWY_ATTR void test_triangles(const Block& block, const PartsOfTile& seen_in) {
        if (rays_.pinhole) test_triangles<true>(block, seen_in);
        else test_triangles<false>(block, seen_in);
    }

    template <bool pinhole>
    HWY_ATTR void test_triangles(const Block& block, const PartsOfTile& seen_in) {
        const RaysAtBlock at_block = rays_at(block, rays_);
        if (!at_block.are_within_floats()) {
            given_up_ = true;
            return;
        }
        const RaysInFloats<pinhole> seen(D_, at_block);
        const auto precise = [&](std::uint32_t at) {
            return precise_key(rays_, at_block, block, engine_.blocks().triangle(block, at));
        };
        Triangles triangles = set_up(seen, static_cast<float>(at_block.key_factor), TileErrors(rays_, at_block), block,
                                     least_key_, precise);
        if (triangles.left == 0) return;
        draw(triangles, block, seen_in);
        if (triangles.unoriented == 0) return;
        for (std::uint32_t rest = triangles.unoriented; rest != 0; rest &= rest - 1)
            triangles.turn_over(static_cast<std::size_t>(__builtin_ctz(rest)));
        triangles.left = triangles.unoriented;
        draw(triangles, block, seen_in);
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

    /// Tests the triangles that are left against the rays of some parts, where they may be hit before all that was met
    /// there. Which part they may be hit in nobody can foresee: so pairs of a triangle and a part are gathered first.
    HWY_ATTR void draw(const Triangles& triangles, const Block& block, const PartsOfTile& some) {
        for (std::size_t at = 0; at < fan_out; at += FanOfFloats::count()) {
            const GreatestInParts a(triangles.edge[0], at), b(triangles.edge[1], at), c(triangles.edge[2], at),
                key(triangles.key, at);
            const FanOfFloats key_error = FanOfFloats::load(triangles.key_error + at);
            Pairs pairs;
            for (int y = some.bottom(); y <= some.top(); ++y) {
                const FanOfFloats a_row = a.in_row(y), b_row = b.in_row(y), c_row = c.in_row(y),
                                  key_row = key.in_row(y) + key_error;
                for (int x = some.left(); x <= some.right(); ++x) {
                    const int part = y * parts_across + x;
                    const auto inside = min(min(a.in_part(a_row, x), b.in_part(b_row, x)), c.in_part(c_row, x));
                    const auto met = (inside >= 0.0f) & (key.in_part(key_row, x) >= least_keys_[part]);
                    pairs.add(part, (bits_of(met) << at) & triangles.left);
                    if (pairs.are_full()) draw(triangles, block, pairs);
                }
            }
            draw(triangles, block, pairs);
        }
    }

    /// Triangles and the parts in which they may be hit.
    struct Pairs {
        static constexpr int most = 64 / fan_out;
        std::uint64_t triangles = 0;  ///< eight bits for each part
        std::uint8_t part[most];
        int count = 0;  ///< of parts

        bool are_full() const { return count == most; }
        void add(int number, std::uint32_t which) {
            triangles |= std::uint64_t{which} << (count * fan_out);
            part[count] = static_cast<std::uint8_t>(number);
            count += which != 0;
        }
    };

    /// Tests them, and forgets them.
    HWY_INLINE HWY_ATTR void draw(const Triangles& triangles, const Block& block, Pairs& pairs) {
        for (std::uint64_t rest = pairs.triangles; rest != 0; rest &= rest - 1) {
            const auto pair = static_cast<std::size_t>(__builtin_ctzll(rest));
            draw(triangles, pair % fan_out, block, pairs.part[pair / fan_out]);
        }
        for (int i = 0; i < pairs.count; ++i) find_least_key(pairs.part[i]);
        pairs = {};
    }

    /// Tests a triangle against the rays of a part.
    HWY_INLINE HWY_ATTR void draw(const Triangles& triangles, std::size_t at, const Block& block, std::size_t part) {
        const Floats behind = grid_.pinhole ? std::numeric_limits<float>::infinity() : 0.0f;
        for (std::size_t i = part * part_size; i < (part + 1) * part_size; i += Floats::count()) {
            const Floats dj = Floats::load(offsets.right + i), di = Floats::load(offsets.up + i);
            const auto number = [&](const Linear& linear) HWY_ATTR {
                return multiply_add(di, linear.up[at], multiply_add(dj, linear.right[at], linear.value[at]));
            };
            const Floats a = number(triangles.edge[0]), b = number(triangles.edge[1]), c = number(triangles.edge[2]);
            const Floats innermost = min(min(a, b), c);
            const Floats key = number(triangles.key), key_error = triangles.key_error[at];
            const Floats low = key - key_error, high = key + key_error;
            Best best = Best::load(*this, i);
            const auto live = (innermost >= 0.0f) & (high >= best.low) & (low < behind);
            const auto sure = live & (high < behind) & (innermost > triangles.sure[at]);
            best.take({live, sure, low, high}, block.surface[at]);
            best.store(*this, i);
        }
    }

    HWY_INLINE HWY_ATTR void find_least_key(std::size_t part) {
        Floats least = std::numeric_limits<float>::infinity();
        for (std::size_t i = part * part_size; i < (part + 1) * part_size; i += Floats::count())
            least = min(least, Floats::load(key_low_ + i));
        const float key = least_of_all(least);
        least_rose_ |= (least_keys_[part] == least_key_) & (key > least_key_);
        least_keys_[part] = key;
    }

    const Engine& engine_;
    const Grid& grid_;
    Tile& tile_;
    alignas(64) float key_low_[tile_size], key_high_[tile_size];  ///< of what each ray has met; its key lies between
    glassbox::Ray<double> middle_;
    TileRays rays_;
    LinearVector<FanOfVectors> D_;                          ///< of those rays
    float least_keys_[parts], least_key_ = 0;               ///< of each part, and of all
    bool least_rose_ = false;                               ///< whether the last one is to be found anew
    float t_max_ = std::numeric_limits<float>::infinity();  ///< what all rays have met lies before it
    bool given_up_ = false;                                 ///< the rays are to be traced one by one
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
