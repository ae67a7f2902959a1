// What compilers print, and what a learner reads. The messages are those of g++ 12 and clang++ 14.
#include "learn/build/compile_error.hpp"

#include <doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "learn/build/plain_words.hpp"
#include "output/folder.hpp"

using namespace glassbox;
using namespace glassbox::learn;
using glassbox::test::Folder;
namespace fs = std::filesystem;

namespace {

Outcome said(const std::string& errors) {
    Outcome outcome;
    outcome.end = End::exited;
    outcome.status = 1;
    outcome.errors = errors;
    return outcome;
}

/// A project with a learner's header of three lines, and a test that includes it.
struct Project {
    Folder folder;
    fs::path mine = folder / "my";

    Project() {
        fs::create_directories(mine / "1-rays");
        std::ofstream(mine / "1-rays" / "vec3.hpp") << "#pragma once\nint two = 2\n\treturn tow;\n";
        fs::create_directories(folder / "src" / fs::path("core/2-spheres"));
        std::ofstream(folder / "src" / fs::path("core/2-spheres/sphere.hpp")) << "\n";
    }
    CompileError error(const std::string& errors) const {
        const auto found = compile_error(said(errors), {{mine}}, folder.path);
        REQUIRE(found);
        return *found;
    }
};

}  // namespace

TEST_CASE("g++ and clang++ are told in the same plain words") {
    struct Case {
        const char *gcc, *clang, *part;
    };
    for (const Case& one : {
             Case{"expected ';' before '}' token", "expected ';' after return statement", "semicolon is missing"},
             Case{"'c' was not declared in this scope", "use of undeclared identifier 'c'", "Nothing is called c here"},
             Case{"'Reel' was not declared in this scope; did you mean 'Real'?",
                  "unknown type name 'Reel'; did you mean 'Real'?", "called Reel here; did you mean Real?"},
             Case{"no match for 'operator+' (operand types are 'const glassbox::Vec3<double>' and 'double')",
                  "invalid operands to binary expression ('const Vec3<double>' and 'double')",
                  "between Vec3<double> and double. What there is"},
             Case{"no matching function for call to 'dot(const glassbox::Vec3<double>&)'",
                  "no matching function for call to 'dot'", "There is a function dot, but it does not take"},
             Case{"no return statement in function returning non-void [-Werror=return-type]",
                  "non-void function does not return a value [-Werror,-Wreturn-type]", "without 'return'"},
             Case{"control reaches end of non-void function [-Werror=return-type]",
                  "non-void function does not return a value in all control paths [-Werror,-Wreturn-type]",
                  "no case of the switch fits? Write a return at the end"},
             Case{"cannot convert 'glassbox::test::UnsureTruth' to 'const bool' in initialization",
                  "no viable conversion from 'glassbox::test::UnsureTruth' to 'const bool'", "keep it as Truth<Real>"},
             Case{"could not convert 'glassbox::operator>(t, 0.0)' from 'glassbox::Kleene' to 'bool'",
                  "value of type 'glassbox::Kleene' is not contextually convertible to 'bool'",
                  "possibly(…) or surely"},
             Case{"cannot convert 'const glassbox::Vec3<double>' to 'double' in return",
                  "no viable conversion from returned value of type 'const Vec3<double>' to function return type "
                  "'double'",
                  "must return double, and this is Vec3<double>"},
             Case{"narrowing conversion of '1.5e+0' from 'double' to 'int' [-Wnarrowing]",
                  "type 'double' cannot be narrowed to 'int' in initializer list [-Wc++11-narrowing]",
                  "write static_cast<int>"},
             Case{"'const struct glassbox::Vec3<double>' has no member named 'w'",
                  "no member named 'w' in 'glassbox::Vec3<double>'", "There is no member w"},
             Case{"cmaht: No such file or directory", "'cmaht' file not found", "There is no header cmaht"},
             Case{"#include nested depth 200 exceeds maximum of 200 (use -fmax-include-depth=DEPTH to increase)",
                  "#include nested too deeply", "includes itself"},
             Case{"template instantiation depth exceeds maximum of 900 (use '-ftemplate-depth=' to increase)",
                  "recursive template instantiation exceeded maximum depth of 1024", "needs itself without end"},
             Case{"expected ')' before ';' token", "expected ')'", "A ( is not closed"},
             Case{"unterminated comment", "unterminated /* comment", "never ends"},
             Case{"unterminated #if", "unterminated conditional directive", "#endif is missing"},
             Case{"#endif without #if", "#endif without #if", "There is no #if before this #endif"},
             Case{"extended character × is not valid in an identifier", "unexpected character <U+00D7>",
                  "write * for × and ·"},
             Case{"lvalue required as left operand of assignment", "expression is not assignable",
                  "To compare, write =="},
             Case{"assignment of member 'glassbox::Vec3<double>::x' in read-only object",
                  "cannot assign to variable 'a' with const-qualified type 'const Vec3<double> &'", "const"},
             Case{"redefinition of 'template<class Real> constexpr Real glassbox::dot(const Vec3<Real>&)'",
                  "redefinition of 'dot'", "is written twice"},
             Case{"'Real' does not name a type", "unknown type name 'Real'", "template <class Real>"},
             Case{"invalid type argument of unary '*' (have 'double')",
                  "indirection requires pointer operand ('double' invalid)", "missing before this *"},
             Case{"'squrt' is not a member of 'std'; did you mean 'sqrt'?",
                  "no member named 'squrt' in namespace 'std'; did you mean 'sqrt'?", "did you mean sqrt?"},
         }) {
        CAPTURE(one.part);
        CHECK_MESSAGE(in_plain_words(one.gcc).find(one.part) != std::string::npos, in_plain_words(one.gcc));
        CHECK_MESSAGE(in_plain_words(one.clang).find(one.part) != std::string::npos, in_plain_words(one.clang));
    }
    CHECK(in_plain_words("something that no compiler has ever said") == "");
    CHECK(in_plain_words("") == "");
}

