#include "engine/sight.hpp"
#include "engine/tile.hpp"
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
        for (int y = 0; y < tile_side; ++y)
            for (int x = 0; x < tile_side; ++x) {
                right[place_in_tile(x, y)] = static_cast<float>(x) - (tile_side - 1) * 0.5f;
                up[place_in_tile(x, y)] = static_cast<float>(y) - (tile_side - 1) * 0.5f;
            }
    }
};
inline constexpr Offsets offsets;
inline constexpr double half_tile = (tile_side - 1) * 0.5;
/// From a tile's middle to that of a quarter, and from there to its rays.
inline constexpr float to_quarter = quarter_side * 0.5f, half_quarter = (quarter_side - 1) * 0.5f;
inline constexpr int quarters = 4;

/// The children whose boxes some ray of the tile may meet, not beyond `until`; and the least t in each.
HWY_ATTR std::uint32_t children_met(const Node& node, const Sight& sight, float until, float (&entries)[fan_out]) {
    const hn::CappedTag<float, fan_out> d;
    const auto zero = hn::Zero(d), infinite = hn::Set(d, std::numeric_limits<float>::infinity());
    std::uint32_t met = 0;
    for (std::size_t at = 0; at < fan_out; at += hn::Lanes(d)) {
        // In the corner of the box where it is least, and where it is most.
        const auto least = [&](const Bounds& b) HWY_ATTR {
            auto sum = hn::Set(d, b.low);
            for (int k = 0; k < 3; ++k)
                sum = hn::MulAdd(hn::Set(d, b.w[k]), hn::Load(d, (b.w[k] > 0 ? node.lo : node.hi)[k] + at), sum);
            return sum;
        };
        const auto most = [&](const Bounds& b) HWY_ATTR {
            auto sum = hn::Set(d, b.high);
            for (int k = 0; k < 3; ++k)
                sum = hn::MulAdd(hn::Set(d, b.w[k]), hn::Load(d, (b.w[k] > 0 ? node.hi : node.lo)[k] + at), sum);
            return sum;
        };
        const auto t_least = least(sight.t), t_most = most(sight.t);
        const auto around_start = hn::Lt(t_least, hn::Set(d, 0x1p-100f));
        const auto one = hn::Set(d, 1.0f), by_near = hn::Div(one, t_least), by_far = hn::Div(one, t_most);
        // Is one of the tile's rays between the box's ends? They are 0 to 7 pixels from the first.
        const auto holds_a_ray = [&](const Bounds& b) HWY_ATTR {
            auto from = least(b), to = most(b);
            if (sight.pinhole) {
                from = hn::Min(hn::Mul(from, by_near), hn::Mul(from, by_far));
                to = hn::Max(hn::Mul(to, by_near), hn::Mul(to, by_far));
                from = hn::IfThenElse(around_start, hn::Neg(infinite), from);
                to = hn::IfThenElse(around_start, infinite, to);
            }
            constexpr auto slack = static_cast<float>(2 * off_by), first = static_cast<float>(half_tile);
            from = hn::Max(hn::Add(from, hn::Set(d, first - slack)), zero);
            to = hn::Min(hn::Add(to, hn::Set(d, first + slack)), hn::Set(d, tile_side - 1.0f));
            return hn::Le(hn::Ceil(from), hn::Floor(to));
        };
        const auto ahead = hn::And(hn::Ge(t_most, zero), hn::Le(t_least, hn::Set(d, until)));
        hn::StoreU(t_least, d, entries + at);
        met |= bits_of(d, hn::And(ahead, hn::And(holds_a_ray(sight.right), holds_a_ray(sight.up)))) << at;
    }
    return met;
}

/// What a tile's rays need to know of eight triangles. An edge's number at a ray is value + dj·right + di·up, not
/// negative if the triangle may be hit, and above `sure` if it is.
struct Linear {
    alignas(64) float value[fan_out], right[fan_out], up[fan_out];
};
struct Triangles {
    Linear edge[3];
    alignas(64) float sure[3][fan_out];
    Linear key;
    alignas(64) float key_error[fan_out];
};

