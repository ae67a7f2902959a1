#include "scene/toml_depth.hpp"

#include <doctest.h>

#include <string>

using namespace glassbox;

namespace {

std::string repeated(const std::string& text, std::size_t times) {
    std::string all;
    for (std::size_t k = 0; k < times; ++k) all += text;
    return all;
}

}  // namespace

TEST_CASE("Brackets, dotted keys and sections, each a level") {
    // a = [[[…1…]]]: the key's level and one for each bracket, so that 99 brackets make 100 levels.
    CHECK_FALSE(first_too_deep("a = " + repeated("[", 99) + "1" + repeated("]", 99)));
    CHECK(first_too_deep("a = " + repeated("[", 100)) == 4 + 99);
    // a.a.….a = 1: 99 dots part 100 names.
    CHECK_FALSE(first_too_deep("a" + repeated(".a", 99) + " = 1"));
    CHECK(first_too_deep("a" + repeated(".a", 100) + " = 1").has_value());
    CHECK_FALSE(first_too_deep("[a" + repeated(" . a", 98) + "]\nx = 1"));
    CHECK(first_too_deep("[a" + repeated(" . a", 98) + "]\nx.y = 1").has_value());
    CHECK(first_too_deep("[[a" + repeated(".a", 100) + "]]").has_value());
    CHECK(first_too_deep("a = " + repeated("{a = ", 100)).has_value());
    // All of them together: 50 + 1 + 25 (1 + 1) = 101.
    CHECK(first_too_deep("[a" + repeated(".a", 49) + "]\nb = " + repeated("{a.a = {", 20)).has_value());
    CHECK(first_too_deep("x = 1\n\ny.\"a.b\"" + repeated(".'c'", 40000) + " = 1").has_value());
}

TEST_CASE("What only looks deep") {
    CHECK_FALSE(first_too_deep("title = \"" + repeated("[.", 1000) + "\""));
    CHECK_FALSE(first_too_deep("title = 'a\\'\nb = '" + repeated("[.", 1000) + "'"));
    CHECK_FALSE(first_too_deep("title = \"\"\"\n\"" + repeated("[.\n", 1000) + "\\\"\"\"\"\nx = 1"));
    CHECK_FALSE(first_too_deep("# " + repeated("a.[{", 1000)));
    CHECK_FALSE(first_too_deep("a = [" + repeated("1.5, [2.5],\n", 1000) + "]"));
    CHECK_FALSE(first_too_deep(repeated("[[sphere]]\ncenter = [0.1, 0.2, 0.3]\n", 1000)));
    CHECK_FALSE(first_too_deep(repeated("view.eye.x = 1.5\n", 1000)));
    CHECK_FALSE(first_too_deep(repeated("]", 1000)));
}