TEST_CASE("a vector times a number is told with the learner's own operands, the number first") {
    struct Case {
        const char *line, *words;
    };
    for (const Case& one : {Case{"    return ray.P + ray.D * t;", "write the number first: t * ray.D."},
                            Case{"    return (a + b) * dot(a, b);", "write the number first: dot(a, b) * (a + b)."},
                            Case{"    return at(ray, 2)*2;", "write the number first: 2 * at(ray, 2)."}}) {
        const Project project;
        std::ofstream(project.mine / "1-rays" / "vec3.hpp") << "#pragma once\n" << one.line << '\n';
        // both compilers point at the operator; only g++ says which it is
        const std::string place = fmt::format("my/1-rays/vec3.hpp:2:{}: error: ", std::string(one.line).rfind('*') + 1);
        CHECK(project
                  .error(place + "no match for 'operator*' (operand types are 'const glassbox::Vec3<double>' and "
                                 "'const std::type_identity_t<double>' {aka 'const double'})\n")
                  .plain == std::string("There is no vector * number here; ") + one.words);
        CHECK(project.error(place + "invalid operands to binary expression ('const Vec3<double>' and 'double')\n")
                  .plain == std::string("There is no vector * number here; ") + one.words);
    }
    CHECK(in_plain_words("no match for 'operator*' (operand types are 'Vec3<float>' and 'int')") ==
          "There is no vector * number here; write the number first: number * vector.");
    CHECK(in_plain_words("no match for 'operator*' (operand types are 'Vec3<float>' and 'Vec3<float>')",
                         {"ray.D", "*", "n"}) ==
          "There is no vector * vector here; do you mean dot(ray.D, n), a number, or cross(ray.D, n), a vector?");
    CHECK(in_plain_words("no match for 'operator*' (operand types are 'Rotation<float>' and 'float')")
              .starts_with("There is no * between Rotation<float> and float."));
}

