// How a failure is described: the inputs that a check is made from, and what right and wrong checks have in common.
#include "learn/check/description.hpp"

#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "learn/check/facts.hpp"
#include "learn/check/relation.hpp"
#include "learn/check/seen_variables.hpp"
#include "learn/telling.hpp"

using namespace glassbox::learn;

namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A check of the function `f` that compares numbers.
CheckMade compared(const std::vector<double>& expected, const std::vector<double>& got,
                   const std::vector<Input>& inputs = {}) {
    CheckMade one;
    one.test = "f: it is right<double>";
    one.line = 7;
    one.passed = expected == got;
    one.expression = "f(a)";
    one.expected = expected;
    one.got = got;
    one.inputs = inputs;
    return one;
}

std::string relation(const std::vector<CheckMade>& wrong) {
    std::vector<const CheckMade*> all;
    for (const CheckMade& one : wrong) all.push_back(&one);
    return relation_of(all);
}

/// What is said of a function's checks; the case that is shown is the first.
std::string described(const std::vector<CheckMade>& checks) {
    Exercise exercise;
    exercise.functions = {{"f", "f.hpp", {"f:"}, {}}};
    TestRun run;
    run.checks = checks;
    Failure failure;
    failure.line = checks[0].line;
    run.cases = {{checks[0].test, failure}};
    return description(exercise, run, judged(exercise, run));
}

/// A check of a ray against the sphere of radius 5 about the origin.
CheckMade traced(const std::vector<double>& ray, bool passed) {
    CheckMade one = compared({1}, {passed ? 1.0 : 2.0});
    one.ray = ray;
    one.surface = {0, 0, 0, 5};
    return one;
}

}  // namespace

TEST_CASE("a check is told which variables it is made from, and what those were computed from") {
    const std::string source =
        "TEST_CASE(\"one\") {\n"
        "    Dice dice;\n"
        "    for (const Real size : sizes<Real>) {\n"
        "        const Vec3<Real> a = dice.vector(Real(1)), b{1, 2, 3};\n"
        "        const Vec3<Real> u = unit(size * a);\n"
        "        if (size > 1) CHECK_EXACT(u, unit(b));\n"
        "        CHECK(std::any_of(v.begin(), v.end(), [&](int x) { return x > 0; }));\n"
        "    }\n"
        "    CHECK_FALSE(met({{10, 3, 0},\n"
        "                     {1, 0, 0}}));\n"
        "}\n";
    const std::string seen = with_seen_variables(source, "/tests/\"one\".cpp");
    CHECK(seen.starts_with("#line 1 \"/tests/\\\"one\\\".cpp\"\n"));
    // u and b are named, u was computed from size and a; dice has no value to show
    CHECK(has(seen,
              "if (size > 1) { const ::glassbox::test::Seen glassbox_seen(6, {::glassbox::test::variable(\"u\", u), "
              "::glassbox::test::variable(\"b\", b), ::glassbox::test::variable(\"size\", size), "
              "::glassbox::test::variable(\"a\", a)}); CHECK_EXACT(u, unit(b)); }\n"));
    // x is no variable out here, and the last check is made from numbers alone
    CHECK(seen.find("glassbox_seen(") == seen.rfind("glassbox_seen("));
    CHECK(std::count(seen.begin(), seen.end(), '\n') == std::count(source.begin(), source.end(), '\n') + 1);
}

TEST_CASE("what is no check, no variable or out of scope is left alone") {
    const std::string source =
        "#define CHECK_TWICE(x) CHECK(x); CHECK(x)\n"
        "// CHECK(a);\n"
        "const char* text = \"CHECK(a);\";\n"
        "void f() {\n"
        "    { const int gone = 1; }\n"
        "    CHECK(gone::by(Vec3<Real>{1, 2, 3}).x == five<Real> + gone);\n"
        "}\n";
    CHECK(with_seen_variables(source, "one.cpp") == "#line 1 \"one.cpp\"\n" + source);
}

TEST_CASE("what all wrong numbers have in common is said, and nothing that one of them has not") {
    CHECK(relation({compared({4}, {2}), compared({-6}, {-3})}) == "is half of what is expected");
    CHECK(relation({compared({4}, {-4}), compared({-6}, {6})}) == "is minus what is expected: the sign is turned");
    CHECK(relation({compared({-4}, {4}), compared({-6}, {6})}) == "is minus what is expected: the sign is turned");
    CHECK(relation({compared({4}, {12}), compared({6}, {18})}) == "is 3 times what is expected");
    CHECK(relation({compared({4}, {16}), compared({3}, {9})}) == "is the square of what is expected");
    CHECK(relation({compared({4}, {7}), compared({3}, {6})}) == "is what is expected plus 3");
    CHECK(relation({compared({4}, {0}), compared({3}, {0})}) == "is 0");
    CHECK(relation({compared({4}, {7}), compared({3}, {7})}) == "is 7");
    CHECK(relation({compared({4}, {5}), compared({3}, {7})}) == "is too large");
    CHECK(relation({compared({4}, {NAN}), compared({3}, {NAN})}) == "is not a number");
    CHECK(relation({compared({4}, {2}), compared({3}, {7})}) == "");
    CHECK(relation({compared({0}, {1}), compared({0}, {3})}) == "is too large");  // and not 1 over 0
    CHECK(relation({compared({1}, {1 + 1e-12})}).starts_with("is nearly right: off by rounding"));
    const Input t0{"t0", {6}};
    CHECK(relation({compared({4}, {6}, {t0}), compared({5}, {6}, {t0})}) == "is the very `t0`");
}