/// Traces one tile.
class TileKernel {
    using Floats = hn::ScalableTag<float>;
    using Words = hn::RebindToUnsigned<Floats>;

public:
    HWY_ATTR TileKernel(const Engine& engine, const Grid& grid, int column, int row, Tile& tile)
        : engine_(engine), grid_(grid), tile_(tile) {
        const double j = column + half_tile, i = row + half_tile;
        const glassbox::Vec3<double> at = grid.corner + j * grid.right + i * grid.up;
        start_ = grid.pinhole ? grid.eye : at;
        direction_ = grid.pinhole ? at : grid.direction;
        const float nothing_yet = grid.pinhole ? 0 : -std::numeric_limits<float>::infinity();
        fill(no_surface, nothing_yet);
    }

    HWY_ATTR void operator()() {
        const Hierarchy& hierarchy = engine_.hierarchy();
        if (!engine_.loose().empty()) return give_up();
        if (hierarchy.nodes.empty()) return;
        const std::optional<Sight> seen = sight(engine_, grid_, {start_ - engine_.middle(), direction_});
        if (!seen) return give_up();
        float until = std::numeric_limits<float>::infinity();
        Visits visits({0, -std::numeric_limits<float>::infinity()});
        while (!visits.is_empty()) {
            const auto [child, at] = visits.pop();
            if (at > until) continue;
            if (Child::is_leaf(child)) {
                if (test(child)) until = beyond(t_of_key(grid_, least_key_));
                continue;
            }
            const Node& node = hierarchy.nodes[child];
            alignas(32) float entries[fan_out];
            const std::uint32_t met = children_met(node, *seen, until, entries);
            visits.push(node, met, entries);
        }
    }

private:
    HWY_ATTR void fill(std::uint32_t surface, float key) {
        const Floats f;
        const Words w;
        for (std::size_t i = 0; i < tile_size; i += hn::Lanes(f)) {
            hn::Store(hn::Set(f, key), f, tile_.key_low + i);
            hn::Store(hn::Set(f, key), f, tile_.key_high + i);
            hn::Store(hn::Set(w, surface), w, tile_.surface + i);
        }
        least_key_ = key;
        std::fill(std::begin(least_keys_), std::end(least_keys_), key);
    }

    void give_up() { fill(not_told, 0); }

    /// Tests a leaf's surfaces against all rays; true if all rays have now met something nearer than before.
    HWY_ATTR bool test(std::uint32_t leaf) {
        if (Child::is_of_spheres(leaf)) {
            const auto [first, count] = engine_.hierarchy().sphere_leaves[Child::index(leaf)];
            for (std::uint32_t i = 0; i < count; ++i) test_sphere(engine_.hierarchy().surfaces[first + i]);
        } else {
            test_triangles(engine_.blocks()[Child::index(leaf)]);
        }
        const float before = least_key_;
        least_key_ = std::min(std::min(least_keys_[0], least_keys_[1]), std::min(least_keys_[2], least_keys_[3]));
        return least_key_ > before;
    }

    /// What the rays of some lanes may meet: whether they may, whether they do for sure, and how near.
    template <class Mask, class V>
    struct Found {
        Mask live, sure;
        V low, high;
    };

    /// Takes what was found for the best so far where it is nearer for sure; where nobody can tell, says so.
    template <class Mask, class V, class W>
    HWY_ATTR static void take(const Found<Mask, V>& found, std::uint32_t surface, V& best_low, V& best_high, W& best) {
        const Words w;
        const auto nearer = hn::And(found.sure, hn::Gt(found.low, best_high));
        best_low = hn::IfThenElse(found.sure, hn::Max(best_low, found.low), best_low);
        best_high =
            hn::IfThenElse(nearer, found.high, hn::IfThenElse(found.live, hn::Max(best_high, found.high), best_high));
        best = hn::IfThenElse(hn::RebindMask(w, found.live), hn::Set(w, not_told), best);
        best = hn::IfThenElse(hn::RebindMask(w, nearer), hn::Set(w, surface), best);
    }

