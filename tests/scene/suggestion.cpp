#include "scene/suggestion.hpp"

#include <doctest.h>

#include <array>

using namespace glassbox;

TEST_CASE("The edit distance counts letters added, dropped, changed, and neighbours swapped") {
    CHECK(edit_distance("", "") == 0);
    CHECK(edit_distance("radius", "radius") == 0);
    CHECK(edit_distance("radius", "Radius") == 0);
    CHECK(edit_distance("radus", "radius") == 1);
    CHECK(edit_distance("radiuss", "radius") == 1);
    CHECK(edit_distance("rodius", "radius") == 1);
    CHECK(edit_distance("centre", "center") == 1);
    CHECK(edit_distance("", "abc") == 3);
    CHECK(edit_distance("kitten", "sitting") == 3);  // k → s, e → i, and a g
}

TEST_CASE("A suggestion is the nearest name, or all of them where none is near") {
    constexpr std::array<std::string_view, 3> names{"center", "radius", "color"};
    CHECK(suggestion("colour", names) == "did you mean 'color'?");
    CHECK(suggestion("RADIUS", names) == "did you mean 'radius'?");
    CHECK(suggestion("material", names) == "it must be one of 'center', 'radius', 'color'");
    CHECK(suggestion(std::string(1000000, 'c'), names) == "it must be one of 'center', 'radius', 'color'");
}
