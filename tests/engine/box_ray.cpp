// BoxRay against exact arithmetic: no box that the true ray meets is left out, at any magnitude.
#include "engine/box_ray.hpp"

#include <doctest.h>

#include <optional>
#include <vector>

#include "bounds_against_exact.hpp"
#include "engine/kernels.hpp"

using namespace glassbox;
using engine::Box;
using test::exact;
using test::is_less;

namespace {

/// A box in the engine's own: in floats, relative to its middle. Many are flat.
Box box_in(const engine::Engine& engine, test::Doubles& random) {
    Box box;
    for (int k = 0; k < 3; ++k) {
        const float lo = engine.around().lo[k], hi = engine.around().hi[k];
        const auto coordinate = [&] {
            const double size = random.one_in(4) ? random.positive(-40, -1) : 1;
            return std::clamp(static_cast<float>((2 * random.fraction() - 1) * size) * hi, lo, hi);
        };
        const float a = coordinate(), b = random.one_in(4) ? a : coordinate();
        box.lo[k] = std::min(a, b);
        box.hi[k] = std::max(a, b);
    }
    return box;
}

/// The first t ≥ 0 at which P + tD is in the box, its faces included. Along an axis it is there from (lo − P)/D to
/// (hi − P)/D, or the other way round; D = 0: always or never.
std::optional<Exact> enters(const Vec3<Exact>& P, const Vec3<Exact>& D, const Box& box) {
    const Exact* const start[3] = {&P.x, &P.y, &P.z};
    const Exact* const direction[3] = {&D.x, &D.y, &D.z};
    Exact entry;
    std::optional<Exact> exit;
    for (int k = 0; k < 3; ++k) {
        const Exact lo(double{box.lo[k]}), hi(double{box.hi[k]});
        const int sign = direction[k]->sign();
        if (sign == 0) {
            if (is_less(*start[k], lo) || is_less(hi, *start[k])) return {};
            continue;
        }
        const Exact from = ((sign > 0 ? lo : hi) - *start[k]) / *direction[k];
        const Exact to = ((sign > 0 ? hi : lo) - *start[k]) / *direction[k];
        if (is_less(entry, from)) entry = from;
        if (!exit || is_less(to, *exit)) exit = to;
    }
    if (exit && is_less(*exit, entry)) return {};
    return entry;
}

/// A node whose children are these boxes, each a leaf with its own number.
engine::Hierarchy hierarchy_of(const std::vector<Box>& boxes) {
    engine::Hierarchy hierarchy;
    engine::Node& node = hierarchy.nodes.emplace_back();
    for (std::size_t i = 0; i < engine::fan_out; ++i) {
        for (int k = 0; k < 3; ++k) {
            node.side[engine::Node::lo][k][i] = boxes[i].lo[k];
            node.side[engine::Node::hi][k][i] = boxes[i].hi[k];
        }
        node.child[i] = engine::Child::leaf | static_cast<std::uint32_t>(i);
    }
    return hierarchy;
}

/// The leaves that a traversal visits, a bit each.
std::uint32_t visited(const engine::Hierarchy& hierarchy, const engine::BoxRay& ray, float t_max) {
    std::uint32_t leaves = 0;
    engine::traverse(hierarchy, ray, t_max, [&](std::uint32_t leaf, float before) {
        leaves |= 1u << engine::Child::index(leaf);
        return before;
    });
    return leaves;
}

/// A double that is not below t.
double at_least(const Exact& t) {
    const Bounded nearest = t.to_bounded();
    // The sum is rounded to the nearest double, which may be below.
    return std::nextafter(nearest.value + 2 * nearest.error, std::numeric_limits<double>::infinity());
}

struct BoxCounts {
    int rays = 0, met = 0, missed = 0, left_out = 0, left_out_before_t = 0;
};

/// A ray that passes a corner, an edge or a face of one of the boxes, as nearly as doubles can.
Ray<double> ray_at(const engine::Engine& engine, const Box& box, double distance, double speed, test::Doubles& random) {
    double x[3];
    for (int k = 0; k < 3; ++k) {
        const double lo = double{box.lo[k]}, hi = double{box.hi[k]};
        x[k] = random.one_in(3) ? lo : random.one_in(2) ? hi : lo + random.fraction() * (hi - lo);
    }
    const Vec3<double> D = test::some_vector(random, 1);
    const Vec3<double> P = 1 / engine.scale() * (engine.middle() + Vec3<double>{x[0], x[1], x[2]}) - distance * D;
    return {P, speed * D};
}

void check_boxes(BoxCounts& counts, double size, double away, double distance, double speed, test::Doubles& random) {
    const engine::Engine engine = test::engine_of_size(test::some_vector(random, away), size);
    if (engine.loose().size() == engine.size()) return;  // floats cannot hold its surface: there are no boxes
    std::vector<Box> boxes;
    for (int i = 0; i < engine::fan_out; ++i) boxes.push_back(box_in(engine, random));
    const engine::Hierarchy hierarchy = hierarchy_of(boxes);
    for (int n = 0; n < 20; ++n) {
        const Ray<double> ray = ray_at(engine, boxes[random.below(engine::fan_out)], distance, speed, random);
        if (!is_valid(ray)) continue;
        const std::optional<engine::BoxRay> in_floats = engine::box_ray(ray, engine);
        if (!in_floats) continue;
        ++counts.rays;
        const std::uint32_t all = visited(hierarchy, *in_floats, Box::inf);
        // Boxes are at the engine's scale s: the ray passes through sP + t sD there.
        const Exact s(engine.scale());
        const Vec3<Exact> P = s * exact(ray.P) - exact(engine.middle()), D = s * exact(ray.D);
        for (std::size_t i = 0; i < engine::fan_out; ++i) {
            const std::optional<Exact> t = enters(P, D, boxes[i]);
            if (!t) {
                counts.missed += (all >> i & 1) == 0;
                continue;
            }
            ++counts.met;
            counts.left_out += (all >> i & 1) == 0;
            const double t_max = at_least(*t);
            if (t_max <= std::numeric_limits<double>::max())
                counts.left_out_before_t += (visited(hierarchy, *in_floats, in_floats->t_max(t_max)) >> i & 1) == 0;
        }
    }
}

}  // namespace