    /// Tests a sphere against all rays, by their doubles.
    ///
    /// With v = P − c the ray meets it where Δ = (v·D)² − D²(v² − r²) ≥ 0, and from outside, v² > r², first at
    /// t = (−v·D − √Δ)/D², if v·D < 0. Rounding is off by at most 40u D²(v² + r²) for Δ (see filter.hpp), by 8u(v² +
    /// r²) for v² − r², by 8u|v||D| for v·D, and by 8u relatively for D². A ray that is off by ε changes Δ by at most
    /// 4ε(|D| + ε)(v² + r²) or 4ε D²(|v| + ε), v·D by ε|v| or ε|D|, D² by 3ε|D| or not at all, v² − r² by 3ε(|v| + ε):
    /// a sphere can be smaller, and nearer, than what a ray's start is off. Where −v·D and √Δ
    /// cancel, 8u|v||D| once more. What underflows is below 2⁻¹⁰⁷⁰ a product: where v² or r² could be lost to it,
    /// 2⁻¹⁰⁰⁰ hides v² − r² and 2⁻⁹⁰⁰ hides Δ, D being ordinary. From inside, and where nothing is sure, it is not
    /// told.
    HWY_ATTR void test_sphere(std::uint32_t surface) {
        const Doubles::Tag d;
        const hn::Rebind<float, Doubles::Tag> f;
        const glassbox::Sphere<double>& sphere = engine_.spheres()[surface];
        const Doubles r(sphere.r), r2 = r * r, zero(0);
        const Doubles off_D(grid_.pinhole ? grid_.ray_error : 0), off_P(grid_.pinhole ? 0 : grid_.ray_error);
        const Doubles u(0x1p-53), one(1), key_of_t(grid_.key_of_t);
        alignas(64) float low[tile_size], high[tile_size], live[tile_size], sure[tile_size];
        for (std::size_t i = 0; i < tile_size; i += hn::Lanes(d)) {
            const Doubles dj = hn::PromoteTo(d, hn::Load(f, offsets.right + i));
            const Doubles di = hn::PromoteTo(d, hn::Load(f, offsets.up + i));
            const auto step = [&](double x, double y) HWY_ATTR { return dj * Doubles(x) + di * Doubles(y); };
            const Vec3<Doubles> steps = {step(grid_.right.x, grid_.up.x), step(grid_.right.y, grid_.up.y),
                                         step(grid_.right.z, grid_.up.z)};
            const Vec3<Doubles> D = grid_.pinhole ? broadcast(direction_) + steps : broadcast(direction_);
            const Vec3<Doubles> from = broadcast(start_ - sphere.c);
            const Vec3<Doubles> v = grid_.pinhole ? from : from + steps;
            const Doubles D2 = dot(D, D), v2 = dot(v, v), b = dot(v, D), power = v2 - r2;
            const Doubles size_D = hn::Sqrt(D2.v), size_v = hn::Sqrt(v2.v), size = v2 + r2;
            const Doubles far = size_v + off_P;
            const Doubles delta = b * b - D2 * power;
            const Doubles delta_error = Doubles(48) * u * D2 * size +
                                        Doubles(5) * (off_D * (size_D + off_D) * size + off_P * D2 * far) +
                                        Doubles(0x1p-900);
            const Doubles b_error = Doubles(24) * u * size_v * size_D + Doubles(2) * (off_D * size_v + off_P * size_D);
            const Doubles power_error = Doubles(16) * u * size + Doubles(4) * off_P * far + Doubles(0x1p-1000);
            const Doubles root_least = hn::Sqrt(max(delta - delta_error, zero).v);
            const Doubles root_most = hn::Sqrt(max(delta + delta_error, zero).v);
            const auto outside = hn::And(hn::Gt(power.v, power_error.v), hn::Lt(b.v, (-b_error).v));
            const auto behind = hn::And(hn::Gt(power.v, power_error.v), hn::Gt(b.v, b_error.v));
            const auto missed = hn::Or(behind, hn::Lt(delta.v, (-delta_error).v));
            const Doubles slack = Doubles(0x1p-40) + Doubles(4) * off_D * Doubles(hn::Div(one.v, size_D.v));
            const Doubles t_low = Doubles(hn::Div((-b - b_error - root_most).v, D2.v)) * (one - slack);
            const Doubles t_high = Doubles(hn::Div((b_error - b - root_least).v, D2.v)) * (one + slack);
            const auto is_sure = hn::And(hn::And(outside, hn::Gt(delta.v, delta_error.v)), hn::Gt(t_low.v, zero.v));
            // To floats, and outwards: a larger key is nearer.
            const Doubles wide(1 + 0x1p-20), narrow(1 - 0x1p-20);
            const Doubles nearest =
                grid_.pinhole ? Doubles(hn::Div((key_of_t * wide).v, t_low.v)) : -(key_of_t * t_low * narrow);
            const Doubles farthest =
                grid_.pinhole ? Doubles(hn::Div((key_of_t * narrow).v, t_high.v)) : -(key_of_t * t_high * wide);
            const auto infinite = hn::Set(d, std::numeric_limits<double>::infinity());
            const auto mark = [&](auto mask) HWY_ATTR { return Doubles(hn::IfThenElseZero(mask, one.v)); };
            store(Doubles(hn::IfThenElse(is_sure, nearest.v, infinite)), high + i);
            store(Doubles(hn::IfThenElse(is_sure, farthest.v, hn::Neg(infinite))), low + i);
            store(mark(hn::Not(missed)), live + i);
            store(mark(hn::AndNot(missed, is_sure)), sure + i);
        }
        const Floats floats;
        const Words w;
        for (int q = 0; q < quarters; ++q) {
            auto least = hn::Set(floats, std::numeric_limits<float>::infinity());
            const auto begin = static_cast<std::size_t>(q * quarter_size);
            for (std::size_t i = begin; i < begin + quarter_size; i += hn::Lanes(floats)) {
                auto best_low = hn::Load(floats, tile_.key_low + i), best_high = hn::Load(floats, tile_.key_high + i);
                auto best = hn::Load(w, tile_.surface + i);
                const auto is = [&](const float* marks)
                                    HWY_ATTR { return hn::Gt(hn::Load(floats, marks + i), hn::Zero(floats)); };
                const auto sphere_low = hn::Load(floats, low + i), sphere_high = hn::Load(floats, high + i);
                const auto may = hn::And(is(live), hn::Ge(sphere_high, best_low));
                const Found<decltype(may), decltype(best_low)> found{may, hn::And(may, is(sure)), sphere_low,
                                                                     sphere_high};
                take(found, surface, best_low, best_high, best);
                hn::Store(best_low, floats, tile_.key_low + i);
                hn::Store(best_high, floats, tile_.key_high + i);
                hn::Store(best, w, tile_.surface + i);
                least = hn::Min(least, best_low);
            }
            least_keys_[q] = hn::GetLane(hn::MinOfLanes(floats, least));
        }
    }