TEST_CASE("what people write for a power, a comparison, a component, or beside a Truth") {
    struct Case {
        const char *gcc, *clang;
        OperatorInSource source;
        const char* words;
    };
    for (const Case& one : {
             Case{"invalid operands of types 'const double' and 'double' to binary 'operator^'",
                  "invalid operands to binary expression ('const double' and 'double')",
                  {"a.x", "^", "2"},
                  "^ is no power in C++: a square is a.x * a.x, any other power pow(a.x, e)."},
             Case{"no match for 'operator!=' (operand types are 'const glassbox::Vec3<double>' and 'int')",
                  "invalid operands to binary expression ('const Vec3<double>' and 'int')",
                  {"ray.D", "!=", "0"},
                  "A vector is compared with a vector; whether it is not zero: ray.D != Vec3<Real>{}."},
             Case{"no match for 'operator==' (operand types are 'const glassbox::Vec3<double>' and 'int')",
                  "invalid operands to binary expression ('const Vec3<double>' and 'int')",
                  {"h", "==", "0"},
                  "A vector is compared with a vector; whether it is zero: h == Vec3<Real>{}."},
             Case{
                 "no match for 'operator|' (operand types are 'const glassbox::test::UnsureTruth' and 'const "
                 "glassbox::test::UnsureTruth')",
                 "invalid operands to binary expression ('const glassbox::test::UnsureTruth' and 'const "
                 "glassbox::test::UnsureTruth')",
                 {"left", "|", "right"},
                 "There is no | between what two comparisons answer. There is a & b for and, !a for not, and a != b; a "
                 "or b is !(!a & !b), and a equal to b is !(a != b)."},
             Case{"no match for 'operator*' (operand types are 'glassbox::Vec3<double>' and 'const "
                  "glassbox::Rotation<double>')",
                  "invalid operands to binary expression ('Vec3<double>' and 'const Rotation<double>')",
                  {"(point - pivot)", "*", "R"},
                  "A rotation stands on the left of what it rotates: write R * (point - pivot)."},
             Case{
                 "no match for 'operator<' (operand types are 'const std::optional<glassbox::Hit<double> >' and 'const "
                 "double')",
                 "invalid operands to binary expression ('const std::optional<Hit<double>>' and 'const double')",
                 {"best", "<", "t"},
                 "There is no < between these: what an optional holds is reached by ->, as in best->t, where it holds "
                 "something."},
             Case{"no match for 'operator[]' (operand types are 'const glassbox::Vec3<double>' and 'int')",
                  "type 'const Vec3<double>' does not provide a subscript operator",
                  {},
                  "A vector's components are called, and not counted: write .x, .y or .z, as in a.x."},
             Case{"no matching function for call to 'max(<brace-enclosed initializer list>)'",
                  "no matching function for call to 'max'",
                  {},
                  "All that max is given must be of one type: write Real(0) for 0."},
         }) {
        CHECK(in_plain_words(one.gcc, one.source) == one.words);
        CHECK(in_plain_words(one.clang, one.source) == one.words);
    }
    CHECK(in_plain_words("no match for 'operator+' (operand types are 'Vec3<float>' and 'int')").find("== and !=") !=
          std::string::npos);
}

TEST_CASE("the tests' own types are called as a learner calls them") {
    CHECK(in_our_names("cannot convert 'glassbox::test::UnsureTruth' to 'const bool'") ==
          "cannot convert 'Truth' to 'const bool'");
    CHECK(in_our_names("to 'sqrt(const glassbox::test::Unsure&)'") == "to 'sqrt(const Real&)'");
    const Project project;
    const CompileError error = project.error(
        "my/1-rays/vec3.hpp:2:9: error: no viable conversion from returned value of type 'glassbox::test::UnsureTruth' "
        "to function return type 'bool'\n");
    CHECK(error.message == "no viable conversion from returned value of type 'Truth' to function return type 'bool'");
    CHECK(error.plain.find("keep it as Truth<Real>") != std::string::npos);
}

