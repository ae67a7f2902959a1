// What is not closed in a header. Each text has one fault, and the expected place is where a reader would point:
// counted by hand.
#include "learn/build/unclosed.hpp"

#include <doctest.h>

#include <filesystem>
#include <string>

#include "learn/build/headers.hpp"

using namespace glassbox::learn;
namespace fs = std::filesystem;

namespace {

/// "line:column words", or "" if all is closed.
std::string told(std::string_view source) {
    const auto found = unclosed_in(source);
    return found ? std::to_string(found->line) + ':' + std::to_string(found->column) + ' ' + found->words : "";
}

void check_told(std::string_view source, std::string_view beginning) {
    const std::string words = told(source);
    CHECK_MESSAGE(words.starts_with(beginning), words);
}

}  // namespace

TEST_CASE("in a file where all is closed nothing is found, whatever its texts and comments hold") {
    for (const char* source : {
             "",
             "namespace a {\nint f() { return 1; }\n}  // namespace a\n",
             "const char* s = \"}}{\\\"{\"; char c = '{', d = '\\'';  // { it's\n/* { don't */\n",
             "const auto s = R\"x({ )\" \" )x\"; int n = 1'000'000;\n",
             "#define OPEN {\n#define TWO \\\n    {{\n#error don't { \n",
             "struct A {\npublic:\n    int x;\n};\n",
         })
        CHECK(told(source) == "");
}

TEST_CASE("in our own sources all is closed, and without its last brace none is") {
    int files = 0;
    for (const char* folder : {"src", "lessons"})
        for (const fs::path& file : headers_in(fs::path(ROOT) / folder)) {
            CAPTURE(file.string());
            const std::string source = content_of(file);
            CHECK(told(source) == "");
            const std::size_t last = source.rfind("}  // namespace");
            if (last == std::string::npos) continue;
            CHECK(told(source.substr(0, last)).find("This { is never closed") != std::string::npos);
            ++files;
        }
    CHECK(files > 100);
}

TEST_CASE("each branch of an #if may open the brace that is closed behind it; '#if 0' holds any words") {
    CHECK(told("#if A\nvoid f() {\n#elif B\nvoid g() {\n#else\nvoid h() {\n#endif\n}\n") == "");
    CHECK(told("#if 0\nwe don't {\n#else\nint x;\n#endif\n") == "");
    CHECK(told("#if 0\n{\n#endif\nvoid f() {\n}\n") == "");
    check_told("#if A\nvoid f() {\n#else\nvoid g() {\n#endif\n", "2:10 This { is never closed");
    CHECK(told("#if 1\nvoid f() {\n") == "");       // every compiler reports the #if, at its line
    CHECK(told("void f() {\n/* and so on") == "");  // and of the comment
}

TEST_CASE("a namespace whose last brace was left out") {
    check_told("#pragma once\nnamespace glassbox {\n\nint f() { return 1; }\n", "2:20 This { is never closed");
}

TEST_CASE("of a function, or a struct, without its } indentation tells where it is missing") {
    check_told(
        "namespace a {\ntemplate <class T>\nT f(T x,\n    T y) {\n    if (x) {\n        return y;\n    }\n    return "
        "x;\n\n"
        "template <class T>\nT g(T x) {\n    return x;\n}\n}  // namespace a\n",
        "4:10 This { is never closed: its } is missing before line 10.");
    check_told("namespace a {\nstruct P {\n    int x;\n\nint f() {\n    return 1;\n}\n}\n",
               "2:10 This { is never closed: its } is missing before line 5.");
    check_told("int f(int x)\n{\n    while (x) {\n        --x;\n    return x;\n}\n",
               "3:15 This { is never closed: its } is missing before line 5.");
    // Two are missing: correct the inner one first.
    check_told("namespace a {\nint f(int x) {\n    if (x) {\n        return 1;\nint g() {\n    return 2;\n}\n}\n",
               "3:12 This { is never closed: its } is missing before line 5.");
}

TEST_CASE("without indentation no guess is made: the innermost that stays open is named") {
    check_told("int f() {\nif (true) {\nreturn 1;\n}\nint g() {\nreturn 2;\n}\n",
               "1:9 This { is never closed: a } is missing, at the end or further up.");
}

TEST_CASE("a list of values ends before its statement does: its brace is named, and not the function's") {
    check_told("int f() {\n    return {1,\n            g(2);\n}\n\nint g() {\n    return 1;\n}\n",
               "2:12 This { is never closed: its } is missing before the ; of line 3.");
    check_told("M f() {\n    return {{1, 0}, {0, 1};\n}\n",
               "2:12 This { is never closed: its } is missing before the ;");
    check_told("M f() {\n    return {{1, 0}, {0, 1;\n}\n",
               "2:21 This { is never closed: its } is missing before the ;");
    check_told("void f() {\n    const M m = {1, 2;\n}\n", "2:17 This { is never closed: its } is missing before the ;");
    CHECK(told("void f() {\n    return {[] { return 1; }(), 2};\n}\n") == "");
}

TEST_CASE("a } too many is named where a namespace ends early, by indentation, or where nothing is open") {
    check_told("namespace a {\nint f() {\n    return 1;\n}\n}\n\nint g() {\n    return 2;\n}\n}  // namespace a\n",
               "5:1 With this } the namespace ends already, and the } of line 10 closes nothing");
    check_told("namespace a {\nint f(int x) {\n    if (x) {\n        return 1;\n    }\n    }\n    return 2;\n}\n}\n",
               "6:5 This } is one too many");
    check_told("int f() {\n    return 1;\n}\n}\n", "4:1 This } closes nothing");
    // It is in the second of two namespaces; the first ends where it should.
    check_told("namespace a {\nint x;\n}\nnamespace b {\nint f() {\n    return 1;\n}\n}\n}\n",
               "9:1 This } closes nothing");
}

TEST_CASE("a text that is not closed, and a comment that swallows the next one") {
    check_told("int f() {\n    const char* s = \"abc;\n    return 1;\n}\n", "2:21 This quotation mark is not closed");
    check_told("char c = 'a;\n", "1:10 This quotation mark is not closed");
    check_told("auto s = R\"x(abc;\n}\n", "1:11 The text that begins here with R\" never ends: its )x\" is missing.");
    check_told("/* the first\nint f() {\n/* the second */\n}\n",
               "1:1 The comment that begins here goes on beyond the /* of line 3: is its */ missing?");
}
