#include "learn/course/exercise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <span>

#include "render/option_names.hpp"
#include "scene/named.hpp"
#include "scene/suggestion.hpp"
#include "scene/text_file.hpp"
#include "scene/toml_value.hpp"

namespace glassbox::learn {
namespace {

namespace fs = std::filesystem;

std::string text_with_something(const Value& value) {
    std::string string = text(value);
    if (string.find_first_not_of(" \t\n") == std::string::npos) throw wrong(value, "is empty; write something");
    return string;
}

/// A list of at least one string.
std::vector<std::string> texts(const Value& value) {
    const toml::array* array = value.node->as_array();
    if (!array || array->empty()) throw wrong(value, R"(must be a list of strings, like ["one", "two"])");
    std::vector<std::string> all;
    for (const toml::node& node : *array)
        all.push_back(text_with_something({&node, value.name + "'s member", value.file}));
    return all;
}

/// The name of a file or folder of our own; it cannot lead out of the folder where it is looked for.
std::string relative_path(const Value& value) {
    std::string path = text(value);
    const fs::path parts(path);
    if (parts.is_absolute() || std::find(parts.begin(), parts.end(), "..") != parts.end())
        throw wrong(value, "must be a path within the project, without '..'");
    return path;
}

std::string header_name(const Value& value, std::span<const std::string> headers) {
    std::string name = text(value);
    const std::vector<std::string_view> known(headers.begin(), headers.end());
    if (std::find(known.begin(), known.end(), name) == known.end())
        throw error_at(place(value), fmt::format("unknown header {}; {}", in_quotes(name), suggestion(name, known)));
    return name;
}

constexpr NameTable<OwnPicture, 3> own_pictures{{
    {"in double", OwnPicture::in_double, "what the headers compute in plain double"},
    {"by bounds", OwnPicture::by_bounds, "what the headers' bounds can prove alone"},
    {"none", OwnPicture::none, "no tracer of ours includes the headers"},
}};

OwnPicture own_picture(const Value& value) {
    const std::string name = text(value);
    if (const auto found = find_named(own_pictures, name)) return *found;
    throw error_at(place(value),
                   fmt::format("unknown own_picture {}; {}", in_quotes(name), suggestion(name, names(own_pictures))));
}

/// The name of a sphere's or a triangle's rule.
std::string rule_name(const Value& value) {
    const std::string name = text(value);
    if (find_named(sphere_rules, name) || find_named(triangle_rules, name)) return name;
    std::vector<std::string_view> known = names(sphere_rules);
    for (const std::string_view other : names(triangle_rules)) known.push_back(other);
    throw error_at(place(value), fmt::format("unknown rule {}; {}", in_quotes(name), suggestion(name, known)));
}

Function read_function(const Section& section, const std::vector<std::string>& headers) {
    section.expect_keys({"name", "header", "tests", "question", "formula", "line", "returns", "turn", "rule"});
    Function function;
    function.name = text_with_something(section.at("name", "name = \"cross\""));
    function.header = header_name(section.at("header", "header = \"vec3.hpp\""), headers);
    function.tests = texts(section.at("tests", "tests = [\"a x b is right-handed\"]"));
    function.hints[0] = text_with_something(section.at("question", "question = \"What is …?\""));
    function.hints[1] = text_with_something(section.at("formula", "formula = \"|a| = √(a·a)\""));
    function.hints[2] = text_with_something(section.at("line", "line = \"return sqrt(dot(a, a));\""));
    function.returns = text_with_something(section.at("returns", "returns = \"Real\""));
    function.turn = section.get("turn", text, std::string());
    function.rule = section.get("rule", rule_name, std::string());
    function.place = place(section.at("name", ""));
    return function;
}

/// Returns the number that a lesson's folder begins with; 0 if it is not a lesson's.
int number_of(const std::string& name) {
    const std::size_t digits = name.find_first_not_of("0123456789");
    if (digits == 0 || digits > 3 || digits == std::string::npos || name[digits] != '-') return 0;
    return std::stoi(name.substr(0, digits));
}

void expect_unique(std::set<std::string>& seen, const Value& value) {
    if (!seen.insert(text(value)).second)
        throw wrong(value, fmt::format("{} is taken; each has its own", in_quotes(text(value))));
}

}  // namespace

Exercise read_exercise(const fs::path& lesson) {
    const fs::path path = lesson / "exercise.toml";
    const std::string file = path.string();
    const toml::table document = parse_toml(read_text(path), file, "an exercise");
    const Section top(document, "the exercise", file);
    top.expect_keys({"title", "sentence", "core", "headers", "tests", "scene", "stage", "own_picture", "function"});

    Exercise exercise;
    exercise.name = lesson.filename().string();
    exercise.number = number_of(exercise.name);
    exercise.lesson = lesson;
    exercise.title = text_with_something(top.at("title", "title = \"Spheres\""));
    exercise.sentence = text_with_something(top.at("sentence", "sentence = \"You can …\""));
    exercise.core = relative_path(top.at("core", "core = \"src/core/2-spheres\""));
    const Value headers = top.at("headers", "headers = [\"sphere.hpp\"]");
    exercise.headers = texts(headers);
    for (const std::string& header : exercise.headers)
        if (fs::path(header).has_parent_path())
            throw wrong(headers, fmt::format("has {}; a header's name has no folder", in_quotes(header)));
    exercise.tests = texts(top.at("tests", "tests = [\"tests/stages/stage2_spheres.cpp\"]"));
    exercise.scene = relative_path(top.at("scene", "scene = \"scenes/levental-2014.toml\""));
    exercise.stage = whole_number(top.at("stage", "stage = 2"), 1, 5);
    exercise.own_picture = top.get("own_picture", own_picture, OwnPicture::in_double);
    std::set<std::string> names;
    for (const Section& section : top.sections("function")) {
        exercise.functions.push_back(read_function(section, exercise.headers));
        expect_unique(names, section.at("name", ""));
    }
    if (exercise.functions.empty())
        throw wrong(top.self(), "has no [[function]]; it needs one for each that is to be written");
    return exercise;
}

std::vector<Mistake> read_mistakes(const Exercise& exercise) {
    const fs::path path = exercise.lesson / "mistakes.toml";
    const std::string file = path.string();
    const toml::table document = parse_toml(read_text(path), file, "a list of mistakes");
    const Section top(document, "the list of mistakes", file);
    top.expect_keys({"mistake"});
    std::vector<Mistake> mistakes;
    std::set<std::string> names;
    for (const Section& section : top.sections("mistake")) {
        section.expect_keys({"name", "header", "instead_of", "writes", "looks_like"});
        const Value name = section.at("name", "name = \"far-root-missing\"");
        expect_unique(names, name);
        mistakes.push_back(
            {text_with_something(name), header_name(section.at("header", "header = \"sphere.hpp\""), exercise.headers),
             text_with_something(section.at("instead_of", "instead_of = '''return a + b;'''")),
             text(section.at("writes", "writes = '''return a - b;'''")),
             text_with_something(section.at("looks_like", "looks_like = \"Your sum is a difference: …\"")),
             place(name)});
    }
    return mistakes;
}

std::vector<Exercise> read_exercises(const fs::path& root) {
    std::vector<Exercise> exercises;
    std::error_code none;
    for (const fs::directory_entry& entry : fs::directory_iterator(root / "lessons", none))
        if (number_of(entry.path().filename().string()) > 0 && fs::exists(entry.path() / "exercise.toml", none))
            exercises.push_back(read_exercise(entry.path()));
    std::sort(exercises.begin(), exercises.end(),
              [](const Exercise& a, const Exercise& b) { return a.number < b.number; });
    return exercises;
}

const Function* function_tested_by(const Exercise& exercise, std::string_view test_case) {
    for (const Function& function : exercise.functions)
        for (const std::string& part : function.tests)
            if (test_case.find(part) != std::string_view::npos) return &function;
    return nullptr;
}

std::string with_mistake(const std::string& solution, const Mistake& mistake) {
    const std::size_t at = solution.find(mistake.instead_of);
    const bool once = at != std::string::npos && solution.find(mistake.instead_of, at + 1) == std::string::npos;
    if (!once)
        throw error_at(
            mistake.place,
            fmt::format("instead_of of mistake {} stands {} in the solution's {}; it must stand there exactly once",
                        in_quotes(mistake.name), at == std::string::npos ? "nowhere" : "more than once",
                        mistake.header));
    std::string text = solution;
    text.replace(at, mistake.instead_of.size(), mistake.writes);
    return text;
}

}  // namespace glassbox::learn