    /// Tests a block's triangles against all rays.
    HWY_ATTR void test_triangles(const Block& block) {
        Triangles triangles;
        std::uint32_t unoriented = 0;
        const std::uint32_t left = set_up(block, triangles, unoriented) & ((1u << block.count) - 1);
        if (left == 0) return;
        std::uint32_t in_quarter[quarters];
        sort_out(triangles, left, in_quarter);
        for (int q = 0; q < quarters; ++q)
            if (in_quarter[q] != 0) draw(triangles, in_quarter[q], block, q);
        for (unoriented &= left; unoriented != 0; unoriented &= unoriented - 1) {
            turn_over(triangles, static_cast<std::size_t>(__builtin_ctz(unoriented)));
            for (int q = 0; q < quarters; ++q) draw(triangles, unoriented & (~unoriented + 1), block, q);
        }
    }

    /// Which of the triangles rays of a quarter may hit, before all that was met there: by the greatest numbers there.
    HWY_ATTR void sort_out(const Triangles& triangles, std::uint32_t left,
                           std::uint32_t (&in_quarter)[quarters]) const {
        const hn::CappedTag<float, fan_out> f;
        std::fill(std::begin(in_quarter), std::end(in_quarter), 0u);
        for (std::size_t at = 0; at < fan_out; at += hn::Lanes(f)) {
            const auto greatest = [&](const Linear& linear, int q) HWY_ATTR {
                const auto right = hn::Load(f, linear.right + at), up = hn::Load(f, linear.up + at);
                const auto right2 = hn::Mul(right, hn::Set(f, to_quarter)), up2 = hn::Mul(up, hn::Set(f, to_quarter));
                const auto value = hn::Load(f, linear.value + at);
                const auto spread = hn::Mul(hn::Add(hn::Abs(right), hn::Abs(up)), hn::Set(f, half_quarter));
                const auto across = q % 2 == 0 ? hn::Sub(value, right2) : hn::Add(value, right2);
                return hn::Add(q / 2 == 0 ? hn::Sub(across, up2) : hn::Add(across, up2), spread);
            };
            for (int q = 0; q < quarters; ++q) {
                auto met = hn::Ge(hn::Add(greatest(triangles.key, q), hn::Load(f, triangles.key_error + at)),
                                  hn::Set(f, least_keys_[q]));
                for (const Linear& edge : triangles.edge) met = hn::And(met, hn::Ge(greatest(edge, q), hn::Zero(f)));
                in_quarter[q] |= bits_of(f, met) << at;
            }
        }
        for (std::uint32_t& some : in_quarter) some &= left;
    }

