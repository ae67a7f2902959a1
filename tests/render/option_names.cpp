// The names of options: one for each value, read back to the same value, explained in a line.
#include "render/option_names.hpp"

#include <doctest.h>

#include <set>

#include "scene/shading_models.hpp"

using namespace glassbox;

namespace {

template <class Value, std::size_t count>
void check_names(const NameTable<Value, count>& table) {
    std::set<std::string_view> names, helps;
    for (const Named<Value>& entry : table) {
        const std::string_view name = entry.name, help = entry.help;  // clang captures no bindings
        CAPTURE(name);
        CHECK(find_named(table, name) == entry.value);
        CHECK(name_of(entry.value) == name);
        CHECK(help.size() >= 10);
        CHECK(help.size() <= 60);
        names.insert(name);
        helps.insert(help);
    }
    CHECK(names.size() == count);
    CHECK(helps.size() == count);
    CHECK_FALSE(find_named(table, ""));
    CHECK_FALSE(find_named(table, "none"));
}

}  // namespace

TEST_CASE("names and values go together") {
    check_names(scalars);
    check_names(sphere_rules);
    check_names(triangle_rules);
    check_names(shading_models);
}

TEST_CASE("every rule that a search can be made of has a name") {
    CHECK(sphere_rules.size() == std::variant_size_v<SphereRule>);
    CHECK(triangle_rules.size() == std::variant_size_v<TriangleRule>);
}

TEST_CASE("what a rule's struct is called") {
    CHECK(struct_of(SphereRule(Stable{})) == "Stable");
    CHECK(struct_of(SphereRule(Textbook{})) == "Textbook");
    CHECK(struct_of(SphereRule(Levental2014{})) == "Levental2014");
    CHECK(struct_of(TriangleRule(Pluecker{})) == "Pluecker");
    CHECK(struct_of(TriangleRule(Tolerance{})) == "Tolerance");
    CHECK(struct_of(TriangleRule(MoellerTrumbore{})) == "MoellerTrumbore");
}

TEST_CASE("a tolerance is written with its number") {
    CHECK(written(Tolerance{}) == "tolerance:10");
    CHECK(written(Tolerance{0.5}) == "tolerance:0.5");
    CHECK(written(Pluecker{}) == "pluecker");
    CHECK(name_of(TriangleRule(Tolerance{3})) == "tolerance");
    CHECK(tolerance_text("tolerance:0.5") == "0.5");
    CHECK(tolerance_text("tolerance:") == "");
    for (const char* other : {"tolerance", "tolerances:1", "pluecker", ":1", ""}) CHECK_FALSE(tolerance_text(other));
}
