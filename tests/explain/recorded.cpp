// The scalar Recorded: a double's own results, and a tape that records where each comes from.
#include "numerics/recorded.hpp"

#include <doctest.h>

#include <algorithm>
#include <intersect_sphere.hpp>
#include <moeller_trumbore.hpp>
#include <probe.hpp>
#include <random>
#include <string_view>
#include <tolerance.hpp>

using namespace glassbox;

namespace {

/// Runs a sphere's and a triangle's test on random rays in double and recorded, and hands both crossings to `compare`.
template <class Rule, class Shape>
void check_same(const Ray<double>& ray, const Shape& shape, const Rule& rule) {
    const Silent silent;
    Tape tape;
    const Ray<Recorded<double>> recorded{input<double>(tape, ray.P, "P"), input<double>(tape, ray.D, "D")};
    const Crossing<double> plain = intersect(ray, shape, rule, silent);
    const Crossing<Recorded<double>> on_tape = intersect(recorded, convert<Recorded<double>>(shape), rule, silent);
    CHECK(plain.met == on_tape.met);
    CHECK(plain.t == on_tape.t.value());
}

}  // namespace

TEST_CASE("a step keeps its operation, its operands and its value") {
    Tape tape;
    const Recorded<double> x = Recorded<double>::input(tape, 3, "x"), y = Recorded<double>::input(tape, 4, "y");
    const Recorded<double> r = sqrt(x * x + y * y);
    name(r, "r");
    CHECK(r.value() == 5);
    REQUIRE(tape.steps().size() == 6);

    const Step& root = tape[r.step()];
    CHECK(root.operation == Operation::square_root);
    const Step& sum = tape[root.left];
    CHECK(sum.operation == Operation::add);
    CHECK(sum.value == 25);
    const Step &xx = tape[sum.left], &yy = tape[sum.right];
    CHECK(xx.operation == Operation::multiply);
    CHECK(xx.left == x.step());
    CHECK(xx.right == x.step());
    CHECK(yy.left == y.step());
    CHECK(tape.names()[x.step()] == "x");
    CHECK(tape.names()[r.step()] == "r");
    CHECK(tape.names()[root.left].empty());
}

TEST_CASE("each operation gives what a double gives") {
    Tape tape;
    const double a = 0.7, b = -2.3;
    const Recorded<double> x = Recorded<double>::input(tape, a, "x"), y = Recorded<double>::input(tape, b, "y");
    CHECK((x + y).value() == a + b);
    CHECK((x - y).value() == a - b);
    CHECK((x * y).value() == a * b);
    CHECK((x / y).value() == a / b);
    CHECK((-x).value() == -a);
    CHECK(abs(y).value() == 2.3);
    CHECK(sqrt(x).value() == std::sqrt(a));
    CHECK(pow(x, 15).value() == std::pow(a, 15.0));
    CHECK((2 * x).value() == 2 * a);
    CHECK((x / 2).value() == a / 2);
}

TEST_CASE("comparisons answer as a double's do, and are on the tape") {
    Tape tape;
    const Recorded<double> x = Recorded<double>::input(tape, 1, "x"), y = Recorded<double>::input(tape, 2, "y");
    CHECK(x < y);
    CHECK_FALSE(x > y);
    CHECK(x <= 1);
    CHECK(x >= 1);
    CHECK(x != y);
    CHECK_FALSE(x == y);
    const Recorded<double> nan = Recorded<double>::input(tape, std::nan(""), "nan");
    CHECK_FALSE(nan < y);
    CHECK_FALSE(nan == nan);
    std::size_t comparisons = 0;
    for (const Step& step : tape.steps()) comparisons += is_comparison(step.operation);
    CHECK(comparisons == 8);
}

TEST_CASE("constants have no tape, and are written down where they meet one that has") {
    const Recorded<double> half = 0.5, three(3);
    CHECK((half * three).value() == 1.5);
    CHECK((half * three).tape() == nullptr);
    Tape tape;
    const Recorded<double> x = Recorded<double>::input(tape, 4, "x");
    const Recorded<double> y = half * x;
    CHECK(y.tape() == &tape);
    CHECK(tape[tape[y.step()].left].operation == Operation::constant);
    CHECK(tape[tape[y.step()].left].value == 0.5);
}