TEST_CASE("box_ray: no box is left out that the true ray meets, nor before the t where it does") {
    test::Doubles random(7);
    BoxCounts counts;
    for (int i = 0; i < 300; ++i) {
        const double size = test::power_of_ten(random, -12, 12);
        const double distance = size * (random.one_in(4) ? 0 : random.positive(-10, 30));
        const double away = size * (random.one_in(2) ? 0 : random.positive(-10, 40));
        check_boxes(counts, size, away, distance, test::power_of_ten(random, -25, 25), random);
    }
    CHECK(counts.left_out == 0);
    CHECK(counts.left_out_before_t == 0);
    // There is something to be met, and something to be left out.
    CHECK(counts.rays > 5000);
    CHECK(counts.met > counts.rays / 4);
    CHECK(counts.missed > counts.rays);
}

TEST_CASE("box_ray: numbers of all magnitudes at once give no BoxRay, or one that leaves nothing out") {
    test::Doubles random(8);
    BoxCounts counts;
    for (int i = 0; i < 300; ++i) {
        const double size = test::magnitude(random);
        check_boxes(counts, size, test::magnitude(random), test::magnitude(random), test::magnitude(random), random);
    }
    CHECK(counts.left_out == 0);
    CHECK(counts.left_out_before_t == 0);
    CHECK(counts.rays > 0);
}

// By the definition of BoxRay: what it counts t in, and what a float can say about it.
TEST_CASE("box_ray: t_max of a t that is beyond floats is infinite, and never below the true t") {
    const engine::Engine engine = test::engine_of_size({0, 0, 0}, 1);
    const std::optional<engine::BoxRay> ray = engine::box_ray({{-33, 0.25, 0}, {4, 0, 0}}, engine);
    REQUIRE(ray.has_value());
    // |D| = 4 is 2² times 1, so t counts four times; from so far it begins at the hierarchy, at x = −1 or the float
    // before.
    CHECK(ray->scale == 4);
    CHECK(ray->shift <= 32);
    CHECK(ray->shift > 32 - 0x1p-22);
    // x = 0 is met at t = 33/4: at 33 − shift ≥ 1, a little more for the rounding in floats.
    CHECK(ray->t_max(8.25) >= 1);
    CHECK(ray->t_max(8.25) < 1 + 0x1p-15f);
    // From nearby it begins where it starts: x = 0 is met at t = 3/4, which counts as 3.
    const std::optional<engine::BoxRay> near = engine::box_ray({{-3, 0.25, 0}, {4, 0, 0}}, engine);
    REQUIRE(near.has_value());
    CHECK(near->shift == 0);
    CHECK(near->t_max(0.75) >= 3);
    CHECK(near->t_max(0.75) < 3 + 0x1p-15f);
    CHECK(ray->t_max(1e300) == Box::inf);
    CHECK(ray->t_max(std::numeric_limits<double>::infinity()) == Box::inf);
}
