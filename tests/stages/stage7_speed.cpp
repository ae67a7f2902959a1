// Stage 7: boxes around surfaces. A ray's way through a box, which loses no hit to rounding; where to cut boxes in two;
// and the walk through a tree of boxes, which finds what the plain loop finds and tests only a few surfaces.
#include <box.hpp>
#include <intersect_triangle.hpp>
#include <probe.hpp>
#include <slabs.hpp>
#include <tree.hpp>
#include <walk.hpp>

#include "checks.hpp"

/// Whole numbers are equal; fails with expected and got.
#define CHECK_COUNT(got, expected) \
    glassbox::test::check_ulps(static_cast<double>(got), static_cast<double>(expected), 0, #got, __FILE__, __LINE__)

using namespace glassbox;
using namespace glassbox::test;
using engine::Box, engine::Branch, engine::Interval, engine::Tree;

namespace {

template <class Real>
constexpr Real infinity = std::numeric_limits<Real>::infinity();

Box box(const Vec3<float>& lo, const Vec3<float>& hi) { return {{lo.x, lo.y, lo.z}, {hi.x, hi.y, hi.z}}; }

/// A cube of side 1 whose lower corner is (x, 0, 0).
Box cube_at(float x) { return box({x, 0, 0}, {x + 1, 1, 1}); }

/// 1/D, without the header under test.
template <class Real>
Interval<Real> through(const Box& box, const Ray<Real>& ray) {
    return engine::through(box, ray.P, Vec3<Real>{1 / ray.D.x, 1 / ray.D.y, 1 / ray.D.z});
}

// slab

TEST_CASE_TEMPLATE("slab: it is entered where the ray crosses lo, and left where it crosses hi", Real, EVERY_SCALAR) {
    // x = -2 + 2t: 2 at t = 2, 6 at t = 4
    const Interval<Real> t = engine::slab<Real>(2, 6, -2, 1 / Real(2));
    CHECK_EXACT(t.enters, Real(2));
    CHECK_EXACT(t.leaves, Real(4));
    // x = -2 + 3t: 2 at t = 4/3, 6 at t = 8/3; 1/3 is rounded, and the product
    const Interval<Real> thirds = engine::slab<Real>(2, 6, -2, 1 / Real(3));
    CHECK_ULPS(thirds.enters, Real(4) / 3, 2);
    CHECK_ULPS(thirds.leaves, Real(8) / 3, 2);
}

TEST_CASE_TEMPLATE("slab: a ray that runs the other way enters at hi and leaves at lo", Real, EVERY_SCALAR) {
    // x = 10 - 2t: 6 at t = 2, 2 at t = 4
    const Interval<Real> t = engine::slab<Real>(2, 6, 10, 1 / Real(-2));
    CHECK_EXACT(t.enters, Real(2));
    CHECK_EXACT(t.leaves, Real(4));
}

TEST_CASE_TEMPLATE("slab: from inside it was entered before the start, and from beyond it was left, too", Real,
                   EVERY_SCALAR) {
    // x = 4 + t
    const Interval<Real> inside = engine::slab<Real>(2, 6, 4, 1);
    CHECK_EXACT(inside.enters, Real(-2));
    CHECK_EXACT(inside.leaves, Real(2));
    // x = 10 + 2t: 2 at t = -4, 6 at t = -2
    const Interval<Real> behind = engine::slab<Real>(2, 6, 10, 1 / Real(2));
    CHECK_EXACT(behind.enters, Real(-4));
    CHECK_EXACT(behind.leaves, Real(-2));
}

TEST_CASE_TEMPLATE("slab: a flat one is entered and left at once", Real, EVERY_SCALAR) {
    const Interval<Real> t = engine::slab<Real>(3, 3, 0, 1 / Real(4));
    CHECK_EXACT(t.enters, Real(0.75));
    CHECK_EXACT(t.leaves, Real(0.75));
}

TEST_CASE_TEMPLATE("slab: a ray that runs along it lies in it always, or never", Real, EVERY_SCALAR) {
    for (const Real inverse : {infinity<Real>, -infinity<Real>}) {  // D = 0 and D = -0
        const Interval<Real> inside = engine::slab<Real>(2, 6, 4, inverse);
        CHECK_EXACT(inside.enters, -infinity<Real>);
        CHECK_EXACT(inside.leaves, infinity<Real>);
        for (const Real P : {Real(1), Real(7)}) {
            const Interval<Real> outside = engine::slab<Real>(2, 6, P, inverse);
            CHECK(outside.enters > outside.leaves);
        }
    }
}

TEST_CASE_TEMPLATE("slab: its faces belong to it, for a ray that runs along one, too", Real, EVERY_SCALAR) {
    // lo - P is 0 here, and 0 times the infinite 1/D is not a number.
    for (const Real inverse : {infinity<Real>, -infinity<Real>}) {
        for (const Real P : {Real(2), Real(6)}) {
            const Interval<Real> on_a_face = engine::slab<Real>(2, 6, P, inverse);
            CHECK_EXACT(on_a_face.enters, -infinity<Real>);
            CHECK_EXACT(on_a_face.leaves, infinity<Real>);
        }
        const Interval<Real> flat = engine::slab<Real>(2, 2, 2, inverse);
        CHECK_EXACT(flat.enters, -infinity<Real>);
        CHECK_EXACT(flat.leaves, infinity<Real>);
    }
}

// through

/// The most that an exit may be widened by: 32 times the largest error of one operation, where 8 times is enough.
template <class Real>
constexpr Real a_little = 16 * epsilon<Real>;

TEST_CASE_TEMPLATE("through: the ray is in the box from the last entry to the first exit", Real, EVERY_SCALAR) {
    const Vec3<Real> P{0, 0, 0}, D{1, 1, 1};
    // With D = (1, 1, 1) each slab is entered at its lo and left at its hi. From 2 to 6, 1 to 4 and 0 to 8: from 2
    // to 4. Each of the axes is the last to be entered once, and once the first to be left.
    for (const Box& b : {box({2, 1, 0}, {6, 4, 8}), box({0, 2, 1}, {8, 6, 4}), box({1, 0, 2}, {4, 8, 6})}) {
        const Interval<Real> t = through<Real>(b, {P, D});
        CHECK_EXACT(t.enters, Real(2));
        CHECK_WITHIN(t.leaves, Real(4), 4 * a_little<Real>);
    }
}

TEST_CASE_TEMPLATE("through: t is rounded a few times, where it is no whole number", Real, EVERY_SCALAR) {
    // With D = (3, 3, 3) all slabs are entered at t = 2/3 and left at t = 4/3.
    const Interval<Real> t = through<Real>(box({2, 2, 2}, {4, 4, 4}), {{0, 0, 0}, {3, 3, 3}});
    CHECK_ULPS(t.enters, Real(2) / 3, 2);
    CHECK_WITHIN(t.leaves, Real(4) / 3, 2 * a_little<Real>);
}

TEST_CASE_TEMPLATE("through: a box is missed if one slab is left before another is entered", Real, EVERY_SCALAR) {
    // 2 to 3 along one axis, 4 to 5 along another: never both
    for (const Box& b : {box({2, 4, 0}, {3, 5, 9}), box({0, 2, 4}, {9, 3, 5}), box({4, 0, 2}, {5, 9, 3})})
        CHECK(is_empty(through<Real>(b, {{0, 0, 0}, {1, 1, 1}})));
}

TEST_CASE_TEMPLATE("through: what lies behind the start is missed; a box around it is entered at 0", Real,
                   EVERY_SCALAR) {
    const Box b = box({2, 2, 2}, {4, 4, 4});
    CHECK(is_empty(through<Real>(b, {{6, 6, 6}, {1, 1, 1}})));
    const Interval<Real> from_inside = through<Real>(b, {{3, 3, 3}, {1, 1, 1}});
    CHECK_EXACT(from_inside.enters, Real(0));
    CHECK_WITHIN(from_inside.leaves, Real(1), a_little<Real>);
}

TEST_CASE_TEMPLATE("through: rays along an axis, beside the box, through it and along its face", Real, EVERY_SCALAR) {
    const Box b = box({2, 1, 0}, {4, 3, 2});
    const auto along_x = [&](Real y, Real z) { return through<Real>(b, {{0, y, z}, {1, 0, 0}}); };
    CHECK_EXACT(along_x(2, 1).enters, Real(2));
    CHECK_EXACT(along_x(1, 1).enters, Real(2));  // y = 1 is a face
    CHECK_EXACT(along_x(3, 2).enters, Real(2));  // an edge
    CHECK_FALSE(is_empty(along_x(1, 1)));
    CHECK_FALSE(is_empty(along_x(3, 2)));
    CHECK(is_empty(along_x(0.5, 1)));
    CHECK(is_empty(along_x(2, 2.5)));
}

TEST_CASE_TEMPLATE("through: a flat box is met", Real, EVERY_SCALAR) {
    // z = 3 at t = 1, where the ray is at (1, 2, 3)
    CHECK_FALSE(is_empty(through<Real>(box({0, 0, 3}, {2, 4, 3}), {{0, 0, 0}, {1, 2, 3}})));
    CHECK(is_empty(through<Real>(box({2, 0, 3}, {4, 4, 3}), {{0, 0, 0}, {1, 2, 3}})));
}

/// A box that the ray meets in one point only, Q = P + tD: it leaves along `from` where it enters along `to`. All
/// numbers are integers, so that this is exact. `gap` moves the box away from it along `to`.
template <class Real>
Box grazed(const Vec3<Real>& Q, const Vec3<Real>& D, int from, int to, Real gap) {
    const Real q[3] = {Q.x, Q.y, Q.z}, d[3] = {D.x, D.y, D.z};
    Box b;
    for (int k = 0; k < 3; ++k) {
        const Real ahead = d[k] > 0 ? 1 : -1;
        const Real near = k == from ? q[k] - 8 * ahead : k == to ? q[k] + gap * ahead : q[k] - 4096;
        const Real far = k == from ? q[k] : k == to ? q[k] + 8 * ahead : q[k] + 4096;
        b.lo[k] = static_cast<float>(std::min(near, far));
        b.hi[k] = static_cast<float>(std::max(near, far));
    }
    return b;
}

/// A component of a direction: whole, from 1 to 20 in size.
template <class Real>
Real component(Dice& dice) {
    return static_cast<Real>(dice.whole(1, 20) * (dice.whole(0, 1) == 0 ? -1 : 1));
}

/// How many of 3000 such boxes are missed.
template <class Real>
double missed_of_3000(Real gap) {
    Dice dice;
    int missed = 0;
    for (int n = 0; n < 3000; ++n) {
        const Vec3<Real> P = dice.whole_vector<Real>(50);
        const Vec3<Real> D{component<Real>(dice), component<Real>(dice), component<Real>(dice)};
        const Vec3<Real> Q = P + static_cast<Real>(dice.whole(1, 50)) * D;
        const int from = dice.whole(0, 2), to = (from + dice.whole(1, 2)) % 3;
        missed += is_empty(through<Real>(grazed(Q, D, from, to, gap), {P, D}));
    }
    return missed;
}

TEST_CASE_TEMPLATE("through: a box that the ray meets in a single point is not lost to rounding", Real, EVERY_SCALAR) {
    // 1/D is rounded, for D = 3 upwards and for D = 5 downwards: the entry may be computed as later than the exit.
    CHECK_EXACT(missed_of_3000(Real(0)), 0.0);
}

TEST_CASE_TEMPLATE("through: a box that the ray misses by a hair is missed", Real, EVERY_SCALAR) {
    // The hair is 1/4, where coordinates are up to 1050 and D up to 20: in t that is 1/80 of at most 50, far more than
    // rounding.
    CHECK_EXACT(missed_of_3000(Real(0.25)), 3000.0);
}

// best_cut

/// Half the area of the box around some boxes, times their number, without the header under test.
float cost_of(std::span<const Box> boxes) {
    Box all;
    for (const Box& one : boxes) all.add(one);
    return all.half_area() * static_cast<float>(boxes.size());
}

TEST_CASE("best_cut: two and two, where the boxes leave a gap") {
    // Two cubes side by side are 2 x 1 x 1, half the area is 2 + 1 + 2 = 5; times 2, and twice that, 20. To cut off one
    // costs 3 and 3 times that of 11 x 1 x 1, 23: 72.
    const std::vector<Box> boxes{cube_at(0), cube_at(1), cube_at(10), cube_at(11)};
    const engine::Cut cut = engine::best_cut(boxes);
    CHECK_COUNT(cut.left, 2);
    CHECK_EXACT(cut.cost, 20.0f);
}

TEST_CASE("best_cut: one large box is cut off from many small ones") {
    // 7 cubes in one place and one box of side 10: 3 times 7 and 300 times 1. In the middle it would be 3 * 4 + 300
    // * 4.
    std::vector<Box> boxes(7, cube_at(0));
    boxes.push_back(box({0, 0, 0}, {10, 10, 10}));
    const engine::Cut cut = engine::best_cut(boxes);
    CHECK_COUNT(cut.left, 7);
    CHECK_EXACT(cut.cost, 321.0f);
}

TEST_CASE("best_cut: a row of equal boxes is cut in the middle") {
    // n cubes in a row: half the area is 2n + 1. Of 8: 4 * 9 twice, 72; one and seven, 3 + 7 * 15, would be 108.
    std::vector<Box> boxes;
    for (int i = 0; i < 8; ++i) boxes.push_back(cube_at(static_cast<float>(i)));
    const engine::Cut cut = engine::best_cut(boxes);
    CHECK_COUNT(cut.left, 4);
    CHECK_EXACT(cut.cost, 72.0f);
}

TEST_CASE("best_cut: two boxes have one cut; of equally good cuts it is the first") {
    const std::vector<Box> two{cube_at(0), cube_at(5)};
    CHECK_COUNT(engine::best_cut(two).left, 1);
    CHECK_EXACT(engine::best_cut(two).cost, 6.0f);
    // a cube of side 1/2 has half an area of 3/4
    const std::vector<Box> small(2, box({0, 0, 0}, {0.5f, 0.5f, 0.5f}));
    CHECK_EXACT(engine::best_cut(small).cost, 1.5f);
    // 3 + 2 * 5 and 2 * 5 + 3
    const std::vector<Box> three{cube_at(0), cube_at(1), cube_at(2)};
    CHECK_COUNT(engine::best_cut(three).left, 1);
    CHECK_EXACT(engine::best_cut(three).cost, 13.0f);
}

TEST_CASE("best_cut: no other cut is better, for boxes of all sizes in any order") {
    // Coordinates are whole and below 100: no cost is rounded.
    Dice dice;
    for (int n = 0; n < 20; ++n) {
        std::vector<Box> boxes;
        for (int i = 0; i < 30; ++i) {
            const Vec3<float> lo = dice.whole_vector<float>(40);
            const auto side = [&] { return static_cast<float>(dice.whole(0, 10)); };
            const float x = side(), y = side(), z = side();
            boxes.push_back(box(lo, lo + Vec3<float>{x, y, z}));
        }
        std::size_t left = 1;
        const auto cost = [&](std::size_t i) {
            return cost_of(std::span(boxes).first(i)) + cost_of(std::span(boxes).subspan(i));
        };
        for (std::size_t i = 2; i < boxes.size(); ++i)
            if (cost(i) < cost(left)) left = i;
        const engine::Cut cut = engine::best_cut(boxes);
        CHECK_COUNT(cut.left, left);
        CHECK_EXACT(cut.cost, cost(left));
    }
}

// nearer

template <class Real>
using Best = std::optional<Hit<Real>>;

TEST_CASE_TEMPLATE("nearer: of two hits the one with the smaller t stays", Real, EVERY_SCALAR) {
    for (const std::size_t surface : {std::size_t(1), std::size_t(9)}) {  // whichever is listed first
        const Best<Real> five = Hit<Real>{5, 2};
        CHECK_COUNT(engine::nearer<Real>(five, surface, {true, 3}).value().surface, 5);
        CHECK_COUNT(engine::nearer<Real>(five, surface, {true, 1}).value().surface, surface);
        CHECK_EXACT(engine::nearer<Real>(five, surface, {true, 1}).value().t, Real(1));
    }
}

TEST_CASE_TEMPLATE("nearer: a miss changes nothing, and the first hit is the best", Real, EVERY_SCALAR) {
    CHECK_FALSE(engine::nearer<Real>({}, 3, {false, 0}));
    CHECK_COUNT(engine::nearer<Real>(Hit<Real>{5, 2}, 3, {false, 2}).value().surface, 5);
    CHECK_COUNT(engine::nearer<Real>(Hit<Real>{5, 2}, 8, {false, 0}).value().surface, 5);
    CHECK_COUNT(engine::nearer<Real>({}, 3, {true, 7}).value().surface, 3);
}

TEST_CASE_TEMPLATE("nearer: at equal t a larger number that comes later wins", Real, EVERY_SCALAR) {
    CHECK_COUNT(engine::nearer<Real>(Hit<Real>{5, 2}, 8, {true, 2}).value().surface, 8);
}

TEST_CASE_TEMPLATE("nearer: at equal t a larger number that came before stays", Real, EVERY_SCALAR) {
    CHECK_COUNT(engine::nearer<Real>(Hit<Real>{8, 2}, 5, {true, 2}).value().surface, 8);
}

// is_beyond

TEST_CASE_TEMPLATE("is_beyond: nothing is, before there is a hit", Real, EVERY_SCALAR) {
    CHECK_FALSE(engine::is_beyond<Real>(Real(1e30), {}));
}

TEST_CASE_TEMPLATE("is_beyond: a box that begins behind the hit is, one before it is not", Real, EVERY_SCALAR) {
    const Best<Real> best = Hit<Real>{0, 4};
    CHECK(engine::is_beyond(Real(5), best));
    CHECK(engine::is_beyond(Real(4.01), best));
    CHECK(engine::is_beyond(4 + 256 * epsilon<Real>, best));  // 16 times what `widened` adds
    CHECK_FALSE(engine::is_beyond(Real(3), best));
    CHECK_FALSE(engine::is_beyond(Real(0), best));
}

TEST_CASE_TEMPLATE("is_beyond: a box that begins at the hit, or as near as rounding tells, is not", Real,
                   EVERY_SCALAR) {
    const Best<Real> best = Hit<Real>{0, 4};
    CHECK_FALSE(engine::is_beyond(Real(4), best));
    // An entry at 4 that was rounded three times may come out as this.
    CHECK_FALSE(engine::is_beyond(4 + 4 * epsilon<Real>, best));
    CHECK_FALSE(engine::is_beyond(4 * (1 + 4 * epsilon<Real>), best));  // widened · 4 itself
}

// walk

Branch halves(const Box& box, std::uint32_t first) { return {box, first, 0}; }
Branch leaf(const Box& box, std::uint32_t first, std::uint32_t count = 1) { return {box, first, count}; }

/// Four cubes in a row at x = 0, 2, 4 and 6, a surface in each:
///
///              0: all
///        1: 0 to 3    2: 4 to 7
///        3    4        5    6        leaves with the surfaces 0, 1, 2, 3
Tree row() {
    return {{halves(box({0, 0, 0}, {7, 1, 1}), 1), halves(box({0, 0, 0}, {3, 1, 1}), 3),
             halves(box({4, 0, 0}, {7, 1, 1}), 5), leaf(cube_at(0), 0), leaf(cube_at(2), 1), leaf(cube_at(4), 2),
             leaf(cube_at(6), 3)},
            {0, 1, 2, 3}};
}

/// What a walk found and how much it looked at.
template <class Real>
struct Walked {
    Best<Real> best;
    int boxes = 0, surfaces = 0;
    std::size_t first = 999;  ///< the surface that was tested first

    std::size_t surface() const { return best ? best->surface : 999; }
};

/// A walk through surfaces of which only this is known: at which t the ray meets each; 0: not at all.
template <class Real>
Walked<Real> walk(const Tree& tree, const Ray<Real>& ray, const std::vector<Real>& t_of) {
    struct Counting {
        int* boxes;
        void operator()(told::BoxTested) const { ++*boxes; }
    };
    Walked<Real> walked;
    const Counting probe{&walked.boxes};
    walked.best = engine::walk(
        tree, ray,
        [&](std::size_t surface) {
            if (walked.surfaces++ == 0) walked.first = surface;
            return Crossing<Real>{t_of[surface] > 0, t_of[surface]};
        },
        probe);
    return walked;
}

template <class Real>
const Ray<Real> rightwards{{-1, 0.5, 0.5}, {1, 0, 0}};
template <class Real>
const Ray<Real> leftwards{{8, 0.5, 0.5}, {-1, 0, 0}};

TEST_CASE_TEMPLATE("walk: where there is nothing, nothing is met", Real, EVERY_SCALAR) {
    CHECK_FALSE(walk<Real>({}, rightwards<Real>, {}).best);
}

TEST_CASE_TEMPLATE("walk: a ray that passes by the box around all looks no further", Real, EVERY_SCALAR) {
    const Walked<Real> walked = walk<Real>(row(), {{-1, 5, 5}, {1, 0, 0}}, {1, 1, 1, 1});
    CHECK_COUNT(walked.surface(), 999);
    CHECK_COUNT(walked.boxes, 1);
    CHECK_COUNT(walked.surfaces, 0);
}

TEST_CASE_TEMPLATE("walk: of a row it finds the first, from the left and from the right", Real, EVERY_SCALAR) {
    // Each surface is met in the middle of its cube.
    const Walked<Real> right = walk<Real>(row(), rightwards<Real>, {1.5, 3.5, 5.5, 7.5});
    CHECK_COUNT(right.surface(), 0);
    CHECK_EXACT(right.best.value().t, Real(1.5));
    const Walked<Real> left = walk<Real>(row(), leftwards<Real>, {7.5, 5.5, 3.5, 1.5});
    CHECK_COUNT(left.surface(), 3);
    CHECK_EXACT(left.best.value().t, Real(1.5));
}

TEST_CASE_TEMPLATE("walk: it looks into the nearer half first, wherever the ray comes from", Real, EVERY_SCALAR) {
    CHECK_COUNT(walk<Real>(row(), rightwards<Real>, {0, 0, 0, 0}).first, 0);
    CHECK_COUNT(walk<Real>(row(), leftwards<Real>, {0, 0, 0, 0}).first, 3);
}

TEST_CASE_TEMPLATE("walk: the half that is entered first comes first, where one lies in the other, too", Real,
                   EVERY_SCALAR) {
    // From x = -1 along x: what begins first is entered first. The box around both begins before either.
    const auto first_of = [](const Box& one, const Box& other) {
        const Tree tree{{halves(box({0, 0, 0}, {20, 1, 1}), 1), leaf(one, 0), leaf(other, 1)}, {0, 1}};
        return walk<Real>(tree, rightwards<Real>, {0, 0}).first;
    };
    const Box wide = box({1, 0, 0}, {9, 1, 1}), within = box({2, 0, 0}, {8, 1, 1}),
              behind = box({12, 0, 0}, {14, 1, 1});
    CHECK_COUNT(first_of(wide, within), 0);
    CHECK_COUNT(first_of(within, wide), 1);
    CHECK_COUNT(first_of(within, behind), 0);
    CHECK_COUNT(first_of(behind, within), 1);
}

TEST_CASE_TEMPLATE("walk: it does not look behind a hit", Real, EVERY_SCALAR) {
    // All; its two halves; the nearer half's two. Then there is a hit, and the other boxes begin beyond it.
    for (const auto& [ray, t_of] : {std::pair{rightwards<Real>, std::vector<Real>{1.5, 3.5, 5.5, 7.5}},
                                    std::pair{leftwards<Real>, std::vector<Real>{7.5, 5.5, 3.5, 1.5}}}) {
        const Walked<Real> walked = walk<Real>(row(), ray, t_of);
        CHECK_COUNT(walked.boxes, 5);
        CHECK_COUNT(walked.surfaces, 1);
    }
}

TEST_CASE_TEMPLATE("walk: through a box without a hit it goes on to the next", Real, EVERY_SCALAR) {
    for (std::size_t met = 0; met < 4; ++met) {
        std::vector<Real> t_of(4, Real(0));
        t_of[met] = static_cast<Real>(2 * met) + Real(1.5);
        const Walked<Real> walked = walk<Real>(row(), rightwards<Real>, t_of);
        CHECK_COUNT(walked.surface(), met);
        // The cubes are looked into in their order: the second half's only after both of the first.
        CHECK_COUNT(walked.surfaces, met + 1);
        CHECK_COUNT(walked.boxes, met < 2 ? 5 : 7);
    }
    CHECK_COUNT(walk<Real>(row(), rightwards<Real>, {0, 0, 0, 0}).surface(), 999);
}

TEST_CASE_TEMPLATE("walk: boxes overlap: the one entered first may have the farther hit", Real, EVERY_SCALAR) {
    // The first box is entered at 1 and its surface met at 9; the second is entered at 2, and its surface met at 3.
    const Tree tree{
        {halves(box({0, 0, 0}, {9, 1, 1}), 1), leaf(box({0, 0, 0}, {9, 1, 1}), 0), leaf(box({1, 0, 0}, {3, 1, 1}), 1)},
        {0, 1}};
    CHECK_COUNT(walk<Real>(tree, rightwards<Real>, {9, 3}).surface(), 1);
    // The first is the better one, though the ray comes out of its box last: the second box begins before 2.5.
    CHECK_COUNT(walk<Real>(tree, rightwards<Real>, {2.5, 3}).surface(), 0);
    CHECK_COUNT(walk<Real>(tree, rightwards<Real>, {2.5, 3}).surfaces, 2);
}

TEST_CASE_TEMPLATE("walk: every surface of a leaf is tested, and they are those of the tree's list", Real,
                   EVERY_SCALAR) {
    // The leaf's surfaces are 4, 2 and 0.
    const Tree tree{{leaf(cube_at(0), 1, 3)}, {1, 4, 2, 0, 3}};
    CHECK_COUNT(walk<Real>(tree, rightwards<Real>, {1, 1, 1, 1, 1.5}).surfaces, 3);
    CHECK_COUNT(walk<Real>(tree, rightwards<Real>, {2, 0, 1.75, 0, 1.5}).surface(), 4);
    CHECK_COUNT(walk<Real>(tree, rightwards<Real>, {2, 0, 1.25, 0, 1.5}).surface(), 2);
    CHECK_COUNT(walk<Real>(tree, rightwards<Real>, {1, 0, 1.25, 0, 1.5}).surface(), 0);
}

TEST_CASE_TEMPLATE("walk: at equal t the larger number wins, in whichever box it lies", Real, EVERY_SCALAR) {
    // Two boxes side by side, and surfaces on the face between them, x = 1: the second box begins right at the hit.
    for (const std::vector<std::uint32_t>& surfaces : {std::vector<std::uint32_t>{0, 1}, {1, 0}}) {
        const Tree tree{{halves(box({0, 0, 0}, {2, 1, 1}), 1), leaf(cube_at(0), 0), leaf(cube_at(1), 1)}, surfaces};
        CHECK_COUNT(walk<Real>(tree, rightwards<Real>, {2, 2}).surface(), 1);
        CHECK_COUNT(walk<Real>(tree, {{3, 0.5, 0.5}, {-1, 0, 0}}, {2, 2}).surface(), 1);
    }
}

TEST_CASE_TEMPLATE("walk: in a heap of triangles it meets what the plain loop meets, and tests a tenth", Real,
                   EVERY_SCALAR) {
    // 500 triangles with whole corners; rays run from afar through the corners, edges and insides of triangles.
    Dice dice;
    std::vector<Triangle<double>> triangles;
    std::vector<Box> boxes;
    for (int n = 0; n < 500; ++n) {
        const Vec3<double> at = dice.whole_vector<double>(200);
        const auto corner = [&] { return at + dice.whole_vector<double>(20); };
        const Vec3<double> A = corner(), B = corner(), C = corner();
        triangles.push_back({A, B, C});
        boxes.push_back(engine::box_of(triangles.back(), {}));
    }
    const Tree tree = engine::tree_over(boxes);
    Silent silent;
    double tested = 0;
    for (int n = 0; n < 300; ++n) {
        const auto& [A, B, C] = triangles[static_cast<std::size_t>(dice.whole(0, 499))];
        const Vec3<double> goals[] = {A, 0.5 * (A + B), 0.25 * (A + A + B + C)};
        const Vec3<double> P = dice.whole_vector<double>(400);
        const Ray<Real> ray{convert<Real>(P), convert<Real>(goals[n % 3] - P)};
        if (!is_valid(ray)) continue;
        const auto test = [&](std::size_t surface) {
            return Pluecker{}(ray, convert<Real>(triangles[surface]), silent);
        };
        Best<Real> expected;
        for (std::size_t k = 0; k < triangles.size(); ++k) expected = nearest(expected, k, test(k));
        const auto counted = [&](std::size_t surface) {
            ++tested;
            return test(surface);
        };
        const Best<Real> got = engine::walk(tree, ray, counted, silent);
        CHECK_COUNT(got ? got->surface : 999, expected ? expected->surface : 999);
        CHECK_EXACT(got ? got->t : 0, expected ? expected->t : 0);
    }
    const double share = tested / (300.0 * 500.0);
    CHECK_WITHIN(share, 0.0, 0.1);
}

}  // namespace