    /// A number that is linear within the tile, in doubles.
    struct Line {
        Doubles value, right, up;

        /// The most that it differs from its value.
        HWY_ATTR Doubles spread() const { return Doubles(half_tile) * (abs(right) + abs(up)); }
    };

    HWY_ATTR static void store(const Line& line, std::size_t at, Linear& to) {
        store(line.value, to.value + at);
        store(line.right, to.right + at);
        store(line.up, to.up + at);
    }
    HWY_ATTR static void store(const Doubles& numbers, float* to) {
        const hn::Rebind<float, Doubles::Tag> f;
        hn::Store(hn::DemoteTo(f, numbers.v), f, to);
    }
    HWY_ATTR static Line times(const Doubles& factor, const Line& line) {
        return {factor * line.value, factor * line.right, factor * line.up};
    }

    /// The largest coordinate of a vertex as seen from any of the tile's rays, or more.
    double farthest_vertex(const Block& block) const {
        const glassbox::Vec3<double> P = start_ - engine_.middle();
        const double at[3] = {P.x, P.y, P.z};
        double most = 0;
        for (int k = 0; k < 3; ++k)
            most = std::max({most, static_cast<double>(block.hi[k]) - at[k], at[k] - static_cast<double>(block.lo[k])});
        return most * (1 + 0x1p-40) + static_cast<double>(engine_.around().reach()) * 0x1p-40;
    }

