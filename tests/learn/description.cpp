// How a failure is described: the inputs that a check is made from, and what right and wrong checks have in common.
#include "learn/check/description.hpp"

#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
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
    return relation_of(all, "f");
}

/// What is said of a function's checks; the case that is shown is the first.
std::string described(const std::vector<CheckMade>& checks, const std::string& returns = "Real") {
    Exercise exercise;
    exercise.functions = {{"f", "f.hpp", {"f:"}, {}, returns}};
    TestRun run;
    run.checks = checks;
    Failure failure;
    failure.line = checks[0].line;
    run.cases = {{checks[0].test, failure}};
    return description(exercise, run, judged(exercise, run));
}

/// A check of f(a, b), of two numbers.
CheckMade called(double a, double b, bool passed) {
    CheckMade one = compared({a + 10}, {passed ? a + 10 : a + 11 + b * b}, {{"a", {a}}, {"b", {b}}});
    one.expression = "f(a, b)";
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
    const auto of_three = [](double (*got)(double)) {
        return relation({compared({4}, {got(4)}), compared({-6}, {got(-6)}), compared({9}, {got(9)})});
    };
    CHECK(of_three([](double x) { return x / 2; }) == "is half of what is expected");
    CHECK(of_three([](double x) { return -x; }) == "is minus what is expected: the sign is turned");
    CHECK(of_three([](double x) { return 3 * x; }) == "is 3 times what is expected");
    CHECK(of_three([](double x) { return x * std::numbers::pi / 180; }) == "is what is expected, times π/180");
    CHECK(of_three([](double x) { return x * x; }) == "is the square of what is expected");
    CHECK(of_three([](double x) { return x + 3; }) == "is what is expected plus 3");
    CHECK(of_three([](double) { return 0.0; }) == "is 0");
    CHECK(of_three([](double) { return 7.0; }) == "is 7");
    CHECK(of_three([](double x) { return std::abs(x) + 7; }) == "is too large");  // 11, 13 and 16
    CHECK(relation({compared({4}, {NAN}), compared({3}, {NAN})}) == "is not a number");
    CHECK(of_three([](double x) { return x > 5 ? 2 : 7.5; }) == "");
    CHECK(relation({compared({1}, {1 + 1e-12})}).starts_with("is nearly right: off by rounding"));
}

TEST_CASE("what may be chance is not said: a factor of two numbers, or of the same ones; one that nobody writes") {
    CHECK(relation({compared({4}, {2}), compared({-6}, {-3})}) == "");
    CHECK(relation({compared({4}, {2}), compared({4}, {2}), compared({4}, {2}), compared({6}, {3})}) == "");
    CHECK(relation({compared({4}, {-0.17392}), compared({-6}, {0.26088}), compared({9}, {-0.39132})}) == "");
    // "too large" is said of the function's own answer alone
    std::vector<CheckMade> others{compared({4}, {5}), compared({3}, {7}), compared({1}, {9})};
    CHECK(relation(others) == "is too large");
    for (CheckMade& one : others) one.expression = "at(f(a), 1)";
    CHECK(relation(others) == "");
}

TEST_CASE("an argument that comes out unchanged is told by its place; other variables of the test are not") {
    const auto with = [](double expected, double a, const char* expression) {
        CheckMade one = compared({expected}, {a}, {{"a", {a}}});
        one.expression = expression;
        return one;
    };
    CHECK(relation({with(4, 6, "f(2, a)"), with(5, 9, "f(2, a)"), with(1, 3, "f(2, a)")}) ==
          "is its second argument, unchanged");
    CHECK(relation({with(4, 6, "forwards.t"), with(5, 7, "forwards.t"), with(2, 1, "forwards.t")}) == "");
}

TEST_CASE("of vectors it is said which component is wrong, or that only the length is, or the direction") {
    CHECK(
        relation({compared({1, 2, 3}, {1, -2, 3}), compared({4, 5, 6}, {4, -5, 6}), compared({4, 1, 6}, {4, -1, 6})}) ==
        "differs from what is expected in y alone, where the sign is turned");
    CHECK(relation({compared({1, 2, 3}, {1, -2, 3}), compared({4, 5, 6}, {4, -5, 6})}) ==
          "differs from what is expected in y alone");
    CHECK(relation({compared({1, 2, 3}, {1, 2, 0}), compared({4, 5, 6}, {4, 5, 0})}) ==
          "differs from what is expected in z alone, which is 0");
    CHECK(relation({compared({1, 2, 3}, {1, 2, 0})}) == "");  // of one it is seen
    CHECK(relation({compared({1, 2, 3}, {2, 1, 3}), compared({4, 5, 6}, {5, 4, 6}), compared({7, 8, 0}, {8, 7, 0})}) ==
          "has x and y exchanged");
    CHECK(relation({compared({1, 0, 0}, {5, 0, 0}), compared({0, 1, 0}, {0, 7, 0}), compared({0, 0, 1}, {0, 0, 2})}) ==
          "has the right direction, but not the length 1");
    CHECK(relation({compared({3, 4, 0}, {0, 0, 5}), compared({4, 3, 0}, {0, 0, 5}), compared({0, 4, 3}, {5, 0, 0})}) ==
          "has the right length and the wrong direction");
    CHECK(relation({compared({3, 4, 0}, {0, 0, 5})}) == "");
}