TEST_CASE("a step knows the line that asked for it") {
    Tape tape;
    const Recorded<double> x = Recorded<double>::input(tape, 2, "x");
    const int here = __LINE__ + 1;
    const Recorded<double> y = x * x;
    CHECK(tape[y.step()].line == here);
    CHECK(std::string_view(tape[y.step()].file) == __FILE__);
}

TEST_CASE("the core's formulas, run on tape: every operation is in a file of the core") {
    Tape tape;
    const Silent silent;
    const Ray<Recorded<double>> ray{input<double>(tape, {500, 350, 350}, "P"), input<double>(tape, {-1, 0, 0}, "D")};
    const Sphere<Recorded<double>> sphere{input<double>(tape, {100, 350, 350}, "c"),
                                          Recorded<double>::input(tape, 50, "r")};
    const Crossing<Recorded<double>> crossing = intersect(ray, sphere, Textbook{}, silent);
    CHECK(crossing.t.value() == 350);
    const std::string_view file = tape[crossing.t.step()].file;
    CHECK(file.ends_with("core/2-spheres/quadratic.hpp"));
    for (const Step& step : tape.steps()) {
        if (operands(step.operation) == 0) continue;
        CHECK(std::string_view(step.file).find("src/core/") != std::string_view::npos);
        CHECK(step.line > 0);
    }
}

TEST_CASE("by every rule a recorded test goes the way of the plain one, to the bit") {
    std::mt19937_64 random(20141);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    const auto vector = [&] { return Vec3<double>{coordinate(random), coordinate(random), coordinate(random)}; };
    for (int i = 0; i < 2000; ++i) {
        const Ray<double> ray{vector(), vector()};
        const Sphere<double> sphere{vector(), 0.01 + std::abs(coordinate(random))};
        check_same(ray, sphere, Textbook{});
        check_same(ray, sphere, Stable{});
        const Triangle<double> triangle{vector(), vector(), vector()};
        check_same(ray, triangle, Pluecker{});
        check_same(ray, triangle, Tolerance{0.1});
        check_same(ray, triangle, MoellerTrumbore{});
    }
}

// The discriminant is b² − ac of `discriminant`, which Textbook calls, which `intersect` calls, which this test calls.
TEST_CASE("a step knows the calls in which it is done, and from which lines") {
    Tape tape;
    const Silent silent;
    const Ray<Recorded<double>> ray{input<double>(tape, {500, 350, 350}, "P"), input<double>(tape, {-1, 0, 0}, "D")};
    const Sphere<Recorded<double>> sphere{input<double>(tape, {100, 350, 350}, "c"),
                                          Recorded<double>::input(tape, 50, "r")};
    const int here = __LINE__ + 1;
    (void)intersect(ray, sphere, Textbook{}, silent);
    const auto difference = std::ranges::find_if(
        tape.steps(), [](const Step& step) { return step.operation == Operation::subtract && step.value == 2500; });
    REQUIRE(difference != tape.steps().end());
    const Call& innermost = tape.calls()[difference->call];
    CHECK(std::string_view(innermost.function) == "discriminant");
    CHECK(std::string_view(innermost.header) == "quadratic.hpp");
    CHECK(std::string_view(innermost.file).ends_with("intersect_sphere.hpp"));
    const Call& rule = tape.calls()[innermost.caller];
    CHECK(std::string_view(rule.function) == "Textbook");
    const Call& outermost = tape.calls()[rule.caller];
    CHECK(std::string_view(outermost.function) == "intersect");
    CHECK(std::string_view(outermost.file) == __FILE__);
    CHECK(outermost.line == here);
    CHECK(outermost.caller == 0);
    // After the calls, steps are the test's own.
    const Recorded<double> sum = ray.P.x + sphere.r;
    CHECK(tape[sum.step()].call == 0);
}