    /// What the rays need to know of the triangles; those that some ray may hit, before all that was met, a bit each.
    ///
    /// The bounds, with E = m(m side1 + side2) of Grid for the doubles:
    /// - a side product in floats: 8 roundings of 2⁻²⁴ at most, relatively to |value| + 3.5(|right| + |up|), and E;
    /// - V = |A B C|: F = m²(m volume1 + volume2);
    /// - the sum of the side products: 4E;
    /// - the key: of a quotient n/d with errors N and M < 2⁻¹²|d|, (N + |n/d| M)/(|d| − M), and 12 roundings in floats.
    /// All are made larger by 2⁻¹⁰ of them for their own rounding, and by 2⁻¹¹⁰ for underflow.
    HWY_ATTR std::uint32_t set_up(const Block& block, Triangles& result, std::uint32_t& unoriented) const {
        const Doubles::Tag d;
        const Vec3<Doubles> P = broadcast(start_), D = broadcast(grid_.direction_scale * direction_);
        const double scale = grid_.pinhole ? grid_.direction_scale : 1;
        const Vec3<Doubles> right = broadcast(scale * grid_.right), up = broadcast(scale * grid_.up);
        const Doubles larger(1 + 0x1p-10), tiny(0x1p-110), float_error(0x1p-24), one(1);
        const double m = farthest_vertex(block);
        const Doubles E(m * (m * grid_.side1 + grid_.side2)), F(m * m * (m * grid_.volume1 + grid_.volume2));
        std::uint32_t left = 0;
        for (std::size_t at = 0; at < fan_out; at += hn::Lanes(d)) {
            const Vec3<Doubles> A = load(block.A, at) - P, B = load(block.B, at) - P, C = load(block.C, at) - P;
            const Vec3<Doubles> a = cross(C, B), b = cross(A, C), c = cross(B, A), all = a + b + c;
            const auto edge = [&](const Vec3<Doubles>& moment, const Vec3<Doubles>& from, const Vec3<Doubles>& to)
                                  HWY_ATTR -> Line {
                if (grid_.pinhole) return {dot(D, moment), dot(right, moment), dot(up, moment)};
                const Vec3<Doubles> turned = cross(to - from, D);
                return {dot(D, moment), dot(right, turned), dot(up, turned)};
            };
            Line edges[3] = {edge(a, B, C), edge(b, C, A), edge(c, A, B)};
            const Doubles volume = dot(A, a), sum = edges[0].value + edges[1].value + edges[2].value;

            // t = V/sum; its key is 1/t or −t.
            const Doubles key_scale(grid_.key_scale);
            const Doubles under = grid_.pinhole ? volume : sum,
                          under_error = (grid_.pinhole ? F : Doubles(4) * E) * larger;
            const Doubles over_error = (grid_.pinhole ? Doubles(4) * E : F) * key_scale;
            const auto sum_of = [&](auto part) HWY_ATTR { return part(edges[0]) + part(edges[1]) + part(edges[2]); };
            const Line over =
                grid_.pinhole
                    ? Line{key_scale * sum, key_scale * sum_of([](const Line& l) HWY_ATTR { return l.right; }),
                           key_scale * sum_of([](const Line& l) HWY_ATTR { return l.up; })}
                    : Line{key_scale * (-volume), key_scale * dot(right, all), key_scale * dot(up, all)};
            const Doubles inverse = hn::Div(one.v, under.v);
            const Doubles doubt = abs(inverse) * under_error;
            const auto oriented = hn::Lt(doubt.v, hn::Set(d, 0x1p-12));
            const Line key = times(inverse, over);
            const Doubles key_most = abs(key.value) + key.spread();
            const Doubles key_error =
                (abs(inverse) * over_error + key_most * (doubt + Doubles(12) * float_error)) * larger + tiny;

            // Where the sign of the denominator is sure the side products must have it, too. Where it is not, they may
            // have either, and what is possible is not told: such triangles are seen edge-on, or from their own plane.
            const Doubles sign = hn::CopySign(one.v, under.v);
            auto met = hn::Le(hn::Zero(d), hn::Zero(d));
            for (int k = 0; k < 3; ++k) {
                const Doubles error =
                    (E + Doubles(8) * float_error * (abs(edges[k].value) + edges[k].spread())) * larger + tiny;
                edges[k] = times(sign, edges[k]);
                edges[k].value = edges[k].value + error;
                met = hn::And(met, hn::Ge((edges[k].value + edges[k].spread()).v, hn::Zero(d)));
                store(edges[k], at, result.edge[k]);
                store((error + error) * larger, result.sure[k] + at);
            }
            met = hn::And(
                met, hn::Ge((key.value + key.spread() + key_error).v, hn::Set(d, static_cast<double>(least_key_))));
            if (!grid_.pinhole) met = hn::And(met, hn::Lt((key.value - key.spread() - key_error).v, hn::Zero(d)));
            store(key, at, result.key);
            store(key_error, result.key_error + at);
            unoriented |= bits_of(d, hn::Not(oriented)) << at;
            left |= bits_of(d, met) << at;
        }
        for (std::uint32_t rest = unoriented; rest != 0; rest &= rest - 1) {
            const int at = __builtin_ctz(rest);
            result.key.value[at] = result.key.right[at] = result.key.up[at] = 0;
            result.key_error[at] = std::numeric_limits<float>::infinity();
        }
        return left | unoriented;
    }