TEST_CASE("where a function is wrong is said by its arguments, of all checks, and with enough inputs on each side") {
    std::vector<CheckMade> checks;
    for (const double a : {-1, -2, -3, -4, -5}) checks.push_back(called(a, 2, false));
    for (const double a : {1, 2, 3, 4, 6}) checks.push_back(called(a, 2, true));
    CHECK(has(described(checks), "5 of 10 checks of `f` fail."));
    CHECK(
        has(described(checks),
            "It is wrong wherever its first argument is negative (5 checks), and right wherever its first argument is "
            "not negative (5)."));
    // four of a side are too few, unless what they have in common is a case by itself
    CHECK_FALSE(has(described({checks.begin() + 1, checks.end()}), "wherever"));
    std::vector<CheckMade> zero{called(0, 2, false)};
    for (const double a : {1, 2, 3, 4, 5}) zero.push_back(called(a, 1, true));
    CHECK(has(described(zero),
              "It is wrong wherever its first argument is 0 (1 check), and right wherever its first argument is not 0 "
              "(5)."));
    // one check of which that is not known, and nothing is said of any
    zero.push_back(compared({1}, {1}, {{"a", {7}}}));
    zero.back().expression = "twice";
    CHECK_FALSE(has(described(zero), "wherever"));
    // nor of a variable that the function is not given
    for (CheckMade& one : zero) one.expression = "f(0.5 * a, g)";
    CHECK_FALSE(has(described(zero), "wherever"));
}

TEST_CASE("an argument is known by what is written there, by a variable's name, or by its members") {
    CheckMade check = compared({1}, {1}, {{"ray.P", {1, 2, 3}}, {"ray.D", {4, 5, 6}}, {"n", {7}}});
    check.expression = "glassbox::f<Real>(ray, Real(-7), n, Vec3<Real>{1, 0, 2}).t";
    const auto call = own_call(check, "f of a ray");
    REQUIRE(call);
    std::vector<std::string> names;
    for (const Input& one : call->arguments) names.push_back(one.name);
    CHECK(names == std::vector<std::string>{"P of its first argument", "D of its first argument", "its second argument",
                                            "its third argument", "its fourth argument"});
    CHECK(call->arguments[2].numbers == std::vector<double>{-7});
    CHECK_FALSE(call->is_whole_answer);
    CHECK(member_checked(check) == "t");
    CHECK_FALSE(own_call(check, "g"));
    CHECK_FALSE(own_call(check, "f + f"));
    check.expression = "f(n)";
    CHECK(own_call(check, "f")->arguments[0].name == "its argument");
    CHECK(own_call(check, "f")->is_whole_answer);
    CHECK(member_checked(check) == "");
    check.expression = "2 * f(n)";
    CHECK_FALSE(own_call(check, "f"));
}

TEST_CASE("a member that alone is wrong is named, with the counts of its own checks") {
    const auto member = [](const char* expression, bool passed) {
        CheckMade one = compared({1}, {passed ? 1.0 : 3.0});
        one.expression = expression;
        return one;
    };
    CHECK(has(described({member("one.b", false), member("one.c", true), member("two.b", false)}),
              "2 of 3 checks of `f` fail. Those are the 2 checks of `b`."));
    CHECK(has(described({member("one.b", false), member("one.c", true), member("two.b", true)}),
              "1 of 3 checks of `f` fails. It is one of the 2 checks of `b`."));
    CHECK_FALSE(has(described({member("one.b", false), member("one.c", false), member("two.b", true)}), "`b`"));
    CHECK_FALSE(has(described({member("one.b", false), member("two.b", true)}), "`b`"));
}

TEST_CASE("where not all checks were kept, their number is none of all") {
    CHECK(has(described({compared({1}, {2})}), "The one check of `f` fails."));
    CHECK(has(described({compared({1}, {2}), compared({3}, {2})}), "All 2 checks of `f` fail."));
    std::vector<CheckMade> many(60, compared({1}, {2}));
    CHECK(has(described(many), "All checks of `f` fail."));
    many.push_back(compared({1}, {1}));
    CHECK(has(described(many), "Of 61 checks of `f`, 60 fail."));
}

TEST_CASE("a yes or no is spoken of where the function answers so, and both are asked for") {
    const auto asked = [](bool right_answer, bool passed) {
        CheckMade one = compared({right_answer ? 1.0 : 0.0}, {passed == right_answer ? 1.0 : 0.0});
        one.is_condition = true;
        one.passed = passed;
        return one;
    };
    const auto told = [&](const std::vector<CheckMade>& checks) { return described(checks, "bool"); };
    CHECK(has(told({asked(true, false), asked(true, false), asked(false, true)}),
              "Every wrong answer is no, where yes is right."));
    CHECK(has(told({asked(false, false), asked(true, true)}), "The wrong answer is yes, where no is right."));
    CHECK_FALSE(has(told({asked(true, false), asked(true, true)}), "answer"));
    CHECK_FALSE(has(told({asked(true, false), asked(false, false)}), "answer"));
    CHECK_FALSE(has(described({asked(true, false), asked(false, true)}), "answer"));
}

TEST_CASE("what is so of all wrong vectors is said, or what is so of all that were made in the check above") {
    CheckMade shown = compared({1, 2, 3}, {1, 2, 5}), other = compared({4}, {5});
    other.line = 8;
    CHECK_FALSE(has(described({shown, other}), "vector"));  // of one it is seen
    CHECK(has(described({shown, compared({4, 5, 6}, {4, 5, 8}), other}),
              "Every wrong vector differs from what is expected in z alone."));
    CheckMade in_x = compared({4, 5, 6}, {1, 5, 6});
    in_x.line = 9;
    CHECK(has(described({shown, compared({4, 5, 6}, {4, 5, 8}), in_x}),
              "In the check above every wrong vector differs from what is expected in z alone."));
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