TEST_CASE("of vectors it is said which component is wrong, or that only the length is, or the direction") {
    CHECK(relation({compared({1, 2, 3}, {1, -2, 3}), compared({4, 5, 6}, {4, -5, 6})}) ==
          "is wrong in y alone, where the sign is turned");
    CHECK(relation({compared({1, 2, 3}, {1, 2, 0})}) == "is wrong in z alone, which is 0");
    CHECK(relation({compared({1, 2, 3}, {2, 1, 3}), compared({4, 5, 6}, {5, 4, 6})}) == "has x and y exchanged");
    CHECK(relation({compared({1, 0, 0}, {5, 0, 0}), compared({0, 1, 0}, {0, 7, 0})}) ==
          "has the right direction, but not the length 1");
    CHECK(relation({compared({3, 4, 0}, {0, 0, 5})}) == "has the right length and the wrong direction");
}

TEST_CASE("where a function is wrong is said by what its inputs have in common") {
    // |D| = 1 is right, |D| = 2 wrong
    const std::string lengths = described({traced({-10, 3, 0, 2, 0, 0}, false), traced({-10, 0, 0, 0, 2, 0}, false),
                                           traced({-10, 3, 0, 1, 0, 0}, true), traced({-10, 9, 0, 1, 0, 0}, true)});
    CHECK(has(lengths, "2 of 4 checks looked at are wrong."));
    CHECK(has(lengths, "It is wrong wherever |D| is not 1 (2 checks), and right wherever |D| is 1 (2)."));
    CHECK(has(lengths, "Every wrong number is twice what is expected."));
    // from inside
    CHECK(has(described({traced({2, 0, 0, 1, 0, 0}, false), traced({-10, 3, 0, 1, 0, 0}, true),
                         traced({-10, 3, 0, 2, 0, 0}, true)}),
              "wrong wherever the ray starts inside the sphere (1 check), and right wherever the ray does not start "
              "inside the sphere (2)"));
    // only where both are so: each is so of a check that is right, too
    CHECK(has(described({traced({2, 0, 0, 2, 0, 0}, false), traced({-1, 1, 0, 0, 2, 1}, false),
                         traced({2, 0, 0, 1, 0, 0}, true), traced({-10, 3, 0, 2, 0, 0}, true)}),
              "wrong wherever the ray starts inside the sphere and |D| is not 1 (2 checks)"));
}

TEST_CASE("variables and numbers that a check is written with count as its inputs") {
    const auto with = [](double a, double b, bool passed) {
        return compared({1}, {passed ? 1.0 : 3.0}, {{"a", {a}}, {"b", {b}}});
    };
    CHECK(has(described({with(2, 2, false), with(5, 5, false), with(2, 3, true), with(3, 2, true)}),
              "wrong wherever a and b are equal (2 checks), and right wherever a and b are not equal (2)"));
    const auto written = [](const char* expression, bool passed) {
        CheckMade one = compared({1}, {passed ? 1.0 : 3.0});
        one.expression = expression;
        return one;
    };
    CHECK(
        has(described({written("first_of(Real(-7), Real(-3)).t", false), written("first_of(Real(-7), Real(3)).t", true),
                       written("first_of(Real(6), Real(14)).t", true)}),
            "wrong wherever first_of's second argument is negative (1 check)"));
}

TEST_CASE("where nothing tells right from wrong, the tests that pass and fail are named") {
    Exercise exercise;
    exercise.functions = {{"f", "f.hpp", {"f:"}, {}}};
    TestRun run;
    run.cases = {{"f: up<double>", Failure{}}, {"f: down<double>"}, {"f: up<float>"}, {"f: down<float>"}};
    const std::string told = description(exercise, run, judged(exercise, run));
    CHECK(has(told, "In float all is right."));
    CHECK(has(told, "Right in “f: down”; wrong in “f: up”."));
}

TEST_CASE("lines are broken between words, by characters and not by bytes") {
    CHECK(wrapped("one two three", 2, 9) == "one two\n  three");
    CHECK(wrapped("√√√ √√√", 0, 7) == "√√√ √√√");
    CHECK(wrapped("a_very_long_word and more", 2, 8) == "a_very_long_word\n  and\n  more");
    CHECK(wrapped("one\ntwo", 2, 20) == "one\n  two");
    CHECK(wrapped("", 2, 20) == "");
}