TEST_CASE("what is meant is seen from the line and the function that it is in") {
    struct Case {
        const char* declaration;  ///< its body has the line
        const char* line;
        const char* marked;  ///< what g++ and clang++ point at, the first time that it stands in the line
        const char *gcc, *clang;
        const char* words;
    };
    const char* const at = "Vec3<Real> at(const Ray<Real>& ray, const Real& t) {";
    for (const Case& one : {
             Case{at, "    return P + t * ray.D;", "P", "'P' was not declared in this scope",
                  "use of undeclared identifier 'P'", "Nothing is called P here; did you mean ray.P?"},
             Case{"constexpr Real f(const Ray<Real>& one,\n                 const glassbox::Ray<Real>& other) {",
                  "    return D;", "D", "'D' was not declared in this scope", "use of undeclared identifier 'D'",
                  "Nothing is called D here; did you mean one.D or other.D?"},
             Case{at, "    return max(0, t);", "max", "'max' was not declared in this scope; did you mean 'std::max'?",
                  "use of undeclared identifier 'max'; did you mean 'std::max'?",
                  "Write std::max, and give it numbers of one type: Real(0) for 0."},
             Case{at, "    return choose(t > 0, t, 0);", "choose",
                  "'choose' was not declared in this scope; did you mean 'close'?",
                  "use of undeclared identifier 'choose'", "There is no choose here: write condition ? a : b."},
             Case{at, "    v = ray.P;", "v", "'v' was not declared in this scope", "use of undeclared identifier 'v'",
                  "Nothing is called v here. To make a variable of that name, write const auto v = …"},
             Case{at, "    const v = ray.P;", "v ", "'v' does not name a type",
                  "C++ requires a type specifier for all declarations",
                  "A type is missing before v: write const auto v = …"},
             Case{at, "    return best.t;", "t;",
                  "'const class std::optional<glassbox::Hit<double> >' has no member named "
                  "'t'",
                  "no member named 't' in 'std::optional<glassbox::Hit<double>>'",
                  "What an optional holds is reached by ->, where it holds something: best->t."},
             Case{at, "    return pow(sphere.r, 2);", "pow",
                  "cannot convert 'const glassbox::test::Unsure' to 'double'", "no matching function for call to 'pow'",
                  "pow is for built-in numbers alone, and Real may be another: write sphere.r * sphere.r."},
             Case{"constexpr Interval<Real> f(const Real& a, const Real& b) {", "    return a < b ? {a, b} : {b, a};",
                  "{a", "expected primary-expression before '{' token",
                  "initializer list cannot be used on the right hand side of operator '?'",
                  "Beside ? and : braces need their type before them: write Interval<Real>{…}."},
         }) {
        const Project project;
        std::ofstream(project.mine / "1-rays" / "vec3.hpp")
            << "#pragma once\ntemplate <class Real>\nstruct Ray {\n    Vec3<Real> P, D;\n};\n\ntemplate <class Real>\n"
            << one.declaration << '\n'
            << one.line << "\n}\n";
        const auto line = 9 + std::ranges::count(std::string_view(one.declaration), '\n');
        const std::string place =
            fmt::format("my/1-rays/vec3.hpp:{}:{}: error: ", line, std::string(one.line).find(one.marked) + 1);
        CHECK(project.error(place + one.gcc + '\n').plain == one.words);
        CHECK(project.error(place + one.clang + '\n').plain == one.words);
    }
}

TEST_CASE("a template without <Real> is named, where g++ points behind it, and clang++ at it") {
    const Project project;
    std::ofstream(project.mine / "1-rays" / "vec3.hpp") << "#pragma once\n    return widened * t;\n";
    // 4 blanks, return, a blank: 11 before widened, 19 before the *
    CHECK(project.error("my/1-rays/vec3.hpp:2:20: error: missing template arguments before '*' token\n").plain ==
          "widened is a template: write widened<Real>.");
    CHECK(project
              .error("my/1-rays/vec3.hpp:2:12: error: use of variable template 'widened' requires template arguments\n")
              .plain == "widened is a template: write widened<Real>.");
}

TEST_CASE("cos_sin of a turn is told at its own line, whatever line is complained of") {
    const Project project;
    std::ofstream(project.mine / "1-rays" / "vec3.hpp")
        << "#pragma once\ntemplate <class Real>\nRotation<Real> rotation(const Turn<Real>& turn) {\n"
           "    const auto [c, s] = cos_sin(turn);\n    return {c, s};\n}\n";
    const CompileError error = project.error(
        "src/core/5-rotation/turn.hpp:43:44: error: cannot convert 'int' to 'glassbox::Axis' in initialization\n"
        "my/1-rays/vec3.hpp:4:25: error: something that follows\n");
    CHECK(error.place.line == 4);
    CHECK(error.plain == "cos_sin takes an angle in degrees, a number: cos_sin(turn.degrees).");
}

TEST_CASE("a name that the compiler suggests is passed on if it is one of ours or the learner's") {
    const Project project;
    CHECK(
        project.error("my/1-rays/vec3.hpp:3:9: error: 'colse' was not declared in this scope; did you mean 'close'?\n")
            .plain.find("close") == std::string::npos);
    std::ofstream(project.folder / fs::path("src/core/2-spheres/sphere.hpp")) << "int close();\n";
    CHECK(
        project.error("my/1-rays/vec3.hpp:3:9: error: 'colse' was not declared in this scope; did you mean 'close'?\n")
            .plain == "Nothing is called colse here; did you mean close?");
}