    /// Looks at a triangle from its other side: s + error becomes −s + error.
    static void turn_over(Triangles& triangles, std::size_t at) {
        for (int k = 0; k < 3; ++k) {
            Linear& edge = triangles.edge[k];
            edge.value[at] = triangles.sure[k][at] - edge.value[at];
            edge.right[at] = -edge.right[at];
            edge.up[at] = -edge.up[at];
        }
    }

    /// Tests triangles against the rays of a quarter.
    HWY_ATTR void draw(const Triangles& triangles, std::uint32_t which, const Block& block, int quarter) {
        const Floats f;
        const Words w;
        const auto behind = hn::Set(f, grid_.pinhole ? std::numeric_limits<float>::infinity() : 0.0f);
        auto least = hn::Set(f, std::numeric_limits<float>::infinity());
        const auto begin = static_cast<std::size_t>(quarter * quarter_size);
        for (std::size_t i = begin; i < begin + quarter_size; i += hn::Lanes(f)) {
            const auto dj = hn::Load(f, offsets.right + i), di = hn::Load(f, offsets.up + i);
            auto best_low = hn::Load(f, tile_.key_low + i), best_high = hn::Load(f, tile_.key_high + i);
            auto best = hn::Load(w, tile_.surface + i);
            for (std::uint32_t rest = which; rest != 0; rest &= rest - 1) {
                const auto at = static_cast<std::size_t>(__builtin_ctz(rest));
                const auto number = [&](const Linear& linear) HWY_ATTR {
                    return hn::MulAdd(di, hn::Set(f, linear.up[at]),
                                      hn::MulAdd(dj, hn::Set(f, linear.right[at]), hn::Set(f, linear.value[at])));
                };
                const auto a = number(triangles.edge[0]), b = number(triangles.edge[1]), c = number(triangles.edge[2]);
                const auto possible = hn::Ge(hn::Min(hn::Min(a, b), c), hn::Zero(f));
                if (hn::AllFalse(f, possible)) continue;
                const auto key = number(triangles.key), key_error = hn::Set(f, triangles.key_error[at]);
                const auto low = hn::Sub(key, key_error), high = hn::Add(key, key_error);
                const auto live = hn::And(hn::And(possible, hn::Ge(high, best_low)), hn::Lt(low, behind));
                const auto above = [&](int k, auto side)
                                       HWY_ATTR { return hn::Gt(side, hn::Set(f, triangles.sure[k][at])); };
                const auto sure = hn::And(hn::And(live, hn::Lt(high, behind)),
                                          hn::And(above(0, a), hn::And(above(1, b), above(2, c))));
                const Found<decltype(live), decltype(best_low)> found{live, sure, low, high};
                take(found, block.surface[at], best_low, best_high, best);
            }
            hn::Store(best_low, f, tile_.key_low + i);
            hn::Store(best_high, f, tile_.key_high + i);
            hn::Store(best, w, tile_.surface + i);
            least = hn::Min(least, best_low);
        }
        least_keys_[quarter] = hn::GetLane(hn::MinOfLanes(f, least));
    }

    const Engine& engine_;
    const Grid& grid_;
    Tile& tile_;
    glassbox::Vec3<double> start_, direction_;
    float least_key_ = 0, least_keys_[quarters];
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
