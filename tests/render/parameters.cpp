// The table of parameters: each row is one member of Setup, and the pages for users tell of it.
#include "render/parameters.hpp"

#include <doctest.h>
#include <fmt/format.h>

#include <filesystem>
#include <set>

#include "scene/text_file.hpp"

using namespace glassbox;

namespace {

/// Differs from Setup{} in every parameter.
Setup all_changed() {
    Setup setup;
    setup.options = {
        3, {{Axis::z, 10}, {Axis::y, -0.5}}, true, Scalar::float_, EngineChoice::plain, Textbook{}, Tolerance{0.5}};
    setup.shading.model = ShadingModel::phong;
    for (const Coefficient<double>& coefficient : coefficients<double>) setup.shading.*coefficient.member = 0.25;
    setup.light_vector = {1, 2, -3};
    setup.light_intensity = 0.75;
    return setup;
}

bool tells_of(const std::string& page, std::string_view name) {
    return page.find(fmt::format("`{}`", name)) != std::string::npos;
}

bool has_row(const std::string& page, std::string_view name) {
    return page.find(fmt::format("\n| `{}` |", name)) != std::string::npos;
}

/// A page from a heading on.
std::string from(const char* file, std::string_view heading) {
    const std::string page = read_text(std::filesystem::path(DOCS) / file);
    REQUIRE(page.find(heading) != std::string::npos);
    return page.substr(page.find(heading));
}

}  // namespace

TEST_CASE("a row is one member: to take it over changes it and no other") {
    const Setup changed = all_changed();
    Setup setup;
    for (const Parameter& parameter : parameters()) {
        CAPTURE(parameter.name);
        CHECK_FALSE(is_same(parameter, setup, changed));
        const Setup one = taken_over({}, parameter, changed);
        for (const Parameter& other : parameters()) CHECK(is_same(other, one, Setup{}) == (&other != &parameter));
        setup = taken_over(setup, parameter, changed);
        CHECK(is_same(parameter, setup, changed));
    }
    CHECK(setup == changed);
}

TEST_CASE("no two parameters share a name") {
    std::set<std::string_view> names;
    for (const Parameter& parameter : parameters()) CHECK(names.insert(parameter.name).second);
}

TEST_CASE("values are written as they are typed") {
    const Setup setup = all_changed();
    std::string line;
    for (const Parameter& parameter : parameters())
        line += fmt::format("{}={} ", parameter.name, written(parameter, setup));
    CHECK(
        line ==
        "stage=3 turn=z:10,y:-0.5 accumulated= ambient=0.25 diffuse=0.25 specular=0.25 exponent=0.25 "
        "shading=phong light=1,2,-3 intensity=0.75 scalar=float triangle=tolerance:0.5 sphere=textbook engine=plain ");
}

TEST_CASE("the page of the scene format has a row for each coefficient and its colour") {
    const std::string section = from("scene-format.md", "### `[shading]`");
    for (const Coefficient<double>& coefficient : coefficients<double>) {
        CAPTURE(coefficient.name);
        CHECK(has_row(section, coefficient.name));
        if (coefficient.color_member) CHECK(has_row(section, coefficient.color_name));
    }
}

TEST_CASE("the viewer's page tells of all that a script can set") {
    const std::string section = from("viewer.md", "\n| `set` | values |");
    for (const Parameter& parameter : parameters())
        if (is_offered(parameter)) {
            CAPTURE(parameter.name);
            CHECK(tells_of(section, parameter.name));
        }
}