TEST_CASE("a name that g++ gives and then explains is the explained one") {
    CHECK(in_plain_words("cannot convert 'glassbox::Vec3<double>' to 'std::type_identity_t<double>' {aka 'double'} in "
                         "return") == "The function must return double, and this is Vec3<double>.");
}

TEST_CASE("a member that is not there is answered with those of its own type") {
    const Project project;
    std::ofstream(project.folder / fs::path("src/core/2-spheres/sphere.hpp"))
        << "template <class Real>\nstruct Sphere {\n    Vec3<Real> c;\n    Real r{}, s = 2;  ///< radius; more\n"
           "    static constexpr int no = 1;\n};\n";
    CHECK(project
              .error("my/1-rays/vec3.hpp:2:1: error: 'const struct glassbox::Sphere<double>' has no member named "
                     "'q'\n")
              .plain == "A Sphere has no member q: it has c, r and s.");
    CHECK(project.error("my/1-rays/vec3.hpp:2:1: error: no member named 'q' in 'glassbox::Sphere<double>'\n").plain ==
          "A Sphere has no member q: it has c, r and s.");
    CHECK(project.error("my/1-rays/vec3.hpp:2:1: error: no member named 'q' in 'glassbox::Cone<double>'\n").plain ==
          "There is no member q in Cone<double>: is it spelt right?");
}

TEST_CASE("a missing ) is not called a semicolon, on one line or on two") {
    const Project project;
    std::ofstream(project.mine / "1-rays" / "vec3.hpp") << "int a = 1;\n    if (a > b {\n    if (f(a) &&\n"
                                                           "        f(b) {\n    f(a)\n}\n";
    const auto plain = [&](const char* place) {
        return project.error(fmt::format("my/1-rays/vec3.hpp:{}: error: expected ';' before '{{' token\n", place))
            .plain;
    };
    CHECK(plain("2:14").starts_with("A ( is not closed"));
    CHECK(plain("4:13").starts_with("A ( is not closed"));
    CHECK(plain("5:9").find("semicolon is missing") != std::string::npos);
}

TEST_CASE("the first error in the learner's own file is the one, though others come before it") {
    const Project project;
    const CompileError error = project.error(
        "In file included from tests/stage.cpp:3:\n"
        "src/core/1-rays/ray.hpp:11:5: error: 'Vec3' does not name a type\n"
        "my/1-rays/vec3.hpp:2:12: error: expected ',' or ';' before 'return'\n"
        "    2 | int two = 2\n"
        "tests/stage.cpp:7:3: error: 'dot' was not declared in this scope\n");
    CHECK(error.yours);
    CHECK(error.place.file == (project.mine / "1-rays/vec3.hpp").string());
    CHECK(error.place.line == 2);
    CHECK(error.place.column == 12);
    CHECK(error.source == "int two = 2");
    CHECK(error.others == 2);
    CHECK(with_caret(error) == "int two = 2\n           ^");
}

TEST_CASE("an error elsewhere that a line of the learner's led to is told at that line") {
    const Project project;
    // g++ prints the path to an error before it, clang++ after it
    for (const char* text : {
             "my/1-rays/vec3.hpp: In instantiation of 'int f() [with T = int]':\n"
             "my/1-rays/vec3.hpp:3:9:   required from here\n"
             "/usr/include/c++/12/cmath:99:1: error: no type named 'x' in 'struct y'\n",
             "/usr/include/c++/12/cmath:99:1: error: no type named 'x' in 'y'\n"
             "my/1-rays/vec3.hpp:3:9: note: in instantiation of function template specialization 'f' requested here\n",
         }) {
        const CompileError error = project.error(text);
        CHECK(error.yours);
        CHECK(error.place.line == 3);
        CHECK(with_caret(error) == "\treturn tow;\n\t       ^");
    }
}

TEST_CASE("what is not closed in a header goes before what another file, or a later line, complains of") {
    const Project project;
    const fs::path first = project.mine / "1-rays/vec3.hpp", second = project.mine / "1-rays/ray.hpp",
                   unused = project.mine / "1-rays/old.hpp";
    std::ofstream(first) << "#pragma once\nnamespace glassbox {\nint two = 2;\n";
    std::ofstream(second) << "#pragma once\n#include <vec3.hpp>\nint three = two;\n";
    std::ofstream(unused) << "void old() {\n";
    const auto error = [&](const std::string& errors) {
        const auto found =
            compile_error(said(errors), {{project.mine / "1-rays"}, {second, first}}, project.folder.path);
        REQUIRE(found);
        return *found;
    };
    for (const char* errors :
         {"tests/checks.hpp:93:7: error: 'passed' was not declared in this scope\n",
          "my/1-rays/ray.hpp:3:13: error: 'two' was not declared in this scope\n",
          "my/1-rays/vec3.hpp:3:1: error: a template declaration cannot appear at block scope\n"}) {
        const CompileError one = error(errors);
        CHECK(one.yours);
        CHECK(one.place.file == first.string());
        CHECK(one.place.line == 2);
        CHECK(one.place.column == 20);  // n-a-m-e-s-p-a-c-e, a blank, glassbox, a blank: 19
        CHECK(one.source == "namespace glassbox {");
        CHECK(one.plain.starts_with("This { is never closed"));
        CHECK(one.message == "");
        CHECK(one.others == 1);
    }
    // What is unclosed before the error is reported first; a file that nothing includes is ignored.
    CHECK(error("my/1-rays/vec3.hpp:1:9: error: 'tow' was not declared in this scope\n").place.line == 1);
    std::ofstream(first, std::ios::app) << "}\n";
    CHECK_FALSE(error("tests/checks.hpp:93:7: error: 'passed' was not declared in this scope\n").yours);
}

TEST_CASE("control characters of a learner's line do not reach the terminal, and the caret stays in its column") {
    CompileError error;
    error.source =
        "\tint a\x1b[2J = \xC2\x9B"
        "31m + \xE2\x80\xAE + \x9B"
        "b;";
    // Before b there are, after the tab, 'int a' 5, '?[2J' 4, ' = ' 3, '?31m' 4, ' + ' 3, '?', ' + ' 3 and '?': 24
    // columns.
    error.place.column = error.source.find('b') + 1;
    CHECK(with_caret(error) == "\tint a?[2J = ?31m + ? + ?b;\n\t                        ^");
    error.place.column = 0;
    CHECK(with_caret(error).ends_with("\n^"));
}

TEST_CASE("an error in the tests is said to be about the headers") {
    const Project project;
    const CompileError error = project.error("tests/stage.cpp:7:3: error: some complaint that has no plain words\n");
    CHECK_FALSE(error.yours);
    CHECK(error.plain.find("The tests cannot use your headers as they are") == 0);
}

TEST_CASE("an error that our own headers lead to, too, is no mistake of the learner's") {
    const Project project;
    const CompileError in_the_tests =
        project.error("tests/stage.cpp:7:3: error: 'dot' was not declared in this scope\n");
    const CompileError in_mine = project.error("my/1-rays/vec3.hpp:3:9: error: 'tow' was not declared in this scope\n");
    int asked = 0;
    const auto well = [&]() -> std::optional<CompileError> { return ++asked, std::nullopt; };
    const auto as_bad = [&]() -> std::optional<CompileError> { return ++asked, in_the_tests; };

    const CompileError theirs = with_its_cause(in_the_tests, well);
    CHECK_FALSE(theirs.ours);
    CHECK(theirs.plain == in_the_tests.plain);
    const CompileError ours = with_its_cause(in_the_tests, as_bad);
    CHECK(ours.ours);
    CHECK(ours.plain.starts_with("This is no mistake of yours"));
    CHECK(ours.plain.find("./glassbox") != std::string::npos);
    CHECK(asked == 2);
    CHECK_FALSE(with_its_cause(in_mine, as_bad).ours);  // there is no need to compile ours
    CHECK(asked == 2);
}

TEST_CASE("a file of ours that does not compile is told of in one line, without warnings") {
    const Error error = error_in_ours(
        said("src/learn/check/runner/prelude.hpp:1:9: warning: #pragma once in main file\n"
             "    1 | #pragma once\n"
             "src/learn/check/runner/prelude.hpp:3:10: fatal error: doctest.h: No such file or directory\n"
             "src/learn/check/runner/prelude.hpp:9:10: error: 'doctest' is not declared\n"),
        "src/learn/check/runner/prelude.hpp");
    const std::string words = error.what();
    CHECK(words.starts_with(
        "src/learn/check/runner/prelude.hpp:3:10: error: cannot be compiled: doctest.h: No such file or directory. "));
    CHECK(words.find("no mistake of yours") != std::string::npos);
    CHECK(words.find('\n') == std::string::npos);
    Outcome gone;
    gone.end = End::deadline;
    const std::string late = error_in_ours(gone, "main.cpp").what();
    CHECK(late.starts_with("main.cpp: error: cannot be compiled: it takes more than 10 s"));  // Limits::time
    CHECK(late.find("busy") != std::string::npos);
}

TEST_CASE("names that are nearly right are suggested from the file itself; headers from all lessons") {
    const Project project;
    CHECK(project.error("my/1-rays/vec3.hpp:3:9: error: 'tow' was not declared in this scope\n").plain ==
          "Nothing is called tow here; did you mean 'two'?");
    CHECK(project.error("my/1-rays/vec3.hpp:3:9: error: use of undeclared identifier 'tow'\n").plain ==
          "Nothing is called tow here; did you mean 'two'?");
    CHECK(project.error("my/1-rays/vec3.hpp:1:1: fatal error: sphere.hpp: No such file or directory\n").plain ==
          "sphere.hpp belongs to lesson 2-spheres; this lesson does without it: take the include away.");
    CHECK(project.error("my/1-rays/vec3.hpp:1:1: fatal error: 'spheer.hpp' file not found\n").plain ==
          "There is no header spheer.hpp; did you mean 'sphere.hpp'?");
}

TEST_CASE("what the machine does not allow is told as such, by g++, clang++ and the linker, and nobody is blamed") {
    const Project project;
    const auto refusal = [&](const std::string& errors) {
        return test::message_of<Error>([&] { compile_error(said(errors), {{project.mine}}, project.folder.path); });
    };
    for (const char* full :
         {"x.cpp:3:44: fatal error: cannot write PCH file: No space left on device\n",
          "/usr/include/stdc-predef.h:1: fatal error: error writing to /tmp/a.s: No space left on device\n",
          "fatal error: error in backend: IO failure on output stream: No space left on device\n"}) {
        CHECK(refusal(full).find("cannot write what it makes: No space left on device (") != std::string::npos);
        CHECK(refusal(full).find("free some space there") != std::string::npos);
        CHECK(refusal(full).find("report") == std::string::npos);
    }
    CHECK(refusal("Assembler messages:\nFatal error: can't create a.o: Read-only file system\n").find("--folder") !=
          std::string::npos);
    CHECK(refusal("error: unable to open output file 'a.o': 'Permission denied'\n").find("TMPDIR") !=
          std::string::npos);
    CHECK(test::message_of<Error>([] {
              link_error(said("/usr/bin/ld: final link failed: Disk quota exceeded\ncollect2: error: ld returned 1\n"));
          }).find("delete some files of yours") != std::string::npos);
    CHECK(test::message_of<Error>([&] {
              throw error_in_ours(
                  said("prelude.hpp:1:1: fatal error: cannot write PCH file: No space left on device\n"),
                  "prelude.hpp");
          }).find("free some space") != std::string::npos);
    // A learner's own words, a line of source, and a header that may not be read are no faults of the machine.
    for (const char* other :
         {"my/1-rays/vec3.hpp:2:2: error: #error it said: No space left on device\n",
          "tests/stage.cpp:7:3: error: 'dot' was not declared\n    7 | a: No space left on device\n",
          "tests/stage.cpp:7:3: fatal error: /root/x.hpp: Permission denied\n"})
        CHECK(refusal(other) == "");
}

TEST_CASE("a compiler that comes to an end itself is told of, and so is a linker that misses a body") {
    const Project project;
    Outcome outcome = said("");
    outcome.end = End::deadline;
    const auto late = compile_error(outcome, {{project.mine}}, project.folder.path);
    REQUIRE(late);
    CHECK(late->plain.find("does not come to an end") != std::string::npos);
    const auto missing =
        link_error(said("/usr/bin/ld: x.o: in function `f':\nx.cpp:(.text+0x1): undefined reference to "
                        "`glassbox::dot(int)'\ncollect2: error: ld returned 1 exit status\n"));
    REQUIRE(missing);
    CHECK(missing->message == "undefined reference to `glassbox::dot(int)'");
    CHECK(missing->plain.find("no body") != std::string::npos);
    Outcome good;
    good.end = End::exited;
    CHECK_FALSE(compile_error(good, {{project.mine}}, project.folder.path));
    CHECK_FALSE(link_error(good));
}
